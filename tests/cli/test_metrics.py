"""morphotype blend: the metrics of the fonts it makes, against the same mix of the sources' own."""

import subprocess

import cli
from fontTools import ttLib
from fontTools.otlLib.maxContextCalc import maxCtxFont


def read(spec):
    path, _, face = str(spec).partition('#')
    return ttLib.TTFont(path, fontNumber=int(face or 0))


class Test(cli.Test):
    def blend(self, a, b, *arguments):
        """The font at 0.5, or at each --at, accepted by the sanitizer and blended with itself: every glyph can be read."""
        self.made('blend', a, b, '-q', '-o', 'x.ttf', *arguments)
        for path in sorted(self.directory.glob('x*.ttf')):
            subprocess.run(['ots-sanitize', path], check=True, stdout=subprocess.DEVNULL)
            self.made('blend', path, path, '--at', '0', '--strict', '-q', '-o', 'again.ttf')
        return read(self.path('x.ttf')) if self.path('x.ttf').exists() else None


class Lines(Test):
    def line(self, font):
        """From a line to the next one, in em: the typographic lines where they are used."""
        os2, hhea = font['OS/2'], font['hhea']
        if os2.fsSelection & 128:
            used = os2.sTypoAscender - os2.sTypoDescender + os2.sTypoLineGap
        else:
            used = hhea.ascent - hhea.descent + hhea.lineGap
        return used / font['head'].unitsPerEm

    def test_spacing_lies_between_the_ends(self):
        for a, b in ((cli.SANS_BOLD, cli.SERIF), (cli.SANS_BOLD, cli.INTER), (cli.UKAI, cli.ZENHEI)):
            self.blend(a, b, '--text', 'A', '--at', '0,0.25,0.75,1')
            ends = self.line(read(a)), self.line(read(b))
            for t in (0, 0.25, 0.75, 1):
                expected = (1 - t) * ends[0] + t * ends[1]
                self.assertAlmostEqual(self.line(read(self.path(f'x-{t}.ttf'))), expected, delta=0.0015, msg=(a, b, t))

    def test_font_wide_figures(self):
        font, a, b = self.blend(cli.SANS_BOLD, cli.SERIF, '--text', 'Ax'), read(cli.SANS_BOLD), read(cli.SERIF)
        for table, names in (('OS/2', ('usWinAscent', 'usWinDescent', 'yStrikeoutPosition',
                                       'yStrikeoutSize', 'ySubscriptYSize', 'ySuperscriptYOffset', 'usWeightClass')),
                             ('post', ('underlinePosition', 'underlineThickness', 'italicAngle'))):
            for name in names:
                middle = (getattr(a[table], name) + getattr(b[table], name)) / 2
                self.assertAlmostEqual(getattr(font[table], name), middle, delta=0.5, msg=name)
        digits = [getattr(font['OS/2'].panose, name) for name in
                  ('bFamilyType', 'bSerifStyle', 'bWeight', 'bProportion', 'bContrast', 'bStrokeVariation', 'bArmStyle')]
        self.assertEqual(digits, [2, 0, 7, 3, 4, 6, 0])
        self.assertEqual(font['OS/2'].fsSelection & 0x61, 0x40)
        glyphs = [font['glyf'][name] for name in font.getGlyphOrder() if font['glyf'][name].numberOfContours]
        self.assertEqual(font['head'].yMax, max(glyph.yMax for glyph in glyphs))
        self.assertEqual(font['hhea'].advanceWidthMax, max(width for width, _ in font['hmtx'].metrics.values()))

    def test_longest_context(self):
        chars = self.write('chars', 'U+0020-017F')
        for a, b in ((cli.SANS_BOLD, cli.SERIF), (cli.INTER, cli.SERIF)):
            font = self.blend(a, b, '--chars', chars)
            self.assertEqual(font['OS/2'].usMaxContext, maxCtxFont(font))
            self.assertGreater(font['OS/2'].usMaxContext, 1)

    def test_smooth_and_without_instructions(self):
        font = self.blend(cli.SANS_BOLD, cli.SERIF, '--text', 'A')
        self.assertEqual(font['gasp'].gaspRange, {0xFFFF: 15})
        self.assertNotIn('fpgm', font)


