"""Wrong usage: exit code 2, one line on stderr that points at the help. And the help itself."""

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
        for t in ('-0.1', '1.1', '1.0000001', 'half', 'nan', 'inf', '', ' 0.5', '0.5 ', '0,5;1', '0.5,', ',0.5', '0x1p-1',
                  '0.5,2', '1e999'):
            for command, output in COMMANDS[:3]:
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
        self.misused('blend', *FONTS, '-o', 'x.ttf', '--quiet=yes', says=['--quiet'])


class Help(cli.Test):
    """--help and --version"""

    def shown(self, *arguments):
        result = self.run_program(*arguments)
        self.assertEqual((result.returncode, result.stderr), (0, b''))
        return result.stdout.decode()

    def test_program(self):
        text = self.shown('--help')
        self.assertEqual(text, self.shown('-h'))
        for command, _ in COMMANDS:
            self.assertIn(f'\n  {command} ', text)
        self.assertRegex(self.shown('--version'), r'^morphotype \d+\.\d+\.\d+\n$')

    def test_commands(self):
        for command, _ in COMMANDS:
            text = self.shown(command, '--help')
            self.assertTrue(text.startswith(f'usage: morphotype {command} '), text)
            self.assertIn('--tolerance', text)
            self.assertLessEqual(max(map(len, text.splitlines())), 110)

    def test_commands_show_their_own_options_only(self):
        self.assertIn('--family', self.shown('blend', '--help'))
        self.assertNotIn('--family', self.shown('strip', '--help'))
        self.assertNotIn('--strict', self.shown('inspect', '--help'))


if __name__ == '__main__':
    cli.main()
