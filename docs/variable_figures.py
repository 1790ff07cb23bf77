#!/usr/bin/env python3
"""VARIABLE SOURCE SOURCE: the size of a variable font beside its sources' glyf tables, and how many contours its glyphs have."""

import os
import sys

from fontTools.ttLib import TTFont


def drawn(font):
    """The glyphs that have contours of their own."""
    glyphs = (font['glyf'][name] for name in font.getGlyphOrder())
    return [glyph for glyph in glyphs if glyph.numberOfContours > 0]


def main():
    path, *sources = sys.argv[1:]
    font, glyphs = TTFont(path), drawn(TTFont(path))
    tables = sum(len(TTFont(source).reader['glyf']) for source in sources)
    size, overlapping = os.path.getsize(path), sum(glyph.flags[0] & 0x40 != 0 for glyph in glyphs)
    print(f'{len(font.getGlyphOrder())} glyphs, {size} bytes: {size / tables:.2f} of the sources\' {tables} bytes of glyf')
    print(f'{len(glyphs)} with contours of their own, {sum(g.numberOfContours for g in glyphs) / len(glyphs):.2f} each; '
          f'{overlapping} overlap')
    for source in sources:
        own = drawn(TTFont(source))
        print(f'{source}: {sum(g.numberOfContours for g in own) / len(own):.2f} each')


if __name__ == '__main__':
    main()
