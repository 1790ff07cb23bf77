#!/usr/bin/env python3
"""VARIABLE FONT...: how near a family's variable font comes to fonts of the family that it was not made of.

Each FONT is placed where its n and o fit best on the font's one axis. Told are the place, and of all characters that both draw the
shared ink over all ink, and the advances. VARIABLE_SAMPLE names the comparing program, build/tests/cli/variable-sample.
"""

import os
import subprocess
import sys

from fontTools.ttLib import TTFont

SAMPLE = os.environ.get('VARIABLE_SAMPLE', 'build/tests/cli/variable-sample')


def compare(variable, tag, place, font, points):
    """Shared ink over all ink, and by how many units the advance is longer, of each."""
    lines = subprocess.run([SAMPLE, 'compare', 'none', f'{variable}@{tag}={place:.4f}', '0', font], check=True, text=True,
                           input=' '.join(f'{c:x}' for c in points), stdout=subprocess.PIPE).stdout.splitlines()
    return [tuple(map(float, line.split()[1:])) for line in lines]


def best_place(variable, axis, font):
    """By ever narrower looks."""
    low, high, looks = axis.minValue, axis.maxValue, 8
    for _ in range(5):
        places = [low + (high - low) * i / looks for i in range(looks + 1)]
        fits = [sum(share for share, _ in compare(variable, axis.axisTag, place, font, map(ord, 'no'))) for place in places]
        best = fits.index(max(fits))
        low, high = places[max(best - 1, 0)], places[min(best + 1, looks)]
    return (low + high) / 2


def main():
    variable, *fonts = sys.argv[1:]
    varying = TTFont(variable)
    axis, ours = varying['fvar'].axes[0], varying.getBestCmap()
    print(f'{variable}: {os.path.getsize(variable)} bytes')
    for path in fonts:
        font = TTFont(path)
        theirs, em = font.getBestCmap(), font['head'].unitsPerEm
        points = [c for c in ours if c in theirs and font['glyf'][theirs[c]].numberOfContours != 0]
        place = best_place(variable, axis, path)
        rows = compare(variable, axis.axisTag, place, path, points)
        shares, advances = sorted(share for share, _ in rows), [1000 * abs(apart) / em for _, apart in rows]
        print(f'{path}: {os.path.getsize(path)} bytes, at {place:.1f}, {len(points)} characters: {shares[len(shares) // 2]:.3f} in the '
              f'median, {shares[len(shares) // 20]:.3f} at the 5th percentile; advances within {max(advances):.2f}/1000 em')


if __name__ == '__main__':
    main()
