"""What a person chooses: forms that text asks for, forms of a source, characters alone, pairs of glyphs."""

import json
import subprocess

import cli
from fontTools import ttLib
from fontTools.fontBuilder import FontBuilder
from fontTools.feaLib.builder import addOpenTypeFeaturesFromString
from fontTools.pens.ttGlyphPen import TTGlyphPen
from fontTools.varLib import instancer

LIBERTINE = cli.DEBIAN / 'opentype/linux-libertine/LinLibertine_R.otf'
BIOLINUM = cli.DEBIAN / 'opentype/linux-libertine/LinBiolinum_R.otf'
NO_MATH = f'morphotype: colour, bitmap and math tables are left out: MATH of {LIBERTINE}'


def features_of(font):
    return {record.FeatureTag for record in font['GSUB'].table.FeatureList.FeatureRecord}


class Alternates(cli.Test):
    """Of --text and --chars, a font has the forms that shaping makes by itself; with --alternates, all."""

    def glyphs(self, *arguments, command='blend', output='x.ttf'):
        self.said = self.made(command, LIBERTINE, BIOLINUM, *arguments, '-o', output)
        self.font = ttLib.TTFont(self.path(output))
        return set(self.font.getGlyphOrder())

    def test_without(self):
        names = self.glyphs('--text', 'Haffi 12')
        self.assertEqual(names, {'.notdef', 'space', 'H', 'a', 'f', 'i', 'one', 'two', 'f_f', 'f_i', 'f_f_i'})
        self.assertIn('liga', features_of(self.font))
        self.assertFalse({'smcp', 'onum', 'sups'} & features_of(self.font))
        line, = (line for line in self.said if '--alternates' in line)
        self.assertRegex(line, r'^morphotype: \d+ glyphs left out that text has to ask for \(.*\bonum\b.*\bsmcp\b.*\): '
                               '--alternates keeps them$')
        self.assertNotIn('liga', line)
        self.assertEqual(self.run_program('blend', LIBERTINE, BIOLINUM, '--text', 'Haffi 12', '-q', '-o', 'x.ttf').stderr, b'')

    def test_as_many_as_said(self):
        few = self.glyphs('--chars', self.write('chars', 'Haffi 12'))
        said, = (int(line.split()[1]) for line in self.said if '--alternates' in line)
        all_of_them = self.glyphs('--chars', self.path('chars'), '--alternates')
        self.assertLess(few, all_of_them)
        self.assertEqual(len(all_of_them - few), said)
        self.assertLess({'a.sc', 'one.oldstyle', 'one.superior'}, all_of_them)
        self.assertIn('smcp', features_of(self.font))
        self.assertFalse(any('--alternates' in line for line in self.said), self.said)

    def test_fractions(self):
        """HarfBuzz makes fractions around U+2044 without being asked."""
        self.assertIn('one.superior', self.glyphs('--text', '12⁄'))
        self.assertNotIn('one.superior', self.glyphs('--text', '12/'))

    def test_pictures_and_variable_fonts(self):
        self.assertNotIn('a.sc', self.glyphs('--text', 'aH', command='variable'))
        self.assertTrue(any('--alternates' in line for line in self.said), self.said)
        self.assertIn('a.sc', self.glyphs('--text', 'aH', '--alternates', command='variable'))
        self.assertEqual(self.made('strip', LIBERTINE, BIOLINUM, '--text', 'aH', '--steps', 2, '-o', 'x.png'), [])

    def test_whole_fonts_keep_them(self):
        cut = cli.cut_font(self.path('cut.ttf'), 'AB')
        self.assertEqual(self.made('blend', cut, cut, '-o', 'x.ttf'), self.made('blend', cut, cut, '--alternates', '-o', 'y.ttf'))
        self.assertEqual(self.path('x.ttf').read_bytes(), self.path('y.ttf').read_bytes())

    def test_usage(self):
        self.refused(2, 'strip', LIBERTINE, BIOLINUM, '--text', 'a', '--alternates', '-o', 'x.png', says=['--alternates'])


