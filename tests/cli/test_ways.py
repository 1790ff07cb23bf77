"""T of heights apart from that of widths, and places of single glyphs."""

import re

import cli
from fontTools import ttLib
from fontTools.pens.recordingPen import DecomposingRecordingPen

LETTERS = 'HIOTnoaekv'


def coordinates(path, character):
    """All x and all y of a character's outline, its advance, and the font."""
    font = ttLib.TTFont(path)
    glyphs, name = font.getGlyphSet(), font.getBestCmap()[ord(character)]
    pen = DecomposingRecordingPen(glyphs)
    glyphs[name].draw(pen)
    points = [p for _, arguments in pen.value for p in arguments if p]
    return [p[0] for p in points], [p[1] for p in points], font['hmtx'][name][0], font


class Directions(cli.Test):
    FONTS = (cli.SANS_BOLD, cli.SERIF)

    def blended(self, name, at, *options, text=LETTERS):
        return self.made('blend', *self.FONTS, '--text', text, '--at', at, *options, '-o', name)

    def test_x_is_that_of_the_one_place_and_y_that_of_the_other(self):
        self.blended('x.ttf', '0.3', '-q')
        self.blended('y.ttf', '0.6', '-q')
        self.assertEqual([line for line in self.blended('xy.ttf', '0.3,y=0.6') if 'short of' in line], [])
        compared = 0
        for character in LETTERS:
            across, up, both = (coordinates(self.path(f'{name}.ttf'), character) for name in ('x', 'y', 'xy'))
            for axis, one in ((0, across), (1, up)): # contours may begin elsewhere, and points between two others are left out
                if len(both[axis]) == len(one[axis]):
                    self.assertLessEqual(max(abs(p - q) for p, q in zip(sorted(both[axis]), sorted(one[axis]))), 1, character)
                    compared += 1
                self.assertLessEqual(abs(min(both[axis]) - min(one[axis])), 1, character)
                self.assertLessEqual(abs(max(both[axis]) - max(one[axis])), 1, character)
            self.assertEqual(both[2], across[2])
        self.assertGreater(compared, len(LETTERS))
        x, y, both = (ttLib.TTFont(self.path(f'{name}.ttf')) for name in ('x', 'y', 'xy'))
        for field in ('sxHeight', 'sCapHeight', 'sTypoAscender', 'yStrikeoutSize'):
            self.assertEqual(getattr(both['OS/2'], field), getattr(y['OS/2'], field))
        for field in ('usWeightClass', 'usWidthClass', 'ySubscriptXSize'):
            self.assertEqual(getattr(both['OS/2'], field), getattr(x['OS/2'], field))
        self.assertEqual(both['name'].getDebugName(2), 'Regular')
        self.assertIn('0.3,y=0.6', both['name'].getDebugName(17))

    def test_same_t_in_both_is_that_t(self):
        self.blended('one.ttf', '0.4', '-q')
        self.blended('two.ttf', '0.4,y=0.4', '-q')
        self.assertEqual(self.path('one.ttf').read_bytes(), self.path('two.ttf').read_bytes())

    def test_several_places(self):
        self.blended('x.ttf', '0.25,0.3,y=0.6,0.75', '-q')
        self.assertEqual(sorted(p.name for p in self.directory.iterdir()), ['x-0.25.ttf', 'x-0.3,y=0.6.ttf', 'x-0.75.ttf'])
        self.blended('alone.ttf', '0.3,y=0.6', '-q')
        self.assertEqual(self.path('alone.ttf').read_bytes(), self.path('x-0.3,y=0.6.ttf').read_bytes())
        self.made('strip', *self.FONTS, '--text', 'Ha', '--at', '0,0.3,y=0.6,1', '-o', 'x.svg')
        self.made('sheet', *self.FONTS, '--text', 'Ha', '--at', '0.3,y=0.6', '-o', 'x.png')

    def test_links_have_directions_too(self):
        self.blended('x.ttf', '0.2', '-q', '--method', 'paper', text='Io')
        self.blended('y.ttf', '0.7', '-q', '--method', 'paper', text='Io')
        self.blended('xy.ttf', '0.2,y=0.7', '-q', '--method', 'paper', text='Io')
        for character in 'Io':
            across, up, both = (coordinates(self.path(f'{name}.ttf'), character) for name in ('x', 'y', 'xy'))
            for axis, one in ((0, across), (1, up)):
                self.assertLessEqual(abs(min(both[axis]) - min(one[axis])), 1)
                self.assertLessEqual(abs(max(both[axis]) - max(one[axis])), 1)

    def test_what_would_not_hold_stays_near_and_is_named(self):
        lines = self.made('blend', cli.DEMO_SANS, cli.DEMO_SERIF, '--text', 'gR', '--at', '1,y=0', '-o', 'x.ttf')
        said = [line for line in lines if 'short of' in line]
        self.assertEqual(len(said), 1, lines)
        self.assertIn('1 glyph stays short of T = 1,y=0,', said[0])
        x, y = re.search(r'“g” \(U\+0067\) at (0\.\d+),y=(0\.\d+)$', said[0]).groups()
        self.assertAlmostEqual(float(x) + float(y), 1, delta=0.011)
        # Where it stays it is what is asked for there.
        self.made('blend', cli.DEMO_SANS, cli.DEMO_SERIF, '--text', 'gR', '--at', f'{x},y={y}', '-q', '-o', 'y.ttf')
        held, there = (coordinates(self.path(name), 'g') for name in ('x.ttf', 'y.ttf'))
        for axis in (0, 1): # the line has two decimals
            self.assertLess(abs(min(held[axis]) - min(there[axis])), 12)
            self.assertLess(abs(max(held[axis]) - max(there[axis])), 12)

    def test_wrong_places(self):
        for at in ('0.3,y=', '0.3,y', 'y=0.3', '0.3,y=0.4,y=0.5', '0.3,y=2.5', '0.3,y=nan', '0.3, y=0.4'):
            self.refused(2, 'blend', *self.FONTS, '--at', at, '-o', 'x.ttf', says=['--at', 'from -1 to 2'])
        self.refused(2, 'strip', *self.FONTS, '--text', 'a', '--at', '0.5,y=1.2', '-o', 'x.png', says=['--at', 'from 0 to 1'])
        self.refused(2, 'blend', *self.FONTS, '--at', '0.3,y=0.6,0.3,y=0.6', '-o', 'x.ttf', says=['stands there twice'])
        self.refused(2, 'blend', *self.FONTS, '--at', '0.3,y=0.6', '--rotate', '10', '-o', 'x.ttf', says=['--at T,y=T and --rotate'])
        self.refused(2, 'solid', cli.SOURCE / 'solids/block.obj', cli.SOURCE / 'solids/goblet.obj', '--at', '0.3,y=0.6', '-o', 'x.obj',
                     says=['--at', 'from 0 to 1'])


