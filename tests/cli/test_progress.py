"""What stderr shows of long work: on a terminal every half second, and nothing elsewhere within a minute."""

import os
import pty
import re
import subprocess
import time

import cli

WORK = ('blend', cli.NOTO_SANS, cli.NOTO_SERIF, '--no-layout', '-j', '1', '-o', 'x.ttf',
        '--text', ''.join(map(chr, range(0x4e00, 0x4e40))))
LINE = r'(\d+) of (\d+) glyphs(?:, ([\d.]+) a second, (\d+) s left)?'


class Progress(cli.Test):
    def shown(self, *options, terminal='xterm'):
        """What a terminal is sent, and the seconds that it took."""
        ours, theirs = pty.openpty()
        begun = time.monotonic()
        run = subprocess.Popen([cli.MORPHOTYPE, *map(str, WORK), *options], cwd=self.directory, stderr=theirs,
                               env={**os.environ, 'TERM': terminal})
        os.close(theirs)
        sent = b''
        while True:
            try:
                part = os.read(ours, 4096)
            except OSError: # the other end is closed
                break
            if not part:
                break
            sent += part
        os.close(ours)
        self.assertEqual(run.wait(), 0)
        return sent.decode(), time.monotonic() - begun

    def test_terminal(self):
        sent, seconds = self.shown()
        found = [re.fullmatch(LINE, part) for part in sent.split('\r\x1b[K')[1:] if ' of ' in part]
        self.assertTrue(found and all(found), sent)
        self.assertLessEqual(len(found), 2 * seconds + 1)
        done = [int(match[1]) for match in found]
        self.assertEqual(done, sorted(set(done)))
        self.assertEqual({int(match[2]) for match in found}, {65})
        for match in found:
            if match[3]:
                left = (65 - int(match[1])) / float(match[3])
                self.assertAlmostEqual(int(match[4]), left, delta=1 + left / 10)
        self.assertTrue(any(match[3] for match in found), sent)
        self.assertTrue(sent.endswith('\r\x1b[K'), sent) # nothing of it stays

    def test_none(self):
        self.assertEqual(self.shown('-q')[0], '')
        self.assertEqual(self.shown(terminal='dumb')[0], '')
        self.assertEqual(self.made(*WORK), [])


if __name__ == '__main__':
    cli.main()
