"""Installs the library into a folder, and builds docs/example.c from there by what pkg-config says and nothing else: with the shared
library, and with the static one alone. Both programs are then to write the same font.

    check_install.py BUILD EXAMPLE FONT-A FONT-B COMPILER...
"""

import os
import pathlib
import re
import subprocess
import sys
import tempfile

BUILD, EXAMPLE, FONT_A, FONT_B = sys.argv[1:5]
COMPILER = sys.argv[5:]


def run(*command, **more):
    result = subprocess.run([str(word) for word in command], capture_output=True, text=True, check=False, **more)
    assert result.returncode == 0, f'{command}: {result.stdout}{result.stderr}'
    return result.stdout


def install(folder):
    """Installs there, with a pkg-config file that says so; where this file and the libraries are."""
    run('meson', 'install', '-C', BUILD, '--no-rebuild', '--quiet', env=dict(os.environ, DESTDIR=str(folder)))
    (module,) = folder.rglob('morphotype.pc')
    module.write_text(re.sub(r'^prefix=', f'prefix={folder}', module.read_text(), flags=re.M))
    return module.parent, module.parent.parent


def flags(modules, *options):
    return run('pkg-config', *options, '--cflags', '--libs', 'morphotype',
               env=dict(os.environ, PKG_CONFIG_PATH=str(modules))).split()


def font_of(program, output, libraries):
    run(program, FONT_A, FONT_B, '0.5', 'U+0067', output, env=dict(os.environ, LD_LIBRARY_PATH=str(libraries)))
    return output.read_bytes()


def needs_library(program):
    return 'libmorphotype' in run('ldd', program, env=dict(os.environ, LD_LIBRARY_PATH='/nowhere'))


def main():
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        modules, libraries = install(folder)
        run(*COMPILER, '-o', folder / 'dynamic', EXAMPLE, *flags(modules))
        assert needs_library(folder / 'dynamic')
        dynamic = font_of(folder / 'dynamic', folder / 'dynamic.ttf', libraries)
        for shared in libraries.glob('libmorphotype.so*'):
            shared.unlink()
        run(*COMPILER, '-o', folder / 'static', EXAMPLE, *flags(modules, '--static'))
        assert not needs_library(folder / 'static')
        assert font_of(folder / 'static', folder / 'static.ttf', '/nowhere') == dynamic


if __name__ == '__main__':
    main()
