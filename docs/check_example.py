"""Runs docs/example.c's program on the demo fonts and looks at what it writes.

    check_example.py PROGRAM FONT-A FONT-B
"""

import pathlib
import re
import struct
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as ElementTree

PROGRAM, FONT_A, FONT_B = sys.argv[1:]


def run(*arguments):
    return subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, text=True, check=False)


def tables_of(path):
    """The tables of a TrueType font, by tag."""
    data = path.read_bytes()
    version, count = struct.unpack('>IH', data[:6])
    assert version == 0x00010000, 'no TrueType font'
    tables = {}
    for i in range(count):
        tag, _, start, length = struct.unpack('>4sIII', data[12 + 16 * i:28 + 16 * i])
        tables[tag.decode()] = data[start:start + length]
    return tables


def drawing_of(svg):
    """Units per em, advance, and the area inside the path of an SVG that the program printed."""
    root = ElementTree.fromstring(svg)
    _, top, advance, _ = map(float, root.get('viewBox').split())
    (path,) = root
    area, start, at = 0.0, None, None
    for command, numbers in re.findall(r'([MLQZ])([^MLQZ]*)', path.get('d')):
        values = list(map(float, numbers.split()))
        points = list(zip(values[::2], values[1::2]))
        assert len(points) == {'M': 1, 'L': 1, 'Q': 2, 'Z': 0}[command], command + numbers
        if command == 'M':
            start = at = points[0]
            continue
        end = points[-1] if points else start
        if command == 'Q':  # two thirds of the triangle between the chord and the control point
            (x0, y0), (x1, y1), (x2, y2) = at, points[0], end
            area += ((x1 - x0) * (y2 - y0) - (x2 - x0) * (y1 - y0)) / 3
        area += (at[0] * end[1] - end[0] * at[1]) / 2
        at = end
    return -top, advance, abs(area)


def check_drawings(output):
    """The glyph at 0, 0.5 and 1: its advance in the middle, its ink between the ends', the font as promised."""
    made = []
    for t in (0, 0.5, 1):
        result = run(FONT_A, FONT_B, t, 'U+0067', output)
        assert result.returncode == 0, result.stderr
        assert result.stderr == '', result.stderr
        made.append(drawing_of(result.stdout))
        tables = tables_of(output)
        assert {'glyf', 'loca', 'hmtx', 'cmap', 'head', 'hhea', 'maxp', 'OS/2', 'post', 'name'} <= set(tables)
        units = struct.unpack('>H', tables['head'][18:20])[0]
        assert made[-1][0] == units, (made[-1], units)
        output.unlink()
    (_, first, ink_a), (_, middle, ink), (_, last, ink_b) = made
    assert abs(middle - (first + last) / 2) < 1e-3, made
    assert first != last and ink_b < ink < ink_a, made


def check_refusals(output):
    """Each failure is one line on stderr, and leaves no file and nothing on stdout."""
    for arguments, code, text in [
        ((FONT_A, FONT_B, 0.5, 'U+0067'), 2, 'usage'),
        ((FONT_A, FONT_B, 'half', 'U+0067', output), 2, 'usage'),
        ((FONT_A, 'missing.ttf', 0.5, 'U+0067', output), 1, 'missing or cannot be read'),
        ((FONT_A, FONT_B, 1.5, 'U+0067', output), 1, 'out of range'),
        ((FONT_A, FONT_B, 0.5, 'U+0424', output), 1, 'no glyph'),
    ]:
        result = run(*arguments)
        assert result.returncode == code, (arguments, result)
        assert text in result.stderr and result.stderr.count('\n') == 1, result.stderr
        assert result.stdout == '' and not output.exists(), arguments


with tempfile.TemporaryDirectory(prefix='morphotype-test-') as directory:
    check_drawings(pathlib.Path(directory) / 'Between.ttf')
    check_refusals(pathlib.Path(directory) / 'Between.ttf')
