"""What is said of characters and glyphs: each can be seen, is the one that is meant, and one kind is one line."""

import cli
from fontTools import ttLib
from fontTools.feaLib.builder import addOpenTypeFeaturesFromString
from fontTools.ttLib.tables._g_l_y_f import Glyph


class Characters(cli.Test):
    """How a character is named."""

    def lacks(self, text):
        said = self.refused(1, 'strip', self.font, self.font, '--text', text, '-o', 'x.png')
        return said.partition('lacks ')[2].partition(';')[0].strip()

    def setUp(self):
        super().setUp()
        self.font = cli.cut_font(self.path('font.ttf'), 'A')

    def test_printable(self):
        self.assertEqual(self.lacks('aж形'), '“a” (U+0061), “ж” (U+0436), “形” (U+5F62)')

    def test_without_ink(self):
        for character, name in (('\u200d', 'ZERO WIDTH JOINER'), ('\u200b', 'ZERO WIDTH SPACE'), ('\u3000', 'IDEOGRAPHIC SPACE'),
                                ('\ufe0f', 'VARIATION SELECTOR-16'), ('\U000e0100', 'VARIATION SELECTOR-17'), ('\t', 'TAB'),
                                ('\u2066', 'LEFT-TO-RIGHT ISOLATE'), ('\u1160', 'HANGUL JUNGSEONG FILLER')):
            said = self.lacks('A' + character)
            self.assertEqual(said, f'U+{ord(character):04X} {name}')
            self.assertNotIn(character, said)

    def test_code_point_alone(self):
        for character in ('\ue001', '\u0378', '\x1b', '\x7f', '\U000f0000', '\ufffe', '\U000e0061'):
            self.assertEqual(self.lacks('A' + character), f'U+{ord(character):04X}')

    def test_marks_stand_on_a_circle(self):
        self.assertEqual(self.lacks('\u0301\u0e31\u20dd'), '“◌\u0301” (U+0301), “◌\u0e31” (U+0E31), “◌\u20dd” (U+20DD)')


class Glyphs(cli.Test):
    """Which glyph could not be blended, and in which font."""

    def font(self, name, blank):
        """DejaVu Serif's capitals with an alternate each, A.alt …; those in `blank` lose their ink."""
        cli.cut_font(self.path(name), 'ABCDEFGHIJKLMN')
        font = ttLib.TTFont(self.path(name))
        order = font.getGlyphOrder()
        alternates = [f'{letter}.alt' for letter in 'ABC']
        font.setGlyphOrder(order + alternates)
        for alternate in alternates:
            font['glyf'].glyphs[alternate] = font['glyf'][alternate[0]]
            font['hmtx'].metrics[alternate] = font['hmtx'][alternate[0]]
        font['glyf'].glyphOrder = font.getGlyphOrder()
        for glyph in blank:
            font['glyf'].glyphs[glyph] = Glyph()
        addOpenTypeFeaturesFromString(font, 'feature salt { sub [A B C] by [A.alt B.alt C.alt]; } salt;')
        font['post'].formatType, font['post'].extraNames, font['post'].mapping = 2, [], {}
        font.save(self.path(name))
        return name

    def test_form(self):
        """A blank form goes with no inked one, which stays."""
        a, b = self.font('a.ttf', []), self.font('b.ttf', ['B.alt'])
        self.assertEqual(self.made('blend', a, b, '-o', 'x.ttf'),
                         [f'morphotype: 1 glyph that {b} has not stays as in {a}: /B.alt'])

    def test_font(self):
        a, b = self.font('a.ttf', ['A']), self.font('b.ttf', ['B'])
        self.assertEqual(self.made('blend', a, b, '-o', 'x.ttf'),
                         [f"morphotype: “{letter}” (U+{ord(letter):04X}): not blended, the nearer font's glyph stands in: "
                          f'{font} leaves the character blank' for letter, font in (('A', a), ('B', b))])

    def test_one_kind_is_one_line(self):
        a, b = self.font('a.ttf', []), self.font('b.ttf', list('ABCDEFGHIJ'))
        lines = self.made('blend', a, b, '-o', 'x.ttf')
        self.assertEqual(len(lines), 1, lines)
        self.assertTrue(lines[0].startswith("morphotype: 10 glyphs not blended, the nearer font's glyphs stand in: b.ttf leaves "
                                            'the character blank: “A” (U+0041), “B” (U+0042), '), lines)
        self.assertTrue(lines[0].endswith('“H” (U+0048) and 2 more'), lines)
        lines = self.made('blend', a, b, '-v', '-o', 'x.ttf')
        self.assertEqual(sum('not blended' in line for line in lines), 10)
        result = self.run_program('blend', a, b, '--strict', '-o', 'y.ttf')
        self.assertEqual((result.returncode, len(result.stderr.decode().splitlines())), (1, 2))
        self.assertIn('10 glyphs could not be blended', result.stderr.decode())

    def test_variable_font_of_several(self):
        fonts = [self.font(name, blank) for name, blank in (('a.ttf', []), ('b.ttf', ['B']), ('c.ttf', []))]
        lines = self.made('variable', *fonts, '-o', 'x.ttf')
        self.assertEqual(len(lines), 1, lines)
        self.assertIn('“B” (U+0042): not blended', lines[0])
        self.assertIn('b.ttf leaves', lines[0])

    def test_glyphs_without_a_partner(self):
        a, b = self.font('a.ttf', []), 'b.ttf'
        cli.cut_font(self.path(b), 'AB')
        said = self.made('blend', a, b, '--glyphs', 'first', '-o', 'x.ttf')
        self.assertTrue(said[-1].startswith('morphotype: 15 glyphs that b.ttf has not stay as in a.ttf: “C” (U+0043), '), said)
        self.assertTrue(said[-1].endswith(' and 7 more'), said)
        said = self.made('blend', a, b, '--glyphs', 'first', '-v', '-o', 'x.ttf')
        self.assertTrue(any(line.endswith(': /B.alt') for line in said), said)

    def test_left_out_tables_of_a_row_are_one_line(self):
        said = self.made('variable', cli.SANS_BOLD, cli.SERIF, cli.SERIF, cli.SERIF, '--text', 'A', '-o', 'x.ttf')
        self.assertEqual(sum('left out' in line for line in said), 1, said)


if __name__ == '__main__':
    cli.main()