class Forms(cli.Test):
    """FILE:FEATURE,…: the source's characters in these forms."""

    def setUp(self):
        super().setUp()
        font = ttLib.TTFont(cli.cut_font(self.path('base.ttf'), 'ABCDEFG12'))
        addOpenTypeFeaturesFromString(font, """
            languagesystem DFLT dflt; languagesystem latn dflt;
            lookup inner { sub A by F; } inner;
            feature salt { sub A from [B C D]; } salt;
            feature ss01 { sub A by E; sub one by two; } ss01;
            feature ss02 { sub B by C D; sub C by G; } ss02;
            feature ss03 { sub D A' lookup inner; } ss03;
        """)
        font.save(self.path('F.ttf'))

    def drawn(self, font, text):
        """The outlines and advances of these characters."""
        if not isinstance(font, ttLib.TTFont):
            font = ttLib.TTFont(self.path(font))
        names = font.getBestCmap()
        return [(font['glyf'][names[ord(c)]].getCoordinates(font['glyf'])[0], font['hmtx'][names[ord(c)]][0]) for c in text]

    def assert_drawn_as(self, spec, text, like, at=0, order=lambda f: (f, 'F.ttf')):
        self.made('blend', *order(spec), '--no-layout', '--at', at, '-o', 'x.ttf')
        self.made('blend', 'F.ttf', 'F.ttf', '--no-layout', '--at', at, '-o', 'y.ttf')
        self.assertEqual(self.drawn('x.ttf', text), self.drawn('y.ttf', like))

    def test_first(self):
        self.assert_drawn_as('F.ttf:ss01', 'ABCDE12', 'EBCDE22')
        self.assert_drawn_as('F.ttf:salt', 'ABC', 'BBC')
        self.assert_drawn_as('F.ttf:salt=3,ss01=0', 'ABC', 'DBC')
        self.assert_drawn_as('F.ttf:salt=2,ss02', 'ABCD1', 'GBGD1')

    def test_second(self):
        self.assert_drawn_as('F.ttf:ss01', 'ABCDE12', 'EBCDE22', at=1, order=lambda f: ('F.ttf', f))

    def test_both_with_layout(self):
        """Text has the forms without a feature, and the features of the font go on from there."""
        self.made('blend', 'F.ttf:salt', 'F.ttf:salt', '-o', 'x.ttf')
        font = ttLib.TTFont(self.path('x.ttf'))
        self.assertEqual(font.getBestCmap()[ord('A')], font.getBestCmap()[ord('B')])
        self.assertEqual(features_of(font), {'ss01', 'ss02'})

    def test_oldstyle_figures(self):
        self.made('blend', f'{LIBERTINE}:onum', f'{BIOLINUM}:onum', '--text', '01', '--at', 0, '-o', 'x.ttf')
        font, source = ttLib.TTFont(self.path('x.ttf')), ttLib.TTFont(LIBERTINE)
        name = font.getBestCmap()[ord('1')]
        self.assertIn('oldstyle', name)
        scale = font['head'].unitsPerEm / source['head'].unitsPerEm
        self.assertAlmostEqual(font['hmtx'][name][0], source['hmtx'][name][0] * scale, delta=1)

    def test_every_command(self):
        for command, output in (('blend', 'x.ttf'), ('variable', 'v.ttf'), ('strip', 'x.png'), ('sheet', 'x.pdf'), ('report', 'x.json'),
                                ('inspect', 'i.json'), ('specimen', 'x.html')):
            self.made(command, 'F.ttf:ss01', 'F.ttf:salt=2', '--text', 'A', '-q', '-o', output)
        side = json.loads(self.path('i.json').read_text())['glyphs'][0]
        self.made('inspect', 'F.ttf', 'F.ttf', '--text', 'EC', '-o', 'i.json')
        e, c = json.loads(self.path('i.json').read_text())['glyphs']
        self.assertEqual((side['a'], side['b']), (e['a'], c['a']))

    def test_said(self):
        self.assertIn('morphotype: no character of F.ttf:ss03 has another form by these features',
                      self.made('blend', 'F.ttf:ss03', 'F.ttf', '-o', 'x.ttf'))

    def test_file_names(self):
        for name in ('C:F.ttf', 'F.ttf:ss01'):
            self.path(name).write_bytes(self.path('F.ttf').read_bytes())
            self.made('blend', name, 'F.ttf', '-o', 'x.ttf')
            self.assertEqual(ttLib.TTFont(self.path('x.ttf')).getBestCmap()[ord('A')], 'A')
        self.assert_drawn_as('C:F.ttf:ss01', 'A', 'E')

    def test_wrong(self):
        for command, output in (('blend', 'x.ttf'), ('strip', 'x.png'), ('inspect', 'x.svg'), ('variable', 'x.ttf')):
            self.refused(1, command, 'F.ttf:ss09', 'F.ttf', '--text', 'A', '-o', output, says=['F.ttf:ss09', 'feature'])
            self.refused(1, command, 'F.ttf', 'F.ttf:ss01,kern', '--text', 'A', '-o', output, says=['F.ttf:ss01,kern'])
            for wrong in (':', ':ss01,', ':salt=', ':salt=x', ':salt=256', ':ligature', ':ss01,ss01', ':ss01#0'):
                self.refused(2, command, 'F.ttf', 'F.ttf' + wrong, '--text', 'A', '-o', output, says=['F.ttf' + wrong, '--help'])


