#!/usr/bin/env python3
"""Writes a C file with the digest of the engine: of all sources that the morph of two glyphs comes from.

    engine.py OUT.c OUT.d WORD...

The sources are those of the rooms below, which include no others but the public header (tools/check-includes), and the file that
calls them. The WORDs, such as the version of the library for unions and of the compiler, count too. OUT.d lists the sources for the build.
"""

import hashlib
import pathlib
import sys

SOURCE = pathlib.Path(__file__).resolve().parent.parent
ROOMS = ['arithmetic', 'base', 'geometry', 'morph', 'cache']
FILES = ['morphotype.h', 'blend/pair.c', 'blend/pair.h']


def sources():
    found = [path for room in ROOMS for path in (SOURCE / room).rglob('*') if path.suffix in ('.c', '.cpp', '.h')]
    return sorted(found + [SOURCE / name for name in FILES])


def main():
    out, dependencies, *words = sys.argv[1:]
    digest = hashlib.sha256('\0'.join(words).encode())
    for path in sources():
        content = path.read_bytes()
        digest.update(f'{path.relative_to(SOURCE)} {len(content)}\0'.encode() + content)
    pathlib.Path(out).write_text(
        f'#include "cache/engine.h"\n\nconst char mt_engine[] = "{digest.hexdigest()}";\n', encoding='utf-8')
    listed = ' '.join(str(path).replace(' ', '\\ ') for path in sources())
    pathlib.Path(dependencies).write_text(f'{out}: {listed}\n', encoding='utf-8')


main()
