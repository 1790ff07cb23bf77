"""The fonts between two fonts.

    import morphotype

    data = morphotype.blend("Sans.ttf", "Serif.otf", at=0.5)              # bytes of a TrueType font
    font = morphotype.blend(TTFont("Sans.ttf"), data, as_ttfont=True)     # a fontTools TTFont

Fonts are paths as the command line takes them (``"Inter.ttf@wght=650"``), the bytes of a file, or a fontTools ``TTFont``. `at` is 0 for the first font and
1 for the second. What cannot be done is an `Error` with a `status`, in the words of the command line, and with a `glyph` where one is
the reason; what is of a wrong type is a TypeError. Nothing is written then.

`blend`, `variable` and `report` are for one call; `Blend` and `Variable` for several, with all settings; `Font` draws a font's own glyphs;
`Outline` and `Morph` are drawings without a font. The library makes threads of its own and lets other Python threads run.
"""

from __future__ import annotations

import io
from typing import TYPE_CHECKING, Literal, Optional, Union, overload

from ._blend import Blend, Progress, Variable
from ._fonts import Font, GlyphId, Source
from ._library import Error, Glyph, Params, Status, version
from ._pens import Morph, Outline, Pen
from ._report import Flag, GlyphReport, Report

if TYPE_CHECKING:
    from fontTools.ttLib import TTFont

__all__ = [
    "Blend",
    "Error",
    "Flag",
    "Font",
    "Glyph",
    "GlyphId",
    "GlyphReport",
    "Morph",
    "Outline",
    "Params",
    "Pen",
    "Progress",
    "Report",
    "Source",
    "Status",
    "Variable",
    "blend",
    "report",
    "variable",
    "version",
]
__version__ = version()


def _to_ttfont(data: bytes) -> TTFont:
    from fontTools.ttLib import TTFont

    return TTFont(io.BytesIO(data))


@overload
def blend(
    a: Source,
    b: Source,
    at: float = ...,
    *,
    chars: Optional[str] = ...,
    hints: Optional[str] = ...,
    family: Optional[str] = ...,
    style: Optional[str] = ...,
    glyphs: str = ...,
    params: Params = ...,
    strict: bool = ...,
    progress: Optional[Progress] = ...,
    as_ttfont: Literal[False] = ...,
) -> bytes: ...


@overload
def blend(
    a: Source,
    b: Source,
    at: float = ...,
    *,
    chars: Optional[str] = ...,
    hints: Optional[str] = ...,
    family: Optional[str] = ...,
    style: Optional[str] = ...,
    glyphs: str = ...,
    params: Params = ...,
    strict: bool = ...,
    progress: Optional[Progress] = ...,
    as_ttfont: Literal[True],
) -> TTFont: ...


def blend(
    a: Source,
    b: Source,
    at: float = 0.5,
    *,
    chars: Optional[str] = None,
    hints: Optional[str] = None,
    family: Optional[str] = None,
    style: Optional[str] = None,
    glyphs: str = "both",
    params: Params = Params(),
    strict: bool = False,
    progress: Optional[Progress] = None,
    as_ttfont: bool = False,
) -> Union[bytes, TTFont]:
    """The TrueType font between two fonts, as bytes or as a `TTFont`: the bytes that ``morphotype blend`` writes.

    `chars` keeps these characters and the forms that shaping makes of them; `hints` is the text of a file of hints; `glyphs` is "both", or
    "first" for all of the first font's. With `strict` a glyph that cannot be blended is an `Error` with that `glyph`; without, the nearer font's own stands in.
    `progress` is called after each glyph with two numbers, done and all; when it returns False the work ends with status STOPPED.
    """
    made = Blend(a, b, params)
    made.set_glyphs(glyphs)
    made.set_chars(chars)
    made.set_family(family)
    made.set_styles(None if style is None else [style])
    if hints is not None:
        made.set_hints(hints)
    data = made.font(at, progress)
    if strict:
        made.check_failures()
    return _to_ttfont(data) if as_ttfont else data


@overload
def variable(
    *fonts: Source,
    chars: Optional[str] = ...,
    hints: Optional[str] = ...,
    family: Optional[str] = ...,
    axis: Optional[tuple[str, float, float]] = ...,
    params: Params = ...,
    strict: bool = ...,
    progress: Optional[Progress] = ...,
    as_ttfont: Literal[False] = ...,
) -> bytes: ...


@overload
def variable(
    *fonts: Source,
    chars: Optional[str] = ...,
    hints: Optional[str] = ...,
    family: Optional[str] = ...,
    axis: Optional[tuple[str, float, float]] = ...,
    params: Params = ...,
    strict: bool = ...,
    progress: Optional[Progress] = ...,
    as_ttfont: Literal[True],
) -> TTFont: ...


def variable(
    *fonts: Source,
    chars: Optional[str] = None,
    hints: Optional[str] = None,
    family: Optional[str] = None,
    axis: Optional[tuple[str, float, float]] = None,
    params: Params = Params(),
    strict: bool = False,
    progress: Optional[Progress] = None,
    as_ttfont: bool = False,
) -> Union[bytes, TTFont]:
    """One variable font from the first of two or more fonts to the last: the bytes that ``morphotype variable`` writes.

    `axis` is another axis than MORF from 0 to 100: ``("wght", 400, 900)``. The rest is as for `blend`.
    """
    made = Variable(*fonts, params=params)
    made.set_chars(chars)
    made.set_family(family)
    if axis is not None:
        made.set_axis(*axis)
    if hints is not None:
        made.set_hints(hints)
    data = made.font(progress)
    if strict:
        made.check_failures()
    return _to_ttfont(data) if as_ttfont else data


def report(
    a: Source,
    b: Source,
    *,
    chars: Optional[str] = None,
    hints: Optional[str] = None,
    params: Params = Params(),
    progress: Optional[Progress] = None,
) -> Report:
    """Which glyphs between two fonts need a look, and why, the worst first: what ``morphotype report`` says."""
    made = Blend(a, b, params)
    made.set_chars(chars)
    if hints is not None:
        made.set_hints(hints)
    return made.report(progress)
