"""T outside 0 … 1: as far as a glyph's topology holds; and the report, which says how far."""

import json
import os
import subprocess

import cli
from fontTools import ttLib

SAMPLE = os.environ['VARIABLE_SAMPLE']
LETTERS = ''.join(map(chr, (*range(0x41, 0x5B), *range(0x61, 0x7B), *range(0x30, 0x3A)))) + '&@§éñ'


def compare(path, other, text):
    """Shared ink over all ink, and by how many units the first's advance is longer, of each character."""
    points = ' '.join(f'{ord(c):x}' for c in text).encode()
    lines = subprocess.run([SAMPLE, 'compare', 'none', path, '0', other], input=points, stdout=subprocess.PIPE, check=True)
    rows = [line.split() for line in lines.stdout.decode().splitlines()]
    assert len(rows) == len(text)
    return {chr(int(row[0], 16)): (float(row[1]), float(row[2])) for row in rows}


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
