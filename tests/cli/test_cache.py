"""--cache: the same bytes without one, with an empty one and with a full one; what is made anew, and what is not."""

import re
import signal
import subprocess
import threading
import time

import cli

FONTS = (cli.SANS_BOLD, cli.SERIF)
TEXT = 'Morphing & 8aBQ'


class Test(cli.Test):
    def counts(self, *arguments):
        """Runs it with the cache; how many glyphs were taken, and made."""
        said = self.made(*arguments, '--cache', 'cache', '-v')
        [found] = [re.fullmatch(r'morphotype: cache: (\d+) glyphs? taken, (\d+) made', line)
                   for line in said if ': cache:' in line]
        return int(found[1]), int(found[2])

    def entries(self):
        return sorted(path for path in self.path('cache').glob('??/*') if not path.name.startswith('.'))

    def read(self, name):
        """A file, or what all the files of a folder hold."""
        path = self.path(name)
        return {p.name: p.read_bytes() for p in sorted(path.rglob('*')) if p.is_file()} if path.is_dir() \
            else path.read_bytes()


class Bytes(Test):
    def check(self, output, *arguments):
        self.made(*arguments, '-q', '-o', output)
        without = self.read(output)
        again, made = self.counts(*arguments, '-o', output) # a page asks for its glyphs twice
        self.assertGreater(made, 5)
        self.assertEqual(len(self.entries()), made)
        self.assertEqual(self.read(output), without)
        self.assertEqual(self.counts(*arguments, '-o', output), (again + made, 0))
        self.assertEqual(self.read(output), without)

    def test_blend(self):
        self.check('x.ttf', 'blend', *FONTS, '--text', TEXT, '--at', '-0.2')

    def test_blend_by_links(self):
        self.check('x.ttf', 'blend', *FONTS, '--text', TEXT, '--method', 'paper', '--rotate', 'auto')

    def test_ufo(self):
        self.check('x.ufo', 'blend', *FONTS, '--text', TEXT)

    def test_variable(self):
        self.check('x.ttf', 'variable', *FONTS, cli.MONO, '--text', TEXT)

    def test_report(self):
        self.check('x.json', 'report', *FONTS, '--text', TEXT)

    def test_report_page(self):
        self.check('x.html', 'report', *FONTS, '--text', TEXT)

    def test_strip(self):
        self.check('x.svg', 'strip', *FONTS, '--text', TEXT, '--steps', '3')

    def test_sheet(self):
        self.check('x.svg', 'sheet', *FONTS, '--text', TEXT)

    def test_specimen(self):
        self.check('x.html', 'specimen', *FONTS, '--text', TEXT)

    def test_one_serves_all(self):
        _, made = self.counts('variable', *FONTS, '--text', TEXT, '-o', 'x.ttf')
        for command, output in (('blend', 'x.ttf'), ('report', 'x.json'), ('strip', 'x.png')):
            taken, anew = self.counts(command, *FONTS, '--text', TEXT, '-o', output)
            self.assertEqual(anew, 0, command)
            self.assertLessEqual(taken, made)

    def test_failures_are_kept(self):
        blank = cli.cut_font(self.path('blank.ttf'), 'AB', blank='B')
        arguments = ('blend', cli.SANS_BOLD, blank, '--text', 'AB', '-o', 'x.ttf')
        first = self.made(*arguments, '--cache', 'cache')
        self.assertTrue(any('not blended' in line for line in first), first)
        self.assertEqual(self.counts(*arguments)[1], 0)
        self.assertEqual(self.made(*arguments, '--cache', 'cache'), first)


