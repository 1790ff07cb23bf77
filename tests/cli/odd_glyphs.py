"""Glyphs that no one draws: stars, nests, combs, spirals, walks, slivers and contours that share places, by a seed."""

import math
import random

from fontTools.fontBuilder import FontBuilder
from fontTools.pens.ttGlyphPen import TTGlyphPen

EM = 1000
MOST = 16383 # so that the way between two points is one that 'glyf' can hold


def star(dice, points):
    """One contour that crosses itself some points² / 5 times."""
    points |= 1
    leap, far = dice.randrange(2, max(3, points // 2)), dice.choice((400, 400, 4000, 16000))
    turns = [2 * math.pi * i * leap / points for i in range(points)]
    return [[(500 + far * math.cos(t), 400 + far * math.sin(t)) for t in turns]]


def nest(dice, points):
    """Squares in squares, each the other way around or the same."""
    count, flip, each = max(1, points // 4), dice.random() < 0.7, dice.choice((1, 3, 10))
    contours = []
    for i in range(count):
        far = each * (count - i)
        square = [(-far, -far), (far, -far), (far, far), (-far, far)]
        contours.append(square[::-1] if flip and i % 2 else square)
    return contours


def comb(dice, points):
    """Teeth, close together."""
    teeth, width, high = max(1, points // 4), dice.choice((1, 2, 7, 40)), dice.choice((100, 700, 20000))
    top = []
    for i in range(teeth):
        x = 2 * i * width
        top += [(x, high), (x + width, high), (x + width, 10), (x + 2 * width, 10)]
    return [[(0, 0)] + top + [(2 * teeth * width, 0)]]


def spiral(dice, points):
    """A band that winds around itself."""
    half, turns, wide = max(3, points // 2), dice.uniform(1, 60), dice.choice((1, 4, 15))
    out, back = [], []
    for i in range(half):
        angle, far = 2 * math.pi * turns * i / half, 20 + 30 * turns * i / half
        out.append((far * math.cos(angle), far * math.sin(angle)))
        back.append(((far + wide) * math.cos(angle), (far + wide) * math.sin(angle)))
    return [out + back[::-1]]


def walk(dice, points):
    """Anywhere, in contours of any length."""
    contours, left, far = [], points, dice.choice((30, 1000, MOST))
    while left > 2:
        count = min(left, dice.randrange(3, max(4, points)))
        contours.append([(dice.uniform(-far, far), dice.uniform(-far, far)) for _ in range(count)])
        left -= count
    return contours


def slivers(dice, points):
    """Triangles that are hardly there, up to 16 em long."""
    contours = []
    for _ in range(max(1, points // 3)):
        x, y = dice.uniform(-500, 500), dice.uniform(-500, 500)
        angle, long = dice.uniform(0, 2 * math.pi), dice.choice((3, 500, 16000))
        end = x + long * math.cos(angle), y + long * math.sin(angle)
        contours.append([(x, y), end, (end[0] + dice.choice((-1, 0, 1)), end[1] + 1)])
    return contours


def shared(dice, points):
    """Contours whose points stand on few places: they touch, lie on one another and run back on themselves."""
    side = dice.choice((2, 3, 5, 9))
    places = [(200 * i, 200 * k) for i in range(side) for k in range(side)]
    contours = []
    for _ in range(max(1, min(points // 4, 60))):
        contours.append([dice.choice(places) for _ in range(dice.randrange(3, 12))])
    return contours


KINDS = (star, nest, comb, spiral, walk, slivers, shared)


def drawn(contours):
    """A glyph of these contours, of lines between places that 'glyf' can hold."""
    pen = TTGlyphPen(None)
    for contour in contours:
        placed = [tuple(max(-MOST, min(MOST, round(v))) for v in p) for p in contour]
        pen.moveTo(placed[0])
        for p in placed[1:]:
            pen.lineTo(p)
        pen.closePath()
    return pen.glyph()


def glyph(dice, most):
    """A glyph of up to `most` points, of few more often than of many."""
    contours = dice.choice(KINDS)(dice, round(math.exp(dice.uniform(math.log(3), math.log(most)))))
    kept, left = [], most
    for contour in contours:
        left -= len(contour)
        if left < 0:
            break
        kept.append(contour)
    return drawn(kept)


def built(glyphs, first, **options):
    """A font of these glyphs by their names, from the code point `first` on, not saved yet; options are of setupGlyf."""
    builder = FontBuilder(EM, isTTF=True)
    builder.setupGlyphOrder(['.notdef', *glyphs])
    builder.setupCharacterMap({first + i: name for i, name in enumerate(glyphs)})
    builder.setupGlyf({'.notdef': TTGlyphPen(None).glyph(), **glyphs}, **options)
    builder.setupHorizontalMetrics({name: (EM, 0) for name in ['.notdef', *glyphs]})
    builder.setupHorizontalHeader(ascent=800, descent=-200)
    builder.setupNameTable({'familyName': 'Odd', 'styleName': 'Regular'})
    builder.setupOS2()
    builder.setupPost()
    return builder.font


def font(path, count, seed, most):
    """A font of `count` odd glyphs, from U+E000 on."""
    dice = random.Random(seed)
    built({f'odd{i}': glyph(dice, most) for i in range(count)}, 0xE000).save(path)
    return path