class NoLayout(cli.Test):
    """--no-layout: characters, and nothing that text does with them."""

    def test_tables(self):
        for command in ('blend', 'variable'):
            said = self.made(command, LIBERTINE, BIOLINUM, '--text', 'Affiá', '--no-layout', '-o', 'x.ttf')
            self.assertEqual(said, [NO_MATH])
            font = ttLib.TTFont(self.path('x.ttf'))
            self.assertFalse({'GSUB', 'GPOS', 'GDEF', 'kern'} & set(font.keys()))
            self.assertEqual(font.getGlyphOrder(), ['.notdef', 'A', 'f', 'i', 'aacute'])

    def test_whole_font(self):
        font = ttLib.TTFont(cli.cut_font(self.path('F.ttf'), 'ABé'))
        self.assertGreater(len(font.getGlyphOrder()), 4) # parts of é, which no character leads to
        self.made('blend', 'F.ttf', 'F.ttf', '--no-layout', '-o', 'x.ttf')
        made = ttLib.TTFont(self.path('x.ttf'))
        self.assertEqual(set(made.getGlyphOrder()), {'.notdef', *made.getBestCmap().values()})

    def test_usage(self):
        self.refused(2, 'blend', cli.SERIF, cli.SERIF, '--no-layout', '--alternates', '-o', 'x.ttf', says=['--no-layout'])
        self.refused(2, 'inspect', cli.SERIF, '--no-layout', '--text', 'A', '-o', 'x.svg', says=['--no-layout'])


