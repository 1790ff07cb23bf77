"""What bash, zsh and fish complete: each shell itself is asked, in a terminal where it wants one."""

import os
import pathlib
import pty
import re
import select
import subprocess
import time

import cli

PAGES = pathlib.Path(os.environ['PAGES'])

# What is typed before Tab, and what it becomes; the files are those of Shell.setUp.
BECOMES = (
    ('morphotype bl', 'morphotype blend '),
    ('morphotype var', 'morphotype variable '),
    ('morphotype help insp', 'morphotype help inspect '),
    ('morphotype blend Fir', 'morphotype blend First.ttf '),
    ('morphotype blend First.ttf Sec', 'morphotype blend First.ttf Second.OTF '),
    ('morphotype blend fol', 'morphotype blend folder/'),
    ('morphotype blend folder/', 'morphotype blend folder/Third.woff2 '),
    ('morphotype animate Dra', 'morphotype animate Drawing.svg '),
    ('morphotype blend --tol', 'morphotype blend --tolerance'),
    ('morphotype strip --no-lab', 'morphotype strip --no-labels '),
    ('morphotype blend --no-lab', 'morphotype blend --no-lab'),
    ('morphotype blend First.ttf --glyphs fi', 'morphotype blend First.ttf --glyphs first '),
    ('morphotype blend First.ttf --method=pa', 'morphotype blend First.ttf --method=paper '),
    ('morphotype animate --ease lin', 'morphotype animate --ease linear '),
    ('morphotype blend --rotate au', 'morphotype blend --rotate auto '),
    ('morphotype blend --chars no', 'morphotype blend --chars notes.txt '),
    ('morphotype strip -o st', 'morphotype strip -o strip.png '),
    ('morphotype blend --output Fir', 'morphotype blend --output First.ttf '),
)

# Files that do not fit: none is completed, but in zsh, which then offers all files.
FITS_NOT = (
    ('morphotype blend First.ttf no', 'morphotype blend First.ttf notes.txt '),
    ('morphotype strip Dra', 'morphotype strip Drawing.svg '),
    ('morphotype blend -o no', 'morphotype blend -o notes.txt '),
)


def options_of(command):
    """Those that the help shows."""
    text = subprocess.run([cli.MORPHOTYPE, *command.split(), '--help'], capture_output=True, text=True, check=True).stdout
    return re.findall(r'^  (?:-\w, |    )(--[a-z-]+)', text, flags=re.M)


def commands():
    text = subprocess.run([cli.MORPHOTYPE, '--help'], capture_output=True, text=True, check=True).stdout
    return re.findall(r'^  ([a-z]+)  ', text, flags=re.M)


class Shell(cli.Test):
    """Some files to complete."""

    def setUp(self):
        super().setUp()
        self.path('folder').mkdir()
        for name in ('First.ttf', 'Second.OTF', 'Drawing.svg', 'notes.txt', 'strip.png', 'folder/Third.woff2'):
            self.write(name, '')

    def environment(self):
        return {'HOME': os.fspath(self.directory), 'TERM': 'xterm', 'LC_ALL': 'C.UTF-8', 'PATH': os.environ['PATH'],
                'INPUTRC': '/dev/null'}