class Places(cli.Test):
    FONTS = (cli.SANS_BOLD, cli.SERIF)

    def blended(self, name, *options):
        return self.made('blend', *self.FONTS, '--text', 'aégAVTo', *options, '-o', name)

    def refused_file(self, text, says):
        self.path('places.txt').write_text(text)
        self.refused(1, 'blend', *self.FONTS, '--places', 'places.txt', '-o', 'x.ttf', says=['places.txt', *says])

    def test_glyphs_are_at_their_places(self):
        self.path('places.txt').write_text('# of two\na é   0.25 # both\n\n/g\t0.3,y=0.6\n')
        self.blended('x.ttf', '--at', '0.75', '--places', 'places.txt', '-q')
        for at, characters in (('0.25', 'aé'), ('0.75', 'AVTo'), ('0.3,y=0.6', 'g')):
            self.blended('at.ttf', '--at', at, '-q')
            for character in characters:
                self.assertEqual(coordinates(self.path('x.ttf'), character)[:3], coordinates(self.path('at.ttf'), character)[:3])

    def test_an_accented_letter_is_at_its_own_place(self):
        self.path('places.txt').write_text('e 0\n')
        self.made('blend', *self.FONTS, '--text', 'eé\u0301', '--at', '0.75', '--places', 'places.txt', '-q', '-o', 'x.ttf')
        self.made('blend', *self.FONTS, '--text', 'eé\u0301', '--at', '0.75', '-q', '-o', 'y.ttf')
        self.assertEqual(coordinates(self.path('x.ttf'), 'é')[2], coordinates(self.path('y.ttf'), 'é')[2])
        self.assertNotEqual(coordinates(self.path('x.ttf'), 'e')[2], coordinates(self.path('y.ttf'), 'e')[2])
        for axis in (0, 1):
            one, other = (coordinates(self.path(name), 'é')[axis] for name in ('x.ttf', 'y.ttf'))
            self.assertLessEqual(abs(max(one) - max(other)), 1)

    def test_kerning_is_at_the_mean(self):
        def kerning(left, right, *options):
            self.blended('k.ufo', *options, '-q')
            import plistlib
            pairs = plistlib.loads(self.path('k.ufo/kerning.plist').read_bytes())
            groups = plistlib.loads(self.path('k.ufo/groups.plist').read_bytes())
            of = lambda side, glyph: [glyph, *(g for g, members in groups.items() if g.startswith(side) and glyph in members)]
            found = [pairs[l][r] for l in of('public.kern1', left) for r in of('public.kern2', right) if r in pairs.get(l, {})]
            return found[0] if found else 0
        self.path('places.txt').write_text('A 0\nT 1\n')
        for pair in ('AV', 'TA', 'To'):
            ends = [kerning(*pair, '--at', t) for t in (0, 1)]
            place = {'A': 0, 'T': 1}
            t = (place.get(pair[0], 0.5) + place.get(pair[1], 0.5)) / 2
            wanted = ends[0] + t * (ends[1] - ends[0])
            self.assertAlmostEqual(kerning(*pair, '--at', 0.5, '--places', 'places.txt'), wanted, delta=1, msg=pair)

    def test_same_bytes_for_any_number_of_threads(self):
        self.path('places.txt').write_text('a é 0.25\n')
        for jobs in (1, 3):
            self.blended(f'{jobs}.ttf', '--places', 'places.txt', '-q', '-j', jobs)
        self.assertEqual(self.path('1.ttf').read_bytes(), self.path('3.ttf').read_bytes())

    def test_wrong_files(self):
        self.refused_file('', ['no places'])
        self.refused_file('a\n', ['places.txt:1: characters or glyphs are wanted, then T'])
        self.refused_file('# T\n\na 3\n', ['places.txt:3:', 'from -1 to 2'])
        self.refused_file('0.5\n', ['places.txt:1:'])
        self.refused_file('a 0.5,0.6\n', ['places.txt:1:'])
        self.refused_file('a 0.5\n\ue123 0.5\n', ['places.txt:2:', 'has no character U+E123'])
        self.refused_file('/nosuch 0.5\n', ['places.txt:1:', 'has no glyph /nosuch'])
        self.refused_file('a b 0.5\nc 0.1\n/a 0.6\n', ['places.txt:3: /a has a place on line 1 already'])
        self.refused_file('U+0062-61 0.5\n', ['places.txt:1: the range runs backwards'])
        self.path('places.txt').write_bytes(b'a 0.5\n\xff 0.5\n')
        self.refused(1, 'blend', *self.FONTS, '--places', 'places.txt', '-o', 'x.ttf', says=['places.txt:2: not UTF-8'])
        self.refused(1, 'blend', *self.FONTS, '--places', 'none.txt', '-o', 'x.ttf', says=['none.txt'])
        self.path('places.txt').write_text('a 0.5,y=0.6\n')
        self.refused(1, 'blend', *self.FONTS, '--rotate', 'auto', '--places', 'places.txt', '-o', 'x.ttf', says=['places.txt:1:', '--rotate'])

    def test_beyond_what_holds(self):
        self.path('places.txt').write_text('o 2\n')
        lines = self.blended('x.ttf', '--places', 'places.txt', '--at', '0.5')
        said = [line for line in lines if 'short of' in line]
        self.assertEqual(len(said), 1, lines)
        self.assertIn('1 glyph stays short of T = 2, where its drawing would come apart or close: “o”', said[0])


if __name__ == '__main__':
    cli.main()
