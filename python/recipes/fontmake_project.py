"""Into a fontmake project: the font at T as a UFO among the sources, named as the project has it. Then: fontmake -u SOURCES/NAME.ufo -o ttf

    python3 fontmake_project.py A B T FAMILY STYLE SOURCES
"""

import pathlib
import sys

import morphotype


def main(a: str, b: str, t: str, family: str, style: str, sources: str) -> None:
    blend = morphotype.Blend(a, b)
    blend.set_family(family)
    blend.set_styles([style])
    folder = pathlib.Path(sources)
    folder.mkdir(exist_ok=True)
    blend.save(folder / f"{family}-{style}.ufo".replace(" ", ""), at=float(t))


if __name__ == "__main__":
    main(*sys.argv[1:])
