#!/usr/bin/env python3
"""Whether an animation looks the same wherever it plays: SMIL and CSS in Chromium, Lottie in lottie-web and in librlottie, beside
animate's own frames, at nine times.

    MORPHOTYPE=$PWD/build/morphotype ORACLES=DIRECTORY tests/oracles/players.py

prints a row for each pair of animations.py: by the player the least intersection over union of ink at the nine times.
DIRECTORY is where npm installs.
"""

import base64
import ctypes
import io
import os
import pathlib
import sys
import tempfile

from PIL import Image, ImageChops, ImageStat

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / 'cli'))

import animations
import browser
import cli
import oracles

TIMES = [i / 8 for i in range(9)] # seconds; frames of a play of one second
PLAY = ('--fps', '8', '--duration', '1', '--loop', '1', '--size', '512', '--color', 'black')
PLAYERS = ('SMIL', 'CSS', 'lottie-web', 'librlottie')
RLOTTIE = 'librlottie.so.0-1'


class Failed(Exception):
    """An error of a player, or something that it fetched."""


def overlap(one, other):
    """Intersection over union of the ink of two grey pictures, black on white."""
    if one.size != other.size:
        raise Failed(f'{one.size} and {other.size} pixels')
    ink = [ImageChops.invert(image) for image in (one, other)]
    both, either = (ImageStat.Stat(image).sum[0] for image in (ImageChops.darker(*ink), ImageChops.lighter(*ink)))
    return both / either if either else 1


def picture(data):
    return Image.open(io.BytesIO(data)).convert('L')


class Chromium:
    """Plays in one window, and looks at what the console says and at what is asked for."""

    def __init__(self, directory, modules):
        self.window = browser.Browser(directory, width=2048, height=1024)
        self.script = (modules / 'lottie-web/build/player/lottie.min.js').as_uri()
        self.page = directory / 'player.html'
        self.page.write_text('<!DOCTYPE html><meta charset="utf-8"><body style="margin:0"><div id="stage"></div>'
                             f'<script src="{self.script}"></script>')

    def close(self):
        self.window.close()

    def open(self, path, *, also=()):
        self.window.requests() # of the page before
        self.window.console()
        self.window.open(path.as_uri())
        self.own = {path.as_uri(), *also}

    def check(self):
        said = [message['message'] for message in self.window.console()]
        fetched = [address for address in self.window.requests() if address not in self.own and not address.startswith('data:')]
        if said or fetched:
            raise Failed(f'Chromium says {said} and asks for {fetched}')

    def shot(self, size):
        clip = {'x': 0, 'y': 0, 'width': size[0], 'height': size[1], 'scale': 1}
        answer = self.window.devtools('Page.captureScreenshot', format='png', clip=clip, captureBeyondViewport=True)
        return picture(base64.b64decode(answer['data']))

    def pictures(self, go_to, size):
        """One at each time, after the script `go_to` with that time as its argument."""
        for time in TIMES:
            self.window.run(go_to, time)
            yield self.shot(size)
        self.check()

    def smil(self, path, size):
        self.open(path)
        return list(self.pictures('const svg = document.documentElement; svg.pauseAnimations(); svg.setCurrentTime(arguments[0]);', size))

    def css(self, path, size):
        self.open(path)
        return list(self.pictures('for (const a of document.getAnimations()) { a.pause(); a.currentTime = 1000 * arguments[0]; }', size))

    def lottie(self, path, size):
        self.open(self.page, also=[self.script])
        self.window.run('''
            const stage = document.getElementById('stage');
            [stage.style.width, stage.style.height] = [arguments[1] + 'px', arguments[2] + 'px'];
            window.play = lottie.loadAnimation({container: stage, renderer: 'svg', loop: false, autoplay: false,
                                                animationData: JSON.parse(arguments[0])});
            return new Promise((done) => window.play.addEventListener('DOMLoaded', done)).then(() => null);
        ''', path.read_text(), *size)
        return list(self.pictures('window.play.goToAndStop(1000 * arguments[0], false);', size))


class RLottie:
    """librlottie by its C interface (rlottie_capi.h)."""

    def __init__(self):
        self.library = ctypes.CDLL(RLOTTIE)
        self.library.lottie_animation_from_data.restype = ctypes.c_void_p
        self.library.lottie_animation_from_data.argtypes = [ctypes.c_char_p] * 3
        self.library.lottie_animation_get_framerate.restype = ctypes.c_double
        self.library.lottie_animation_get_framerate.argtypes = [ctypes.c_void_p]
        self.library.lottie_animation_render.argtypes = [ctypes.c_void_p, ctypes.c_size_t, ctypes.c_void_p] + [ctypes.c_size_t] * 3
        self.library.lottie_animation_destroy.argtypes = [ctypes.c_void_p]

    def pictures(self, path, size):
        animation = self.library.lottie_animation_from_data(path.read_bytes(), os.fsencode(path), b'')
        if not animation:
            raise Failed('librlottie does not read it')
        rate = self.library.lottie_animation_get_framerate(animation)
        made = []
        for time in TIMES:
            pixels = ctypes.create_string_buffer(4 * size[0] * size[1])
            self.library.lottie_animation_render(animation, round(time * rate), pixels, *size, 4 * size[0])
            made.append(Image.frombytes('RGBA', size, pixels.raw, 'raw', 'BGRA').convert('L'))
        self.library.lottie_animation_destroy(animation)
        return made


class Players:
    """All of them; files are made in `directory` by `run`, which takes the arguments of the program."""

    def __init__(self, directory, modules, run):
        self.directory, self.run = directory, run
        self.chromium, self.rlottie = Chromium(directory, modules), RLottie()

    def close(self):
        self.chromium.close()

    def frames(self, keys):
        """animate's own."""
        self.run('animate', *keys, '-q', *PLAY, '-o', 'frame.png')
        return [picture((self.directory / f'frame-{i + 1}.png').read_bytes()) for i in range(len(TIMES))]

    def play(self, keys):
        """By the player the pictures at the nine times, and under '' our own frames."""
        made = {'': self.frames(keys)}
        size = made[''][0].size
        for name, output, player, options in (('SMIL', 'smil.svg', self.chromium.smil, ()),
                                              ('CSS', 'css.svg', self.chromium.css, ('--css',)),
                                              ('lottie-web', 'lottie.json', self.chromium.lottie, ()),
                                              ('librlottie', 'lottie.json', self.rlottie.pictures, ())):
            self.run('animate', *keys, '-q', *PLAY, *options, '-o', output)
            made[name] = player(self.directory / output, size)
        return made

    def scores(self, pair):
        """By the player the overlap at each of the nine times."""
        made = self.play(animations.key_frames(pair, self.directory))
        own = made.pop('')
        return {name: [overlap(*two) for two in zip(own, pictures, strict=True)] for name, pictures in made.items()}


def main():
    modules = oracles.Oracles(os.environ['ORACLES']).directory.resolve() / 'node_modules'
    with tempfile.TemporaryDirectory() as name:
        test = cli.Test()
        test.directory = pathlib.Path(name)
        players = Players(test.directory, modules, test.made)
        try:
            print('| pair |', ' | '.join(PLAYERS), '|')
            print('|---' * (len(PLAYERS) + 1) + '|')
            for pair in animations.PAIRS:
                scores = players.scores(pair)
                print(f'| {pair[0]} |', ' | '.join(f'{min(scores[player]):.4f}' for player in PLAYERS), '|', flush=True)
        finally:
            players.close()


if __name__ == '__main__':
    main()
