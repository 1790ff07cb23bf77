"""--hints: what a file of hints does, and what is said of one that is wrong."""

import pathlib

import cli
from fontTools import ttLib

FONTS = (cli.SANS_BOLD, cli.SERIF)
COMMANDS = (('blend', 'x.ttf'), ('strip', 'x.svg'), ('sheet', 'x.svg'), ('inspect', 'x.json'), ('report', 'x.json'))


class Errors(cli.Test):
    """Exit code 1, one line with the file's name, and nothing written."""

    def refuse(self, content, *says):
        path = content if isinstance(content, pathlib.Path) else self.write('hints.txt', content)
        for command, output in COMMANDS:
            with self.subTest(command=command):
                self.refused(1, command, *FONTS, '--text', 'A', '--hints', path, '-o', output, says=(path, *says))

    def test_missing(self):
        self.refuse(self.path('nowhere.txt'), 'No such file')

    def test_directory(self):
        self.path('folder').mkdir()
        self.refuse(self.path('folder'), 'directory')

    def test_not_utf8(self):
        self.refuse(b'glyph a\n# \xff\xfe\n', 'hints.txt:2: not UTF-8')
        self.refuse(cli.SERIF, f'{cli.SERIF}:1: ')

    def test_bad_lines(self):
        self.refuse('point 1,2 3,4\n', 'hints.txt:1: a hint before the first glyph')
        self.refuse('# A\nglyph A\npoint 1,2\n', 'hints.txt:3: ', 'two places')
        self.refuse('glyph A\r\ncomponent 1,2 3,4\r\ncomponent 1,2 3;4\r\n', 'hints.txt:3: a place')
        self.refuse('glyph A\npoint 1,2 3,1e9', 'hints.txt:2: a place')
        self.refuse('glyph\n', 'hints.txt:1: ', 'character')
        self.refuse('glyph A\n\nline 1,2 3,4\n', 'hints.txt:3: ', 'begins with')

    def test_too_many(self):
        self.refuse('glyph A\n' + 257 * 'point 1,2 3,4\n', 'hints.txt:258: too many')

    def test_too_large(self):
        self.refuse(b'\n' * (2 ** 24 + 1), 'too large')

    def test_wrong_lines_of_other_characters_too(self):
        self.refuse('glyph U+5F62\npoint 1,2 3,4\npoint', 'hints.txt:3: ')

    def test_one_font(self):
        path = self.write('hints.txt', 'glyph A\npoint 1,2\n')
        self.refused(1, 'inspect', cli.SERIF, '--text', 'A', '--hints', path, '--json', says=['hints.txt:2: '])

    def test_no_file_given(self):
        for command, output in COMMANDS:
            self.refused(2, command, *FONTS, '--text', 'A', '-o', output, '--hints', says=['--hints', '--help'])


class Use(cli.Test):
    """What a file that is right changes, and what is said of it."""

    def made_by(self, command, output, *arguments):
        self.made(command, *FONTS, '--text', 'Rags&8', '-q', '-o', output, *arguments)
        return self.path(output).read_bytes()

    def test_hints_for_other_characters_change_nothing(self):
        other = self.write('hints.txt', '\ufeff# not in the text\r\nglyph é\r\npoint 100,700 90,680\r\nglyph U+5F62\r\n'
                                        'component 0,0 500,500\r\nglyph b # no hints\r\n')
        for command, output in COMMANDS:
            with self.subTest(command=command):
                without = self.made_by(command, output)
                self.assertTrue(without == self.made_by(command, output, '--hints', other, '-j', 3))

    def test_a_hint_is_followed_by_every_command(self):
        """The top of one o goes with a place 30 degrees further on the other."""
        a, b = (ttLib.TTFont(font)['glyf']['o'] for font in FONTS)
        x, y = (b.xMin + b.xMax) / 2 + (b.xMax - b.xMin) / 4, (b.yMin + b.yMax) / 2 + (b.yMax - b.yMin) * 3 ** 0.5 / 4
        path = self.write('hints.txt', f'glyph o\npoint {(a.xMin + a.xMax) / 2},{a.yMax} {x:.1f},{y:.1f}\n')
        for command, output in COMMANDS:
            with self.subTest(command=command):
                without = self.made_by(command, output, '--text', 'o')
                self.assertFalse(without == self.made_by(command, output, '--text', 'o', '--hints', path))

    def test_an_empty_file_changes_nothing(self):
        empty = self.write('hints.txt', '')
        for command, output in COMMANDS[:2]:
            without = self.made_by(command, output)
            self.assertTrue(without == self.made_by(command, output, '--hints', empty))

    def test_characters_that_are_not_shared_are_told_when_asked(self):
        path = self.write('hints.txt', 'glyph 形\npoint 1,2 3,4\nglyph a\npoint 1,2 3,4\nglyph U+5F61\npoint 1,2 3,4\n')
        for command, output in COMMANDS:
            said = self.made(command, *FONTS, '--text', 'A', '--hints', path, '-v', '-o', output)
            lines = [line for line in said if 'hints' in line]
            self.assertEqual(lines, [f'morphotype: {path}: hints for 2 characters not in both fonts: U+5F61-5F62'])
            said = self.made(command, *FONTS, '--text', 'A', '--hints', path, '-o', output)
            self.assertEqual([line for line in said if 'hints' in line], [])

    def test_nothing_is_told_where_all_are_shared(self):
        path = self.write('hints.txt', 'glyph é\npoint 1,2 3,4\n')
        said = self.made('blend', *FONTS, '--text', 'A', '--hints', path, '-v', '-o', 'x.ttf')
        self.assertEqual([line for line in said if 'hints' in line], [])

    def test_one_font(self):
        path = self.write('hints.txt', 'glyph 形\npoint 1,2 3,4\n')
        self.assertEqual(self.made('inspect', cli.SERIF, '--text', 'A', '--hints', path, '-v', '-o', 'x.svg'), [])


if __name__ == '__main__':
    cli.main()