def icon(shape, size):
    """A square, a triangle or a ring, of this size."""
    pen = TTGlyphPen(None)
    contours = {'square': [[(0, 0), (0, size), (size, size), (size, 0)]],
                'triangle': [[(0, 0), (size // 2, size), (size, 0)]],
                'ring': [[(0, 0), (0, size), (size, size), (size, 0)],
                         [(size // 4, size // 4), (3 * size // 4, size // 4), (3 * size // 4, 3 * size // 4), (size // 4, 3 * size // 4)]]}
    for contour in contours[shape]:
        pen.moveTo(contour[0])
        for point in contour[1:]:
            pen.lineTo(point)
        pen.closePath()
    return pen.glyph()


def icon_font(path, icons, names=True):
    """A font of icons without any layout: NAME: (code point or None, shape, size)."""
    builder = FontBuilder(1000, isTTF=True)
    builder.setupGlyphOrder(['.notdef', *icons])
    builder.setupCharacterMap({code: name for name, (code, _, _) in icons.items() if code})
    builder.setupGlyf({'.notdef': icon('square', 10), **{name: icon(shape, size) for name, (_, shape, size) in icons.items()}})
    builder.setupHorizontalMetrics({'.notdef': (500, 0), **{name: (size + 100, 0) for name, (_, _, size) in icons.items()}})
    builder.setupHorizontalHeader(ascent=800, descent=-200)
    builder.setupNameTable({'familyName': path.stem, 'styleName': 'Regular'})
    builder.setupOS2(fsType=0)
    builder.setupPost(keepGlyphNames=names)
    builder.save(path)


class Icons(cli.Test):
    """Two fonts with icons of the same names, most for other code points."""

    def setUp(self):
        super().setUp()
        icon_font(self.path('A.ttf'), {'home': (0xE001, 'square', 400), 'car': (0xE002, 'triangle', 400), 'star': (0xE003, 'ring', 400),
                                       'spare': (None, 'square', 200)})
        icon_font(self.path('B.ttf'), {'car': (0xE001, 'triangle', 800), 'star': (0xF005, 'ring', 800), 'home': (0xF015, 'square', 800),
                                       'extra': (None, 'ring', 600)})
        self.write('pairs', '# icons of the same name\nhome home\n/car  /car # by name\n\nU+E003\tu+f005\n')


class Pairs(Icons):
    """--pairs: glyphs that go together whatever characters lead to them."""

    def boxes(self, name):
        """How wide each character's glyph is drawn, and how many contours it has."""
        font = ttLib.TTFont(self.path(name))
        glyphs = {code: font['glyf'][name] for code, name in font.getBestCmap().items()}
        return {code: (glyph.xMax - glyph.xMin, glyph.numberOfContours) for code, glyph in glyphs.items()}

    def test_blend(self):
        said = self.made('blend', 'A.ttf', 'B.ttf', '--pairs', 'pairs', '--at', '0,0.5,1', '-o', 'x.ttf')
        self.assertEqual(said, [])
        for t, width in (('0', 400), ('0.5', 600), ('1', 800)):
            self.assertEqual(self.boxes(f'x-{t}.ttf'), {0xE001: (width, 1), 0xE002: (width, 1), 0xE003: (width, 2)})
        square, triangle = (len(ttLib.TTFont(self.path('x-1.ttf'))['glyf'][name].coordinates) for name in ('home', 'car'))
        self.assertEqual((square, triangle), (4, 3))

    def test_variable(self):
        self.made('variable', 'A.ttf', 'B.ttf', '--pairs', 'pairs', '-o', 'v.ttf')
        font = ttLib.TTFont(self.path('v.ttf'))
        self.assertEqual(font.getBestCmap(), {0xE001: 'home', 0xE002: 'car', 0xE003: 'star'})
        for place, width in ((0, 400), (50, 600), (100, 800)):
            instancer.instantiateVariableFont(ttLib.TTFont(self.path('v.ttf')), {'MORF': place}).save(self.path('i.ttf'))
            self.assertEqual({code: box[0] for code, box in self.boxes('i.ttf').items()}, dict.fromkeys((0xE001, 0xE002, 0xE003), width))
        subprocess.run(['ots-sanitize', self.path('v.ttf')], check=True, stdout=subprocess.DEVNULL)

    def test_only_what_is_named(self):
        """All else is paired as without the option, and each glyph of the second font may serve again."""
        self.write('one', 'home home')
        self.made('blend', 'A.ttf', 'B.ttf', '--pairs', 'one', '--at', 1, '-o', 'x.ttf')
        self.assertEqual(self.boxes('x.ttf'), {0xE001: (800, 1)})
        self.write('twice', 'home star\ncar star')
        self.made('blend', 'A.ttf', 'B.ttf', '--pairs', 'twice', '--at', 1, '-o', 'x.ttf')
        self.assertEqual(self.boxes('x.ttf'), {0xE001: (800, 2), 0xE002: (800, 2)})

    def test_glyphs_without_a_character(self):
        self.write('pairs', 'spare extra\nhome home')
        self.made('blend', 'A.ttf', 'B.ttf', '--pairs', 'pairs', '--at', 1, '-o', 'x.ttf')
        font = ttLib.TTFont(self.path('x.ttf'))
        self.assertEqual(font['glyf']['spare'].xMax, 600)
        self.assertEqual(font.getBestCmap(), {0xE001: 'home'})

    def test_more_fonts(self):
        icon_font(self.path('C.ttf'), {'casa': (0xE009, 'square', 1200), 'auto': (0xE001, 'triangle', 1200)})
        self.write('pairs', 'home home casa\nU+E002 car auto\n')
        said = self.made('variable', 'A.ttf', 'B.ttf', 'C.ttf', '--pairs', 'pairs', '-o', 'v.ttf')
        self.assertFalse(any('other names' in line for line in said), said)
        instancer.instantiateVariableFont(ttLib.TTFont(self.path('v.ttf')), {'MORF': 100}).save(self.path('i.ttf'))
        self.assertEqual({code: box[0] for code, box in self.boxes('i.ttf').items()}, {0xE001: 1200, 0xE002: 1200})

    def test_text_and_left_out(self):
        self.made('blend', 'A.ttf', 'B.ttf', '--pairs', 'pairs', '--text', '\ue003', '--at', 1, '-o', 'x.ttf')
        self.assertEqual(self.boxes('x.ttf'), {0xE003: (800, 2)})
        self.made('blend', 'A.ttf', 'B.ttf', '--pairs', 'pairs', '--chars', self.write('chars', 'U+E002-E003'), '--at', 1, '-o', 'x.ttf')
        self.assertEqual(self.boxes('x.ttf'), {0xE002: (800, 1), 0xE003: (800, 2)})
        self.refused(1, 'blend', 'A.ttf', 'B.ttf', '--pairs', self.write('one', 'home home'), '--text', '\ue003', '-o', 'y.ttf',
                     says=['B.ttf lacks', 'U+E003'])

    def test_every_command(self):
        for command, output in (('strip', 'x.png'), ('sheet', 'x.svg'), ('inspect', 'x.json'), ('report', 'r.json'), ('specimen', 'x.html')):
            with self.subTest(command=command):
                self.made(command, 'A.ttf', 'B.ttf', '--text', '\ue001\ue003', '--pairs', 'pairs', '-o', output)
        glyphs = json.loads(self.path('x.json').read_text())['glyphs']
        self.assertAlmostEqual(glyphs[0]['b']['area'], 0.64, places=3)
        self.assertEqual(glyphs[1]['b']['components'][0]['holes'], 1)
        self.assertNotIn('"still":"\ue001', self.path('x.html').read_text())

    def test_hints(self):
        """A hint for a character is for the glyphs that are paired: the top of the o goes with a place further on the zero."""
        o, zero = (ttLib.TTFont(font)['glyf'][name] for font, name in ((cli.SERIF, 'o'), (cli.SANS_BOLD, 'zero')))
        x, y = (zero.xMin + zero.xMax) / 2 + (zero.xMax - zero.xMin) / 4, (zero.yMin + zero.yMax) / 2 + (zero.yMax - zero.yMin) * 3 ** 0.5 / 4
        self.write('hints', f'glyph o\npoint {(o.xMin + o.xMax) / 2},{o.yMax} {x:.1f},{y:.1f}\n')
        self.write('pairs', 'o zero')
        for command, output in (('inspect', 'x.json'), ('strip', 'x.svg')):
            made = []
            for more in ([], ['--hints', 'hints']):
                self.made(command, cli.SERIF, cli.SANS_BOLD, '--text', 'o', '--pairs', 'pairs', *more, '-o', output)
                made.append(self.path(output).read_bytes())
            self.assertNotEqual(*map(hash, made))

    def test_forms(self):
        self.made('blend', cli.SERIF, cli.SANS_BOLD, '--pairs', self.write('letters', 'A B'), '--text', 'AB', '-q', '--at', 1, '-o', 'x.ttf')
        self.made('blend', cli.SERIF, cli.SANS_BOLD, '--text', 'AB', '-q', '--at', 1, '-o', 'y.ttf')
        letters, plain = (ttLib.TTFont(self.path(name)) for name in ('x.ttf', 'y.ttf'))
        self.assertEqual(letters['hmtx']['A'], letters['hmtx']['B'])
        self.assertEqual(letters['hmtx']['B'], plain['hmtx']['B'])

    def test_wrong_files(self):
        icon_font(self.path('nameless.ttf'), {'home': (0xE001, 'square', 400)}, names=False)
        for content, *says in (('home hous', 'pairs:1:', 'B.ttf has no glyph /hous'), ('# x\nhome home\nhut home', 'pairs:3:', 'A.ttf has no glyph /hut'),
                               ('U+E009 home', 'pairs:1:', 'A.ttf has no glyph for U+E009'), ('home U+E00X', 'pairs:1:', 'code point'),
                               ('home U+', 'code point'), ('home', 'pairs:1:', '1 glyph instead of 2'), ('home home home', '3 glyphs instead of 2'),
                               ('home home\n/home car', 'pairs:2:', 'already', 'line 1'), ('home home\nU+E001 home', 'pairs:2:', 'already'),
                               ('', 'no pairs'), ('# home home\n', 'no pairs'), ('.notdef home', '.notdef'), (b'home home\n\xff\xfe home', 'pairs:2:', 'UTF-8'),
                               (b'home\0 home', 'pairs:1:', 'UTF-8'), (b'home h\xc3', 'pairs:1:', 'UTF-8'), ('home \x1b[31m', 'pairs:1:', '<U+001B>[31m'),
                               ('home ' + 'x' * 5000, 'pairs:1:')):
            for command, output in (('blend', 'x.ttf'), ('inspect', 'x.svg'), ('variable', 'v.ttf')):
                with self.subTest(content=content, command=command):
                    said = self.refused(1, command, 'A.ttf', 'B.ttf', '--text', '\ue001', '--pairs', self.write('pairs', content), '-o', output, says=says)
                    self.assertLess(len(said), 300)
        self.refused(1, 'blend', 'A.ttf', 'nameless.ttf', '--pairs', self.write('pairs', 'home home'), '-o', 'x.ttf', says=['nameless.ttf has no names'])
        self.refused(1, 'blend', 'A.ttf', 'B.ttf', '--pairs', 'nowhere', '-o', 'x.ttf', says=['nowhere', 'No such file'])

    def test_usage(self):
        self.refused(2, 'blend', 'A.ttf', 'B.ttf', '-o', 'x.ttf', '--pairs', says=['--pairs'])
        self.refused(2, 'inspect', 'A.ttf', '--text', '\ue001', '--pairs', 'pairs', '-o', 'x.svg', says=['--pairs'])


class PrivateNames(Icons):
    """Private characters whose glyphs have other names in the second font."""

    def test_warned(self):
        line = ('morphotype: 1 private character has other names in B.ttf than in A.ttf (U+E001 is /car there and /home here): --pairs FILE '
                'says which glyphs go together')
        for command in ('blend', 'variable'):
            self.assertIn(line, self.made(command, 'A.ttf', 'B.ttf', '-o', 'x.ttf'))
            self.assertIn(line, self.made(command, 'A.ttf', 'B.ttf', '--text', '\ue001', '-o', 'x.ttf'))
        self.assertEqual(self.run_program('blend', 'A.ttf', 'B.ttf', '-q', '-o', 'x.ttf').stderr, b'')

    def test_not_warned(self):
        icon_font(self.path('codes.ttf'), {'uniE001': (0xE001, 'square', 400), 'glyph2': (0xE002, 'square', 400), 'A.alt': (0x41, 'ring', 100)})
        icon_font(self.path('nameless.ttf'), {'home': (0xE001, 'square', 400)}, names=False)
        icon_font(self.path('letters.ttf'), {'house': (0x41, 'ring', 100)})
        for fonts in (('A.ttf', 'codes.ttf'), ('A.ttf', 'nameless.ttf'), ('A.ttf', 'A.ttf'), ('codes.ttf', 'letters.ttf')):
            self.assertFalse(any('other names' in line for line in self.made('blend', *fonts, '-o', 'x.ttf')), fonts)
        self.assertFalse(any('other names' in line for line in self.made('blend', 'A.ttf', 'B.ttf', '--pairs', 'pairs', '-o', 'x.ttf')))


if __name__ == '__main__':
    cli.main()
