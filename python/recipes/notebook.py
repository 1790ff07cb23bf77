"""A picture in a notebook: the last line of a cell shows it.

    Strip("Sans.ttf", "Serif.otf", "type")
"""

import pathlib
import sys
import tempfile

import morphotype


class Strip:
    """A text at several places between two fonts. A notebook asks for its SVG."""

    def __init__(self, a: morphotype.Source, b: morphotype.Source, text: str) -> None:
        self.blend, self.text = morphotype.Blend(a, b), text

    def _repr_svg_(self) -> str:
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "strip.svg"
            self.blend.save_strip(path, self.text, at=[0, 0.25, 0.5, 0.75, 1], size=64)
            return path.read_text(encoding="utf-8")


if __name__ == "__main__":
    print(Strip(*sys.argv[1:])._repr_svg_())
