"""morphotype variable: advances, kerning, anchors and lines along the axis are those of the blends there."""

import itertools
import subprocess

import cli
import harfbuzz
from fontTools import ttLib
from fontTools.varLib import instancer

NIMBUS = cli.DEBIAN / 'opentype/urw-base35/NimbusSans-Regular.otf'
PALATINO = cli.DEBIAN / 'opentype/urw-base35/P052-Roman.otf'
INTER = f"{cli.DEBIAN / 'truetype/inter-vf/Inter.var.ttf'}@wght=650"
SANS = cli.DEBIAN / 'truetype/dejavu/DejaVuSans.ttf'

LETTERS = 'AVTWYLPFaovwyr.,-ΑΤαυΓТУАГу'
BASES, MARKS = 'aeouAEOαεАЕ', '\u0300\u0301\u0308\u0323'
PLACES = 0, 0.1, 0.25, 0.5, 0.75, 1


class AgainstBlends(cli.Test):
    def compare(self, varying, blend, place, marks):
        """Advances, and kerning, are within a unit; a mark, which hangs on two anchors, is within a unit of each. Nothing
        is off at the ends."""
        within = 0 if place in (0, 1) else 1
        for text in map(''.join, itertools.chain(LETTERS, itertools.product(LETTERS, LETTERS))):
            kerning = []
            for font in varying, blend:
                advances = [font.shape(letter)[0][1] for letter in text]
                shaped = font.shape(text)
                kerning.append([glyph[1] - advance for glyph, advance in zip(shaped, advances)])
            self.assertLessEqual(abs(varying.shape(text[0])[0][1] - blend.shape(text[0])[0][1]), within, text)
            for one, other in zip(*kerning):
                self.assertLessEqual(abs(one - other), within, text)
            self.kerned += any(kerning[1])
        for text in map(''.join, itertools.product(BASES, marks, marks)):
            one, other = varying.shape(text), blend.shape(text)
            self.assertEqual([glyph[0] for glyph in one], [glyph[0] for glyph in other])
            for a, b in zip(one, other):
                self.assertLessEqual(max(abs(a[2] - b[2]), abs(a[3] - b[3])), 2 * within, text)
            self.lifted += any(glyph[3] for glyph in other)

    def check(self, a, b, kerned, lifted, marks=MARKS):
        """At each place so many texts at least are kerned, and have a mark that is moved up or down."""
        text = LETTERS + BASES + marks
        self.made('variable', a, b, '--text', text, '-q', '-o', 'v.ttf')
        self.made('blend', a, b, '--text', text, '-q', '-o', 'x.ttf', '--at', ','.join(map(str, PLACES)))
        subprocess.run(['ots-sanitize', self.path('v.ttf')], check=True, stdout=subprocess.DEVNULL)
        for place in PLACES:
            self.kerned = self.lifted = 0
            blend = self.path(f'x-{place:g}.ttf')
            with harfbuzz.Font(self.path('v.ttf'), 100 * place) as one, harfbuzz.Font(blend) as other:
                self.compare(one, other, place, marks)
            self.assertGreaterEqual(self.kerned, kerned, place)
            self.assertGreaterEqual(self.lifted, lifted, place)

    def test_classes_and_anchors(self):
        """Letters that the fonts have composed stand for some of the texts with marks."""
        self.check(cli.SANS_BOLD, cli.SERIF, 40, 18)

    def test_lists(self):
        self.check(NIMBUS, PALATINO, 100, 0, marks='')

    def test_a_place_of_a_variable_font(self):
        self.check(INTER, cli.SERIF, 30, 0)

    def test_vertical_lines(self):
        """One font hangs its glyphs from origins of its own, the other from its lines."""
        pair = cli.NOTO_SERIF, cli.SERIF
        self.made('variable', *pair, '--text', 'ABx', '-q', '-o', 'v.ttf')
        self.made('blend', *pair, '--text', 'ABx', '-q', '-o', 'x.ttf', '--at', '0,0.25,1')
        seen = set()
        for place in 0, 0.25, 1:
            blend = self.path(f'x-{place:g}.ttf')
            with harfbuzz.Font(self.path('v.ttf'), 100 * place) as one, harfbuzz.Font(blend) as other:
                for glyph in 1, 2, 3:
                    got, wanted = one.vertical(glyph), other.vertical(glyph)
                    self.assertLessEqual(max(abs(a - b) for a, b in zip(got, wanted)), 1)
                    seen.add(wanted[1])
        self.assertGreater(len(seen), 1)


class Instances(cli.Test):
    def test_three_fonts(self):
        """At each stop an instance by fontTools is positioned as the font that stands there."""
        fonts = SANS, INTER, cli.SERIF
        self.made('variable', *fonts, '--text', LETTERS, '-q', '-o', 'v.ttf')
        for i, font in enumerate(fonts):
            instance = instancer.instantiateVariableFont(ttLib.TTFont(self.path('v.ttf')), {'MORF': 50 * i})
            instance.save(self.path('i.ttf'))
            self.made('blend', SANS, font, '--text', LETTERS, '-q', '-o', 'x.ttf', '--at', '1')
            scale = instance['head'].unitsPerEm / ttLib.TTFont(self.path('x.ttf'))['head'].unitsPerEm
            with harfbuzz.Font(self.path('i.ttf')) as one, harfbuzz.Font(self.path('x.ttf')) as other:
                for text in map(''.join, itertools.product(LETTERS, LETTERS)):
                    for got, wanted in zip(one.shape(text), other.shape(text)):
                        self.assertLessEqual(abs(got[1] - scale * wanted[1]), 1 + scale, text)

    def test_lines(self):
        """OS/2's lines are hhea's, are used, and vary from the first font's to the second's."""
        self.made('variable', cli.SANS_BOLD, PALATINO, '--text', 'AB', '-q', '-o', 'v.ttf')
        font = ttLib.TTFont(self.path('v.ttf'))
        ends = []
        for end, at in ('a.ttf', '0'), ('b.ttf', '1'):
            self.made('blend', cli.SANS_BOLD, PALATINO, '--text', 'AB', '-q', '-o', end, '--at', at)
            ends.append(ttLib.TTFont(self.path(end)))
        lines = [(end['OS/2'].sTypoAscender, end['OS/2'].sTypoDescender, end['OS/2'].sTypoLineGap)
                 if end['OS/2'].fsSelection & 1 << 7 else
                 (end['hhea'].ascent, end['hhea'].descent, end['hhea'].lineGap) for end in ends]
        self.assertTrue(font['OS/2'].fsSelection & 1 << 7)
        self.assertEqual((font['hhea'].ascent, font['hhea'].descent, font['hhea'].lineGap), lines[0])
        self.assertNotEqual(*lines)
        for place, wanted in (0, lines[0]), (100, lines[1]):
            os2 = instancer.instantiateVariableFont(ttLib.TTFont(self.path('v.ttf')), {'MORF': place})['OS/2']
            self.assertEqual((os2.sTypoAscender, os2.sTypoDescender, os2.sTypoLineGap), wanted)
            self.assertEqual(os2.sxHeight, ends[place // 100]['OS/2'].sxHeight)


if __name__ == '__main__':
    cli.main()
