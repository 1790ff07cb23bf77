"""morphotype strip and sheet: sizes, pages, ink, and the same bytes each time."""

import re
import unittest
import xml.etree.ElementTree

import cli

SVG = '{http://www.w3.org/2000/svg}'


def pages_of(path):
    """The page count that a PDF's page tree gives (ISO 32000-1, 7.7.3.2)."""
    counts = re.findall(rb'/Type /Pages\s.*?/Count (\d+)', path.read_bytes(), re.DOTALL)
    assert len(counts) == 1, counts
    return int(counts[0])


class Strip(cli.Test):
    """One picture of a text at several T."""

    def strip(self, output, *arguments, fonts=(cli.SANS_BOLD, cli.SERIF)):
        self.assertEqual(self.made('strip', *fonts, '-o', output, *arguments), [])

    def image(self, *arguments, **options):
        self.strip('x.png', *arguments, **options)
        return cli.Image(self.path('x.png'))

    def test_short_text_has_its_steps_side_by_side(self):
        four = self.image('--text', 'Rg', '--steps', 4)
        eight = self.image('--text', 'Rg')
        self.assertEqual(four.height, eight.height)
        self.assertGreater(four.width, four.height)
        self.assertGreater(eight.width, 1.8 * four.width)

    def test_long_text_has_its_steps_below_one_another(self):
        two = self.image('--text', 'Morphotype', '--steps', 2)
        four = self.image('--text', 'Morphotype', '--steps', 4)
        self.assertEqual(two.width, four.width)
        self.assertGreater(four.height, 1.8 * two.height)

    def test_each_text_is_a_line(self):
        one = self.image('--text', 'Rg', '--steps', 2)
        two = self.image('--text', 'Rg', '--text', 'Rg', '--steps', 2)
        self.assertEqual(one.width, two.width)
        self.assertAlmostEqual(two.ink(), 2 * one.ink(), delta=0.1 * one.ink())
        self.strip('y.png', '--text', 'Rg\nRg', '--steps', 2)
        self.assertEqual(self.path('y.png').read_bytes(), self.path('x.png').read_bytes())

    def test_ink_goes_from_the_one_font_to_the_other(self):
        ink = [self.image('--text', 'HO', '--at', t, '--no-labels').ink() for t in ('0', '0.5', '1')]
        self.assertGreater(ink[0], 1.2 * ink[2])
        self.assertTrue(ink[0] > ink[1] > ink[2] > 500, ink)

    def test_labels_are_drawn_without_any_font(self):
        bare = self.image('--text', 'H', '--at', '0.25', '--no-labels')
        labelled = self.image('--text', 'H', '--at', '0.25')
        self.assertGreater(labelled.height, bare.height)
        self.assertGreater(labelled.ink(), bare.ink() + 50)

    def test_size_is_the_em(self):
        small, large = (self.image('--text', 'Rg', '--size', size, '--no-labels', '--steps', 2) for size in (50, 100))
        self.assertAlmostEqual(large.height, 2 * small.height, delta=2)
        self.assertAlmostEqual(large.width, 2 * small.width, delta=2)
        self.assertAlmostEqual(large.ink(), 4 * small.ink(), delta=0.05 * large.ink())

    def test_chinese(self):
        image = self.image('--text', '形', fonts=(cli.ZENHEI, cli.UKAI))
        self.assertGreater(image.ink(), 8 * 300)

    def test_text_is_shaped(self):
        """A base and a combining mark become one letter, as HarfBuzz does it."""
        apart = self.image('--text', 'ee\u0301', '--steps', 2)
        self.assertGreater(apart.ink(), self.image('--text', 'ee', '--steps', 2).ink())

    def test_svg(self):
        self.strip('x.svg', '--text', 'Rg', '--steps', 3, '--no-labels')
        root = xml.etree.ElementTree.parse(self.path('x.svg')).getroot()
        self.assertEqual(root.tag, SVG + 'svg')
        self.assertEqual(len([p for p in root.iter(SVG + 'path') if 'C' in p.get('d')]), 6)

    def test_pdf(self):
        self.strip('x.pdf', '--text', 'Rg')
        self.assertEqual(pages_of(self.path('x.pdf')), 1)

    def test_date_of_a_pdf(self):
        for epoch, date in (({}, b'20000101000000'), ({'SOURCE_DATE_EPOCH': '1700000000'}, b'20231114221320')):
            self.run_program('strip', cli.SANS_BOLD, cli.SERIF, '--text', 'A', '-o', 'x.pdf', env=epoch)
            dates = re.findall(rb'/CreationDate \((?:D:)?(\d+)', self.path('x.pdf').read_bytes())
            self.assertEqual(dates, [date])

    def test_same_bytes_each_time(self):
        for form in ('png', 'svg', 'pdf'):
            self.strip('x.' + form, '--text', 'Rg&', '-j', 1)
            self.strip('y.' + form, '--text', 'Rg&', '-j', 2)
            self.assertEqual(self.path('x.' + form).read_bytes(), self.path('y.' + form).read_bytes(), form)


class Sheet(cli.Test):
    """A grid of characters × steps."""

    def sheet(self, output, *arguments):
        return self.made('sheet', cli.SANS_BOLD, cli.SERIF, '-o', output, *arguments)

    def test_pages_of_a_pdf(self):
        self.sheet('x.pdf', '--text', 'abcdefghijk', '--rows', 4)
        self.assertEqual(pages_of(self.path('x.pdf')), 3)
        self.sheet('x.pdf', '--text', 'abcdefghijk', '--rows', 11)
        self.assertEqual(pages_of(self.path('x.pdf')), 1)

    def test_pages_of_a_png_are_files(self):
        self.sheet('x.png', '--text', 'abcde', '--rows', 2, '--steps', 3, '--size', 40)
        self.assertEqual(sorted(path.name for path in self.files()), ['x-2.png', 'x-3.png', 'x.png'])
        pages = [cli.Image(self.path(name)) for name in ('x.png', 'x-2.png', 'x-3.png')]
        self.assertEqual(len({(page.width, page.height) for page in pages}), 1)
        self.assertLess(pages[2].ink(), pages[0].ink())

    def test_svg(self):
        self.sheet('x.svg', '--text', 'ab')
        xml.etree.ElementTree.parse(self.path('x.svg'))

    def test_a_page_has_the_proportions_of_a4(self):
        self.sheet('x.png', '--chars', self.write('chars', 'U+0021-007E'), '--size', 30)
        page = cli.Image(self.path('x.png'))
        self.assertLessEqual(page.height, 1.42 * page.width)
        self.assertGreater(page.height, 1.42 * page.width - 32)

    def test_columns_go_from_the_one_font_to_the_other(self):
        self.sheet('x.png', '--text', 'HOMW', '--at', '0,1', '--size', 80)
        page = cli.Image(self.path('x.png'))
        right = page.width - 40 # the margin is half a cell
        first, second = page.ink(right - 160, right - 80), page.ink(right - 80, right)
        self.assertGreater(first, 1.2 * second)

    def test_characters_in_one_font_only_are_left_out(self):
        said = self.sheet('x.pdf', '--chars', self.write('chars', 'A 形'))
        self.assertEqual(said, ['morphotype: 1 character not in both fonts, left out: U+5F62'])

    def test_same_bytes_each_time(self):
        for form in ('png', 'svg', 'pdf'):
            for name in 'xy':
                self.sheet(f'{name}.{form}', '--text', 'Rg&')
            self.assertEqual(self.path('x.' + form).read_bytes(), self.path('y.' + form).read_bytes(), form)


if __name__ == '__main__':
    unittest.TestCase.maxDiff = None
    cli.main()
