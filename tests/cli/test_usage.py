"""Wrong usage: exit code 2, one line on stderr that points at the help. And the help itself."""

import re

import cli

COMMANDS = (('blend', 'x.ttf'), ('strip', 'x.png'), ('sheet', 'x.pdf'), ('inspect', 'x.svg'))
FONTS = (cli.SANS_BOLD, cli.SERIF)


class Usage(cli.Test):
    """Every way to call it wrongly."""

    def misused(self, *arguments, says=()):
        self.refused(2, *arguments, says=('--help)', *says))

    def test_command(self):
        self.misused()
        self.misused('merge', *FONTS, says=['merge'])
        self.misused('--at', '0.5', 'blend')

    def test_fonts(self):
        for command, output in COMMANDS:
            self.misused(command, '--text', 'A', '-o', output, says=['wanted'])
            self.misused(command, *FONTS, 'third.ttf', '--text', 'A', '-o', output, says=['third.ttf'])
        for command, output in COMMANDS[:3]:
            self.misused(command, cli.SERIF, '--text', 'A', '-o', output, says=['two fonts'])

    def test_t(self):
        bad = ('half', 'nan', 'inf', '', ' 0.5', '0.5 ', '0,5;1', '0.5,', ',0.5', '0x1p-1', '1e999')
        too_far = {'blend': ('-1.1', '2.1', '2.0000001', '0.5,3')} # a blend goes past the ends
        for command, output in COMMANDS[:3]:
            for t in bad + too_far.get(command, ('-0.1', '1.1', '1.0000001', '0.5,2')):
                with self.subTest(command=command, t=t):
                    self.misused(command, *FONTS, '--text', 'A', '--at', t, '-o', output, says=['--at'])
        self.misused('blend', *FONTS, '--at', '0.5,0.25,0.50', '-o', 'x.ttf', says=['twice'])

    def test_steps(self):
        for steps in ('1', '0', '-3', '2.5', '1001', 'many', ''):
            for command, output in COMMANDS[1:3]:
                self.misused(command, *FONTS, '--text', 'A', '--steps', steps, '-o', output, says=['--steps'])
        self.misused('strip', *FONTS, '--text', 'A', '--steps', 3, '--at', '0', '-o', 'x.png', says=['--at', '--steps'])

    def test_parameters(self):
        for name, values in (('tolerance', ('0', '0.04', '11', 'fine')), ('fit', ('0', 'x')), ('method', ('', 'Paper', 'other')), ('rounds', ('-1', '1001', '1.5')),
                             ('threshold', ('-0.1', '1.1')), ('rotate', ('361', 'left', 'nan')), ('slant', ('46', 'right', 'nan')), ('jobs', ('0', '-1', '1025')),
                             ('weights', ('1', '1,0', '0.5,0.5,0.5', '2,-1,0', '0.5,0.25,0.25,0', 'a,b,c', ''))):
            for value in values:
                with self.subTest(name=name, value=value):
                    self.misused('blend', *FONTS, f'--{name}={value}', '-o', 'x.ttf', says=[f'--{name}'])

    def test_sizes(self):
        for size in ('0', '-1', '3', '8193', 'nan', 'big'):
            self.misused('strip', *FONTS, '--text', 'A', '--size', size, '-o', 'x.png', says=['--size'])
        for rows in ('0', '-1', '1.5'):
            self.misused('sheet', *FONTS, '--text', 'A', '--rows', rows, '-o', 'x.png', says=['--rows'])

    def test_output(self):
        for command, _ in COMMANDS:
            self.misused(command, *FONTS, '--text', 'A', says=['-o'])
            for output in ('x', 'x.jpeg', 'x.ttf.bak', 'ttf', ''):
                self.misused(command, *FONTS, '--text', 'A', '-o', output, says=['-o'])
        self.misused('blend', *FONTS, '-o', 'x.otf', says=['.ttf'])
        self.misused('strip', *FONTS, '--text', 'A', '-o', 'x.ttf', says=['.png'])

    def test_text(self):
        for command, output in COMMANDS[1:]:
            self.misused(command, *FONTS, '-o', output, says=['--text'])
        for command, output in COMMANDS:
            self.misused(command, *FONTS, '--text', b'A\xff'.decode('utf-8', 'surrogateescape'), '-o', output,
                         says=['--text', 'UTF-8'])
            self.misused(command, *FONTS, '--text', '', '-o', output, says=['--text'])
        self.misused('blend', *FONTS, '--text', 'A', '--chars', self.write('chars', 'A'), '-o', 'x.ttf', says=['exclude'])

    def test_family(self):
        self.misused('blend', *FONTS, '--family', '', '-o', 'x.ttf', says=['--family'])

    def test_options(self):
        self.misused('blend', *FONTS, '--frobnicate', '-o', 'x.ttf', says=['--frobnicate'])
        self.misused('blend', *FONTS, '-x', '-o', 'x.ttf', says=['-x'])
        self.misused('blend', *FONTS, '-qx', '-o', 'x.ttf', says=['-x'])
        self.misused('blend', *FONTS, '--steps', '3', '-o', 'x.ttf', says=['--steps'])
        self.misused('blend', *FONTS, '-o', says=['-o'])
        self.misused('blend', *FONTS, '-o', 'x.ttf', '--at', says=['--at'])
        self.misused('blend', *FONTS, '-o', 'x.ttf', '--quiet=yes', says=['--quiet takes no argument'])
        self.misused('blend', *FONTS, '-o', 'x.ttf', '--st', 'x', says=['--st may be any of --style, --strict'])
        self.misused('blend', *FONTS, '-o', 'x.ttf', '--fps=3', says=['--fps is no option of blend, but of animate'])

    def test_options_that_exclude_each_other(self):
        for options in (('-q', '-v'), ('--verbose', '--quiet'), ('-vq',)):
            self.misused('blend', *FONTS, '-o', 'x.ttf', *options, says=['--quiet and --verbose exclude each other'])
        self.misused('blend', *FONTS, '-o', 'x.ttf', '--alternates', '--no-layout', says=['--alternates and --no-layout'])


