"""morphotype blend: accented letters built from their parts, where both fonts build them so."""

import subprocess

import cli
from fontTools import ttLib
from fontTools.pens.areaPen import AreaPen
from fontTools.pens.boundsPen import BoundsPen

ACCENTED = 'éàüôñíçöŝ'


def drawn(font, character):
    """Bounds and area of a character, in em."""
    glyphs, units = font.getGlyphSet(), font['head'].unitsPerEm
    bounds, area = BoundsPen(glyphs), AreaPen(glyphs)
    glyph = glyphs[font.getBestCmap()[ord(character)]]
    glyph.draw(bounds)
    glyph.draw(area)
    return [v / units for v in bounds.bounds], abs(area.value) / units ** 2


def references(font, character):
    """The characters or names of the parts, and where they are moved to."""
    glyph = font['glyf'][font.getBestCmap()[ord(character)]]
    if not glyph.isComposite():
        return None
    return {part.glyphName: (part.x, part.y) for part in glyph.components}


class References(cli.Test):
    def blend(self, *arguments, name='x.ttf'):
        self.made('blend', cli.SANS_BOLD, cli.SERIF, '-q', '-o', name, *arguments)

    def open(self, name):
        subprocess.run(['ots-sanitize', self.path(name)], check=True, stdout=subprocess.DEVNULL)
        return ttLib.TTFont(self.path(name))

    def setUp(self):
        super().setUp()
        self.letters = self.write('letters', 'U+0041-005A U+0060-007A U+00A1-00FF ĄęŞŝı U+02C6-02DD')

    def test_kept_with_blended_offsets(self):
        self.blend('--chars', self.letters, '--at', '0,0.3,1')
        a, b = (ttLib.TTFont(path) for path in (cli.SANS_BOLD, cli.SERIF))
        for t in (0, 0.3, 1):
            font, kept = self.open(f'x-{t}.ttf'), 0
            for character in map(chr, font.getBestCmap()):
                found, in_a, in_b = (references(f, character) for f in (font, a, b))
                if not found or not in_a or set(found) != set(in_a) or set(found) != set(in_b):
                    continue
                kept += 1
                for part in found:
                    for offset, from_a, from_b in zip(found[part], in_a[part], in_b[part]):
                        self.assertAlmostEqual(offset, (1 - t) * from_a + t * from_b, delta=0.5, msg=(character, part))
            self.assertGreater(kept, 25)
            self.assertEqual({c for c in 'éàüôñí' if references(font, c) is None}, set())

    def test_draw_what_the_sources_draw(self):
        self.blend('--chars', self.letters, '--at', '0,1')
        for t, path in (('0', cli.SANS_BOLD), ('1', cli.SERIF)):
            font, source = self.open(f'x-{t}.ttf'), ttLib.TTFont(path)
            for character in ACCENTED:
                (bounds, area), (expected, expected_area) = drawn(font, character), drawn(source, character)
                for found, wanted in zip(bounds, expected):
                    self.assertAlmostEqual(found, wanted, delta=0.0015, msg=(t, character))
                self.assertAlmostEqual(area, expected_area, delta=0.03 * expected_area, msg=(t, character))

    def test_half_way_as_the_whole(self):
        """A rotation by nothing is one all the same, and turns the whole drawing."""
        self.blend('--chars', self.letters)
        self.blend('--chars', self.letters, '--rotate', '0', name='whole.ttf')
        parts, whole = self.open('x.ttf'), self.open('whole.ttf')
        for character in 'éàüôñí':
            self.assertIsNone(references(whole, character))
            for found, wanted in zip(drawn(parts, character)[0], drawn(whole, character)[0]):
                self.assertAlmostEqual(found, wanted, delta=0.002, msg=character)

    def test_drawn_whole_where_the_parts_overlap(self):
        self.blend('--chars', self.letters, '--at', '0,0.5,1')
        for t in ('0', '0.5', '1'):
            font = self.open(f'x-{t}.ttf')
            self.assertEqual([c for c in 'ÇçĄęŞ' if references(font, c)], [])
            self.assertTrue(references(font, 'é'))

    def test_drawn_whole_where_a_part_is_missing(self):
        self.blend('--text', 'éà`')
        font = self.open('x.ttf')
        self.assertIsNone(references(font, 'é'))
        self.assertIsNone(references(font, 'à'))

    def test_hints_for_the_whole(self):
        hints = self.write('hints', 'glyph é\ncomponent 700,500 700,500\n')
        self.blend('--chars', self.letters, '--hints', hints)
        font = self.open('x.ttf')
        self.assertIsNone(references(font, 'é'))
        self.assertTrue(references(font, 'à'))

    def test_a_place_in_a_variable_font(self):
        """References of a variable font are where the axes move them to."""
        bold = f'{cli.INTER}@wght=900'
        self.made('blend', bold, bold, '-q', '--chars', self.letters, '--at', '0', '-o', 'x.ttf')
        self.made('blend', bold, bold, '-q', '--chars', self.letters, '--at', '0', '--rotate', '0', '-o', 'whole.ttf')
        font, whole = self.open('x.ttf'), self.open('whole.ttf')
        for character in 'éàüôñí':
            self.assertTrue(references(font, character))
            for found, wanted in zip(drawn(font, character)[0], drawn(whole, character)[0]):
                self.assertAlmostEqual(found, wanted, delta=0.001, msg=character)

    def test_same_bytes_for_any_number_of_threads(self):
        for jobs in (1, 2, 7):
            self.blend('--chars', self.letters, '-j', jobs, name=f'{jobs}.ttf')
        self.assertEqual(len({self.path(f'{jobs}.ttf').read_bytes() for jobs in (1, 2, 7)}), 1)

    def test_several_places_and_one(self):
        self.blend('--chars', self.letters, '--at', '0.25,0.5')
        self.blend('--chars', self.letters, '--at', '0.25', name='y.ttf')
        self.assertEqual(self.path('x-0.25.ttf').read_bytes(), self.path('y.ttf').read_bytes())


if __name__ == '__main__':
    cli.main()
