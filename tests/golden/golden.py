#!/usr/bin/env python3
"""Draws the paper's figures anew and holds them against the pictures that stand beside this file.

    golden.py PROGRAM FIGURE METHOD        compares one picture
    golden.py PROGRAM --update             draws all of them; look at each before it is checked in

Needs Python 3 alone. The distance leaves out the pixels that are white in both pictures, as most are. Of the others
it takes the mean absolute difference of their grey levels (0 ... 255), and the share that differs by more than a
quarter of the range. Both are printed.

The same build draws the same bytes; the bounds leave room for another Cairo that smooths edges a little otherwise.
Steps that lie at T + 0.01 come to a mean of 1.3 to 4.4 in the strips, and --one-scale, which links other pieces,
to 1.0 in the picture of links.
"""

import pathlib
import struct
import subprocess
import sys
import tempfile
import zlib

HERE = pathlib.Path(__file__).resolve().parent
FONTS = HERE.parents[1] / 'fonts'
PAPER = [FONTS / 'PaperA.ttf', FONTS / 'PaperB.ttf']
DEMO = [FONTS / 'MorphotypeDemo-Sans.ttf', FONTS / 'MorphotypeDemo-Serif.otf']

MEAN_MOST = 0.5  # grey levels
STEP = 64  # grey levels: a pixel differs by more than this
SHARE_MOST = 0.002

# The paper's figures: the subcommand, the fonts, and what is drawn.
FIGURES = {
    'figure1': ['strip', *PAPER, '--text', '\ue001', '--steps', '5', '--size', '64', '--no-labels'],
    'figure2': ['strip', *PAPER, '--text', '三', '--steps', '5', '--size', '64', '--no-labels'],
    'figure2-links': ['inspect', *PAPER, '--text', '三', '--size', '96'],
    'figure3': ['strip', *DEMO, '--text', '形', '--steps', '8', '--size', '96', '--no-labels'],
}
METHODS = ['paper', 'joint']


def name_of(figure, method):
    return f'{figure}-{method}.png'


def draw(program, figure, method, path):
    subprocess.run([program, *FIGURES[figure], '--method', method, '--quiet', '-o', path], check=True)


# ---- PNG -----------------------------------------------------------------------------------------------------------

def chunks_of(data):
    assert data[:8] == b'\x89PNG\r\n\x1a\n', 'no PNG'
    at = 8
    while at < len(data):
        length, kind = struct.unpack('>I4s', data[at:at + 8])
        yield kind, data[at + 8:at + 8 + length]
        at += 12 + length


def predict(kind, left, up, corner):
    """The filters of PNG's section 9."""
    if kind == 4:
        guess = left + up - corner
        return min((left, up, corner), key=lambda value: abs(guess - value))
    return (0, left, up, (left + up) // 2)[kind]


def read_png(path):
    """Width, height and grey levels, row after row, of an RGB picture with 8 bits a channel, as Cairo writes it."""
    packed = b''
    for kind, body in chunks_of(path.read_bytes()):
        if kind == b'IHDR':
            width, height, depth, colours, _, _, interlaced = struct.unpack('>IIBBBBB', body)
            assert (depth, colours, interlaced) == (8, 2, 0), 'another kind of PNG'
        if kind == b'IDAT':
            packed += body
    raw, stride, above, grey = zlib.decompress(packed), 3 * width, bytearray(3 * width), []
    for start in range(0, height * (stride + 1), stride + 1):
        kind, row = raw[start], bytearray(raw[start + 1:start + 1 + stride])
        for i in range(stride):
            left, corner = (row[i - 3], above[i - 3]) if i >= 3 else (0, 0)
            row[i] = (row[i] + predict(kind, left, above[i], corner)) & 255
        grey += [sum(row[i:i + 3]) / 3 for i in range(0, stride, 3)]
        above = row
    return width, height, grey


# ---- the distance --------------------------------------------------------------------------------------------------

def distance(golden, drawn):
    """Mean difference, and the share of pixels that differ by more than STEP."""
    inked = [abs(p - q) for p, q in zip(golden, drawn) if p < 255 or q < 255]
    assert inked, 'both pictures are blank'
    return sum(inked) / len(inked), sum(d > STEP for d in inked) / len(inked)


def compare(program, figure, method):
    golden = read_png(HERE / name_of(figure, method))
    with tempfile.TemporaryDirectory(prefix='morphotype-test-') as directory:
        path = pathlib.Path(directory) / name_of(figure, method)
        draw(program, figure, method, path)
        drawn = read_png(path)
    if golden[:2] != drawn[:2]:
        return print('sizes differ: {}×{} checked in, {}×{} drawn'.format(*golden[:2], *drawn[:2])) or 1
    mean, share = distance(golden[2], drawn[2])
    print(f'{name_of(figure, method)}: mean {mean:.3f} (at most {MEAN_MOST}), '
          f'{100 * share:.3f} % over {STEP} (at most {100 * SHARE_MOST:g} %)')
    return 0 if mean <= MEAN_MOST and share <= SHARE_MOST else 1


def update(program):
    for figure in FIGURES:
        for method in METHODS:
            draw(program, figure, method, HERE / name_of(figure, method))
    return 0


if __name__ == '__main__':
    sys.exit(update(sys.argv[1]) if sys.argv[2] == '--update' else compare(*sys.argv[1:]))
