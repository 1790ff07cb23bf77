"""Variable fonts: their tables, their instances beside the blends at the same places, how they are drawn, and their masters."""

import os
import pathlib
import subprocess

import cli
import harfbuzz
from fontTools import ttLib
from fontTools.designspaceLib import DesignSpaceDocument
from fontTools.ufoLib import UFOReader
from fontTools.varLib import instancer, interpolatable

SAMPLE = os.environ['VARIABLE_SAMPLE']
FONTS = (cli.SANS_BOLD, cli.SERIF)
HAN_FONTS = (cli.NOTO_SANS, cli.NOTO_SERIF)
PLACES = ('0', '0.1', '0.25', '0.5', '0.75', '1')

LETTERS = ''.join(map(chr, (*range(0x41, 0x5B), *range(0x61, 0x7B), *range(0x391, 0x3A2), *range(0x3A3, 0x3CA),
                            *range(0x410, 0x450))))
ACCENTED = LETTERS + ''.join(map(chr, (*range(0x30, 0x3A), *range(0xC0, 0xD7), *range(0xD8, 0xF7), *range(0xF8, 0x180))))
# Without 家: FreeType 2.12 gives up on it (Raster_Overflow) at some sizes over 256 pixels where its overlaps are looked at.
HAN = '的一是了我不人在他有这个上们来到时大地为子中你说生国年着就那和要她出也得里后自以会可下而过天去能对小多然于心分'
TEXT = 'AaBgQ&8éЖщ'

FLAG_OVERLAP = 0x40


def code_points(text):
    return ' '.join(f'{ord(c):x}' for c in text).encode()


def sampled(*arguments, text):
    """What the comparing program says of each character: its numbers."""
    result = subprocess.run([SAMPLE, *map(str, arguments)], input=code_points(text), stdout=subprocess.PIPE, check=True)
    rows = [line.split() for line in result.stdout.decode().splitlines()]
    assert len(rows) == len(text), 'not all characters were compared'
    return {chr(int(row[0], 16)): tuple(map(float, row[1:])) for row in rows}


