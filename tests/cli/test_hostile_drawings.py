"""Hostile drawings: each is drawn or refused with an exit code of the program's own, in one or two lines, leaves nothing behind and
fetches nothing. MT_DRAWINGS=300 looks at more of them."""

import os
import socket
import unittest

import cli
import hostile_drawings

DRAWINGS, SEED = int(os.environ.get('MT_DRAWINGS', 60)), 15
RING = '<svg xmlns="http://www.w3.org/2000/svg"><path fill-rule="evenodd" d="M2 2h20v20h-20zM7 7h10v10h-10z"/></svg>'


class Hostile(cli.Test):
    """All of them, in three parts for three tests."""

    PARTS = 3

    def animate_part(self, part):
        self.write('ring.svg', RING)
        server = socket.create_server(('127.0.0.1', 0))
        self.addCleanup(server.close)
        server.setblocking(False)
        here = b'http://127.0.0.1:%d' % server.getsockname()[1]
        outcomes = set()
        for number, (kind, drawing) in enumerate(hostile_drawings.drawings(DRAWINGS, SEED)):
            if number % self.PARTS != part:
                continue
            with self.subTest(number=number, kind=kind):
                self.path('bad.svg').write_bytes(drawing.replace(b'http://example.org', here))
                outcomes.add(self.animate_one())
        self.assertEqual(outcomes - {2}, {0, 1})
        with self.assertRaises(BlockingIOError): # nobody has called
            server.accept()

    def animate_one(self):
        output = self.path('x.svg')
        output.unlink(missing_ok=True)
        result = self.run_program('animate', 'bad.svg', 'ring.svg', '-o', 'x.svg')
        misuse = b'a key frame is FONT=TEXT, or an SVG drawing' in result.stderr # what is in the file tells, and this is no XML
        self.assertIn(result.returncode, (2,) if misuse else (0, 1), result.stderr)
        self.assertLessEqual(result.stderr.count(b'\n'), 2, result.stderr)
        self.assertEqual(output.exists(), result.returncode == 0)
        self.assertEqual({path.name for path in self.directory.iterdir()} - {'x.svg'}, {'bad.svg', 'ring.svg'})
        return result.returncode


class First(Hostile):
    def test_all(self):
        self.animate_part(0)


class Second(Hostile):
    def test_all(self):
        self.animate_part(1)


class Third(Hostile):
    def test_all(self):
        self.animate_part(2)


if __name__ == '__main__':
    cli.main()