class Changes(Test):
    def blend(self, *options, text=TEXT, output='x.ttf'):
        return 'blend', *FONTS, '--text', text, '-o', output, *options

    def test_a_hint_costs_one_glyph(self):
        _, made = self.counts(*self.blend())
        hints = self.write('hints.txt', 'glyph B\npoint 100,0 100,0\n')
        self.assertEqual(self.counts(*self.blend('--hints', hints)), (made - 1, 1))
        self.assertEqual(self.counts(*self.blend('--hints', hints)), (made, 0))
        self.assertEqual(self.counts(*self.blend()), (made, 0))

    def test_settings_cost_all(self):
        _, made = self.counts(*self.blend())
        for option in (('--tolerance', '2'), ('--slant', '3'), ('--effort', '2'), ('--rotate', '5')):
            self.assertEqual(self.counts(*self.blend(*option)), (0, made), option)
        self.assertEqual(self.counts(*self.blend('-j', '2', '--at', '0.1', '--family', 'Other')), (made, 0))

    def test_more_characters_cost_themselves(self):
        taken, made = self.counts(*self.blend())
        self.assertEqual(self.counts(*self.blend(text=TEXT + 'x')), (taken + made, 1))

    def test_damage_is_as_nothing(self):
        _, made = self.counts(*self.blend())
        font, entries = self.path('x.ttf').read_bytes(), self.entries()
        self.assertEqual(len(entries), made)
        for k, (taken, content) in enumerate(((1, b''), (1, b'x' * 1000), (1, None), (1, entries[0].read_bytes()))):
            entry = entries[-1 - k]
            content = entry.read_bytes()[:-3] if content is None else content
            entry.write_bytes(content)
            self.assertEqual(self.counts(*self.blend()), (made - taken, 1), k)
            self.assertEqual(self.path('x.ttf').read_bytes(), font)
        self.assertEqual(self.counts(*self.blend()), (made, 0))

    def test_a_folder_in_place_of_an_entry(self):
        _, made = self.counts(*self.blend())
        entry = self.entries()[0]
        entry.unlink()
        entry.mkdir()
        said = self.made(*self.blend(), '--cache', 'cache', '-v')
        self.assertIn(f'morphotype: cache: {made - 1} glyphs taken, 1 made, of which 1 could not be kept', said)

    def test_a_killed_run_goes_on(self):
        arguments = ('blend', *FONTS, '--no-layout', '-j', '1', '-o', 'x.ttf',
                     '--text', ''.join(map(chr, (*range(0x41, 0x7b), *range(0xc0, 0x180)))))
        self.made(*arguments, '-q')
        whole = self.path('x.ttf').read_bytes()
        self.path('x.ttf').unlink()
        for _ in range(3):
            run = subprocess.Popen([cli.MORPHOTYPE, *map(str, arguments), '--cache', 'cache'],
                                   cwd=self.directory, stderr=subprocess.DEVNULL)
            before, end = len(self.entries()), time.monotonic() + 60
            while len(self.entries()) < before + 5 and time.monotonic() < end:
                time.sleep(0.005)
            run.send_signal(signal.SIGKILL)
            run.wait()
        self.assertFalse(self.path('x.ttf').exists())
        kept = len(self.entries())
        taken, made = self.counts(*arguments)
        self.assertGreaterEqual(kept, 15)
        self.assertEqual(taken, kept)
        self.assertGreater(made, 0)
        self.assertEqual(self.path('x.ttf').read_bytes(), whole)

    def test_several_at_once(self):
        arguments = [self.blend('--cache', 'cache', output=f'{i}.ttf') for i in range(4)]
        runs = [threading.Thread(target=self.made, args=a) for a in arguments]
        for run in runs:
            run.start()
        for run in runs:
            run.join()
        self.assertEqual(len({self.path(f'{i}.ttf').read_bytes() for i in range(4)}), 1)
        self.assertEqual(self.counts(*self.blend())[1], 0)

    def test_it_is_bounded(self):
        text = ''.join(map(chr, range(0x21, 0x7f)))
        arguments = ('blend', *FONTS, '--no-layout', '--text', text, '-o', 'x.ttf')
        self.made(*arguments, '--cache', 'cache', '--cache-size', '0.01')
        few = len(self.entries())
        size = sum(-(-entry.stat().st_size // 4096) * 4096 for entry in self.entries())
        self.assertLessEqual(size, 0.01e9)
        self.assertGreater(few, 60)
        self.made(*arguments, '--tolerance', '0.1', '--cache', 'cache', '--cache-size', '0.01')
        self.made(*arguments, '--tolerance', '0.2', '--cache', 'cache', '--cache-size', '0.01')
        self.assertLessEqual(len(self.entries()), 0.01e9 / 4096 * 9 / 8)


class Usage(Test):
    def test_size_alone(self):
        self.refused(2, 'blend', *FONTS, '--cache-size', '1', '-o', 'x.ttf', says=['--cache DIR'])

    def test_sizes(self):
        for size in ('0', '-1', 'x', '10001'):
            self.refused(2, 'blend', *FONTS, '--cache', 'cache', '--cache-size', size, '-o', 'x.ttf',
                         says=['--cache-size'])

    def test_a_file(self):
        self.write('file', '')
        self.refused(1, 'blend', *FONTS, '--cache', 'file', '-o', 'x.ttf', says=['file', 'Not a directory'])

    def test_nowhere(self):
        self.refused(1, 'report', *FONTS, '--cache', 'no/cache', '-o', 'x.json', says=['no/cache', 'No such file'])

    def test_not_of_every_command(self):
        self.refused(2, 'animate', 'a.svg', 'b.svg', '--cache', 'cache', '-o', 'x.svg', says=['--cache', 'blend'])


if __name__ == '__main__':
    cli.main()
