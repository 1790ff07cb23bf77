"""Families: single weights made into one variable font, italics into a second one, beside the single weights themselves."""

import contextlib
import json
import os
import subprocess

import cli
import harfbuzz
from fontTools import subset, ttLib
from fontTools.varLib import instancer

SAMPLE = os.environ['VARIABLE_SAMPLE']
ITALIC = cli.INTER.with_name('Inter-italic.var.ttf')
TEXT = 'AVTonagk8&.éñ'
LINES = ('AVATo.', 'Tan no gk8&')
STYLES = {100: 'Thin', 400: 'Regular', 700: 'Bold', 900: 'Black'}


def read(path):
    return ttLib.TTFont(path, recalcTimestamp=False)


def names_of(font):
    return {record.nameID: record.toUnicode() for record in font['name'].names}


class Family(cli.Test):
    """Single weights of Inter, with the letters of TEXT, as a foundry has them: fonts that do not vary."""

    @classmethod
    def setUpClass(cls):
        cls.stack = contextlib.ExitStack()
        cls.addClassCleanup(cls.stack.close)
        cls.home = cli.make_directory(lambda *a, **k: cls.stack.callback(a[0], *a[1:], **k))
        cls.statics = {}
        for source, slope in ((cli.INTER, ''), (ITALIC, ' Italic')):
            whole = read(source)
            cutter = subset.Subsetter(subset.Options(name_IDs=['*'], layout_features=['kern']))
            cutter.populate(text=TEXT)
            cutter.subset(whole)
            whole.save(cls.home / 'cut.ttf')
            whole.save(cls.home / ('cut-italic.ttf' if slope else 'cut-upright.ttf'))
            for weight, style in STYLES.items():
                cls.statics[weight, slope] = cls.save_static(weight, style, slope)

    @classmethod
    def save_static(cls, weight, style, slope):
        font = instancer.instantiateVariableFont(read(cls.home / 'cut.ttf'), {'wght': weight})
        style = (style + slope).replace('Regular Italic', 'Italic')
        for number, text in ((1, f'Inter {style}'), (2, 'Regular'), (16, 'Inter'), (17, style), (6, f'Inter-{style.replace(" ", "")}')):
            font['name'].setName(text, number, 3, 1, 0x409)
        font['OS/2'].usWeightClass = weight
        font['OS/2'].fsSelection = font['OS/2'].fsSelection & ~1 | bool(slope)
        path = cls.home / f'{style.replace(" ", "")}.ttf'
        font.save(path)
        return path

    def upright(self, *weights):
        return [self.statics[weight, ''] for weight in weights]

    def italics(self, *weights):
        return [self.statics[weight, ' Italic'] for weight in weights]

    def family(self, *fonts, output='Inter.ttf', options=('-q',)):
        self.made('variable', *fonts, '--axis', 'wght', *options, '-o', output)
        return read(self.path(output))

    def changed(self, path, change):
        """A copy of a font after a change."""
        font = read(path)
        change(font)
        made = self.path(f'changed-{path.name}')
        font.save(made)
        return made

    def instance(self, path, weight):
        made = self.path('instance.ttf')
        instancer.instantiateVariableFont(read(path), {'wght': weight}).save(made)
        return made

    def compared(self, path, other):
        """Shared ink over all ink, and by how many units the first's advance is longer, of each character."""
        points = ' '.join(f'{ord(c):x}' for c in TEXT).encode()
        result = subprocess.run([SAMPLE, 'compare', 'none', path, '0', other], input=points, stdout=subprocess.PIPE, check=True)
        rows = [line.split() for line in result.stdout.decode().splitlines()]
        self.assertEqual(len(rows), len(TEXT))
        return {chr(int(row[0], 16)): (float(row[1]), float(row[2])) for row in rows}

    def assert_sane(self, path):
        subprocess.run(['ots-sanitize', path], check=True, stdout=subprocess.DEVNULL)


