"""T outside 0 … 1: as far as a glyph's topology holds; and the report, which says how far."""

import json
import os
import subprocess

import cli
import pyclipper
from fontTools import ttLib
from fontTools.pens.basePen import BasePen

SAMPLE = os.environ['VARIABLE_SAMPLE']
LETTERS = ''.join(map(chr, (*range(0x41, 0x5B), *range(0x61, 0x7B), *range(0x30, 0x3A)))) + '&@§éñ'


def compare(path, other, text):
    """Shared ink over all ink, and by how many units the first's advance is longer, of each character."""
    points = ' '.join(f'{ord(c):x}' for c in text).encode()
    lines = subprocess.run([SAMPLE, 'compare', 'none', path, '0', other], input=points, stdout=subprocess.PIPE, check=True)
    rows = [line.split() for line in lines.stdout.decode().splitlines()]
    assert len(rows) == len(text)
    return {chr(int(row[0], 16)): (float(row[1]), float(row[2])) for row in rows}


class Polygons(BasePen):
    """Outlines as polygons, eight lines a curve, in 64ths of a unit."""

    GRID, LINES = 64, 8

    def __init__(self, glyphs):
        super().__init__(glyphs)
        self.rings = []

    def _moveTo(self, point):
        self.rings.append([])
        self._lineTo(point)

    def _lineTo(self, point):
        self.rings[-1].append([round(self.GRID * number) for number in point])

    def _curveToOne(self, *points):
        start = self._getCurrentPoint()
        for t in (i / self.LINES for i in range(1, self.LINES + 1)):
            weights = ((1 - t) ** 3, 3 * (1 - t) ** 2 * t, 3 * (1 - t) * t ** 2, t ** 3)
            self._lineTo([sum(w * p[k] for w, p in zip(weights, (start, *points))) for k in (0, 1)])


def count_parts(font, character, wider):
    """Components and holes of a glyph, its outlines `wider` by so many units; none smaller than 20 square thousandths of the em."""
    glyphs = font.getGlyphSet()
    pen, union = Polygons(glyphs), pyclipper.Pyclipper()
    glyphs[font.getBestCmap()[ord(character)]].draw(pen)
    union.AddPaths(pen.rings, pyclipper.PT_SUBJECT, True)
    rings = union.Execute(pyclipper.CT_UNION, pyclipper.PFT_NONZERO, pyclipper.PFT_NONZERO)
    if wider:
        offset = pyclipper.PyclipperOffset()
        offset.AddPaths(rings, pyclipper.JT_MITER, pyclipper.ET_CLOSEDPOLYGON)
        rings = offset.Execute(wider * Polygons.GRID)
    least = 20 * (Polygons.GRID * font['head'].unitsPerEm / 1000) ** 2
    areas = [pyclipper.Area(ring) for ring in rings]
    return sum(area > least for area in areas), sum(area < -least for area in areas)


class Sampled(cli.Test):
    """Another union than the engine's, at every hundredth of T that the report allows beyond the ends."""

    LETTERS = LETTERS[:62]
    NEAR = 0.005 # whole units, and steps of the search for a limit: so close to it parts may have met

    def check(self, first, second):
        self.made('report', first, second, '--text', self.LETTERS, '-q', '-o', 'x.json')
        glyphs = json.loads(self.path('x.json').read_text())['glyphs']
        reach = {glyph['character']: glyph['reach'] for glyph in glyphs if 'character' in glyph}
        self.assertEqual(set(reach), set(self.LETTERS))
        for end, step in ((0, -1), (1, 1)):
            self.check_end(first, second, end, [round(end + step * i / 100, 2) for i in range(101)], reach)

    def check_end(self, first, second, end, places, reach):
        self.made('blend', first, second, '--text', self.LETTERS, '--at', ','.join(f'{t:g}' for t in places), '-q', '-o', 'x.ttf')
        counts = {}
        for t in places:
            font = ttLib.TTFont(self.path(f'x-{t:g}.ttf'))
            for character, (least, most) in reach.items():
                if t == end or least + self.NEAR <= t <= most - self.NEAR or t in (-1, 2) and t in (least, most):
                    self.check_glyph(font, character, t, counts)
        self.assertEqual(len(counts), len(reach))

    def check_glyph(self, font, character, t, counts):
        """What whole units part or close is together or open where the outlines are a unit wider or narrower."""
        wanted = counts.setdefault(character, count_parts(font, character, 0))
        self.assertTrue(any(count_parts(font, character, wider) == wanted for wider in (0, 1, -1)), (character, t, wanted))

    def test_a_family_keeps_its_parts(self):
        self.check(f'{cli.INTER}@wght=400', f'{cli.INTER}@wght=700')

    def test_a_sans_and_a_serif_keep_theirs(self):
        self.check(cli.DEBIAN / 'truetype/dejavu/DejaVuSans.ttf', cli.SERIF)


