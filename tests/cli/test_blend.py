"""morphotype blend: the fonts it makes, checked with fontTools and the OpenType sanitizer."""

import subprocess

import cli
from fontTools import ttLib
from fontTools.ttLib.tables.DefaultTable import DefaultTable

TABLES = {'glyf', 'loca', 'hmtx', 'cmap', 'head', 'hhea', 'maxp', 'OS/2', 'post', 'name'}


def advances(path, **options):
    """Advance of each code point, in em."""
    font = ttLib.TTFont(path, **options)
    units, metrics = font['head'].unitsPerEm, font['hmtx'].metrics
    return {code: metrics[glyph][0] / units for code, glyph in font.getBestCmap().items()}


class WholeFont(cli.Test):
    """Two Debian fonts, every character that both have."""

    def test_dejavu(self):
        said = self.made('blend', cli.SANS_BOLD, cli.SERIF, '--at', '0.5', '-o', 'x.ttf')
        font = ttLib.TTFont(self.path('x.ttf'), lazy=False)
        self.assertLessEqual(TABLES, set(font.keys()))
        for tag in font.keys():
            self.assertIsNot(type(font[tag]), DefaultTable, tag)
        for glyph in font.getGlyphOrder():
            font['glyf'][glyph].expand(font['glyf'])
        a, b, x = advances(cli.SANS_BOLD), advances(cli.SERIF), advances(self.path('x.ttf'))
        self.assertEqual(set(x), set(a) & set(b))
        units = font['head'].unitsPerEm
        self.assertEqual([code for code in x if abs(x[code] - (a[code] + b[code]) / 2) * units > 1], [])
        subprocess.run(['ots-sanitize', self.path('x.ttf')], check=True, stdout=subprocess.DEVNULL)
        summary = [line for line in said if line != cli.NO_MATH and 'left out' in line]
        self.assertEqual(len(summary), 2, said)
        self.assertIn(f'{len(set(a) - set(b))} characters only in {cli.SANS_BOLD}', summary[0])
        self.assertIn(f'{len(set(b) - set(a))} characters only in {cli.SERIF}', summary[1])
        self.assertIn('more ranges', summary[0])
        self.assertLess(max(map(len, summary)), 1000)
        self.check_each_glyph_loads('x.ttf')

    def check_each_glyph_loads(self, name):
        """The program reads glyphs through FreeType, and names those that it cannot read by a character."""
        said = self.made('blend', self.path(name), self.path(name), '--at', '0', '--glyphs', 'first', '-o', 'again.ttf')
        self.assertEqual([line for line in said if 'U+' in line or 'no character' in line], [])
        again = ttLib.TTFont(self.path('again.ttf'))
        self.assertEqual(len(again.getGlyphOrder()), len(ttLib.TTFont(self.path(name)).getGlyphOrder()))


class Places(cli.Test):
    """--at, and the same bytes whatever the way to them."""

    def blend(self, output, *arguments):
        return self.made('blend', cli.SANS_BOLD, cli.SERIF, '--text', 'Rags&8é', '-o', output, *arguments)

    def test_ends_have_the_advances_of_the_fonts(self):
        self.blend('x.ttf', '--at', '0,1')
        for t, source in (('0', cli.SANS_BOLD), ('1', cli.SERIF)):
            end, original = advances(self.path(f'x-{t}.ttf')), advances(source)
            self.assertEqual(len(end), 7)
            self.assertEqual({code: original[code] for code in end}, end)

    def test_several_places_are_several_files(self):
        self.blend('x.ttf', '--at', '0.25,0.5,.75,1')
        self.assertEqual(sorted(path.name for path in self.files()),
                         ['x-0.25.ttf', 'x-0.5.ttf', 'x-0.75.ttf', 'x-1.ttf'])
        widths = [advances(self.path(f'x-{t}.ttf'))[ord('R')] for t in ('0.25', '0.5', '0.75', '1')]
        self.assertEqual(widths, sorted(widths, reverse=True))
        self.assertEqual(len(set(widths)), 4)

    def test_half_way_without_at(self):
        self.blend('x.ttf')
        self.blend('y.ttf', '--at', '0.5')
        self.assertEqual(self.path('x.ttf').read_bytes(), self.path('y.ttf').read_bytes())

    def test_one_of_several_is_the_same_as_alone(self):
        self.blend('x.ttf', '--at', '0.25,0.5')
        self.blend('y.ttf', '--at', '0.25')
        self.assertEqual(self.path('x-0.25.ttf').read_bytes(), self.path('y.ttf').read_bytes())

    def test_same_bytes_for_any_number_of_threads(self):
        for name, jobs in (('1', 1), ('2', 2), ('again', 2), ('7', 7)):
            self.made('blend', cli.SANS_BOLD, cli.SERIF, '--chars', self.write('chars', 'U+0020-007E'), '-q',
                      '-j', jobs, '-o', name + '.ttf')
        fonts = {self.path(name + '.ttf').read_bytes() for name in ('1', '2', 'again', '7')}
        self.assertEqual(len(fonts), 1)

    def test_an_old_file_is_replaced(self):
        self.write('x.ttf', 'old')
        self.blend('x.ttf')
        self.assertEqual(len(advances(self.path('x.ttf'))), 7)


