"""Holds the library to what programs that were linked with the last release expect of it: functions are not removed, and neither
their arguments nor public structs and enumerations change. Functions and enumerators at the end may be added.

    check_abi.py LIBRARY HEADER DESCRIPTION              compares
    check_abi.py LIBRARY HEADER DESCRIPTION --update     describes LIBRARY anew: with a release

abidw and abidiff, of abigail-tools, read the library's debug information, without which they would miss all but functions that are
removed; structs that HEADER only declares are left out. The exit code is 77 where these programs are not installed.
"""

import pathlib
import shutil
import subprocess
import sys
import tempfile

DESCRIBE = ['abidw', '--drop-private-types', '--exported-interfaces-only', '--short-locs', '--no-corpus-path',
            '--no-comp-dir-path', '--no-elf-needed']
COMPARE = ['abidiff', '--drop-private-types', '--no-added-syms']


def has_debug_information(library):
    sections = subprocess.run(['readelf', '--section-headers', '--wide', library], capture_output=True, text=True, check=True)
    return ' .debug_info ' in sections.stdout


def main():
    library, header, description, *update = sys.argv[1:]
    if not shutil.which('abidiff'):
        return 77
    if not has_debug_information(library):
        sys.exit(f'{library} has no debug information')
    with tempfile.TemporaryDirectory() as public:
        shutil.copy(header, pathlib.Path(public))
        if update == ['--update']:
            command = [*DESCRIBE, '--headers-dir', public, '--out-file', description, library]
        else:
            command = [*COMPARE, '--headers-dir2', public, description, library]
        return subprocess.run(command, check=False).returncode


if __name__ == '__main__':
    sys.exit(main())
