"""animate in players of others: the same picture at nine times in Chromium, lottie-web and librlottie, nothing said, nothing fetched."""

import ctypes
import os
import sys

import oracles

try:
    import players
    ctypes.CDLL(players.RLOTTIE)
except (ImportError, OSError) as missing:
    print('not installed:', missing)
    sys.exit(77)

from PIL import ImageDraw

import animations
import browser
import cli

LEAST = 0.99 # intersection over union


def holes(image):
    """Light regions within the ink, at a quarter of the size."""
    light = image.reduce(4).point(lambda value: 255 * (value >= 128))
    ImageDraw.floodfill(light, (0, 0), 0)
    count = 0
    while light.getbbox():
        left, top, right, _ = light.getbbox()
        ImageDraw.floodfill(light, next((x, top) for x in range(left, right) if light.getpixel((x, top))), 0)
        count += 1
    return count


class Play(cli.Test):
    def setUp(self):
        super().setUp()
        modules = oracles.Oracles(os.environ['ORACLES']).directory.resolve() / 'node_modules'
        self.players = players.Players(self.directory, modules, self.made)
        self.addCleanup(self.players.close)


class Pairs(Play):
    """All pairs in all players."""

    def test_players_agree_with_the_frames(self):
        self.assertEqual(len(animations.PAIRS), 20)
        for pair in animations.PAIRS:
            for player, scores in self.players.scores(pair).items():
                self.assertEqual(len(scores), 9)
                with self.subTest(pair=pair[0], player=player):
                    self.assertGreaterEqual(min(scores), LEAST, scores)


class Single(Play):
    """What is looked at on a single pair."""

    def test_a_ring_stays_a_ring(self):
        for keys in (('ring', 'frame'), ('ring', f'{cli.DEMO_SANS}=o'), (f'{cli.DEMO_SANS}=o', f'{cli.DEMO_SERIF}=o')):
            for player, pictures in self.players.play(animations.key_frames(('ring', *keys), self.directory)).items():
                self.assertEqual([holes(image) for image in pictures], [1] * 9, (keys, player))

    def test_what_does_not_agree_is_seen(self):
        """Neighbouring times are told apart, so the measure sees a player that is an eighth of a second late."""
        own = self.players.frames([f'{cli.DEMO_SANS}=g', f'{cli.DEMO_SERIF}=8'])
        for one, two in zip(own[1:-2], own[2:-1]):
            self.assertLess(players.overlap(one, two), LEAST)

    def test_an_error_and_a_fetch_are_seen(self):
        chromium = self.players.chromium
        for content in ('<path d="M0 nonsense"/>', '<image href="other.png" width="9" height="9"/>'):
            path = self.write('bad.svg', f'<svg xmlns="http://www.w3.org/2000/svg" width="90" height="90">{content}</svg>')
            chromium.open(path)
            with self.assertRaises(players.Failed):
                chromium.check()


if __name__ == '__main__':
    cli.main(oracles.PROGRAMS + browser.PROGRAMS)
