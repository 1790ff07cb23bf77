"""A designspace: compatible masters of two fonts as UFOs, with an axis of weight, for an editor or fontmake.

    python3 designspace.py A B FROM TO OUT.designspace
"""

import sys

import morphotype


def main(a: str, b: str, start: str, end: str, output: str) -> None:
    variable = morphotype.Variable(a, b)
    variable.set_axis("wght", float(start), float(end))
    variable.save(output, progress=lambda done, total: print(f"\r{done} of {total}", end="", file=sys.stderr))
    print(file=sys.stderr)


if __name__ == "__main__":
    main(*sys.argv[1:])