class Beyond(cli.Test):
    def test_a_family_goes_on_as_its_own_weights_do(self):
        self.made('blend', f'{cli.INTER}@wght=400', f'{cli.INTER}@wght=700', '--at', '1.3', '--text', LETTERS, '-q', '-o', 'x.ttf')
        rows = compare(self.path('x.ttf'), f'{cli.INTER}@wght=790', LETTERS)
        shares = sorted(share for share, _ in rows.values())
        self.assertGreater(shares[len(shares) // 2], 0.98)
        self.assertGreater(shares[0], 0.96)
        self.assertLessEqual(max(abs(apart) for _, apart in rows.values()), 1)
        self.assertEqual(ttLib.TTFont(self.path('x.ttf'))['OS/2'].usWeightClass, 790)

    def test_glyphs_stay_where_the_report_says(self):
        fonts, text = (cli.SANS_BOLD, cli.SERIF), 'HKhkino'
        self.made('report', *fonts, '--text', text, '-q', '-o', 'x.json')
        reach = {glyph['character']: glyph['reach'] for glyph in json.loads(self.path('x.json').read_text())['glyphs']}
        lines = self.made('blend', *fonts, '--text', text, '--at', '-1,2', '-v', '-o', 'x.ttf')
        for k, t in enumerate((-1, 2)):
            held = sorted(c for c, ends in reach.items() if ends[k] != t)
            said = [line for line in lines if f'short of T = {t},' in line]
            self.assertEqual(sorted(line.split('“')[1][0] for line in said), held)
            for line in said:
                self.assertIn(f'at {reach[line.split("“")[1][0]][k]:.2f}', line)
        self.assertTrue(any(ends != [-1, 2] for ends in reach.values()))
        for k, name in enumerate(('x--1.ttf', 'x-2.ttf')):
            for character, ends in reach.items():
                self.made('blend', *fonts, '--text', character, '--at', repr(ends[k]), '-q', '-o', 'at.ttf')
                share, apart = compare(self.path(name), self.path('at.ttf'), character)[character]
                self.assertGreater(share, 0.99, (character, ends[k]))
                self.assertLessEqual(abs(apart), 1)

    def test_places_within_do_not_depend_on_those_beyond(self):
        fonts = (cli.SANS_BOLD, cli.SERIF)
        self.made('blend', *fonts, '--text', 'Kkn', '--at', '0.5', '-q', '-o', 'alone.ttf')
        self.made('blend', *fonts, '--text', 'Kkn', '--at', '0.5,2', '-q', '-o', 'both.ttf')
        self.assertEqual(self.path('alone.ttf').read_bytes(), self.path('both-0.5.ttf').read_bytes())

    def test_same_bytes_for_any_number_of_threads(self):
        for jobs in (1, 3):
            self.made('blend', cli.SANS_BOLD, cli.SERIF, '--text', LETTERS, '--at', '1.4', '-q', '-j', jobs, '-o', f'{jobs}.ttf')
        self.assertEqual(self.path('1.ttf').read_bytes(), self.path('3.ttf').read_bytes())

    def test_links_stay_at_the_ends(self):
        fonts = (cli.SANS_BOLD, cli.SERIF)
        lines = self.made('blend', *fonts, '--text', 'nk', '--method', 'paper', '--at', '1.2', '-o', 'x.ttf')
        self.assertEqual([line for line in lines if 'short of' in line],
                         ['morphotype: 2 glyphs stay short of T = 1.2, where their drawing would come apart or close: '
                          '“k” (U+006B) at 1.00, “n” (U+006E) at 1.00'])
        self.made('blend', *fonts, '--text', 'nk', '--method', 'paper', '--at', '1', '-q', '-o', 'y.ttf')
        for _, (share, apart) in compare(self.path('x.ttf'), self.path('y.ttf'), 'nk').items():
            self.assertEqual((share, apart), (1, 0))

    def test_too_far(self):
        for t in ('-1.01', '2.01', 'nan', '1e9'):
            self.refused(2, 'blend', cli.SANS_BOLD, cli.SERIF, '--at', t, '-o', 'x.ttf', says=['--at', 'from -1 to 2'])
        self.refused(2, 'strip', cli.SANS_BOLD, cli.SERIF, '--text', 'a', '--at', '1.2', '-o', 'x.png', says=['--at', 'from 0 to 1'])


if __name__ == '__main__':
    cli.main()
