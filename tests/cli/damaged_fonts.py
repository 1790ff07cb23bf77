"""Fonts with damage in their tables, by a seed: layout, variation and outline tables more often than others."""

import random
import struct

OFTEN = ('GPOS', 'GSUB', 'GDEF', 'MATH', 'gvar', 'HVAR', 'VVAR', 'MVAR', 'avar', 'fvar', 'glyf', 'CFF ', 'CFF2', 'kern')
SELDOM = ('name', 'head', 'post', 'OS/2', 'gasp', 'cvt ', 'fpgm', 'prep', 'DSIG')
NUMBERS = (0, 1, 2, 3, 0x7FFF, 0x8000, 0xFFFF, 0x100)


def tables_of(font):
    """(tag, offset, length) of each table of an sfnt; of a collection, of its first font."""
    start = struct.unpack('>I', font[12:16])[0] if font[:4] == b'ttcf' else 0
    count = struct.unpack('>H', font[start + 4:start + 6])[0]
    entries = (struct.unpack('>4sIII', font[start + 12 + 16 * i:start + 28 + 16 * i]) for i in range(count))
    return [(tag.decode('latin-1'), offset, length) for tag, _, offset, length in entries if length > 1]


def weight_of(table):
    return 12 if table[0] in OFTEN else 1 if table[0] in SELDOM else 3


def damage(dice, font):
    """A copy with one to eight numbers of 16 bits changed, most of them in the first part of one or two tables."""
    damaged, tables = bytearray(font), tables_of(font)
    chosen = dice.choices(tables, [weight_of(table) for table in tables], k=dice.choice((1, 1, 2)))
    for _ in range(dice.choice((1, 1, 2, 4, 8))):
        _, offset, length = dice.choice(chosen)
        reach = min(length, dice.choice((40, 400, length)))
        at = offset + dice.randrange(max(1, reach // 2)) * 2
        old = struct.unpack('>H', damaged[at:at + 2].ljust(2, b'\0'))[0]
        new = dice.choice((dice.choice(NUMBERS), old + 1 & 0xFFFF, old - 1 & 0xFFFF, old ^ 1 << dice.randrange(16)))
        damaged[at:at + 2] = struct.pack('>H', new)
    return bytes(damaged)


def fonts(paths, count, seed):
    """`count` damaged fonts, as (name, bytes); the first of each path in turn."""
    dice = random.Random(seed)
    whole = [(path, path.read_bytes()) for path in paths]
    for i in range(count):
        path, font = whole[i % len(whole)]
        yield f'{i}-{path.name}', damage(dice, font)
