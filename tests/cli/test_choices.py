"""What a person chooses: forms that text asks for."""

import cli
from fontTools import ttLib

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


if __name__ == '__main__':
    cli.main()
