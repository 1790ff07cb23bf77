"""WOFF2 out, checked with fontTools, and in again, through FreeType."""

import subprocess

import cli
from fontTools import subset, ttLib

TEXT = 'Rags&8é'


def outlines(path):
    """Contours and advance of each character, references resolved."""
    font = ttLib.TTFont(path)
    metrics, glyphs = font['hmtx'], font['glyf']
    return {code: (*map(list, glyphs[name].getCoordinates(glyphs)), metrics[name][0])
            for code, name in font.getBestCmap().items()}


class Out(cli.Test):
    """What blend writes."""

    def blend(self, output, *arguments, fonts=(cli.SANS_BOLD, cli.SERIF)):
        self.assertEqual(self.made('blend', *fonts, '-q', '--text', TEXT, '-o', output, *arguments), [])
        return self.path(output)

    def test_holds_the_font(self):
        plain, packed = self.blend('x.ttf'), self.blend('x.woff2')
        self.assertEqual(packed.read_bytes()[:4], b'wOF2')
        self.assertLess(packed.stat().st_size, plain.stat().st_size)
        self.assertEqual(len(outlines(plain)), len(TEXT))
        self.assertEqual(outlines(plain), outlines(packed))
        ours, theirs = ttLib.TTFont(packed, lazy=False), ttLib.TTFont(plain, lazy=False)
        self.assertEqual(set(ours.keys()), set(theirs.keys()))
        for tag in set(theirs.keys()) - {'GlyphOrder', 'glyf', 'loca', 'head'}:
            self.assertEqual(ours.getTableData(tag), theirs.getTableData(tag), tag)

    def test_sanitizer_takes_it(self):
        subprocess.run(['ots-sanitize', self.blend('x.woff2')], check=True, stdout=subprocess.DEVNULL)

    def test_several_places_whatever_the_capitals(self):
        self.blend('x.Woff2', '--at', '0.25,0.5')
        self.assertEqual(sorted(path.name for path in self.files()), ['x-0.25.Woff2', 'x-0.5.Woff2'])
        self.assertNotEqual(outlines(self.path('x-0.25.Woff2')), outlines(self.path('x-0.5.Woff2')))

    def test_same_bytes_for_any_number_of_threads(self):
        fonts = {self.blend(f'{jobs}.woff2', '-j', jobs).read_bytes() for jobs in (1, 2, 7)}
        self.assertEqual(len(fonts), 1)

    def test_an_old_file_is_replaced(self):
        self.write('x.woff2', 'old')
        self.assertEqual(len(outlines(self.blend('x.woff2'))), len(TEXT))


class In(cli.Test):
    """The same font, packed or not, as an input."""

    def packed(self, font):
        """A WOFF2 of this font, by fontTools."""
        font.flavor = 'woff2'
        font.save(self.path('packed.woff2'))
        return self.path('packed.woff2')

    def assert_same(self, plain, packed, *arguments, place=''):
        for name, source in (('plain.ttf', plain), ('packed.ttf', packed)):
            self.made('blend', f'{source}{place}', cli.SERIF, '--text', TEXT, '--at', '0.25', '-o', name, *arguments)
        self.assertEqual(self.path('plain.ttf').read_bytes(), self.path('packed.ttf').read_bytes())

    def test_what_was_written(self):
        for name in ('x.ttf', 'x.woff2'):
            self.made('blend', cli.SANS_BOLD, cli.SERIF, '--text', TEXT, '-o', name)
        self.assert_same(self.path('x.ttf'), self.path('x.woff2'))

    def test_truetype(self):
        plain = cli.cut_font(self.path('cut.ttf'), TEXT)
        self.assert_same(plain, self.packed(ttLib.TTFont(plain, recalcTimestamp=False)))

    def test_cff(self):
        self.made('blend', cli.DEMO_SERIF, self.packed(ttLib.TTFont(cli.DEMO_SERIF)), '--text', 'gR', '--at', '0,1', '-o', 'x.ttf')
        self.assertEqual(outlines(self.path('x-0.ttf')), outlines(self.path('x-1.ttf')))

    def test_variable(self):
        font = ttLib.TTFont(cli.INTER, recalcTimestamp=False)
        subsetter = subset.Subsetter()
        subsetter.populate(text=TEXT)
        subsetter.subset(font)
        font.save(self.path('plain-inter.ttf'))
        packed = self.packed(font)
        self.assert_same(self.path('plain-inter.ttf'), packed, place='@wght=650')
        heavy = outlines(self.path('packed.ttf'))
        self.assert_same(self.path('plain-inter.ttf'), packed, place='@wght=300')
        self.assertNotEqual(heavy, outlines(self.path('packed.ttf')))


if __name__ == '__main__':
    cli.main()
