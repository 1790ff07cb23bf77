"""-o - --format EXT: the bytes of the file, on stdout; nothing of it stays anywhere."""

import os
import pty
import subprocess

import cli

PAIR = (cli.SANS_BOLD, cli.SERIF)


class Printed(cli.Test):
    def printed(self, *arguments, **options):
        scratch = self.path('scratch')
        scratch.mkdir(exist_ok=True)
        result = self.run_program(*arguments, '-o', '-', env={**os.environ, 'TMPDIR': str(scratch)}, **options)
        self.assertEqual(list(scratch.iterdir()), [])
        return result

    def test_the_bytes_of_the_file(self):
        for command, form, *arguments in (
                ('blend', 'ttf', '--at', '0.5'), ('blend', 'woff2', '--at', '0.3'), ('variable', 'ttf'), ('strip', 'PNG'),
                ('sheet', 'svg', '--steps', '3'), ('inspect', 'html'), ('report', 'json'), ('specimen', 'html')):
            arguments = (command, *PAIR, '--text', 'ab', '-q', *arguments)
            self.made(*arguments, '-o', f'x.{form}')
            result = self.printed(*arguments, '--format', form)
            self.assertEqual((result.returncode, result.stderr), (0, b''), command)
            self.assertEqual(result.stdout, self.path(f'x.{form}').read_bytes(), command)

    def test_several_files_and_folders(self):
        for arguments in (('--at', '0.2,0.4', '--format', 'ttf'), ('--at', '0.5', '--format', 'ufo')):
            result = self.printed('blend', *PAIR, '--text', 'a', '-q', *arguments)
            self.assertEqual((result.returncode, result.stdout, result.stderr),
                             (1, b'', b'morphotype: stdout: it takes one file, and this makes several, or a folder\n'))

    def test_a_failing_command(self):
        result = self.printed('blend', self.write('x.ttf', 'no font'), cli.SERIF, '--at', '0.5', '--format', 'ttf')
        self.assertEqual((result.returncode, result.stdout, result.stderr.count(b'\n')), (1, b'', 1))

    def test_usage(self):
        fonts = ('blend', *PAIR, '--at', '0.5', '-o')
        self.refused(2, *fonts, '-', says=['--format', 'ttf woff2 ufo'])
        self.refused(2, *fonts, '-', '--format', 'pdf', says=['--format pdf', 'ttf woff2 ufo'])
        self.refused(2, *fonts, '-', '--format', 'tt', says=['--format tt'])
        self.refused(2, *fonts, 'x.ttf', '--format', 'ttf', says=['-o -'])
        self.refused(2, 'inspect', *PAIR, '--text', 'a', '--json', '-o', '-', '--format', 'svg', says=['--json'])

    def test_no_place_for_temporary_files(self):
        result = self.run_program('blend', *PAIR, '--at', '0.5', '-o', '-', '--format', 'ttf',
                                  env={**os.environ, 'TMPDIR': str(self.path('nowhere'))})
        self.assertEqual((result.returncode, result.stdout), (1, b''))
        self.assertIn(b'stdout: ', result.stderr)

    def on_terminal(self, *arguments):
        """The exit code, and all that a terminal is shown."""
        ours, theirs = pty.openpty()
        process = subprocess.Popen([cli.MORPHOTYPE, *arguments, '-o', '-'], stdout=theirs, stderr=subprocess.DEVNULL, cwd=self.directory)
        os.close(theirs)
        shown = b''
        try:
            while block := os.read(ours, 65536):
                shown += block
        except OSError: # its other end is closed
            pass
        os.close(ours)
        return process.wait(), shown

    def test_a_terminal(self):
        code, shown = self.on_terminal('blend', *PAIR, '--text', 'a', '-q', '--at', '0.5', '--format', 'ttf')
        self.assertEqual((code, shown), (2, b''))
        code, shown = self.on_terminal('report', *PAIR, '--text', 'a', '-q', '--format', 'json')
        self.assertEqual((code, shown[:1]), (0, b'{'))


if __name__ == '__main__':
    cli.main()
