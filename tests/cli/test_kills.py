"""A run that is killed leaves all old or all new, and the next run clears away what it left. MORPHOTYPE_KILLS says how many kills of each
kind of output; each is at a moment of its own, by a seed."""

import os
import random
import shutil
import subprocess
import time

import cli

KILLS = int(os.environ.get('MORPHOTYPE_KILLS', 6))
PAIR = (cli.SANS_BOLD, cli.SERIF)


class Kills(cli.Test):
    def begin(self, *arguments):
        return subprocess.Popen([cli.MORPHOTYPE, *map(str, arguments)], cwd=self.directory, stdin=subprocess.DEVNULL,
                                stderr=subprocess.DEVNULL)

    def tree(self):
        """What has its place; and what is beside it, of a run that has not ended."""
        files = self.files()
        beside = [path for path in files if path.relative_to(self.directory).parts[0].startswith('.morphotype-')]
        return {path: digest for path, digest in files.items() if path not in beside}, beside

    def clear(self):
        for path in self.directory.iterdir():
            shutil.rmtree(path) if path.is_dir() else path.unlink()

    def kill_often(self, *arguments):
        new = *arguments, '--family', 'Other'
        self.made(*new)
        right_new, _ = self.tree()
        self.clear()
        self.made(*arguments)
        right_old, _ = self.tree()
        start = time.monotonic()
        self.made(*new)
        takes = time.monotonic() - start
        for seed in range(KILLS):
            self.clear()
            self.made(*arguments)
            run = self.begin(*new)
            time.sleep(random.Random(seed).uniform(0, 1.1 * takes))
            run.kill()
            run.wait()
            found, _ = self.tree()
            self.assertIn(found, (right_old, right_new), seed)
            self.made(*new)
            self.assertEqual(self.tree(), (right_new, []), seed)

    def test_font(self):
        self.kill_often('blend', *PAIR, '--text', 'ab', '-q', '-o', 'x.ttf')

    def test_three_places(self):
        self.kill_often('blend', *PAIR, '--text', 'ab', '--at', '0.2,0.5,0.8', '-q', '-o', 'x.ttf')

    def test_variable(self):
        self.kill_often('variable', *PAIR, '--text', 'ab', '-q', '-o', 'x.ttf')

    def test_ufo(self):
        self.kill_often('blend', *PAIR, '--text', 'ab', '-q', '-o', 'x.ufo')

    def test_designspace(self):
        self.kill_often('variable', *PAIR, '--text', 'ab', '-q', '-o', 'x.designspace')


if __name__ == '__main__':
    cli.main()