class Suggestions(cli.Test):
    """Did you mean …? Only what is near."""

    def said(self, *arguments):
        return self.refused(2, *arguments)

    def test_commands(self):
        for wrong, right in (('bland', 'blend'), ('rport', 'report'), ('strpi', 'strip'), ('sheets', 'sheet'), ('varible', 'variable')):
            self.assertIn(f'{wrong} is no command; did you mean {right}?', self.said(wrong, *FONTS))
            self.assertIn(f'{wrong} is no command; did you mean {right}?', self.said('help', wrong))

    def test_options(self):
        for wrong, right in (('--txet', '--text'), ('--sise', '--size'), ('--weigths=1,0,0', '--weights'),
                             ('--tolerence', '--tolerance'), ('--no-lables', '--no-labels'), ('--quite', '--quiet')):
            self.assertIn(f'{wrong} is no option of strip; did you mean {right}?', self.said('strip', *FONTS, wrong))

    def test_nothing_is_near(self):
        for arguments in (('frobnicate', *FONTS), ('b', *FONTS), ('x' * 100, *FONTS), ('blend', *FONTS, '--frobnicate'),
                          ('blend', *FONTS, '--' + 'x' * 100)):
            self.assertNotIn('did you mean', self.said(*arguments))


class Help(cli.Test):
    """--help and --version"""

    def shown(self, *arguments):
        result = self.run_program(*arguments)
        self.assertEqual((result.returncode, result.stderr), (0, b''))
        return result.stdout.decode()

    def commands(self):
        return re.findall(r'^  ([a-z]+)  ', self.shown('--help'), flags=re.M)

    def test_program(self):
        text = self.shown('--help')
        for arguments in (['-h'], ['help']):
            self.assertEqual(text, self.shown(*arguments))
        self.assertLessEqual({command for command, _ in COMMANDS}, set(self.commands()))

    def test_version(self):
        text = self.shown('--version')
        self.assertRegex(text, r'^morphotype \d+\.\d+\.\d+\n$')
        for arguments in (['-V'], ['blend', '--version'], ['strip', '-V', 'nothing.ttf']):
            self.assertEqual(text, self.shown(*arguments))

    def test_commands(self):
        for command in self.commands():
            text = self.shown(command, '--help')
            self.assertTrue(text.startswith(f'usage: morphotype {command} '), text)
            self.assertIn('--quiet', text)
            self.assertEqual('--tolerance' in text, command != 'solid') # a solid has no curves
            for arguments in ([command, '-h'], ['help', command]):
                self.assertEqual(text, self.shown(*arguments))

    def test_width(self):
        for command in ['', *self.commands()]:
            for line in self.shown('help', *command.split()).splitlines():
                self.assertLessEqual(len(line), 110, line)

    def test_commands_show_their_own_options_only(self):
        self.assertIn('--family', self.shown('blend', '--help'))
        self.assertNotIn('--family', self.shown('strip', '--help'))
        self.assertNotIn('--strict', self.shown('inspect', '--help'))


if __name__ == '__main__':
    cli.main()