class Font(Family):
    """One font of the upright weights."""

    def test_fonts_stand_at_their_weights_and_keep_their_names(self):
        font = self.family(*self.upright(100, 400, 700, 900))
        axis, names = font['fvar'].axes[0], names_of(font)
        self.assertEqual((axis.axisTag, axis.minValue, axis.defaultValue, axis.maxValue), ('wght', 100, 400, 900))
        instances = {i.coordinates['wght']: (names[i.subfamilyNameID], names[i.postscriptNameID]) for i in font['fvar'].instances}
        self.assertEqual(instances, {weight: (style, f'Inter-{style}') for weight, style in STYLES.items()})
        self.assertEqual([names.get(i) for i in (1, 2, 4, 6, 16, 25)],
                         ['Inter', 'Regular', 'Inter Regular', 'Inter-Regular', None, 'Inter'])
        self.assertEqual((font['OS/2'].usWeightClass, font['OS/2'].fsSelection & 0x61), (400, 0x40))
        table = font['STAT'].table
        self.assertEqual([a.AxisTag for a in table.DesignAxisRecord.Axis], ['wght'])
        self.assertEqual([(v.Value, names[v.ValueNameID], v.Flags, getattr(v, 'LinkedValue', None)) for v in table.AxisValueArray.AxisValue],
                         [(w, s, 2 * (w == 400), 700 if w == 400 else None) for w, s in STYLES.items()])
        self.assert_sane(self.path('Inter.ttf'))

    def test_the_order_of_the_fonts_does_not_count(self):
        self.family(*self.upright(100, 400, 700), output='one.ttf')
        self.family(*self.upright(700, 100, 400), output='two.ttf')
        self.assertEqual(self.path('one.ttf').read_bytes(), self.path('two.ttf').read_bytes())

    def test_stops_show_the_fonts(self):
        self.family(*self.upright(100, 400, 900))
        for weight in (100, 400, 900):
            static = self.statics[weight, '']
            made = self.instance(self.path('Inter.ttf'), weight)
            for character, (share, advance) in self.compared(made, static).items():
                self.assertEqual(advance, 0, (weight, character))
                self.assertGreater(share, 0.97 if weight == 100 else 0.985, (weight, character)) # thin stems are all border
            for line in LINES:
                ours, theirs = harfbuzz.shape(made, line), harfbuzz.shape(static, line)
                self.assertEqual([g[1:] for g in ours], [g[1:] for g in theirs], (weight, line))
            ours, theirs = read(made), read(static)
            self.assertEqual(ours['OS/2'].sxHeight, theirs['OS/2'].sxHeight)

    def test_as_it_stands_it_is_the_regular(self):
        font, regular = self.family(*self.upright(100, 400, 900)), read(self.statics[400, ''])
        for character in TEXT:
            advances = [f['hmtx'][f.getBestCmap()[ord(character)]][0] for f in (font, regular)]
            self.assertEqual(*advances, character)
        for _, (share, _) in self.compared(self.path('Inter.ttf'), self.statics[400, '']).items():
            self.assertGreater(share, 0.985)

    def test_without_a_regular_it_stands_at_the_lightest(self):
        font = self.family(*self.upright(900, 700, 100))
        self.assertEqual(font['fvar'].axes[0].defaultValue, 100)
        self.assertEqual(names_of(font)[17], 'Thin')

    def test_between_are_the_familys_other_weights(self):
        self.family(*self.upright(100, 400, 900))
        shares = []
        for weight in (250, 700): # Inter's weights between its masters are on straight lines, as these are
            truth = self.home / f'truth-{weight}.ttf'
            instancer.instantiateVariableFont(read(self.home / 'cut-upright.ttf'), {'wght': weight}).save(truth)
            for _, (share, advance) in self.compared(self.instance(self.path('Inter.ttf'), weight), truth).items():
                shares.append(share)
                self.assertLess(abs(advance), 0.004 * read(truth)['head'].unitsPerEm)
        shares.sort()
        self.assertGreater(shares[len(shares) // 2], 0.985)
        self.assertGreater(shares[len(shares) // 20], 0.96)

    def test_nothing_lies_between_a_stop_and_the_next_place(self):
        self.family(*self.upright(100, 400, 900))
        for weight in (399.95, 400.05):
            for character, (share, _) in self.compared(self.instance(self.path('Inter.ttf'), weight), self.statics[400, '']).items():
                self.assertGreater(share, 0.98, (weight, character))

    def test_stops_may_be_said(self):
        font = self.family(*self.upright(700, 400, 100), options=('-q', '--stops', '1000,300,50'))
        axis = font['fvar'].axes[0]
        self.assertEqual((axis.minValue, axis.defaultValue, axis.maxValue), (50, 50, 1000))
        self.assertEqual([(i.coordinates['wght'], names_of(font)[i.subfamilyNameID]) for i in font['fvar'].instances],
                         [(50, 'Thin'), (300, 'Regular'), (1000, 'Bold')])

    def test_names_that_do_not_tell_fonts_apart_are_the_axis_own(self):
        def rename(font):
            font['name'].setName('Regular', 17, 3, 1, 0x409)
        font = self.family(*[self.changed(path, rename) for path in self.upright(100, 400, 700)])
        self.assertEqual([names_of(font)[i.subfamilyNameID] for i in font['fvar'].instances], ['Thin', 'Regular', 'Bold'])

    def test_masters(self):
        self.made('variable', *self.upright(100, 400, 700), '--axis', 'wght', '-q', '-o', 'Inter.designspace')
        text = self.path('Inter.designspace').read_text()
        self.assertIn('minimum="100" maximum="700" default="400"', text)
        for style in ('Thin', 'Regular', 'Bold'):
            self.assertIn(f'stylename="{style}"', text)

    def test_glyphs_that_need_a_look_are_those_of_the_report(self):
        light, dark = cli.cut_font(self.path('cut.ttf'), 'ABCDE', blank='BD'), cli.SANS_BOLD
        options = ('--axis', 'wght', '--stops', '900,400', '--text', 'ABCDE', '-o', 'x.ttf')
        said = [line for line in self.made('variable', dark, light, *options) if 'need' in line and 'look' in line]
        self.made('report', light, dark, '--text', 'ABCDE', '-q', '-o', 'x.json')
        flagged = [g for g in json.loads(self.path('x.json').read_text())['glyphs'] if g['flags']]
        self.assertEqual([g['character'] for g in flagged], ['B', 'D'])
        wanted = ', '.join(f'“{g["character"]}” (U+{ord(g["character"]):04X}): {", ".join(f["flag"] for f in g["flags"])}' for g in flagged)
        self.assertEqual(said, [f'morphotype: {light} to {dark}: 2 glyphs need a look: {wanted}'])
        each = [line for line in self.made('variable', dark, light, *options, '-v') if 'needs a look' in line]
        self.assertEqual([line.split('“')[1][0] for line in each], ['B', 'D'])
        self.assertEqual([line for line in self.made('variable', dark, light, *options, '-q') if 'look' in line], [])


class Width(Family):
    """Other axes."""

    def test_width(self):
        def narrow(font):
            font['OS/2'].usWidthClass = 3
        font = read(self.statics[400, ''])
        self.made('variable', self.statics[700, ''], self.changed(self.statics[400, ''], narrow), '--axis', 'wdth', '-q', '-o', 'x.ttf')
        font = read(self.path('x.ttf'))
        axis = font['fvar'].axes[0]
        self.assertEqual((axis.axisTag, axis.minValue, axis.defaultValue, axis.maxValue), ('wdth', 75, 100, 100))
        self.assertEqual(font['OS/2'].usWidthClass, 5)

    def test_slant_is_one_font_with_the_upright_one(self):
        def lean(font):
            font['post'].italicAngle = -10
        self.made('variable', self.changed(self.statics[400, ' Italic'], lean), self.statics[400, ''], '--axis', 'slnt', '-q', '-o', 'x.ttf')
        font = read(self.path('x.ttf'))
        axis = font['fvar'].axes[0]
        self.assertEqual((axis.axisTag, axis.minValue, axis.defaultValue, axis.maxValue), ('slnt', -10, 0, 0))
        self.assertEqual(font['post'].italicAngle, 0)
        self.assertEqual(sorted(path.name for path in self.files()), [f'changed-{self.statics[400, " Italic"].name}', 'x.ttf'])


class Italics(Family):
    """The second file."""

    def values(self, font):
        names, table = names_of(font), font['STAT'].table
        axes = [axis.AxisTag for axis in table.DesignAxisRecord.Axis]
        return [(axes[v.AxisIndex], v.Value, names[v.ValueNameID], v.Flags, getattr(v, 'LinkedValue', None))
                for v in table.AxisValueArray.AxisValue]

    def test_both_are_made_and_linked(self):
        fonts = self.upright(700, 400) + self.italics(400, 700, 900)
        lines = self.made('variable', *fonts, '--axis', 'wght', '--family', 'Neu', '-o', 'Neu.ttf')
        self.assertIn('morphotype: Neu-Italic.ttf: the italics, 3 fonts', lines)
        upright, italic = read(self.path('Neu.ttf')), read(self.path('Neu-Italic.ttf'))
        self.assertEqual(self.values(upright), [('wght', 400, 'Regular', 2, 700), ('wght', 700, 'Bold', 0, None),
                                                ('ital', 0, 'Roman', 2, 1)])
        self.assertEqual(self.values(italic), [('wght', 400, 'Regular', 2, 700), ('wght', 700, 'Bold', 0, None),
                                               ('wght', 900, 'Black', 0, None), ('ital', 1, 'Italic', 0, None)])
        names = names_of(italic)
        self.assertEqual([(names[i.subfamilyNameID], names[i.postscriptNameID]) for i in italic['fvar'].instances],
                         [('Italic', 'Neu-Italic'), ('Bold Italic', 'Neu-BoldItalic'), ('Black Italic', 'Neu-BlackItalic')])
        self.assertEqual([names.get(i) for i in (1, 2, 6, 25)], ['Neu', 'Italic', 'Neu-Italic', 'NeuItalic'])
        self.assertEqual([(f['OS/2'].fsSelection & 0x61, f['head'].macStyle) for f in (upright, italic)], [(0x40, 0), (1, 2)])
        for name in ('Neu.ttf', 'Neu-Italic.ttf'):
            self.assert_sane(self.path(name))

    def test_italics_alone(self):
        font = self.family(*self.italics(700, 400))
        self.assertEqual(self.values(font)[-1], ('ital', 1, 'Italic', 0, None))
        self.assertEqual([path.name for path in self.files()], ['Inter.ttf'])

    def test_the_name_goes_before_the_axes(self):
        self.made('variable', *self.upright(400, 700), *self.italics(400, 700), '--axis', 'wght', '-q', '-o', 'Neu[wght].woff2')
        self.assertEqual(sorted(path.name for path in self.files()), ['Neu-Italic[wght].woff2', 'Neu[wght].woff2'])

    def test_none_is_written_where_one_cannot_be(self):
        self.path('Neu-Italic.ttf').mkdir()
        self.refused(1, 'variable', *self.upright(400, 700), *self.italics(400, 700), '--axis', 'wght', '-q', '-o', 'Neu.ttf',
                     says=['Neu-Italic.ttf'])

    def test_a_source_is_not_written_over(self):
        source = self.write('Neu-Italic.ttf', self.statics[400, ' Italic'].read_bytes())
        self.refused(1, 'variable', *self.upright(400, 700), source, *self.italics(700), '--axis', 'wght', '-q', '-o', 'Neu.ttf',
                     says=['Neu-Italic.ttf', 'not written over'])


class Errors(Family):
    """One clear line, and nothing written."""

    def test_two_of_one_weight(self):
        again = self.changed(self.statics[400, ''], lambda font: None)
        self.refused(1, 'variable', *self.upright(100, 400), again, '--axis', 'wght', '-o', 'x.ttf', says=['one place', 'wght 400', again])

    def test_no_weight_class(self):
        def drop(font):
            font['OS/2'].usWeightClass = 0
        bad = self.changed(self.statics[700, ''], drop)
        self.refused(1, 'variable', *self.upright(100), bad, '--axis', 'wght', '-o', 'x.ttf', says=[bad, 'usWeightClass', '--stops'])
        self.made('variable', *self.upright(100), bad, '--axis', 'wght', '--stops', '100,700', '-q', '-o', 'x.ttf')

    def test_other_counts_of_stops(self):
        for stops in ('400', '100,400,700'):
            self.refused(2, 'variable', *self.upright(100, 400), '--axis', 'wght', '--stops', stops, '-o', 'x.ttf', says=['--stops', '2 fonts'])

    def test_one_alone(self):
        self.refused(2, 'variable', *self.upright(400), '--axis', 'wght', '-o', 'x.ttf', says=['two fonts'])
        self.refused(1, 'variable', *self.upright(400, 700), *self.italics(400), '--axis', 'wght', '-o', 'x.ttf', says=['only italic'])
        self.refused(1, 'variable', *self.upright(400), *self.italics(400, 700), '--axis', 'wght', '-o', 'x.ttf', says=['only upright'])

    def test_places_that_the_axis_has_not(self):
        self.refused(1, 'variable', *self.upright(100, 400), '--axis', 'wght', '--stops', '0,400', '-o', 'x.ttf', says=['wght', '0 to 400'])
        self.refused(1, 'variable', *self.upright(100, 400), '--axis', 'opsz', '-o', 'x.ttf', says=['opsz', '--stops'])

    def test_options_that_do_not_go_together(self):
        fonts = self.upright(100, 400)
        for options in (('--stops', '1,2'), ('--axis', 'wght=1..2', '--stops', '1,2'), ('--axis', 'wght', '--avar', '25:10'),
                        ('--axis', 'wght', '--style', 'Bold'), ('--axis', 'wgth'), ('--stops', '1;2', '--axis', 'wght')):
            self.refused(2, 'variable', *fonts, *options, '-o', 'x.ttf', says=options[:1])


if __name__ == '__main__':
    cli.main()
