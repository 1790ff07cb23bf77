"""What a person chooses: forms that text asks for, forms of a source, characters alone."""

import json

import cli
from fontTools import ttLib
from fontTools.feaLib.builder import addOpenTypeFeaturesFromString

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


if __name__ == '__main__':
    cli.main()