class Characters(cli.Test):
    """Which characters come into the font, and what is said of the others."""

    def codes(self, name='x.ttf'):
        return set(ttLib.TTFont(self.path(name)).getBestCmap())

    def test_text(self):
        said = self.made('blend', cli.SANS_BOLD, cli.SERIF, '--text', 'abc', '--text', 'cd', '-o', 'x.ttf')
        self.assertEqual(said[0], cli.NO_MATH)
        self.assertEqual([line for line in said[1:] if '--alternates' not in line], [])
        self.assertEqual(self.codes(), set(map(ord, 'abcd')))

    def test_file(self):
        chars = self.write('chars', '\ufeff# letters\nab é # and more\nU+0041-0043, U+0058-U+0059\tu+5a U+23\r\nx#y\n')
        self.made('blend', cli.SANS_BOLD, cli.SERIF, '--chars', chars, '-o', 'x.ttf')
        self.assertEqual(self.codes(), set(map(ord, 'abéABCXYZ#xy')))

    def test_file_with_characters_in_one_font_only(self):
        chars = self.write('chars', 'A U+4E00-4E02 U+E000')
        said = self.made('blend', cli.SANS_BOLD, cli.SERIF, '--chars', chars, '-o', 'x.ttf')
        self.assertEqual(said, ['morphotype: 4 characters not in both fonts, left out: U+4E00-4E02, U+E000', cli.NO_MATH])
        self.assertEqual(self.codes(), {ord('A')})

    def test_quiet(self):
        chars = self.write('chars', 'A U+4E00-4E02')
        self.assertEqual(self.made('blend', cli.SANS_BOLD, cli.SERIF, '--chars', chars, '-q', '-o', 'x.ttf'), [])


class Failures(cli.Test):
    """A glyph that cannot be blended: drawn in one font, blank in the other."""

    def setUp(self):
        super().setUp()
        cli.cut_font(self.path('blank.ttf'), 'ABC', blank='B')

    def test_named_and_the_run_goes_on(self):
        said = self.made('blend', cli.SANS_BOLD, 'blank.ttf', '--text', 'ABC', '--at', '0.25,0.75', '-o', 'x.ttf')
        self.assertEqual(len(said), 1, said)
        self.assertIn('“B” (U+0042)', said[0])
        self.assertIn('blank', said[0])
        for t, contours in (('0.25', 3), ('0.75', 0)):
            font = ttLib.TTFont(self.path(f'x-{t}.ttf'))
            self.assertEqual(set(font.getBestCmap()), set(map(ord, 'ABC')))
            self.assertEqual(font['glyf'][font.getBestCmap()[ord('B')]].numberOfContours, contours)

    def test_quiet(self):
        self.assertEqual(self.made('blend', cli.SANS_BOLD, 'blank.ttf', '--text', 'ABC', '-q', '-o', 'x.ttf'), [])

    def test_strict(self):
        for command, output in (('blend', 'x.ttf'), ('strip', 'x.png'), ('sheet', 'x.pdf')):
            before = self.files()
            result = self.run_program(command, cli.SANS_BOLD, 'blank.ttf', '--text', 'ABC', '--strict', '-o', output)
            lines = result.stderr.decode().splitlines()
            self.assertEqual(result.returncode, 1, lines)
            self.assertEqual(len(lines), 2, lines)
            self.assertIn('“B” (U+0042)', lines[0])
            self.assertIn('nothing written', lines[1])
            self.assertEqual(self.files(), before)

    def test_strict_without_failures(self):
        self.assertEqual(self.made('blend', cli.SANS_BOLD, 'blank.ttf', '--text', 'AC', '--strict', '-o', 'x.ttf'), [])


