"""A gate in CI: fails where more glyphs between two fonts need a look than may, and says which and why.

    python3 gate.py A B MOST [CHARACTERS]
"""

import sys
from typing import Optional

import morphotype


def main(a: str, b: str, most: str, chars: Optional[str] = None) -> int:
    flagged = morphotype.report(a, b, chars=chars).flagged
    for glyph in flagged:
        print(f"{glyph.char or glyph.name}: {glyph.severity:.2f}: " + "; ".join(flag.reason for flag in glyph.flags))
    return 1 if len(flagged) > int(most) else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
