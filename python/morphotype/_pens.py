"""Outlines on their way between the library and pens (fontTools' segment pens)."""

from __future__ import annotations

from typing import Any, Optional, Protocol

from ._library import Params, check
from ._native import ffi, lib

Point = tuple[float, float]


class Pen(Protocol):
    """What an outline is drawn with: fontTools' pen protocol. Contours are closed."""

    def moveTo(self, pt: Point) -> None: ...

    def lineTo(self, pt: Point) -> None: ...

    def qCurveTo(self, *points: Point) -> None: ...

    def curveTo(self, *points: Point) -> None: ...

    def closePath(self) -> None: ...


class Drawing:
    """A drawing on its way to a pen: the line that closes a contour goes without saying, as pens have it. What the pen raises is kept
    for `finish`, as no exception passes through C."""

    def __init__(self, pen: Pen) -> None:
        self.pen = pen
        self.error: Optional[BaseException] = None
        self.start: Point = (0, 0)
        self.line: Optional[Point] = None
        self.handle = ffi.new_handle(self)

    def call(self, name: str, *points: Point) -> None:
        if self.error is not None:
            return
        try:
            line, self.line = self.line, None
            if line is not None and not (name == "closePath" and line == self.start):
                self.pen.lineTo(line)
            if name == "moveTo":
                self.start = points[0]
            if name == "lineTo":
                self.line = points[0]
            else:
                getattr(self.pen, name)(*points)
        except BaseException as error:  # raised again by finish
            self.error = error

    def finish(self) -> None:
        if self.error is not None:
            raise self.error


@ffi.def_extern()  # type: ignore[misc]
def python_move_to(x: float, y: float, user: Any) -> None:
    ffi.from_handle(user).call("moveTo", (x, y))


@ffi.def_extern()  # type: ignore[misc]
def python_line_to(x: float, y: float, user: Any) -> None:
    ffi.from_handle(user).call("lineTo", (x, y))


@ffi.def_extern()  # type: ignore[misc]
def python_quadratic_to(cx: float, cy: float, x: float, y: float, user: Any) -> None:
    ffi.from_handle(user).call("qCurveTo", (cx, cy), (x, y))


@ffi.def_extern()  # type: ignore[misc]
def python_cubic_to(bx: float, by: float, cx: float, cy: float, x: float, y: float, user: Any) -> None:
    ffi.from_handle(user).call("curveTo", (bx, by), (cx, cy), (x, y))


@ffi.def_extern()  # type: ignore[misc]
def python_close(user: Any) -> None:
    ffi.from_handle(user).call("closePath")


DRAW = ffi.new(
    "mt_draw *",
    {
        "move_to": lib.python_move_to,
        "line_to": lib.python_line_to,
        "quadratic_to": lib.python_quadratic_to,
        "close": lib.python_close,
        "cubic_to": lib.python_cubic_to,
    },
)


class Outline:
    """A drawing without a font, and a pen that draws it: give it to ``glyph.draw``. Contours are closed and filled where they go around a
    place (nonzero).

    `em` is about the drawing's height in its own units: tolerances are thousandths of it.
    """

    def __init__(self, em: float = 1000) -> None:
        made = ffi.new("mt_path **")
        check(lib.mt_path_new(em, made), "em")
        self._path = ffi.gc(made[0], lib.mt_path_free)
        self._at: Point = (0, 0)

    def _add(self, status: int, pt: Point) -> None:
        check(status, "outline")
        self._at = pt

    def moveTo(self, pt: Point) -> None:
        self._add(lib.mt_path_move_to(self._path, *pt), pt)

    def lineTo(self, pt: Point) -> None:
        self._add(lib.mt_path_line_to(self._path, *pt), pt)

    def curveTo(self, *points: Point) -> None:
        """A cubic curve; of more than three points, a spline as fontTools has it."""
        from fontTools.pens.basePen import decomposeSuperBezierSegment

        if len(points) < 3:
            raise TypeError("curveTo takes three points or more")
        for b, c, end in decomposeSuperBezierSegment(points):
            self._add(lib.mt_path_cubic_to(self._path, *b, *c, *end), end)

    def qCurveTo(self, *points: Optional[Point]) -> None:
        """Quadratic curves, with points on the curve between two that are off it; without one on it where the last is None."""
        from fontTools.pens.basePen import decomposeQuadraticSegment

        *off, end = points
        if end is None:
            first = _middle(off[-1], off[0])
            self.moveTo(first)
            points = (*off, first)
        if len(points) == 1:
            self.lineTo(points[0])  # type: ignore[arg-type]
            return
        for control, to in decomposeQuadraticSegment(points):
            self._add(lib.mt_path_quadratic_to(self._path, *control, *to), to)

    def closePath(self) -> None:
        """Nothing is left to do: every contour is closed."""

    def endPath(self) -> None:
        """As closePath: an outline has no open contours."""

    def addComponent(self, glyphName: str, transformation: Any) -> None:
        raise TypeError(f"{glyphName}: an outline has no components; draw with fontTools' DecomposingPen")


def _middle(a: Any, b: Any) -> Point:
    return (a[0] + b[0]) / 2, (a[1] + b[1]) / 2


class Morph:
    """What moves between two outlines.

    Raises `Error` with status BLANK when one has no ink.
    """

    def __init__(self, a: Outline, b: Outline, params: Params = Params()) -> None:
        if not isinstance(a, Outline) or not isinstance(b, Outline):
            raise TypeError("a morph is between two morphotype.Outline")
        made = ffi.new("mt_moving **")
        check(lib.mt_moving_new(a._path, b._path, params.to_c(), made), "outlines")
        self._moving = ffi.gc(made[0], lib.mt_moving_free)

    def draw(self, at: float, pen: Pen) -> None:
        """Draws the contours at `at`, 0 … 1, in units of the first outline: the same contours and segments at every place."""
        drawing = Drawing(pen)
        check(lib.mt_moving_draw(self._moving, at, DRAW, drawing.handle), "at")
        drawing.finish()
