"""Outputs are all new or all old, whatever happens: a disk that takes no more, a signal, a kill; and nothing stays beside them."""

import os
import resource
import signal
import stat
import subprocess
import time

import cli

PAIR = (cli.SANS_BOLD, cli.SERIF)


SIGNALS = signal.SIGINT, signal.SIGTERM, signal.SIGHUP


def heed_signals():
    """What runs the tests may have them ignored, as nohup has SIGHUP."""
    for number in SIGNALS:
        signal.signal(number, signal.SIG_DFL)


class Outputs(cli.Test):
    """A file that may not grow over some bytes stands for a disk that is full: writes fail in the same places."""

    def fails_when_full(self, most, *arguments):
        before = self.files()
        result = self.run_program(*arguments, preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (most, most)))
        self.assertEqual(result.returncode, 1, result.stderr.decode())
        self.assertIn('File too large', result.stderr.decode())
        self.assertEqual(self.files(), before)
        self.assertEqual([path for path in self.directory.iterdir() if path.name.startswith('.')], [])

    def test_fonts_at_several_places(self):
        arguments = 'blend', *PAIR, '--text', 'abc', '--at', '0.2,0.5,0.8', '-q', '-o', 'x.ttf'
        self.fails_when_full(1000, *arguments)
        self.made(*arguments)
        self.fails_when_full(1000, *arguments, '--no-layout')
        self.made(*arguments)

    def test_the_last_of_several(self):
        """The last is the largest, and the only one that does not fit."""
        self.path('x-1.ttf').write_bytes(b'old')
        fonts = 'blend', cli.SANS_BOLD, cli.DEMO_SERIF, '--text', 'g', '-q'
        self.made(*fonts, '--at', '0', '-o', 'least.ttf')
        self.made(*fonts, '--at', '0,0.5', '-o', 'x.ttf')
        sizes = [self.path(f'x-{t}.ttf').stat().st_size for t in ('0', '0.5')]
        self.assertNotEqual(*sizes)
        self.fails_when_full(min(sizes), *fonts, '--at', '0,0.5', '-o', 'x.ttf')

    def test_designspace_and_ufo(self):
        designspace = 'variable', *PAIR, '--text', 'abc', '-q', '-o', 'x.designspace'
        ufo = 'blend', *PAIR, '--text', 'abc', '--at', '0.3,0.7', '-q', '-o', 'x.ufo'
        for arguments in (designspace, ufo):
            self.made(*arguments)
            self.fails_when_full(300, *arguments, '--family', 'Other')
            self.made(*arguments, '--family', 'Other')

    def test_pages_of_a_sheet(self):
        self.path('c.txt').write_text('U+0041-005A\n')
        sheet = 'sheet', *PAIR, '--chars', 'c.txt', '--rows', '10', '-q', '-o', 'x.png'
        self.made(*sheet, '--size', '40')
        self.assertTrue(self.path('x-3.png').exists())
        self.fails_when_full(3000, *sheet, '--size', '60')

    def test_rights_and_links_stay(self):
        self.path('target.ttf').write_bytes(b'old')
        self.path('target.ttf').chmod(0o400)
        self.path('below').mkdir()
        self.path('below/link.ttf').symlink_to('../target.ttf')
        for at in ('0.5', '0.2,0.5'):
            name = 'below/link.ttf' if at == '0.5' else 'below/link-0.5.ttf'
            if not self.path(name).is_symlink():
                self.path(name).symlink_to('../target.ttf')
            self.made('blend', *PAIR, '--text', 'a', '--at', at, '-q', '-o', 'below/link.ttf')
            self.assertTrue(self.path(name).is_symlink())
            self.assertEqual(self.path('target.ttf').read_bytes()[:4], b'\0\1\0\0')
            self.assertEqual(stat.S_IMODE(self.path('target.ttf').stat().st_mode), 0o400)
            self.path('target.ttf').chmod(0o600)
            self.path('target.ttf').write_bytes(b'old')
            self.path('target.ttf').chmod(0o400)

    def stopped(self, number):
        """How a run ends that gets a signal when it has begun a UFO beside its place; again, if it was quicker."""
        for _ in range(5):
            self.before = self.files()
            run = self.begin_ufo()
            run.send_signal(number)
            if run.wait() != 0:
                break
        return run.returncode

    def begin_ufo(self):
        whole = 'blend', *map(str, PAIR), '--method', 'paper', '--no-layout', '--at', '0', '-q', '-o', 'x.ufo'
        run = subprocess.Popen([cli.MORPHOTYPE, *whole], cwd=self.directory, stdin=subprocess.DEVNULL,
                               stderr=subprocess.DEVNULL, preexec_fn=heed_signals)
        self.addCleanup(run.wait)
        self.addCleanup(run.kill)
        while run.poll() is None and not list(self.directory.glob('.morphotype-*')):
            time.sleep(0.001)
        return run

    def test_signals_leave_nothing(self):
        self.made('blend', *PAIR, '--text', 'a', '-q', '-o', 'x.ufo')
        for number in SIGNALS:
            self.assertEqual(self.stopped(number), -number)
            self.assertEqual(list(self.directory.glob('.morphotype-*')), [])
            after = self.files()
            self.assertTrue(after == self.before or len(after) > 3000, 'neither all old nor all new')

    def test_what_a_killed_run_leaves_goes_with_the_next(self):
        self.assertEqual(self.stopped(signal.SIGKILL), -signal.SIGKILL)
        self.assertTrue(list(self.directory.glob('.morphotype-*')))
        mine = self.path(f'.morphotype-{os.getpid()}-0')
        mine.write_text('of a process that lives')
        self.made('blend', *PAIR, '--text', 'a', '-q', '-o', 'y.ttf')
        self.assertEqual(list(self.directory.glob('.morphotype-*')), [mine])


if __name__ == '__main__':
    cli.main()
