"""A call that fails, each in turn: what writes, and what C++ allocates. Outputs are all new or all old, and nothing is said wrongly."""

import itertools
import os

import cli

LIBRARY = os.environ['FAILING_CALLS']
PAIR = (cli.SANS_BOLD, cli.SERIF)


class Failing(cli.Test):
    kind = ''

    def failing(self, call, *arguments):
        """Runs with that call failing; 0: none. Gives how it ended, and how many such calls it had."""
        count = self.directory.parent / f'{self.directory.name}-count'
        environment = {**os.environ, 'LD_PRELOAD': LIBRARY, 'FAILING_KIND': self.kind, 'FAILING_CALL': str(call),
                       'FAILING_COUNT': os.fspath(count)}
        result = self.run_program(*arguments, env=environment)
        calls = int(count.read_text())
        count.unlink()
        return result, calls


class Files(Failing):
    """Opening for writing, writing, making a folder, flushing and renaming."""
    kind = 'files'

    def assert_all_old(self, *arguments, other):
        """The output of `arguments` stays where any call fails as the same is made with the option `other`."""
        self.made(*arguments)
        before = self.files()
        for call in itertools.count(1):
            result, calls = self.failing(call, *arguments, *other)
            if result.returncode == 0:
                break
            self.assertEqual(result.returncode, 1, call)
            self.assertIn('No space left on device', result.stderr.decode())
            self.assertEqual(self.files(), before, call)
        self.assertEqual(call, calls + 1)
        self.assertNotEqual(self.files(), before)

    def test_three_places(self):
        self.assert_all_old('blend', *PAIR, '--text', 'a', '--at', '0.2,0.5,0.8', '-q', '-o', 'x.ttf', other=('--family', 'Other'))

    def test_ufo(self):
        self.assert_all_old('blend', *PAIR, '--text', 'a', '-q', '-o', 'x.ufo', other=('--family', 'Other'))

    def test_designspace(self):
        self.assert_all_old('variable', *PAIR, '--text', 'a', '-q', '-o', 'x.designspace', other=('--family', 'Other'))

    def test_sheet(self):
        self.assert_all_old('sheet', *PAIR, '--text', 'ab', '--rows', '1', '-q', '-o', 'x.png', other=('--size', '30'))


class New(Failing):
    """C++'s operator new, of which Clipper has thousands: one in so many fails."""
    kind = 'new'
    STEPS = 40

    def assert_honest(self, *arguments):
        """Whatever fails, the same bytes come out, or one line says that memory does not do."""
        result, calls = self.failing(0, *arguments)
        self.assertEqual(result.returncode, 0)
        right, ended = self.files(), set()
        for call in range(1, calls, calls // self.STEPS):
            result, _ = self.failing(call, *arguments)
            ended.add(result.returncode)
            if result.returncode:
                self.assertEqual((result.returncode, result.stderr.count(b'\n')), (1, 1), result.stderr.decode())
                self.assertIn(b'out of memory', result.stderr)
            self.assertEqual(self.files(), right, call)
        self.assertIn(1, ended)

    def test_blend(self):
        self.assert_honest('blend', *PAIR, '--text', 'ag', '-q', '-o', 'x.ttf')

    def test_variable(self):
        self.assert_honest('variable', *PAIR, '--text', 'a', '-q', '-o', 'x.ttf')

    def test_pictures(self):
        self.assert_honest('strip', *PAIR, '--text', 'a', '-q', '-o', 'x.png')
        self.assert_honest('inspect', *PAIR, '--text', 'a', '-q', '-o', 'y.png')

    def test_pages(self):
        self.assert_honest('report', *PAIR, '--text', 'i', '-q', '-o', 'x.html')
        self.assert_honest('specimen', *PAIR, '--text', 'i', '-q', '-o', 'y.html')

    def test_animation(self):
        self.assert_honest('animate', f'{cli.SANS_BOLD}=a', f'{cli.SERIF}=a', '-q', '-o', 'x.svg')


if __name__ == '__main__':
    cli.main()