class Variable(cli.Test):
    """What the tests share."""

    def variable(self, output, *fonts, text=TEXT, options=()):
        self.assertEqual(self.made('variable', *fonts, '-q', '--text', text, '-o', output, *options), [])
        return self.path(output)

    def blends(self, fonts, text, places=PLACES):
        """The font at each place, by the place."""
        self.made('blend', *fonts, '-q', '--text', text, '--at', ','.join(places), '-o', 'blend.ttf')
        return {place: self.path(f'blend-{place}.ttf') for place in places}

    def instance(self, font, place):
        """By fontTools."""
        made = instancer.instantiateVariableFont(ttLib.TTFont(font), {'MORF': 100 * float(place)})
        made.save(self.path('instance.ttf'))
        return self.path('instance.ttf')

    def fontmade(self, document):
        """A variable font of the masters, by fontmake."""
        made = self.path('made.ttf')
        subprocess.run(['fontmake', '-m', self.path(document), '-o', 'variable', '--output-path', made],
                       check=True, cwd=self.directory, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        self.assert_sane(made)
        return made

    def assert_sane(self, path):
        subprocess.run(['ots-sanitize', path], check=True, stdout=subprocess.DEVNULL)


class Font(Variable):
    """The tables, and the options."""

    def test_axis_and_names(self):
        path = self.variable('x.ttf', *FONTS, options=('--family', 'Sample'))
        self.assert_sane(path)
        font = ttLib.TTFont(path, lazy=False)
        name = font['name'].getDebugName
        axis, = font['fvar'].axes
        self.assertEqual((axis.axisTag, axis.minValue, axis.defaultValue, axis.maxValue, name(axis.axisNameID)),
                         ('MORF', 0, 0, 100, 'Morph'))
        places = {p: f'Morph {p}' for p in (0, 25, 50, 75, 100)}
        self.assertEqual({i.coordinates['MORF']: name(i.subfamilyNameID) for i in font['fvar'].instances}, places)
        stat = font['STAT'].table
        self.assertEqual([a.AxisTag for a in stat.DesignAxisRecord.Axis], ['MORF'])
        self.assertEqual({v.Value: name(v.ValueNameID) for v in stat.AxisValueArray.AxisValue}, places)
        self.assertEqual((name(16), name(17), name(25)), ('Sample', 'Morph 0', 'Sample'))
        self.assertIn('DejaVu Sans Bold, version 2.37 (MORF = 0) and DejaVu Serif Book, version 2.37 (MORF = 100)', name(10))
        self.assertNotIn('avar', font)

    def test_the_font_as_it_stands_is_the_first(self):
        font = ttLib.TTFont(self.variable('x.ttf', *FONTS))
        blend = ttLib.TTFont(self.blends(FONTS, TEXT, ('0', '1'))['0'])
        self.assertEqual(font['hmtx'].metrics.keys(), blend['hmtx'].metrics.keys())
        self.assertEqual({n: a for n, (a, _) in font['hmtx'].metrics.items()},
                         {n: a for n, (a, _) in blend['hmtx'].metrics.items()})

    def test_same_bytes_for_any_number_of_threads(self):
        fonts = {self.variable(f'{jobs}.ttf', *FONTS, options=('-j', jobs)).read_bytes() for jobs in (1, 2, 5)}
        self.assertEqual(len(fonts), 1)

    def test_references_are_kept_and_move(self):
        font = ttLib.TTFont(self.variable('x.ttf', *FONTS, text='eé´'))
        glyph = font['glyf'][font.getBestCmap()[ord('é')]]
        self.assertTrue(glyph.isComposite())
        variations = font['gvar'].variations[font.getBestCmap()[ord('é')]]
        self.assertTrue(any(any(c not in (None, (0, 0)) for c in v.coordinates[:2]) for v in variations))

    def test_overlap_flag_stands_where_contours_overlap(self):
        font = ttLib.TTFont(self.variable('x.ttf', *HAN_FONTS, text='分一'))
        flags = {c: font['glyf'][font.getBestCmap()[ord(c)]].flags[0] & FLAG_OVERLAP for c in '分一'}
        self.assertEqual(flags, {'分': FLAG_OVERLAP, '一': 0})

    def test_paper_method(self):
        path = self.variable('x.ttf', *FONTS, text='AEeo', options=('--method', 'paper'))
        self.assert_sane(path)
        self.made('blend', *FONTS, '-q', '--text', 'AEeo', '--method', 'paper', '--at', '0.5', '-o', 'b.ttf')
        compared = sampled('compare', 'freetype', path, 50, self.path('b.ttf'), text='AEeo')
        self.assertGreaterEqual(min(share for share, *_ in compared.values()), 0.99)

    def test_rotation_follows_the_arc(self):
        path = self.variable('x.ttf', *FONTS, text='AEeo', options=('--rotate', '90'))
        self.assert_sane(path)
        for place in ('0.25', '0.5', '0.8'):
            self.made('blend', *FONTS, '-q', '--text', 'AEeo', '--rotate', '90', '--at', place, '-o', 'b.ttf')
            compared = sampled('apart', 'freetype', path, 100 * float(place), self.path('b.ttf'), text='AEeo')
            self.assertGreaterEqual(min(share for share, *_ in compared.values()), 0.98)
            # The e is cut here, and a part of it ends as a hairline, which a static font leaves out where it is a seam.
            self.assertLessEqual(max(compared[c][-1] for c in 'AEo'), 3)

    def test_first_fonts_glyphs(self):
        self.write('second.txt', 'unused')
        second = cli.cut_font(self.path('second.ttf'), 'Aa')
        path = self.path('x.ttf')
        lines = self.made('variable', cli.SANS_BOLD, second, '--text', 'AaB', '--glyphs', 'first', '-o', path)
        self.assertTrue(any('not stay' in line for line in lines), lines)
        compared = {place: sampled('compare', 'freetype', path, place, cli.SANS_BOLD, text='B') for place in (0, 60, 100)}
        for place, glyphs in compared.items():
            self.assertGreaterEqual(glyphs['B'][0], 0.995, place)
            self.assertEqual(glyphs['B'][1], 0, place)

    def test_a_glyph_that_cannot_be_blended_switches_half_way(self):
        second = cli.cut_font(self.path('second.ttf'), 'AaB', blank='B')
        lines = self.made('variable', cli.SANS_BOLD, second, '--text', 'AaB', '-o', 'x.ttf')
        self.assertTrue(any(line.startswith('morphotype: “B” (U+0042): not blended') for line in lines), lines)
        self.assert_sane(self.path('x.ttf'))
        for place in (0, 25, 49.99):
            glyph = sampled('compare', 'freetype', self.path('x.ttf'), place, cli.SANS_BOLD, text='B')['B']
            self.assertGreaterEqual(glyph[0], 0.995, place)
        for place in (50, 75, 100):
            glyph = sampled('compare', 'freetype', self.path('x.ttf'), place, cli.SANS_BOLD, text='B')['B']
            self.assertEqual(glyph[0], 0, place)

    def test_strict(self):
        second = cli.cut_font(self.path('second.ttf'), 'AaB', blank='B')
        result = self.run_program('variable', cli.SANS_BOLD, second, '--text', 'AaB', '-o', 'x.ttf', '--strict')
        self.assertEqual(result.returncode, 1)
        self.assertFalse(self.path('x.ttf').exists())

    def test_other_formats_are_refused(self):
        self.refused(2, 'variable', *FONTS, '-o', 'x.ufo', says=('x.ufo', '.ttf, .woff2 and .designspace'))
        self.refused(2, 'variable', *FONTS, says=('-o',))
        self.refused(2, 'variable', FONTS[0], '-o', 'x.ttf', says=('two fonts',))
        self.refused(2, 'blend', *FONTS, '-o', 'x.designspace', says=('x.designspace',))

    def test_woff2(self):
        plain, packed = self.variable('x.ttf', *FONTS), self.variable('x.woff2', *FONTS)
        self.assert_sane(packed)
        self.assertLess(packed.stat().st_size, plain.stat().st_size)
        ours, theirs = ttLib.TTFont(packed, lazy=False), ttLib.TTFont(plain, lazy=False)
        for tag in ('gvar', 'fvar', 'STAT', 'HVAR', 'MVAR'):
            self.assertEqual(ours.getTableData(tag), theirs.getTableData(tag), tag)


    def test_woff2_keeps_the_flags_of_overlaps(self):
        packed = self.variable('x.woff2', *HAN_FONTS, text='分一')
        self.assert_sane(packed)
        ours = ttLib.TTFont(packed, lazy=False)
        theirs = ttLib.TTFont(self.variable('x.ttf', *HAN_FONTS, text='分一'), lazy=False)
        self.assertEqual(set(ours.keys()), set(theirs.keys()))
        for tag in set(theirs.keys()) - {'GlyphOrder'}:
            self.assertEqual(ours.getTableData(tag), theirs.getTableData(tag), tag)


class Instances(Variable):
    """Instances by fontTools, FreeType and HarfBuzz are the blends at the same places."""

    def compared(self, fonts, text):
        """For each engine, what the comparing program says of all places' glyphs."""
        font, blends = self.variable('x.ttf', *fonts, text=text), self.blends(fonts, text)
        found = {'freetype': [], 'harfbuzz': [], 'fontTools': []}
        for place, blend in blends.items():
            for engine in ('freetype', 'harfbuzz'):
                found[engine] += sampled('compare', engine, font, 100 * float(place), blend, text=text).values()
            instance = self.instance(font, place)
            self.assert_sane(instance)
            found['fontTools'] += sampled('compare', 'none', instance, 0, blend, text=text).values()
        return found

    def assert_alike(self, fonts, text):
        for engine, glyphs in self.compared(fonts, text).items():
            shares = sorted(share for share, *_ in glyphs)
            self.assertGreaterEqual(shares[len(shares) // 2], 0.998, engine)
            self.assertGreaterEqual(shares[len(shares) // 20], 0.99, engine)
            self.assertLessEqual(max(abs(longer) for _, longer in glyphs), 1, engine)

    def test_latin_greek_cyrillic(self):
        self.assert_alike(FONTS, ACCENTED)

    def test_han(self):
        self.assert_alike(HAN_FONTS, HAN)


class Ends(Variable):
    """The font at both ends is its sources, within 1/1000 em."""

    def assert_ends(self, fonts, text, truths=None):
        font = self.variable('x.ttf', *fonts, text=text)
        for place, source in zip((0, 100), truths or fonts):
            for character, (*_, apart) in sampled('apart', 'freetype', font, place, source, text=text).items():
                self.assertLessEqual(apart, 1, (character, place))

    def test_latin_greek_cyrillic(self):
        """But for ţ: DejaVu Sans Bold's t and its cedilla enclose a wedge whose tip is too thin for its units, and closes."""
        self.assert_ends(FONTS, ACCENTED.replace('ţ', ''))

    def test_han(self):
        self.assert_ends(HAN_FONTS, HAN)

    def test_sources_that_vary(self):
        """Each stands at the place that is named, or at its default; MORF is the only axis. fontTools has the sources there."""
        second, sans = self.path('second.ttf'), cli.DEBIAN / 'truetype/dejavu/DejaVuSans.ttf'
        self.made('variable', sans, cli.SANS_BOLD, '--axis', 'wght', '--text', LETTERS, '-q', '-o', second)
        for place, weight in (('', 400), ('@wght=700', 700)):
            truths = [self.path(name) for name in ('a.ttf', 'b.ttf')]
            for source, truth in zip((cli.INTER, second), truths):
                instancer.instantiateVariableFont(ttLib.TTFont(source), {'wght': weight}).save(truth)
            self.assert_ends((f'{cli.INTER}{place}', f'{second}{place}'), LETTERS, truths)
            self.assertEqual([axis.axisTag for axis in ttLib.TTFont(self.path('x.ttf'))['fvar'].axes], ['MORF'])


class Pixels(Variable):
    """Drawn by FreeType: no hairline and no dark join wider than 1/1000 em, at any size."""

    def assert_clean(self, fonts, text):
        font, blends = self.variable('x.ttf', *fonts, text=text), self.blends(fonts, text)
        for place, blend in blends.items():
            for size in (12, 24, 96, 400):
                for other in ((), (blend,)):
                    found = sampled('pixels', font, 100 * float(place), size, *other, text=text)
                    for character, (darker, lighter, in_white, in_black) in found.items():
                        self.assertLessEqual(max(in_white, in_black), 255 * size / 1000, (character, place, size))
                        if not other:
                            self.assertLessEqual(max(darker, lighter), 40, (character, place, size))

    def test_letters(self):
        self.assert_clean(FONTS, LETTERS)

    def test_han(self):
        self.assert_clean(HAN_FONTS, HAN)


class Stops(Variable):
    """More than two fonts."""

    FONTS = (cli.SANS_BOLD, cli.SERIF, cli.MONO)
    TEXT = 'ABEGKQRSabegkqsy059ЖщдфéÅ'

    def test_each_step_is_the_blend_of_its_fonts(self):
        font = self.variable('x.ttf', *self.FONTS, text=self.TEXT)
        self.assert_sane(font)
        for step in (0, 1):
            blends = self.blends(self.FONTS[step:step + 2], self.TEXT, ('0', '0.3', '0.5', '1'))
            for place, blend in blends.items():
                value = 50 * (step + float(place))
                for engine in ('freetype', 'harfbuzz'):
                    self.assert_same(sampled('compare', engine, font, value, blend, text=self.TEXT), (engine, value))
                instance = self.instance(font, value / 100)
                self.assert_same(sampled('compare', 'none', instance, 0, blend, text=self.TEXT), ('fontTools', value))

    def assert_same(self, glyphs, where):
        shares = sorted(share for share, *_ in glyphs.values())
        self.assertGreaterEqual(shares[len(shares) // 2], 0.997, where)
        self.assertGreaterEqual(shares[0], 0.98, where)
        self.assertLessEqual(max(abs(longer) for _, longer in glyphs.values()), 1, where)

    def test_nothing_lies_between_a_stop_and_the_next_place(self):
        """The axis has 2^14 places; the stop's contours are there up to it, and the next step's from the place after it on."""
        font = self.variable('x.ttf', *self.FONTS, text=self.TEXT)
        blend = self.blends(self.FONTS[1:], self.TEXT, ('0', '1'))['0']
        for place in (8191, 8192, 8193, 8194):
            for engine in ('freetype', 'harfbuzz'):
                glyphs = sampled('compare', engine, font, 100 * place / 16384, blend, text=self.TEXT)
                self.assert_same(glyphs, (engine, place))
            self.assert_same(sampled('compare', 'none', self.instance(font, place / 16384), 0, blend, text=self.TEXT), place)

    def test_stops_that_are_no_quarters_have_names(self):
        font = ttLib.TTFont(self.variable('x.ttf', *self.FONTS, cli.MONO_BOLD, text='Aa'))
        values = [i.coordinates['MORF'] for i in font['fvar'].instances]
        self.assertEqual([round(v, 2) for v in values], [0, 25, 33.33, 50, 66.67, 75, 100])
        for value in values:
            place = value / 100 * 16384
            self.assertAlmostEqual(place, round(place), 2, 'not where the font stands')

    def test_only_what_all_fonts_have(self):
        second = cli.cut_font(self.path('second.ttf'), 'ABC')
        self.write('chars.txt', 'ABCD')
        self.made('variable', cli.SANS_BOLD, second, cli.MONO, '--chars', 'chars.txt', '-o', 'x.ttf', '-q')
        self.assertEqual(sorted(map(chr, ttLib.TTFont(self.path('x.ttf')).getBestCmap())), ['A', 'B', 'C'])


class Map(Variable):
    """--avar: how far the font gets where users set its axis."""

    MAP = ('--avar', '25:10,50:40')
    SEGMENTS = ((-1, -1), (0, 0), (0.25, 0.1), (0.5, 0.4), (1, 1))
    LEADS = {0: 0, 25: 10, 37.5: 25, 50: 40, 75: 70, 100: 100}
    THREE = (*FONTS, cli.MONO)

    def segments(self, font):
        return tuple(sorted(ttLib.TTFont(font)['avar'].segments['MORF'].items()))

    def assert_leads(self, segments, wanted):
        self.assertEqual(len(segments), len(wanted))
        for got, exact in zip(segments, wanted):
            for a, b in zip(got, exact):
                self.assertLessEqual(abs(a - b), 0.5 / 16384)

    def test_table(self):
        path = self.variable('x.ttf', *FONTS, options=self.MAP)
        self.assert_sane(path)
        self.assertEqual(ttLib.TTFont(path).getTableData('avar')[:10].hex(), '00010000' '0000' '0001' '0005')
        self.assert_leads(self.segments(path), self.SEGMENTS)

    def test_ends_may_be_said(self):
        plain = self.variable('x.ttf', *FONTS, options=self.MAP).read_bytes()
        said = self.variable('y.ttf', *FONTS, options=('--avar', '0:0,25:10,50:40,100:100')).read_bytes()
        self.assertEqual(plain, said)
        self.assert_leads(self.segments(self.variable('z.ttf', *FONTS, options=('--avar', '0:0'))), ((-1, -1), (0, 0), (1, 1)))

    def test_nothing_else_of_two_fonts_changes(self):
        ours = ttLib.TTFont(self.variable('x.ttf', *FONTS, options=self.MAP), lazy=False)
        theirs = ttLib.TTFont(self.variable('y.ttf', *FONTS), lazy=False)
        self.assertEqual(set(ours.keys()) - set(theirs.keys()), {'avar'})
        for tag in set(theirs.keys()) - {'GlyphOrder', 'head'}:
            self.assertEqual(ours.getTableData(tag), theirs.getTableData(tag), tag)

    def assert_glyphs_alike(self, ours, theirs, where):
        """Both by fontTools: the points and the advances, within a unit."""
        ours, theirs = ttLib.TTFont(ours), ttLib.TTFont(theirs)
        for name in theirs.getGlyphOrder():
            a, b = (font['glyf'][name].getCoordinates(font['glyf'])[0] for font in (ours, theirs))
            self.assertEqual(len(a), len(b), (where, name))
            for p, q in zip(a, b):
                self.assertLessEqual(max(abs(p[0] - q[0]), abs(p[1] - q[1])), 1, (where, name))
            self.assertLessEqual(abs(ours['hmtx'][name][0] - theirs['hmtx'][name][0]), 1, (where, name))

    def assert_instances(self, fonts):
        mapped, plain = self.variable('x.ttf', *fonts, options=self.MAP), self.variable('y.ttf', *fonts)
        units = ttLib.TTFont(plain)['head'].unitsPerEm
        for value, place in self.LEADS.items():
            instance = self.path('plain.ttf')
            self.instance(plain, place / 100).rename(instance)
            self.assert_glyphs_alike(self.instance(mapped, value / 100), instance, value)
            for engine in ('freetype', 'harfbuzz'):
                for character, (_, longer, apart) in sampled('apart', engine, mapped, value, instance, text=TEXT).items():
                    self.assertLessEqual(apart * units / 1000, 1, (engine, value, character))
                    self.assertLessEqual(abs(longer), 1, (engine, value, character))

    def test_instances(self):
        self.assert_instances(FONTS)

    def test_instances_of_three(self):
        self.assert_instances(self.THREE)

    def test_named_places_of_fonts_in_between_show_them(self):
        """Also where places between two places of the tables would show contours on their way to a point."""
        fonts = (*FONTS, cli.MONO, cli.SERIF)
        font = self.variable('x.ttf', *fonts, options=('--avar', '17:11.3,33.334:33.33,81.7:53.1'))
        values = [i.coordinates['MORF'] for i in ttLib.TTFont(font)['fvar'].instances]
        middle = [v for v in values if v not in (0, 25, 50, 75, 100)]
        self.assertEqual(len(middle), 2)
        for value, source in zip(middle, fonts[1:]):
            for engine in ('freetype', 'harfbuzz'):
                found = sampled('compare', engine, font, value, source, text=TEXT)
                self.assertGreaterEqual(min(share for share, _ in found.values()), 0.98, (engine, value))

    def test_fonts_in_between_are_named_where_users_find_them(self):
        font = ttLib.TTFont(self.variable('x.ttf', *self.THREE, options=self.MAP), lazy=False)
        name = font['name'].getDebugName
        places = {round(i.coordinates['MORF'], 2): name(i.subfamilyNameID) for i in font['fvar'].instances}
        self.assertEqual(places, {0: 'Morph 0', 25: 'Morph 25', 50: 'Morph 50', 58.33: 'Morph 58.33', 75: 'Morph 75',
                                  100: 'Morph 100'})
        self.assertEqual({round(v.Value, 2): name(v.ValueNameID) for v in font['STAT'].table.AxisValueArray.AxisValue}, places)
        self.assertIn('(MORF = 58.33)', name(10))

    def test_masters(self):
        self.variable('x.designspace', *FONTS, options=self.MAP)
        document = DesignSpaceDocument.fromfile(self.path('x.designspace'))
        axis, = document.axes
        self.assertEqual((axis.minimum, axis.default, axis.maximum), (0, 0, 100))
        self.assertEqual(axis.map, [(0, 0), (25, 10), (50, 40), (100, 100)])
        self.assertEqual([source.location['Morph'] for source in document.sources], [0, 100])
        self.assertEqual({i.styleName: i.location['Morph'] for i in document.instances},
                         {'Morph 0': 0, 'Morph 25': 10, 'Morph 50': 40, 'Morph 75': 70, 'Morph 100': 100})

    def test_fontmake_builds_the_same_map(self):
        self.variable('x.designspace', *self.THREE, options=self.MAP)
        made = self.fontmade('x.designspace')
        self.assert_leads(self.segments(made), self.SEGMENTS)
        self.assertEqual([i.coordinates['MORF'] for i in ttLib.TTFont(made)['fvar'].instances], [0, 25, 50, 75, 100])
        ours = self.variable('x.ttf', *self.THREE, options=self.MAP)
        compared = sampled('compare', 'freetype', made, 25, self.instance(ours, 0.25), text=TEXT)
        self.assertGreaterEqual(min(share for share, *_ in compared.values()), 0.99)

    def test_what_is_no_map_is_refused(self):
        for text in ('', '25', '25:', ':10', '25:10,', ',25:10', '25:10:5', '25;10', '25:10 ', 'nan:10', '25:inf', '0x10:10', '-1:0',
                     '25:-1', '101:100', '25:101', '0:5', '100:95', '25:30,50:20', '50:20,25:30', '25:10,25:20',
                     '50:10,50.001:20', '99.999:50', '0:0,0:0'):
            with self.subTest(text=text):
                self.refused(2, 'variable', *FONTS, '--text', 'A', '-o', 'x.ttf', f'--avar={text}', says=('--avar', '--help)'))
        self.refused(2, 'blend', *FONTS, '--avar', '25:10', '-o', 'x.ttf', says=('--avar',))


class Masters(Variable):
    """A designspace of masters with the same points."""

    def masters(self, *fonts, text):
        self.variable('x.designspace', *fonts, text=text)
        document = DesignSpaceDocument.fromfile(self.path('x.designspace'))
        return document, [source.path for source in document.sources]

    def test_are_compatible(self):
        document, paths = self.masters(*FONTS, text=LETTERS)
        self.assertEqual([source.location['Morph'] for source in document.sources], [0, 100])
        self.assertFalse(interpolatable.main(paths))

    def test_han_are_compatible(self):
        document, paths = self.masters(*HAN_FONTS, text='一十上下中')
        self.assertFalse(interpolatable.main(paths))

    def test_fontmake_builds_them(self):
        for fonts in (FONTS, Stops.FONTS):
            self.masters(*fonts, text=TEXT)
            made = self.fontmade('x.designspace')
            blend = self.blends(fonts[:2], TEXT, ('0.5', '1'))['0.5']
            value = 50 if len(fonts) == 2 else 25
            compared = sampled('compare', 'freetype', made, value, blend, text=TEXT)
            self.assertGreaterEqual(min(share for share, *_ in compared.values()), 0.99)

    def test_kerning_is_by_the_same_groups_and_pairs(self):
        """Also where a pair is 0 in one master, so that programs mix it as it is."""
        _, paths = self.masters(*FONTS, text='AVTWLPoaevy.,-')
        groups, kerning = zip(*((reader.readGroups(), reader.readKerning()) for reader in map(UFOReader, paths)))
        self.assertGreater(len(groups[0]), 10)
        self.assertEqual(*groups)
        self.assertEqual(*(set(pairs) for pairs in kerning))
        self.assertNotEqual(*kerning)

    def test_fontmake_makes_instances(self):
        """Without further options, in the files that the document names, and kerned as blends are."""
        text = 'AVATAVTOWave.'
        document, _ = self.masters(*FONTS, text=text)
        names = [pathlib.PurePath(instance.filename) for instance in document.instances]
        self.assertEqual({name.parent.name for name in names}, {'instances'})
        self.assertEqual(len(set(names)), len(names))
        subprocess.run(['fontmake', '-m', 'x.designspace', '-i', '--output-dir', 'made'], cwd=self.directory, check=True,
                       stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        self.made('blend', *FONTS, '--text', text, '--at', '0.25,0.5', '-q', '-o', 'y.ttf')
        for t in (0.25, 0.5):
            wanted = [advance for _, advance, _, _ in harfbuzz.shape(self.path(f'y-{t}.ttf'), text)]
            for kind in ('ttf', 'otf'):
                path, = self.path('made').glob(f'*-{round(100 * t)}.{kind}')
                made = [advance for _, advance, _, _ in harfbuzz.shape(path, text)]
                self.assertLessEqual(max(abs(a - b) for a, b in zip(made, wanted, strict=True)), 2)

    def test_old_ones_are_replaced_and_others_are_not(self):
        self.masters(*FONTS, text='AB')
        self.masters(*FONTS, text='A')
        self.assertEqual(len(list(self.path('x-masters').iterdir())), 2)
        self.path('y-masters').mkdir()
        self.write('y-masters/notes.txt', 'mine')
        self.refused(1, 'variable', *FONTS, '--text', 'A', '-o', 'y.designspace', says=('y.designspace',))


class WholeFont(Variable):
    """DejaVu Sans Bold and DejaVu Serif, all that they share."""

    def test_size(self):
        self.made('variable', *FONTS, '-q', '-o', 'x.ttf')
        self.assert_sane(self.path('x.ttf'))
        sources = [ttLib.TTFont(path) for path in FONTS]
        glyf = sum(len(font.getTableData('glyf')) for font in sources)
        self.assertLessEqual(self.path('x.ttf').stat().st_size, 3 * glyf)


if __name__ == '__main__':
    cli.main()
