"""Text in a blend reads as in its fonts: small inputs for faults that people met. The corpus of tests/shaping has the scripts."""

import pathlib

import cli
import harfbuzz
from fontTools import subset, ttLib
from fontTools.pens.boundsPen import BoundsPen

FIRA = cli.DEBIAN / 'truetype/firacode/FiraCode-Regular.ttf'
JETBRAINS = cli.DEBIAN / 'truetype/jetbrains-mono/JetBrainsMono-Regular.ttf'
NOTO_ARABIC = cli.DEBIAN / 'truetype/noto/NotoSansArabic-Regular.ttf'
DEJAVU = cli.DEBIAN / 'truetype/dejavu/DejaVuSans.ttf'
TYPE1 = cli.DEBIAN / 'type1/urw-base35'
PLACES = (0, 0.5, 1)


class Reading(cli.Test):
    def blend(self, a, b, *options):
        """Fonts at PLACES, by their place."""
        self.made('blend', a, b, '--at', ','.join(str(t) for t in PLACES), '-o', 'x.ttf', *options)
        return {t: self.path(f'x-{t}.ttf') for t in PLACES}

    @staticmethod
    def names(path, text):
        order = ttLib.TTFont(path).getGlyphOrder()
        return [order[number] for number, *_ in harfbuzz.shape(path, text)]

    @staticmethod
    def boxes(path, text):
        """The box around each glyph of the shaped text that has ink, in thousandths of an em, None for a blank one."""
        font = ttLib.TTFont(path)
        glyphs, order, scale = font.getGlyphSet(), font.getGlyphOrder(), 1000 / font['head'].unitsPerEm
        x, boxes = 0, []
        for number, advance, x_offset, y_offset in harfbuzz.shape(path, text):
            pen = BoundsPen(glyphs)
            glyphs[order[number]].draw(pen)
            dx, dy = x + x_offset, y_offset
            boxes.append(pen.bounds and tuple(scale * v for v in (pen.bounds[0] + dx, pen.bounds[1] + dy,
                                                                  pen.bounds[2] + dx, pen.bounds[3] + dy)))
            x += advance
        return boxes

    def assert_drawn_alike(self, path, like, text):
        """Glyph by glyph, within two thousandths of an em: what rounding to font units and curves leave."""
        for box, wanted in zip(self.boxes(path, text), self.boxes(like, text), strict=True):
            self.assertEqual(box is None, wanted is None, text)
            for value, other in zip(box or (), wanted or ()):
                self.assertAlmostEqual(value, other, delta=2, msg=text)


class Code(Reading):
    """Fira Code draws :: in the last of its cells and leaves the others blank, as JetBrains Mono does."""

    def test_spacers_stay_blank(self):
        fonts = self.blend(FIRA, JETBRAINS, '--text', 'a:')
        for text in ('a::a', ':::'):
            wanted = self.names(FIRA, text)
            self.assertIn('colon.spacer', wanted)
            for t, path in fonts.items():
                self.assertEqual(self.names(path, text), wanted, t)
                blank = [box is None for box in self.boxes(path, text)]
                self.assertEqual(blank, [name == 'colon.spacer' for name in wanted], t)
            self.assert_drawn_alike(fonts[0], FIRA, text)
            self.assert_drawn_alike(fonts[1], JETBRAINS, text)


class Arabic(Reading):
    """Noto makes forms by multiple substitution, of a letter without dots and its dots, DejaVu by single substitution."""

    def test_letters_join(self):
        fonts = self.blend(NOTO_ARABIC, DEJAVU, '--text', 'بسميتلا')
        for text in ('بسم', 'بيت', 'لا'):
            wanted = self.names(NOTO_ARABIC, text)
            alone = [name for character in reversed(text) for name in self.names(NOTO_ARABIC, character)]
            self.assertNotEqual(wanted, alone)
            for t, path in fonts.items():
                self.assertEqual(self.names(path, text), wanted, t)
            self.assert_drawn_alike(fonts[0], NOTO_ARABIC, text)


class Symbols(Reading):
    """A character map for symbols alone (platform 3, encoding 0): its codes are U+F020 to U+F0FF, and text reaches them too."""

    def symbols(self, source, name):
        font = ttLib.TTFont(source)
        subsetter = subset.Subsetter(subset.Options(layout_features=[], drop_tables=['FFTM', 'MATH', 'GSUB', 'GPOS']))
        subsetter.populate(text='ABg')
        subsetter.subset(font)
        table = ttLib.tables._c_m_a_p.cmap_format_4(4)
        table.platformID, table.platEncID, table.language = 3, 0, 0
        table.cmap = {0xF000 + code: glyph for code, glyph in font.getBestCmap().items()}
        font['cmap'].tables = [table]
        font.save(self.path(name))
        return self.path(name)

    def test_blended(self):
        a, b = self.symbols(cli.SANS_BOLD, 'a.ttf'), self.symbols(cli.SERIF, 'b.ttf')
        fonts = self.blend(a, b)
        for t, path in fonts.items():
            for text in ('ABg', '\uf041\uf042\uf067'):
                self.assertEqual(self.names(path, text), self.names(a, text), t)
        self.assert_drawn_alike(fonts[0], a, 'ABg')
        self.assert_drawn_alike(fonts[1], b, 'ABg')


class Metrics(Reading):
    """Type 1 fonts have their kerning in a file beside them."""

    def kerning(self, path, pair):
        """How much closer the two stand than each by itself, in thousandths of an em."""
        units = ttLib.TTFont(path)['head'].unitsPerEm
        width = lambda text: sum(advance for _, advance, *_ in harfbuzz.shape(path, text))
        return 1000 * (width(pair) - sum(width(character) for character in pair)) / units

    def told(self, afm, pair):
        for line in pathlib.Path(afm).read_text(encoding='ascii').splitlines():
            if line.split()[:3] == ['KPX', *pair]:
                return float(line.split()[3])
        return 0

    def test_kerning(self):
        names = ('NimbusSans-Regular', 'P052-Roman')
        fonts = self.blend(*(TYPE1 / f'{name}.t1' for name in names), '--text', 'AVTo')
        for pair in ('AV', 'To', 'VA'):
            told = [self.told(TYPE1 / f'{name}.afm', pair) for name in names]
            self.assertTrue(all(told), pair)
            for t, path in fonts.items():
                self.assertAlmostEqual(self.kerning(path, pair), (1 - t) * told[0] + t * told[1], delta=1, msg=pair)


if __name__ == '__main__':
    cli.main()
