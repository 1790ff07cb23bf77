"""morphotype inspect: its data against themselves and against fontTools' areas; its pictures."""

import json
import unittest

import cli
from fontTools import ttLib
from fontTools.pens.areaPen import AreaPen


def drawn_area(path, character):
    """The area that the outline's curves enclose, em²; right where no contours overlap."""
    font = ttLib.TTFont(path)
    glyphs, units = font.getGlyphSet(), font['head'].unitsPerEm
    pen = AreaPen(glyphs)
    glyphs[font.getBestCmap()[ord(character)]].draw(pen)
    return abs(pen.value) / units / units


class Data(cli.Test):
    """--json"""

    def inspect(self, *arguments):
        result = self.run_program('inspect', *arguments, '--json')
        self.assertEqual((result.returncode, result.stderr), (0, b''))
        data = json.loads(result.stdout)
        self.assertEqual((data['format'], data['version']), ('morphotype inspection', 1))
        return data

    def check_side(self, side):
        first = 0
        for index, component in enumerate(side['components']):
            pieces = side['pieces'][first:first + component['piece_count']]
            self.assertEqual(component['first_piece'], first)
            self.assertEqual([piece['component'] for piece in pieces], [index] * component['piece_count'])
            if pieces:
                self.assertAlmostEqual(sum(piece['area'] for piece in pieces), component['area'], places=6)
            first += component['piece_count']
        self.assertEqual(first, len(side['pieces']))
        self.assertAlmostEqual(sum(part['area'] for part in side['components']), side['area'], places=6)

    def aligned(self, side):
        """The components that move by contours: those without pieces."""
        return {index for index, part in enumerate(side['components']) if part['piece_count'] == 0}

    def check_matches(self, glyph):
        """In order, none twice, both components aligned or neither, and every component that is not has a partner."""
        matches = list(map(tuple, glyph['matches']))
        self.assertEqual(matches, sorted(set(matches)))
        in_a, in_b = self.aligned(glyph['a']), self.aligned(glyph['b'])
        for a, b in matches:
            self.assertEqual(a in in_a, b in in_b)
        for side, (key, aligned) in enumerate((('a', in_a), ('b', in_b))):
            self.assertEqual({match[side] for match in matches} | aligned, set(range(len(glyph[key]['components']))))

    def check_links(self, glyph):
        """In order, none twice, within matched components; every piece has one."""
        links = list(map(tuple, glyph['links']))
        self.assertEqual(links, sorted(set(links)))
        owners = [[piece['component'] for piece in glyph[key]['pieces']] for key in 'ab']
        linked = {(owners[0][a], owners[1][b]) for a, b in links}
        self.assertLessEqual(linked, set(map(tuple, glyph['matches'])))
        for side, key in enumerate('ab'):
            self.assertEqual({link[side] for link in links}, set(range(len(glyph[key]['pieces']))))

    def check_contours(self, glyph):
        """As many points on both sides, all of them on or about the glyph; some where a component is aligned."""
        self.assertEqual(bool(glyph['contours']), bool(self.aligned(glyph['a']) | self.aligned(glyph['b'])))
        for contour in glyph['contours']:
            self.assertEqual(len(contour['a']), len(contour['b']))
            self.assertGreater(len(contour['a']), 1)
            for x, y in contour['a'] + contour['b']:
                self.assertTrue(-0.5 < x < 1.5 and -0.5 < y < 1.5, (x, y))

    def check_glyph(self, glyph):
        self.check_side(glyph['a'])
        self.check_side(glyph['b'])
        self.check_matches(glyph)
        self.check_links(glyph)
        self.check_contours(glyph)

    def test_latin(self):
        data = self.inspect(cli.SANS_BOLD, cli.SERIF, '--text', 'oiB%&')
        self.assertEqual([glyph['character'] for glyph in data['glyphs']], list('oiB%&'))
        self.assertEqual(data['a'], {'font': str(cli.SANS_BOLD), 'family': 'DejaVu Sans', 'style': 'Bold'})
        for glyph in data['glyphs']:
            self.check_glyph(glyph)
            self.assertEqual(glyph['rotation'], 0)
        holes = [[part['holes'] for part in glyph['a']['components']] for glyph in data['glyphs']]
        self.assertEqual([sorted(h) for h in holes], [[1], [0, 0], [2], [0, 1, 1], [1]])

    def test_an_aligned_letter_is_contours(self):
        glyph = self.inspect(cli.SANS_BOLD, cli.SERIF, '--text', 'o')['glyphs'][0]
        self.assertEqual((len(glyph['contours']), glyph['links']), (2, []))
        for side in 'ab':
            self.assertEqual((self.aligned(glyph[side]), glyph[side]['pieces']), ({0}, []))

    def test_the_method_of_the_paper_has_links_alone(self):
        for glyph in self.inspect(cli.SANS_BOLD, cli.SERIF, '--text', 'oiB', '--method', 'paper')['glyphs']:
            self.check_glyph(glyph)
            self.assertEqual(glyph['contours'], [])
            for key, font in (('a', cli.SANS_BOLD), ('b', cli.SERIF)):
                alone = self.inspect(font, '--text', glyph['character'])['glyphs'][0]['a']
                self.assertEqual((self.aligned(glyph[key]), glyph[key]), (set(), alone))
            self.assertGreaterEqual(len(glyph['links']), len(glyph['a']['pieces']))

    def test_chinese(self):
        data = self.inspect(cli.ZENHEI, cli.UKAI, '--text', '形三國')
        for glyph in data['glyphs']:
            self.check_glyph(glyph)
        self.assertEqual([glyph['code_point'] for glyph in data['glyphs']], [0x5f62, 0x4e09, 0x570b])
        self.assertEqual(len(data['glyphs'][1]['matches']), 3)

    def test_both_sides_are_cut_into_as_many(self):
        """國 is three components in the one font and five in the other: cut, five in both, with the same ink."""
        drawn, cut = (self.inspect(cli.ZENHEI, cli.UKAI, '--text', '國', *method)['glyphs'][0]
                      for method in (('--method', 'paper'), ()))
        self.check_glyph(drawn)
        self.check_glyph(cut)
        self.assertEqual([len(drawn[side]['components']) for side in 'ab'], [3, 5])
        self.assertEqual([len(cut[side]['components']) for side in 'ab'], [5, 5])
        for side in 'ab':
            self.assertEqual(cut[side]['area'], drawn[side]['area'])
        self.assertEqual(sorted(match[1] for match in cut['matches']), list(range(5)))

    def test_areas_are_those_of_the_outlines(self):
        data = self.inspect(cli.SANS_BOLD, cli.SERIF, '--text', 'loSg8', '--tolerance', '0.05')
        for glyph in data['glyphs']:
            for side, path in (('a', cli.SANS_BOLD), ('b', cli.SERIF)):
                self.assertAlmostEqual(glyph[side]['area'], drawn_area(path, glyph['character']), delta=1e-4)

    def test_a_rectangle(self):
        """DejaVu's l is one rectangle: one piece, whose centre is its middle."""
        font = ttLib.TTFont(cli.SANS_BOLD)
        glyph, units = font['glyf']['l'], font['head'].unitsPerEm
        side = self.inspect(cli.SANS_BOLD, '--text', 'l')['glyphs'][0]['a']
        self.assertEqual(side['advance'], round(font['hmtx']['l'][0] / units, 9))
        self.assertEqual(len(side['pieces']), 1)
        middle = ((glyph.xMin + glyph.xMax) / 2 / units, (glyph.yMin + glyph.yMax) / 2 / units)
        for value, expected in zip(side['pieces'][0]['centre'], middle):
            self.assertAlmostEqual(value, expected, delta=1e-5)
        self.assertEqual(side['pieces'][0]['corners'], 4)

    def test_one_font(self):
        data = self.inspect(cli.SERIF, '--text', 'g')
        self.assertNotIn('b', data)
        glyph = data['glyphs'][0]
        self.assertEqual(set(glyph), {'character', 'code_point', 'a'})
        self.check_side(glyph['a'])
        both = self.inspect(cli.SERIF, cli.SANS_BOLD, '--text', 'g', '--method', 'paper')['glyphs'][0]
        self.assertEqual(both['a'], glyph['a'])

    def test_a_blank(self):
        glyph = self.inspect(cli.SANS_BOLD, cli.SERIF, '--text', ' ')['glyphs'][0]
        self.assertEqual((glyph['a']['components'], glyph['b']['pieces'], glyph['links']), ([], [], []))

    def test_given_rotation(self):
        straight = self.inspect(cli.SANS_BOLD, cli.SERIF, '--text', 'R')['glyphs'][0]
        for method in ('joint', 'paper'):
            turned = self.inspect(cli.SANS_BOLD, cli.SERIF, '--text', 'R', '--rotate', '-30.5', '--method',
                                  method)['glyphs'][0]
            self.assertEqual(turned['rotation'], -30.5)
            self.check_glyph(turned)
            self.assertAlmostEqual(turned['b']['area'], straight['b']['area'], places=5)

    def middle_of_b(self, glyph):
        """The barycentre of B's ink, from its pieces."""
        pieces = glyph['b']['pieces']
        area = sum(piece['area'] for piece in pieces)
        return [sum(piece['area'] * piece['centre'][axis] for piece in pieces) / area for axis in (0, 1)]

    def test_centres_are_given_before_the_turn(self):
        """Turning B for the matching moves none of the centres that the data give."""
        paper = '--text', 'L', '--method', 'paper'
        straight, turned = (self.inspect(cli.SANS_BOLD, cli.SERIF, *paper, *turn)['glyphs'][0]
                            for turn in ((), ('--rotate', '90')))
        for value, expected in zip(self.middle_of_b(turned), self.middle_of_b(straight)):
            self.assertAlmostEqual(value, expected, delta=1e-4)

    def test_contours_are_given_before_the_turn(self):
        """Nor does it move B's ends of the contours out of B's own box."""
        glyph = ttLib.TTFont(cli.SERIF)['glyf']['L']
        box = [value / 2048 for value in (glyph.xMin, glyph.yMin, glyph.xMax, glyph.yMax)]
        for turn in ((), ('--rotate', '90')):
            contour, = self.inspect(cli.SANS_BOLD, cli.SERIF, '--text', 'L', *turn)['glyphs'][0]['contours']
            ends = list(zip(*contour['b']))
            for value, expected in zip([*map(min, ends), *map(max, ends)], box):
                self.assertAlmostEqual(value, expected, delta=1e-3)

    def test_into_a_file(self):
        self.assertEqual(self.made('inspect', cli.SERIF, '--text', 'g', '-o', 'x.json'), [])
        result = self.run_program('inspect', cli.SERIF, '--text', 'g', '--json')
        self.assertEqual(self.path('x.json').read_bytes(), result.stdout)

    def test_same_bytes_each_time(self):
        outputs = {self.run_program('inspect', cli.ZENHEI, cli.UKAI, '--text', '形', '--json').stdout for _ in range(2)}
        self.assertEqual(len(outputs), 1)


