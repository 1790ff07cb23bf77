"""The pages of the manual: one for each command, well formed, with what --help has; their examples do what they say."""

import os
import pathlib
import re
import shlex
import shutil
import subprocess

import cli

PAGES = pathlib.Path(os.environ['PAGES'])


def shown(*arguments):
    return subprocess.run([cli.MORPHOTYPE, *arguments], capture_output=True, text=True, check=True).stdout


COMMANDS = re.findall(r'^  ([a-z]+)  ', shown('--help'), flags=re.M)


def read(page):
    """As it is read on a terminal, a line a paragraph or entry."""
    text = subprocess.run(['mandoc', '-Tutf8', '-Owidth=1000', page], capture_output=True, text=True, check=True).stdout
    return re.sub('.\b', '', text)


class Pages(cli.Test):
    """Their form and their content."""

    def test_each_command_has_one(self):
        self.assertEqual({page.name for page in PAGES.glob('*.1')},
                         {'morphotype.1', *(f'morphotype-{command}.1' for command in COMMANDS)})

    def test_form(self):
        for page in PAGES.glob('*.1'):
            checked = subprocess.run(['mandoc', '-Tlint', page], capture_output=True, text=True, check=False)
            self.assertEqual((checked.returncode, checked.stdout, checked.stderr), (0, '', ''))

    def test_options(self):
        """Those of --help, with what is said of each."""
        for command in COMMANDS:
            text = ' '.join(read(PAGES / f'morphotype-{command}.1').split())
            entries = re.split(r'^  (?:-\w, |    )(?=--)', shown('help', command).partition('\n\nOptions:')[2], flags=re.M)[1:]
            self.assertGreater(len(entries), 15)
            for entry in entries:
                name, said = re.match(r'(--\S+(?: \S+)?)  +(.*)', ' '.join(entry.split('\n')), flags=re.S).groups()
                said = ' '.join(said.replace('Options of every command:', '').split())
                self.assertIn(f'{name} {said}', text)

    def test_program(self):
        text = read(PAGES / 'morphotype.1')
        for command in COMMANDS:
            self.assertIn(f'morphotype-{command}(1)', text)
        for word in ('EXIT STATUS', 'SOURCE_DATE_EPOCH', 'FILE[#FACE]'):
            self.assertIn(word, text)


class Examples(cli.Test):
    """Each example of each page, with the demo fonts and our own models."""

    def test_examples(self):
        shutil.copy(cli.DEMO_SANS, self.path('A.ttf'))
        shutil.copy(cli.DEMO_SERIF, self.path('B.otf'))
        for model in (cli.SOURCE / 'solids').glob('*.obj'):
            shutil.copy(model, self.path(model.name))
        for command in COMMANDS:
            lines = re.findall(r'^ +(morphotype .*)$', read(PAGES / f'morphotype-{command}.1').partition('EXAMPLES')[2], flags=re.M)
            self.assertTrue(lines, command)
            for line in lines:
                words = shlex.split(line)
                result = self.run_program(*words[1:])
                self.assertEqual(result.returncode, 0, (line, result.stderr))
                if '-o' in words:
                    output = self.path(words[words.index('-o') + 1])
                    self.assertTrue(output.exists() or list(self.directory.glob(f'{output.stem}-*')), line)


if __name__ == '__main__':
    cli.main(needs=['mandoc'])