class Monospaced(Test):
    def test_stays_monospaced(self):
        self.blend(cli.MONO, cli.MONO_BOLD, '--chars', self.write('chars', 'U+0020-017F U+0410-044F'), '--at', '0,0.37,1')
        for t in ('0', '0.37', '1'):
            font = read(self.path(f'x-{t}.ttf'))
            self.assertEqual({width for width, _ in font['hmtx'].metrics.values()}, {1233})
            self.assertEqual((font['post'].isFixedPitch, font['OS/2'].panose.bProportion), (1, 9))

    def test_not_with_a_proportional_one(self):
        font = self.blend(cli.MONO, cli.SERIF, '--text', 'im')
        self.assertEqual(font['post'].isFixedPitch, 0)
        self.assertNotEqual(font['OS/2'].panose.bProportion, 9)


class Vertical(Test):
    TEXT = '形永一。ー（A'

    def place(self, font, character):
        """Advance down, and height of the origin, in em."""
        name, units = font.getBestCmap()[ord(character)], font['head'].unitsPerEm
        height, bearing = font['vmtx'].metrics[name]
        if 'VORG' in font:
            origin = font['VORG'].VOriginRecords.get(name, font['VORG'].defaultVertOriginY)
        else:
            origin = bearing + font['glyf'][name].yMax
        return height / units, origin / units

    def assert_mix(self, font, a, b, t):
        for character in self.TEXT:
            places = [self.place(f, character) if 'vmtx' in f else self.made_up(f) for f in (a, b)]
            for found, in_a, in_b in zip(self.place(font, character), *places):
                self.assertAlmostEqual(found, (1 - t) * in_a + t * in_b, delta=0.0006, msg=(character, t))

    def made_up(self, font):
        os2, units = font['OS/2'], font['head'].unitsPerEm
        return (os2.sTypoAscender - os2.sTypoDescender) / units, os2.sTypoAscender / units

    def test_both_have_them(self):
        a, b = read(cli.NOTO_SANS), read(cli.NOTO_SERIF)
        self.blend(cli.NOTO_SANS, cli.NOTO_SERIF, '--text', self.TEXT, '--at', '0,0.5,1')
        for t in (0, 0.5, 1):
            font = read(self.path(f'x-{t}.ttf'))
            self.assert_mix(font, a, b, t)
            for name in ('ascent', 'descent', 'lineGap'):
                middle = (1 - t) * getattr(a['vhea'], name) + t * getattr(b['vhea'], name)
                self.assertAlmostEqual(getattr(font['vhea'], name), middle, delta=0.5)
            self.assertEqual(font['vhea'].advanceHeightMax, 1000)

    def test_one_has_them(self):
        self.TEXT = 'Aé(.'
        a, b = read(cli.NOTO_SERIF), read(cli.SERIF)
        self.blend(cli.NOTO_SERIF, cli.SERIF, '--text', self.TEXT, '--at', '0,0.25,1')
        for t in (0, 0.25, 1):
            self.assert_mix(read(self.path(f'x-{t}.ttf')), a, b, t)

    def test_none_has_them(self):
        font = self.blend(cli.SANS_BOLD, cli.SERIF, '--text', 'A')
        self.assertNotIn('vhea', font)
        self.assertNotIn('vmtx', font)

    def test_glyphs_without_height(self):
        """Zen Hei gives most Han no height in vmtx; its lines' stands in."""
        font = self.blend(cli.ZENHEI, cli.UKAI, '--text', '形永', '--at', '0')
        for character in '形永':
            self.assertEqual(self.place(font, character)[0], 1)


if __name__ == '__main__':
    cli.main()