class Fonts(cli.Test):
    """How fonts are named, and where options stand."""

    def advance(self, name, character):
        return advances(self.path(name))[ord(character)]

    def test_axis(self):
        for axis in ('wght=400', 'wght=900'):
            self.made('blend', f'{cli.INTER}@{axis}', cli.SERIF, '--at', '0', '--text', 'm', '-o', axis + '.ttf')
        self.assertLess(self.advance('wght=400.ttf', 'm'), self.advance('wght=900.ttf', 'm'))

    def test_face_of_a_collection(self):
        with_face = f'{cli.UKAI}#1'
        self.made('blend', with_face, cli.ZENHEI, '--at', '0', '--text', '形', '-o', 'x.ttf')
        expected = advances(cli.UKAI, fontNumber=1)
        self.assertAlmostEqual(self.advance('x.ttf', '形'), expected[ord('形')], delta=0.001)

    def test_options_before_and_after_the_fonts(self):
        self.made('blend', '--text', 'a', cli.SANS_BOLD, '--at', '0.5', cli.SERIF, '-o', 'x.ttf')
        self.made('blend', '-o', 'y.ttf', '--text=a', '--', cli.SANS_BOLD, cli.SERIF)
        self.assertEqual(self.path('x.ttf').read_bytes(), self.path('y.ttf').read_bytes())

    def test_dashes_end_the_options(self):
        self.write('-font.ttf', cli.SERIF.read_bytes())
        self.made('blend', '--text', 'a', '-o', 'x.ttf', '--', cli.SANS_BOLD, '-font.ttf')

    def test_family(self):
        self.made('blend', cli.SANS_BOLD, cli.SERIF, '--text', 'a', '--family', 'Zwischen Ü', '-o', 'x.ttf')
        self.assertEqual(ttLib.TTFont(self.path('x.ttf'))['name'].getBestFamilyName(), 'Zwischen Ü')

    def test_verbose(self):
        said = self.made('blend', cli.SANS_BOLD, cli.SERIF, '--text', 'a', '-v', '-o', 'x.ttf')
        self.assertTrue(any('DejaVu Sans Bold' in line for line in said), said)
        self.assertTrue(any('x.ttf' in line for line in said), said)
        self.assertTrue(any('topology proved for every T of 1 out of 1 glyphs' in line for line in said), said)

    def test_slant_is_measured_given_or_left_out(self):
        """Nimbus Sans and its italic, which leans by 12 degrees."""
        urw = cli.DEBIAN / 'opentype/urw-base35'
        fonts = urw / 'NimbusSans-Regular.otf', urw / 'NimbusSans-Italic.otf'
        found = {}
        for slant in ((), ('--slant', 'auto'), ('--slant', '12'), ('--slant', '0')):
            said = self.made('blend', *fonts, '--text', 'dk', '-v', *slant, '-o', 'x.ttf')
            found[slant[-1:]] = [float(line.split('leans ')[1].split()[0]) for line in said if 'leans' in line]
        self.assertEqual(found[()], found['auto',])
        self.assertTrue(11 <= found[()][0] <= 13, found)
        self.assertEqual(found['12',], [12])
        self.assertEqual(found['0',], [])
        said = self.made('blend', *reversed(fonts), '--text', 'dk', '-v', '-o', 'x.ttf')
        self.assertTrue(any(f'leans {-found[()][0]:.1f} degrees' in line for line in said), said)

    def test_every_option_of_the_engine_is_taken(self):
        self.made('blend', cli.SANS_BOLD, cli.SERIF, '--text', 'aB', '--method', 'paper', '--tolerance', 1, '--fit', '0.5', '--weights',
                  '0.5,0.25,0.25', '--rounds', 3, '--threshold', '0.2', '--one-scale', '--rotate', '-7.5', '--slant', '-3.5', '-j', 1,
                  '-o', 'x.ttf')
        self.made('blend', cli.SANS_BOLD, cli.SERIF, '--text', 'aB', '--rotate', 'auto', '-o', 'y.ttf')
        subprocess.run(['ots-sanitize', self.path('x.ttf')], check=True, stdout=subprocess.DEVNULL)

    def test_demo_fonts(self):
        self.made('blend', cli.DEMO_SANS, cli.DEMO_SERIF, '-o', 'x.ttf', '--strict')
        self.assertLessEqual(set(map(ord, 'aegosBRS&8一二三永形國')), set(advances(self.path('x.ttf'))))
        subprocess.run(['ots-sanitize', self.path('x.ttf')], check=True, stdout=subprocess.DEVNULL)


if __name__ == '__main__':
    cli.main()