class Terminal(Shell):
    """A shell in a terminal: words are typed into it, and it writes the line that they become to a file."""

    COMMAND = ()
    PREPARE = ''

    def completed(self, lines):
        log = self.path('log')
        self.write('prepare', self.PREPARE.format(pages=PAGES, log=log, directory=self.directory))
        child, terminal = pty.fork()
        if child == 0:
            os.chdir(self.directory)
            os.execvpe(self.COMMAND[0], self.COMMAND, self.environment())
        self.addCleanup(os.close, terminal)
        self.addCleanup(self.end, child)
        os.write(terminal, b' . ./prepare\r')
        self.wait(terminal, log, 1)
        for number, line in enumerate(lines, 2):
            os.write(terminal, line.encode() + b'\t\x18p')
            self.wait(terminal, log, number)
        return log.read_text().splitlines()[1:]

    def wait(self, terminal, log, count):
        """Until the log has so many lines. What the shell shows has to be read, or it waits."""
        limit, shown = time.monotonic() + 60, b''
        while not log.exists() or log.read_text().count('\n') < count:
            if select.select([terminal], [], [], 0.02)[0]:
                shown += os.read(terminal, 65536)
            self.assertLess(time.monotonic(), limit, shown.decode(errors='replace'))

    @staticmethod
    def end(child):
        os.kill(child, 9)
        os.waitpid(child, 0)

    def check_becomes(self, rows):
        lines = self.completed([typed for typed, _ in rows])
        for (typed, becomes), line in zip(rows, lines, strict=True):
            # An option that takes an argument is followed by a blank or by =, as the shell has it.
            wanted = {becomes + end for end in (' ', '=')} if becomes.endswith('--tolerance') else {becomes}
            self.assertIn(line, wanted, typed)

    def check_all(self):
        """Each option of each command is known: written whole, it is complete."""
        typed = [f'morphotype {command} {option}' for command in commands() for option in options_of(command)]
        # An option that begins another one stays, too, and without a blank.
        for line, wanted in zip(self.completed(typed), typed, strict=True):
            self.assertEqual(line.rstrip(' ='), wanted)
            begins = sum(other.startswith(wanted) for other in typed)
            self.assertTrue(line[-1] in ' =' or begins > 1, line)


class Bash(Terminal):
    """bash"""

    COMMAND = ('bash', '--norc', '--noprofile', '-i')
    PREPARE = """PS1=
bind 'set bell-style none'
. {pages}/morphotype
probe() {{ printf '%s\\n' "$READLINE_LINE" >>{log}; READLINE_LINE=; }}
bind -x '"\\C-xp": probe'
echo ready >>{log}
"""

    def test_words(self):
        self.check_becomes([*BECOMES, *((typed, typed) for typed, _ in FITS_NOT)])

    def test_all_options(self):
        self.check_all()


class Zsh(Terminal):
    """zsh"""

    COMMAND = ('zsh', '-f', '-i')
    PREPARE = """PS1=
fpath=({pages} $fpath)
autoload -Uz compinit
compinit -u -d {directory}/.zcompdump
probe() {{ print -r -- "$BUFFER" >>{log}; BUFFER=; }}
zle -N probe
bindkey '^Xp' probe
echo ready >>{log}
"""

    def test_words(self):
        self.check_becomes([*BECOMES, *FITS_NOT])

    def test_all_options(self):
        self.check_all()


class Fish(Shell):
    """fish, which lists what it would complete."""

    def offered(self, *lines):
        """Of each line, what it offers: words, without what is told of them."""
        script = f'source {PAGES}/morphotype.fish\n'
        for number, line in enumerate(lines):
            script += f"echo '# {number}'\ncomplete -C '{line}'\n"
        shown = subprocess.run(['fish', '--no-config', '-c', script], cwd=self.directory, env=self.environment(),
                               capture_output=True, text=True, check=True)
        self.assertEqual(shown.stderr, '')
        parts = re.split(r'^# \d+\n', shown.stdout, flags=re.M)[1:]
        return [[line.partition('\t')[0] for line in part.splitlines()] for part in parts]

    def test_words(self):
        rows = [*BECOMES, *((typed, typed) for typed, _ in FITS_NOT)]
        for (typed, becomes), words in zip(rows, self.offered(*(typed for typed, _ in rows)), strict=True):
            with self.subTest(typed=typed):
                last = becomes.rstrip().split(' ')[-1]
                self.assertEqual([word.rstrip('=') for word in words], [last] if becomes != typed else [])

    def test_all_options(self):
        names = commands()
        for command, words in zip(names, self.offered(*(f'morphotype {name} --' for name in names)), strict=True):
            self.assertEqual({word.rstrip('=') for word in words}, set(options_of(command)), command)
        (words,) = self.offered('morphotype ')
        self.assertEqual(sorted(words), sorted([*names, 'help']))


if __name__ == '__main__':
    cli.main(needs=['bash', 'zsh', 'fish'])