class Picture(cli.Test):
    """-o"""

    def test_formats(self):
        for form, start in (('png', b'\x89PNG'), ('svg', b'<?xml'), ('pdf', b'%PDF')):
            self.assertEqual(self.made('inspect', cli.SANS_BOLD, cli.SERIF, '--text', 'Ri', '-o', 'x.' + form), [])
            self.assertTrue(self.path('x.' + form).read_bytes().startswith(start))

    def test_with_data(self):
        result = self.run_program('inspect', cli.SANS_BOLD, '--text', 'R', '-o', 'x.png', '--json')
        self.assertEqual(json.loads(result.stdout)['glyphs'][0]['character'], 'R')
        self.assertGreater(cli.Image(self.path('x.png')).width, 100)

    def test_sizes(self):
        sizes = {}
        for name, arguments in (('one', [cli.SERIF]), ('two', [cli.SERIF, cli.SANS_BOLD])):
            self.made('inspect', *arguments, '--text', 'R', '--size', 200, '-o', 'x.png')
            image = cli.Image(self.path('x.png'))
            sizes[name] = (image.width, image.height)
            self.assertGreater(image.ink(), 1000)
        self.assertEqual(sizes['one'][1], sizes['two'][1])
        self.assertGreater(sizes['two'][0], 1.7 * sizes['one'][0])

    def test_components_have_colours(self):
        self.made('inspect', cli.SERIF, '--text', '%', '-o', 'x.png')
        colours = {bytes(row[i:i + 3]) for row in cli.Image(self.path('x.png')).rows for i in range(0, len(row), 3)}
        coloured = {colour for colour in colours if max(colour) - min(colour) > 40}
        self.assertGreater(len(coloured), 3)


if __name__ == '__main__':
    unittest.TestCase.maxDiff = None
    cli.main()
