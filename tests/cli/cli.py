"""What the command-line tests share: the program, the fonts, and checks on what they leave behind."""

import hashlib
import os
import pathlib
import shutil
import struct
import subprocess
import sys
import tempfile
import unittest
import zlib

from fontTools import subset, ttLib
from fontTools.ttLib.tables._g_l_y_f import Glyph

MORPHOTYPE = os.environ['MORPHOTYPE']
SKIPPED = 77 # what meson takes for a test that was left out
SOURCE = pathlib.Path(__file__).resolve().parents[2]

DEBIAN = pathlib.Path('/usr/share/fonts')
SANS_BOLD = DEBIAN / 'truetype/dejavu/DejaVuSans-Bold.ttf'
SERIF = DEBIAN / 'truetype/dejavu/DejaVuSerif.ttf'
ZENHEI = DEBIAN / 'truetype/wqy/wqy-zenhei.ttc'
UKAI = DEBIAN / 'truetype/arphic/ukai.ttc'
INTER = DEBIAN / 'truetype/inter-vf/Inter-roman.var.ttf'
NOTO_SANS = f"{DEBIAN / 'opentype/noto/NotoSansCJK-Bold.ttc'}#2"
NOTO_SERIF = f"{DEBIAN / 'opentype/noto/NotoSerifCJK-Regular.ttc'}#2"
MONO = DEBIAN / 'truetype/dejavu/DejaVuSansMono.ttf'
MONO_BOLD = DEBIAN / 'truetype/dejavu/DejaVuSansMono-Bold.ttf'
DEMO_SANS = SOURCE / 'fonts/MorphotypeDemo-Sans.ttf'
DEMO_SERIF = SOURCE / 'fonts/MorphotypeDemo-Serif.otf'

# What blend says of DejaVu Serif, always.
NO_MATH = f'morphotype: colour, bitmap and math tables are left out: MATH of {SERIF}'


def cut_font(target, text, blank=''):
    """Makes a font of these characters alone from DejaVu Serif; those in `blank` lose their ink."""
    font = ttLib.TTFont(SERIF)
    options = subset.Options(drop_tables=subset.Options().drop_tables + ['FFTM', 'MATH'])
    subsetter = subset.Subsetter(options)
    subsetter.populate(text=text)
    subsetter.subset(font)
    for character in blank:
        font['glyf'][font.getBestCmap()[ord(character)]] = Glyph()
    font.save(target)
    return target


def make_directory(add_cleanup):
    """An empty directory, removed with all that is in it when the clean-ups of a test or of a class are done."""
    directory = pathlib.Path(tempfile.mkdtemp(prefix='morphotype-test-'))
    add_cleanup(shutil.rmtree, directory, ignore_errors=True)
    return directory


class Test(unittest.TestCase):
    """Each test works in an empty directory of its own."""

    def setUp(self):
        self.directory = make_directory(self.addCleanup)

    def run_program(self, *arguments, **options):
        """Runs it in the test's directory; stdout and stderr are bytes."""
        command = [MORPHOTYPE, *(os.fspath(a) if isinstance(a, os.PathLike) else str(a) for a in arguments)]
        options.setdefault('stdout', subprocess.PIPE)
        return subprocess.run(command, cwd=self.directory, stdin=subprocess.DEVNULL, stderr=subprocess.PIPE,
                              check=False, **options)

    def made(self, *arguments):
        """Runs it, expects success, and gives the lines of stderr."""
        result = self.run_program(*arguments)
        self.assertEqual(result.returncode, 0, result.stderr.decode())
        return result.stderr.decode().splitlines()

    def refused(self, code, *arguments, says=()):
        """Runs it, expects this exit code, one line on stderr that holds all of `says`, and no file made or changed."""
        before = self.files()
        result = self.run_program(*arguments)
        stderr = result.stderr.decode()
        self.assertEqual(result.returncode, code, stderr)
        self.assertEqual(stderr.count('\n'), 1, stderr)
        self.assertTrue(stderr.startswith('morphotype: ') and stderr.endswith('\n'), stderr)
        self.assertEqual(result.stdout, b'')
        for text in says:
            self.assertIn(str(text), stderr)
        self.assertEqual(self.files(), before)
        return stderr

    def files(self):
        """All files below the test's directory, hidden ones too, and the digests of what they hold: two that differ are told in a line."""
        return {path: hashlib.sha256(path.read_bytes()).hexdigest() for path in self.directory.rglob('*') if path.is_file()}

    def path(self, name):
        return self.directory / name

    def write(self, name, content):
        path = self.path(name)
        path.write_bytes(content if isinstance(content, bytes) else content.encode())
        return path


class Image:
    """A PNG of 8-bit RGB, not interlaced, as Cairo writes it."""

    def __init__(self, path):
        data = pathlib.Path(path).read_bytes()
        assert data[:8] == b'\x89PNG\r\n\x1a\n', 'no PNG'
        packed, at = b'', 8
        while at < len(data):
            length, kind = struct.unpack('>I4s', data[at:at + 8])
            body = data[at + 8:at + 8 + length]
            if kind == b'IHDR':
                self.width, self.height, depth, colours, _, _, interlaced = struct.unpack('>IIBBBBB', body)
                assert (depth, colours, interlaced) == (8, 2, 0), 'another kind of PNG'
            if kind == b'IDAT':
                packed += body
            at += 12 + length
        self.rows = self.unfilter(zlib.decompress(packed))

    def unfilter(self, raw):
        """Undoes the filters of PNG's section 9."""
        stride, rows = 3 * self.width, []
        above = bytearray(stride)
        for y in range(self.height):
            start = y * (stride + 1)
            kind, row = raw[start], bytearray(raw[start + 1:start + 1 + stride])
            if kind == 2 and not any(row): # the same as above: much of a picture, and quickly copied
                row, kind = bytearray(above), 0
            for i in range(stride if kind else 0):
                left = row[i - 3] if i >= 3 else 0
                corner = above[i - 3] if i >= 3 else 0
                row[i] = (row[i] + self.predict(kind, left, above[i], corner)) & 255
            rows.append(row)
            above = row
        return rows

    @staticmethod
    def predict(kind, left, up, corner):
        if kind == 4:
            guess = left + up - corner
            return min((left, up, corner), key=lambda value: abs(guess - value))
        return (0, left, up, (left + up) // 2)[kind]

    def ink(self, left=0, right=None):
        """How much black there is between two columns, in pixels."""
        return sum(255 * (len(part) // 3) - sum(part[::3])
                   for part in (row[3 * left:3 * (self.width if right is None else right)] for row in self.rows)) / 255

    def box(self, top=0, bottom=None):
        """The box around what is darker than half between two rows: left, right, top and bottom, in pixels."""
        dark = [(x, y) for y, row in enumerate(self.rows[top:bottom], top) for x in range(self.width) if row[3 * x] < 128]
        columns, lines = zip(*dark)
        return min(columns), max(columns) + 1, min(lines), max(lines) + 1


def main(needs=()):
    """Runs the tests of the class that the command line names, or leaves them out where a program of `needs` is missing."""
    missing = [program for program in needs if not shutil.which(program)]
    if missing:
        print('not installed:', *missing)
        sys.exit(SKIPPED)
    unittest.main(verbosity=2)
