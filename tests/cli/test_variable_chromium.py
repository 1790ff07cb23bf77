"""A variable font drawn by Chromium beside static fonts of the same places: no hairline, no hole, no dark seam. Skipped where
Chromium is not installed."""

import base64
import subprocess
import unittest

import browser
import cli

PLACES = ('0', '0.5', '1')
WHITE = 255
# Pixels an em, and how much of 255 a pixel may be lighter or darker there than what there is around it in the static font. In
# small sizes the tips of strokes, and the white between two, are parts of a pixel.
SPOTS = {12: 32, 24: 32, 96: 12, 400: 8}
HEAVIER = 0.02 # the share by which all the ink may differ


def off(drawn, expected):
    """The most by which a pixel is darker or lighter than all of the same pixel and its eight neighbours. So a border may be half
    a pixel elsewhere, as rounded points put it; a spot, a seam or a hairline there or anywhere else is found."""
    most = 0
    for y in range(1, len(expected) - 1):
        if drawn[y] == expected[y]:
            continue
        for x in range(1, len(expected[y]) - 1):
            value = drawn[y][x]
            if value == expected[y][x]:
                continue
            around = [v for row in expected[y - 1:y + 2] for v in row[x - 1:x + 2]]
            most = max(most, min(around) - value, value - max(around))
    return most


def ink(rows):
    return sum(WHITE * len(row) - sum(row) for row in rows)


class Drawn(unittest.TestCase):
    """Each character alone in a box of whole pixels, as many in a picture as the window has room for."""

    WINDOW = (1600, 1200)

    @classmethod
    def setUpClass(cls):
        cls.directory = cli.make_directory(cls.addClassCleanup)
        cls.browser = browser.Browser(cls.directory, *cls.WINDOW)
        cls.addClassCleanup(cls.browser.close)

    def make(self, fonts, text):
        """The variable font, and the static one of each place."""
        directory = self.directory
        shared = (*fonts, '-q', '--text', text)
        subprocess.run([cli.MORPHOTYPE, 'variable', *shared, '-o', directory / 'x.ttf'], check=True)
        subprocess.run([cli.MORPHOTYPE, 'blend', *shared, '--at', ','.join(PLACES), '-o', directory / 'b.ttf'], check=True)
        return directory / 'x.ttf', {place: directory / f'b-{place}.ttf' for place in PLACES}

    @staticmethod
    def face(name, path):
        data = base64.b64encode(path.read_bytes()).decode()
        return f'@font-face {{ font-family: {name}; src: url(data:font/ttf;base64,{data}) }}'

    def page(self, variable, blends, text):
        """With all the fonts, loaded."""
        faces = self.face('V', variable) + ''.join(self.face(f'B{i}', blend) for i, blend in enumerate(blends.values()))
        path = self.directory / 'x.html'
        path.write_text(f'''<!DOCTYPE html><html><head><meta charset="utf-8"><title>x</title><style>{faces}
            body {{ margin: 0; background: #fff; color: #000; font-kerning: none; text-rendering: geometricPrecision }}
            #all {{ display: flex; flex-wrap: wrap; width: {self.WINDOW[0]}px }}
            span {{ display: block; white-space: pre; overflow: hidden }}
            </style></head><body><div id="all"></div></body></html>''', encoding='utf-8')
        self.browser.open(path.as_uri())
        names = ['V', *(f'B{i}' for i in range(len(blends)))]
        self.assertTrue(self.browser.run('''
            return Promise.all(arguments[0].map(name => document.fonts.load(`20px ${name}`, arguments[1])))
            .then(loaded => loaded.every(faces => faces.length === 1))''', names, text))

    def picture(self, family, place, size, text):
        """Rows of grey."""
        self.browser.run('''const [family, place, size, text] = arguments, all = document.getElementById("all");
            all.style.font = `${size}px/${1.25 * size}px ${family}`;
            all.style.fontVariationSettings = family === "V" ? `"MORF" ${place}` : "normal";
            all.replaceChildren(...[...text].map(character => {
                const box = document.createElement("span");
                box.textContent = character;
                box.style.width = box.style.height = `${1.25 * size}px`;
                return box;
            }));
            return new Promise(done => requestAnimationFrame(() => requestAnimationFrame(done)))''', family, place, size, text)
        path = self.directory / 'x.png'
        path.write_bytes(self.browser.screenshot('#all'))
        rows = cli.Image(path).rows
        self.assertTrue(all(row[::3] == row[1::3] == row[2::3] for row in rows), 'not grey')
        return [row[::3] for row in rows]

    def pieces(self, text, size):
        """As many of the characters as there is room for in the window."""
        box = 1.25 * size
        room = int(self.WINDOW[0] // box) * int((self.WINDOW[1] - 200) // box)
        return [text[i:i + room] for i in range(0, len(text), room)]

    def compare(self, fonts, text):
        variable, blends = self.make(fonts, text)
        self.page(variable, blends, text)
        for size in SPOTS:
            for i, place in enumerate(blends):
                for piece in self.pieces(text, size):
                    drawn = self.picture('V', 100 * float(place), size, piece)
                    expected = self.picture(f'B{i}', 0, size, piece)
                    self.assertGreater(ink(expected), WHITE * size * size * len(piece) / 30, 'nothing is drawn')
                    self.assertLess(abs(ink(drawn) / ink(expected) - 1), HEAVIER, (place, size, piece))
                    yield off(drawn, expected), (place, size, piece)

    def assert_clean(self, fonts, text):
        for found, where in self.compare(fonts, text):
            self.assertLessEqual(found, SPOTS[where[1]], where)


class Chromium(Drawn):
    """No pixel is lighter or darker than what there is around it in the static font, and the ink weighs the same."""

    def test_letters(self):
        self.assert_clean((cli.SANS_BOLD, cli.SERIF), 'AQRgkŮж')

    def test_han(self):
        self.assert_clean((cli.NOTO_SANS, cli.NOTO_SERIF), '分以他')


if __name__ == '__main__':
    cli.main(browser.PROGRAMS)
