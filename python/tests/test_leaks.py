"""A thousand blends, and as many errors, take no more memory than those before them."""

import pathlib
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).parent))

from fontTools.pens.basePen import NullPen

import morphotype
from support import SANS, SERIF

BLENDS, WARM_UP = 1300, 300
GROWTH_MOST = 6 << 20  # bytes: the allocators of C and of Python come to rest slowly; a font that stays is 40 kB, a thousand of them 40 MB


def resident():
    pages = int(pathlib.Path('/proc/self/statm').read_text().split()[1])
    return pages * 4096


class Leaks(unittest.TestCase):
    def test_memory_stays(self):
        a, b = SANS.read_bytes(), SERIF.read_bytes()
        before = 0
        for i in range(BLENDS):
            if i == WARM_UP:
                before = resident()
            made = morphotype.Blend(a, b)
            made.set_chars('l')
            made.font(0.5, progress=lambda done, total: None)
            made.draw('l', NullPen())
            with self.assertRaises(morphotype.Error):
                morphotype.Font(a[:1000])
        growth = resident() - before
        print(f'{BLENDS - WARM_UP} blends: {growth} bytes more')
        self.assertLess(growth, GROWTH_MOST)


if __name__ == '__main__':
    unittest.main()
