"""morphotype blend: the curves of a half-way glyph, as a designer would count them."""

import cli
from fontTools import ttLib

ROUND = 'osS'


def contours(font, char):
    """The on-curve flags of each contour of a character's glyph."""
    glyph = font['glyf'][font.getBestCmap()[ord(char)]]
    flags, start = list(glyph.flags), 0
    for end in glyph.endPtsOfContours:
        yield [flag & 1 for flag in flags[start : end + 1]]
        start = end + 1


def points(font, char):
    return sum(len(contour) for contour in contours(font, char))


def longest_straight_run(contour):
    """The most segments in a row, around the contour, that join two on-curve points directly."""
    straight = [a and b for a, b in zip(contour, contour[1:] + contour[:1])]
    if all(straight):
        return len(straight)
    first = straight.index(False)
    runs = ''.join('x' if s else ' ' for s in straight[first:] + straight[:first]).split()
    return max(map(len, runs), default=0)


class Curves(cli.Test):
    def setUp(self):
        super().setUp()
        self.made('blend', cli.SANS_BOLD, cli.SERIF, '--at', '0.5', '--text', ROUND, '-o', 'x.ttf')
        self.blend = ttLib.TTFont(self.path('x.ttf'))
        self.ends = [ttLib.TTFont(path) for path in (cli.SANS_BOLD, cli.SERIF)]

    def test_round_letters_have_curves(self):
        for char in ROUND:
            for contour in contours(self.blend, char):
                self.assertGreaterEqual(contour.count(0), 4, char)
                self.assertLessEqual(longest_straight_run(contour), 4, char)

    def test_points_stay_few(self):
        for char in ROUND:
            most = max(points(font, char) for font in self.ends)
            self.assertLessEqual(points(self.blend, char), 2 * most, char)


if __name__ == '__main__':
    cli.main()
