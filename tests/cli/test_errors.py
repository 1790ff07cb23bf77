"""What cannot be done: exit code 1, one line on stderr that names the file and the cause, nothing written."""

import os
import pathlib

import cli

COMMANDS = (('blend', 'x.ttf'), ('strip', 'x.png'), ('sheet', 'x.pdf'), ('inspect', 'x.svg'))
TAKE_CHARS = [row for row in COMMANDS if row[0] != 'strip']
PASSWORDS = pathlib.Path('/etc/passwd')


class Fonts(cli.Test):
    """Fonts that are none, in either place and to every command."""

    def refuse(self, font, *says):
        for command, output in COMMANDS:
            for fonts in ((font, cli.SERIF), (cli.SERIF, font)):
                with self.subTest(command=command, fonts=fonts):
                    self.refused(1, command, *fonts, '--text', 'A', '-o', output, says=(font, *says))

    def test_missing(self):
        self.refuse('missing.ttf', 'No such file')

    def test_missing_directory(self):
        self.refuse('nowhere/missing.ttf', 'No such file')

    def test_directory(self):
        self.path('folder.ttf').mkdir()
        self.refuse('folder.ttf', 'directory')

    def test_empty(self):
        self.refuse(self.write('empty.ttf', b''), 'not a font')

    def test_truncated(self):
        whole = cli.SERIF.read_bytes()
        for length in (3, 11, 100, 1000, len(whole) // 2, len(whole) - 1000):
            self.refuse(self.write(f'truncated-{length}.ttf', whole[:length]), 'not a font')

    def test_text(self):
        self.refuse(PASSWORDS, 'not a font')
        self.refuse(self.write('script.ttf', '#!/bin/sh\necho A font, honestly.\n' * 100), 'not a font')

    def test_noise(self):
        self.refuse(self.write('noise.otf', bytes(i * i * 31 % 251 for i in range(20000))), 'not a font')

    def test_no_such_face(self):
        for face in ('#7', '#1', '#x', '#-1', '#99999999999'):
            self.refuse(f'{cli.SERIF}{face}', 'face')

    def test_no_such_axis(self):
        self.refuse(f'{cli.SERIF}@wght=700', 'axis')
        self.refuse(f'{cli.INTER}@wdht=700', 'axis')

    def test_bad_axis(self):
        for axes in ('@wght=heavy', '@wght=9999', '@wght', '@wght=', '@', '@wght=400,wght=500'):
            self.refuse(f'{cli.INTER}{axes}', 'axis')


class Named(cli.Test):
    """How a font that cannot be opened, or its axis, is named."""

    def test_name_with_a_line_end(self):
        self.refused(1, 'blend', 'two\nlines.ttf', cli.SERIF, '-o', 'x.ttf', says=['two<U+000A>lines.ttf'])

    def test_name_with_what_cannot_be_seen(self):
        for name, shown in (('a\x1b[31mb', 'a<U+001B>[31mb'), ('a\u200db', 'a<U+200D>b'), ('a\xa0b', 'a<U+00A0>b'), ('a b', 'a b'),
                            ('a\u202eb', 'a<U+202E>b'), ('\ufeffa', '<U+FEFF>a'), ('\ue000', '<U+E000>'), ('a\U000e0100', 'a<U+E0100>'),
                            ('形é“”', '形é“”'), (b'a\xffb'.decode('utf-8', 'surrogateescape'), 'a<0xFF>b')):
            said = self.refused(1, 'blend', name, cli.SERIF, '-o', 'x.ttf')
            self.assertTrue(said.startswith(f'morphotype: {shown}: the file is missing'), said)
            said = self.refused(2, 'blend', cli.SERIF, cli.SERIF, name, '-o', 'x.ttf')
            self.assertTrue(said.startswith(f'morphotype: {shown} is one argument too many'), said)

    def test_axes_that_there_are(self):
        for axis in ('wgth', 'Wght', 'whgt', 'wgh'):
            said = self.refused(1, 'blend', f'{cli.INTER}@{axis}=700', cli.SERIF, '-o', 'x.ttf')
            self.assertTrue(said.endswith('no such axis in the font; did you mean wght?\n'), said)
        for axes in ('opsz=14', 'wght=500,GRAD=1'):
            self.refused(1, 'blend', f'{cli.INTER}@{axes}', cli.SERIF, '-o', 'x.ttf', says=['no such axis in the font; it has wght'])
        self.refused(1, 'blend', f'{cli.ZENHEI}#1@wght=5', cli.SERIF, '-o', 'x.ttf', says=['no such axis in the font; it does not vary'])
        for axis in ('wgth=400..900', 'wdht=75..100', 'Slnt=-10..0'):
            self.refused(2, 'variable', cli.SERIF, cli.SANS_BOLD, '--axis', axis, '-o', 'x.ttf', says=['did you mean'])


class Sources(cli.Test):
    """What is read is not written over."""

    def setUp(self):
        super().setUp()
        self.a, self.b = cli.cut_font(self.path('a.ttf'), 'A'), cli.cut_font(self.path('b.ttf'), 'A')

    def spared(self, *arguments):
        self.refused(1, *arguments, says=['not written over'])

    def test_the_file_itself(self):
        self.spared('blend', 'a.ttf', 'b.ttf', '-o', 'a.ttf')
        self.spared('blend', 'a.ttf', self.b, '-o', 'b.ttf')
        self.spared('blend', f'{self.a}#0', 'b.ttf', '-o', './a.ttf')
        self.spared('variable', 'a.ttf', 'b.ttf', 'a.ttf', '-o', 'b.ttf')
        self.made('blend', 'a.ttf', 'b.ttf', '-o', 'c.ttf')
        self.made('blend', 'a.ttf', 'b.ttf', '-o', 'c.ttf')

    def test_links(self):
        self.path('soft.ttf').symlink_to('a.ttf')
        self.path('hard.ttf').hardlink_to(self.b)
        for link in ('soft.ttf', 'hard.ttf'):
            self.spared('blend', 'a.ttf', 'b.ttf', '-o', link)
            self.spared('variable', 'a.ttf', 'b.ttf', '-o', link)
        self.spared('blend', 'soft.ttf', 'b.ttf', '-o', 'a.ttf')

    def test_several_places(self):
        self.a.rename(self.path('x-0.25.ttf'))
        self.spared('blend', 'x-0.25.ttf', 'b.ttf', '--at', '0.5,0.25', '-o', 'x.ttf')
        self.made('blend', 'x-0.25.ttf', 'b.ttf', '--at', '0.5,0.75', '-o', 'x.ttf')
        self.made('blend', 'x-0.25.ttf', 'b.ttf', '-o', 'x.ttf')

    def test_solids(self):
        """A tetrahedron under the name of an output."""
        mesh = 'v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n'
        self.write('x-0.25.obj', mesh)
        self.write('b.obj', mesh)
        self.spared('solid', 'x-0.25.obj', 'b.obj', '-o', 'b.obj')
        self.spared('solid', 'x-0.25.obj', 'b.obj', '--at', '0.5,0.25', '-o', 'x.obj')
        self.made('solid', 'x-0.25.obj', 'b.obj', '--at', '0.5,0.75', '-o', 'x.obj')

    def test_other_files(self):
        for option, content in (('--chars', 'A'), ('--hints', 'glyph A\n'), ('--pairs', 'A A\n')):
            self.write('given.svg', content)
            self.spared('sheet', 'a.ttf', 'b.ttf', *(['--text', 'A'] if option != '--chars' else []), option, 'given.svg', '-o', 'given.svg')

    def test_numbered_files(self):
        star = (cli.SOURCE / 'docs/star.svg').read_text()
        for name in ('x-1.svg', 'y-01.svg'):
            self.write(name, star)
            self.spared('animate', name, 'a.ttf=A', '--steps', '2' if name[0] == 'x' else '10', '-o', f'{name[0]}.svg')
        self.made('animate', 'y-01.svg', 'a.ttf=A', '--steps', '2', '-o', 'y.svg')
        self.path('z-2.svg').hardlink_to(self.write('chars', 'A'))
        self.spared('sheet', 'a.ttf', 'b.ttf', '--chars', 'chars', '-o', 'z.svg')
        self.spared('animate', 'x-1.svg', 'a.ttf=A', '-o', 'x-1.svg')

    def test_files_in_a_directory(self):
        self.made('blend', 'a.ttf', 'b.ttf', '-o', 'x.ufo')
        self.write('x.ufo/chars', 'A')
        self.path('link').symlink_to('x.ufo/chars')
        for chars in ('x.ufo/chars', 'link'):
            self.spared('blend', 'a.ttf', 'b.ttf', '--chars', chars, '-o', 'x.ufo')
        self.made('variable', 'a.ttf', 'b.ttf', '-o', 'y.designspace')
        self.write('y-masters/chars', 'A')
        self.spared('variable', 'a.ttf', 'b.ttf', '--chars', 'y-masters/chars', '-o', 'y.designspace')


class Characters(cli.Test):
    """Characters that are not there."""

    def test_text_with_characters_that_a_font_lacks(self):
        for command, output in COMMANDS:
            with self.subTest(command=command):
                said = self.refused(1, command, cli.SANS_BOLD, cli.SERIF, '--text', 'A形永A', '-o', output,
                                    says=['“形” (U+5F62), “永” (U+6C38)', f'{cli.SANS_BOLD} lacks', f'{cli.SERIF} lacks'])
                self.assertNotIn('U+0041', said)

    def test_only_the_font_that_lacks_them_is_named(self):
        latin = cli.cut_font(self.path('latin.ttf'), 'ABC')
        self.refused(1, 'strip', cli.SERIF, latin, '--text', 'AЖ', '-o', 'x.png', says=['latin.ttf lacks “Ж” (U+0416)'])
        self.assertNotIn(str(cli.SERIF), self.refused(1, 'strip', cli.SERIF, latin, '--text', 'Ж', '-o', 'x.png'))

    def test_many_of_them_stay_one_line(self):
        text = ''.join(map(chr, range(0x4e00, 0x5000)))
        said = self.refused(1, 'strip', cli.SANS_BOLD, cli.SERIF, '--text', text, '-o', 'x.png', says=['and 500 more'])
        self.assertLess(len(said), 1000)

    def test_control_characters_are_not_echoed(self):
        said = self.refused(1, 'strip', cli.SANS_BOLD, cli.SERIF, '--text', 'A\x1b\x07', '-o', 'x.png', says=['U+001B'])
        self.assertNotIn('\x1b', said)

    def test_one_font(self):
        self.refused(1, 'inspect', cli.SERIF, '--text', '形', '--json', says=[cli.SERIF, '“形” (U+5F62)'])

    def test_nothing_in_common(self):
        upper, lower = (cli.cut_font(self.path(name), text) for name, text in (('A.ttf', 'XYZ'), ('B.ttf', 'xyz')))
        self.refused(1, 'blend', upper, lower, '-o', 'x.ttf', says=['A.ttf', 'B.ttf', 'no character in common'])
        chars = self.write('chars', 'XYZ xyz')
        for command, output in TAKE_CHARS:
            self.refused(1, command, upper, lower, '--chars', chars, '-o', output, says=['chars', 'none'])

    def test_drawn_in_one_font_only(self):
        cli.cut_font(self.path('blank.ttf'), 'AB', blank='B')
        self.refused(1, 'inspect', cli.SANS_BOLD, 'blank.ttf', '--text', 'AB', '-o', 'x.svg',
                     says=['blank.ttf', '“B” (U+0042)'])


class CharactersFile(cli.Test):
    """--chars with a file that is wrong."""

    def refuse(self, content, *says):
        path = content if isinstance(content, pathlib.Path) else self.write('chars.txt', content)
        for command, output in TAKE_CHARS:
            self.refused(1, command, cli.SANS_BOLD, cli.SERIF, '--chars', path, '-o', output, says=(path, *says))

    def test_missing(self):
        self.refuse(self.path('nowhere.txt'), 'No such file')

    def test_empty(self):
        self.refuse('')
        self.refuse('# nothing\n\n')

    def test_not_utf8(self):
        self.refuse(b'abc\n\xff\xfe\n', 'chars.txt:2:', 'UTF-8')
        self.refuse(b'a\0b\n', 'chars.txt:1:')

    def test_bad_ranges(self):
        self.refuse('a\nb\nU+0042-0041\n', 'chars.txt:3:', 'backwards')
        self.refuse('U+110000', 'chars.txt:1:')
        self.refuse('U+0041-', 'chars.txt:1:')
        self.refuse('U+0041-0042-0043', 'chars.txt:1:')
        self.refuse('U+0041xyz', 'chars.txt:1:')


class Outputs(cli.Test):
    """Files that cannot be written."""

    def refuse(self, make_path, *says):
        for command, output in COMMANDS:
            path = make_path(output)
            with self.subTest(command=command):
                self.refused(1, command, cli.SANS_BOLD, cli.SERIF, '--text', 'A', '-o', path, says=(path, *says))

    def test_no_directory(self):
        self.refuse(lambda name: f'nowhere/{name}', 'cannot be written')

    def test_directory(self):
        for _, name in COMMANDS:
            self.path(name).mkdir()
        self.refuse(lambda name: name, 'cannot be written')

    def test_device(self):
        for _, name in COMMANDS:
            os.mkfifo(self.path(name))
        self.refuse(lambda name: name, 'cannot be written')

    def test_directory_without_leave(self):
        closed = self.path('closed')
        closed.mkdir()
        closed.chmod(0o500)
        self.addCleanup(closed.chmod, 0o700)
        if os.access(closed, os.W_OK):
            closed = pathlib.Path('/proc/self') # where root cannot make files either
        self.refuse(lambda name: f'{closed}/{name}', 'cannot be written')

    def test_first_of_several_goes_when_a_later_one_fails(self):
        self.path('x-0.75.ttf').mkdir()
        self.refused(1, 'blend', cli.SANS_BOLD, cli.SERIF, '--text', 'A', '--at', '0.25,0.5,0.75', '-q', '-o',
                     'x.ttf', says=['x-0.75.ttf'])
        self.path('y-3.png').mkdir()
        self.refused(1, 'sheet', cli.SANS_BOLD, cli.SERIF, '--text', 'ABCDE', '--rows', 1, '-o', 'y.png', says=['y.png'])

    def test_too_large(self):
        self.refused(1, 'strip', cli.SANS_BOLD, cli.SERIF, '--text', 'A', '--size', 8192, '-o', 'x.png', says=['x.png'])
        self.refused(1, 'sheet', cli.SANS_BOLD, cli.SERIF, '--text', 'ABCDE', '--size', 8192, '--rows', 5, '-o', 'x.pdf',
                     says=['x.pdf'])
        self.refused(1, 'inspect', cli.SERIF, '--text', 'ABCDE', '--size', 8192, '-o', 'x.svg', says=['x.svg'])

    def test_full_device_on_stdout(self):
        with open('/dev/full', 'wb') as full:
            result = self.run_program('inspect', cli.SERIF, '--text', 'A', '--json', stdout=full)
        self.assertEqual(result.returncode, 1)
        self.assertEqual(result.stderr.decode().count('\n'), 1)
        self.assertIn(b'stdout', result.stderr)


if __name__ == '__main__':
    cli.main()
