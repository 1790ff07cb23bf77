"""A batch of pairs: a font half-way of each line "A B OUT.ttf" of a list. What cannot be made is told, and the rest goes on.

    python3 batch.py pairs.txt
"""

import pathlib
import sys

import morphotype


def main(pairs: str) -> int:
    failed = 0
    for line in pathlib.Path(pairs).read_text(encoding="utf-8").splitlines():
        a, b, output = line.split()
        try:
            pathlib.Path(output).write_bytes(morphotype.blend(a, b, at=0.5))
        except morphotype.Error as error:
            print(error, file=sys.stderr)
            failed += 1
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
