"""Fonts as the module takes them: paths, bytes, TTFont."""

from __future__ import annotations

import io
import os
from typing import TYPE_CHECKING, Any, Union

from ._library import Turn, check, in_turn, text_of
from ._native import ffi, lib
from ._pens import DRAW, Drawing, Pen

if TYPE_CHECKING:
    from fontTools.ttLib import TTFont

Source = Union[str, "os.PathLike[str]", bytes, bytearray, memoryview, "TTFont", "Font"]
#: A character, a glyph's name with a slash before it, or a glyph's number.
GlyphId = Union[str, int]


def _is_ttfont(source: object) -> bool:
    return hasattr(source, "save") and hasattr(source, "getGlyphOrder")


def _bytes_of(font: Any) -> bytes:
    with io.BytesIO() as file:
        font.save(file, reorderTables=None)
        return file.getvalue()


class Font:
    """A font that is open: from a path, as the command line takes it (``FILE[#FACE][@AXIS=VALUE,…][:FEATURE,…]``), from the bytes
    of a file or from a `TTFont`; bytes are copied, and so is the font that a TTFont is at this time.

    `choice` is what a path has after the file's name: ``"#1@wght=650"``.
    Raises `Error` for a file that is no font, TypeError for what is none of these.
    """

    def __init__(self, source: Source, choice: str = "") -> None:
        made = ffi.new("mt_font **")
        if not isinstance(choice, str):
            raise TypeError(f"choice: a str, not {type(choice).__name__}")
        if isinstance(source, (str, os.PathLike)):
            self._name = os.fspath(source) + choice
            ffi.errno = 0
            status = lib.mt_font_open(os.fsencode(self._name), made)
        elif isinstance(source, (bytes, bytearray, memoryview)) or _is_ttfont(source):
            is_bytes = isinstance(source, (bytes, bytearray, memoryview))
            name = "the font in memory" if is_bytes else "the TTFont"
            content = bytes(source) if is_bytes else _bytes_of(source)  # type: ignore[arg-type]
            self._name = name + choice
            status = lib.mt_font_open_memory(content, len(content), name.encode(), choice.encode(), made)
        else:
            raise TypeError(f"a font is a path, bytes or a TTFont, not {type(source).__name__}")
        check(status, self._name)
        self._font = ffi.gc(made[0], lib.mt_font_close)
        self._turn = Turn()

    @property
    def family(self) -> str:
        return text_of(lib.mt_font_family(self._font))

    @property
    def style(self) -> str:
        return text_of(lib.mt_font_style(self._font))

    @property
    def units_per_em(self) -> int:
        return int(lib.mt_font_units_per_em(self._font))

    def chars(self) -> str:
        """The characters that it maps, by code point."""
        found, code_point = [], ffi.new("uint32_t *")
        with in_turn([self._turn]):
            while lib.mt_font_next_char(self._font, code_point[0], code_point):
                found.append(chr(code_point[0]))
                code_point[0] += 1
        return "".join(found)

    def glyph_number(self, glyph: GlyphId) -> int:
        """The number of a character's glyph, or of one by its name: ``"g"``, ``"/f_i"``. Raises `Error` with status NO_GLYPH."""
        if isinstance(glyph, int):
            return glyph
        with in_turn([self._turn]):
            return self._find(glyph)

    def _find(self, glyph: str) -> int:
        number = ffi.new("uint32_t *")
        if glyph.startswith("/") and len(glyph) > 1:
            status = lib.mt_font_glyph_of_name(self._font, glyph[1:].encode(), number)
            check(status, f"{self._name}: {glyph}")
        else:
            number[0] = lib.mt_font_glyph(self._font, ord(glyph))
            if number[0] == 0:
                check(lib.MT_NO_GLYPH, f"{self._name}: {glyph}")
        return int(number[0])

    def draw(self, glyph: GlyphId, pen: Pen) -> float:
        """Draws a glyph as the font has it, in font units, and returns its advance. `Error`: NO_GLYPH, BAD_GLYPH."""
        drawing, advance = Drawing(pen), ffi.new("double *")
        number = self.glyph_number(glyph)
        with in_turn([self._turn]):
            check(lib.mt_font_draw(self._font, number, DRAW, drawing.handle, advance), f"{self._name}: {glyph}")
        drawing.finish()
        return float(advance[0])


def open_font(source: Source) -> Font:
    """The font itself where it is open already."""
    return source if isinstance(source, Font) else Font(source)
