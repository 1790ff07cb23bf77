"""What the tests of the module share."""

import os
import pathlib
import subprocess

ROOT = pathlib.Path(__file__).resolve().parents[2]
SANS = ROOT / 'fonts' / 'MorphotypeDemo-Sans.ttf'
SERIF = ROOT / 'fonts' / 'MorphotypeDemo-Serif.otf'
PROGRAM = os.environ['MORPHOTYPE']


def command_line(*arguments):
    """The built program's run; what it prints is in `stderr`."""
    return subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, text=True, check=False)
