"""Blends of two fonts and variable fonts of two or more: what both have in common, and each by itself."""

from __future__ import annotations

import functools
import logging
import os
from typing import Any, Callable, Iterable, Mapping, Optional, Sequence, Union

from ._fonts import Font, GlyphId, Source, open_font
from ._library import Error, Glyph, Params, Status, check, in_turn, take_bytes, text_of
from ._native import ffi, lib
from ._pens import DRAW, Drawing, Pen
from ._report import Report

#: Called after each glyph: how many are made of how many. False ends the work with status STOPPED; what it raises ends it too.
Progress = Callable[[int, int], Optional[bool]]
Path = Union[str, "os.PathLike[str]"]

log = logging.getLogger("morphotype")


class Listener:
    """What the library tells of its work, on whatever thread of its own."""

    def __init__(self, stop: Callable[[], None]) -> None:
        self.stop = stop
        self.progress: Optional[Progress] = None
        self.failures: list[Glyph] = []
        self.unblended: list[Glyph] = []
        self.error: Optional[BaseException] = None
        self.handle = ffi.new_handle(self)

    def begin(self, progress: Optional[Progress]) -> None:
        self.progress, self.error = progress, None
        self.failures, self.unblended = [], []

    def tell(self, done: int, total: int) -> None:
        if self.error is not None or self.progress is None:
            return
        if self.progress(done, total) is False:
            self.stop()


@ffi.def_extern()  # type: ignore[misc]
def python_progress(done: int, total: int, user: Any) -> None:
    # A signal such as Ctrl-C is raised here, even where nobody listens.
    listener = ffi.from_handle(user)
    try:
        listener.tell(done, total)
    except BaseException as error:  # raised again when the library has come back
        listener.error = error
        listener.stop()


def _glyph_of(note: Any) -> Glyph:
    name = None if note.name == ffi.NULL else text_of(note.name)
    return Glyph(note.glyph, name, chr(note.code_point) if note.code_point else None, Status(note.why))


@ffi.def_extern()  # type: ignore[misc]
def python_glyph_failed(note: Any, user: Any) -> None:
    ffi.from_handle(user).failures.append(_glyph_of(note))


@ffi.def_extern()  # type: ignore[misc]
def python_unblended(note: Any, user: Any) -> None:
    ffi.from_handle(user).unblended.append(_glyph_of(note))


@ffi.def_extern()  # type: ignore[misc]
def python_warning(line: Any, user: Any) -> None:
    log.warning("%s", text_of(line))


def _free(free: Callable[[Any], None], fonts: list[Font], row: Any) -> None:
    """Frees a row; `fonts` are those that it uses, which thereby last as long."""
    free(row)


class _Row:
    """What a blend and a variable font have in common; `_kind` is the start of the C functions' names."""

    _kind = ""

    def __init__(self, fonts: Sequence[Source], params: Params) -> None:
        if not isinstance(params, Params):
            raise TypeError(f"params: morphotype.Params, not {type(params).__name__}")
        self._fonts = [open_font(source) for source in fonts]
        self._what = " and ".join(font._name for font in self._fonts)
        self._listener = Listener(self.stop)
        self._row = self._open(params.to_c())
        for event, call in (("progress", "progress"), ("glyph_failure", "glyph_failed"), ("unblended", "unblended")):
            self._function(f"on_{event}")(self._row, getattr(lib, f"python_{call}"), self._listener.handle)

    def _open(self, params: Any) -> Any:
        raise NotImplementedError

    def _function(self, name: str) -> Any:
        return getattr(lib, f"{self._kind}_{name}")

    def _keep(self, pointer: Any) -> Any:
        """Gives the handle back before its fonts are closed, whatever goes first here."""
        fonts, free = list(self._fonts), self._function("free")
        return ffi.gc(pointer, functools.partial(_free, free, fonts))

    def _work(self, call: Callable[[], int], progress: Optional[Progress] = None, what: str = "") -> None:
        """Calls the library, and raises what it says, or what the progress raised."""
        if progress is not None and not callable(progress):
            raise TypeError("progress: a function of two numbers")
        with in_turn([font._turn for font in self._fonts]):
            self._listener.begin(progress)
            status = call()
            error = self._listener.error
            if error is not None:
                self.resume()
                raise error
        of_output = status in (lib.MT_CANNOT_WRITE, lib.MT_UNKNOWN_FORMAT, lib.MT_TOO_LARGE)
        check(status, what if what and of_output else self._what)

    # What is said of the last work.

    @property
    def failures(self) -> list[Glyph]:
        """Glyphs of the last fonts that could not be blended: the nearer font's own stand in."""
        return list(self._listener.failures)

    @property
    def unblended(self) -> list[Glyph]:
        """Glyphs of the last fonts that are the first font's own, because another font has none for them."""
        return list(self._listener.unblended)

    def check_failures(self) -> None:
        """Raises `Error` for the first glyph that could not be blended, if there is one."""
        for glyph in self.failures:
            name = glyph.char or f"/{glyph.name or glyph.number}"
            raise Error(f"{self._what}: {name}: {glyph.status.text}", glyph.status, glyph)

    # Settings, of the fonts that follow.

    def set_chars(self, chars: Optional[str]) -> None:
        """Only these characters and the forms that shaping makes of them; None: all."""
        code_points = [ord(char) for char in chars or ""]
        check(self._function("set_chars")(self._row, code_points, len(code_points)), "chars")

    def set_family(self, name: Optional[str]) -> None:
        """The family's name; None: made of the sources'."""
        check(self._function("set_family")(self._row, ffi.NULL if name is None else name.encode()), "family")

    def set_hints(self, hints: Optional[str]) -> None:
        """Decisions for single glyphs, in the format of a file of hints (docs/guide.md); None: none. `Error` with status BAD_HINTS names the line."""
        error = ffi.new("mt_hint_error *")
        if hints is None:
            check(self._function("set_hints")(self._row, ffi.NULL, error), "hints")
            return
        table, text = ffi.new("mt_hint_table **"), hints.encode()
        status = lib.mt_hint_table_read(text, len(text), table, error)
        if status == lib.MT_OK:
            kept = ffi.gc(table[0], lib.mt_hint_table_free)
            with in_turn([font._turn for font in self._fonts]):
                status = self._function("set_hints")(self._row, kept, error)
        if status == lib.MT_BAD_HINTS:
            raise Error(f"hints:{error.line}: {text_of(error.reason)}", Status(status))
        check(status, "hints")

    def set_glyphs(self, which: str) -> None:
        """"both": glyphs that all fonts have; "first": all of the first font's, unblended where another has none."""
        if which not in ("both", "first"):
            raise ValueError(f'glyphs: "both" or "first", not {which!r}')
        first = which == "first"
        self._function("set_glyphs")(self._row, lib.MT_GLYPHS_FIRST if first else lib.MT_GLYPHS_BOTH)

    def warn(self) -> None:
        """Logs what to know before a font goes out, such as what a licence restricts, as warnings of the logger "morphotype"."""
        with in_turn([font._turn for font in self._fonts]):
            status = self._function("warnings")(self._row, lib.python_warning, ffi.NULL)
        check(status, self._what)

    def stop(self) -> None:
        """Ends what is under way, from any thread, with an `Error` of status STOPPED; nothing is written. So does all that is asked later,
        until `resume`."""
        self._function("stop")(self._row, True)

    def resume(self) -> None:
        """Lets it work again, once nothing is under way."""
        self._function("stop")(self._row, False)


class Blend(_Row):
    """Fonts at single places between two fonts. It serves one call at a time."""

    _kind = "mt_blend"

    def __init__(self, a: Source, b: Source, params: Params = Params()) -> None:
        super().__init__((a, b), params)

    def _open(self, params: Any) -> Any:
        made = ffi.new("mt_blend **")
        a, b = self._fonts
        check(lib.mt_blend_new(a._font, b._font, params, made), self._what)
        return self._keep(made[0])

    def set_styles(self, names: Optional[Sequence[str]]) -> None:
        """The styles' names of the fonts at several places, in their order; None: made of the places."""
        kept = [ffi.new("char[]", name.encode()) for name in names or ()]
        check(lib.mt_blend_set_styles(self._row, kept, len(kept)), "styles")

    def set_heights(self, at: Optional[Sequence[float]]) -> None:
        """Where the fonts at several places are upwards (y, heights), in their order; None: as across."""
        places = list(at or ())
        check(lib.mt_blend_set_heights(self._row, places, len(places)), "heights")

    def set_places(self, places: Optional[Mapping[GlyphId, float]]) -> None:
        """Characters, or names or numbers of glyphs, with places of their own; None: all are where the font is."""
        kept = dict(places or {})
        numbers = [self._fonts[0].glyph_number(glyph) for glyph in kept]
        check(lib.mt_blend_set_places(self._row, numbers, list(kept.values()), ffi.NULL, len(kept)), "places")

    def font(self, at: float = 0.5, progress: Optional[Progress] = None) -> bytes:
        """The TrueType font at `at`: 0 is the first font, 1 the second."""
        return self.fonts([at], progress)[0]

    def fonts(self, at: Iterable[float], progress: Optional[Progress] = None) -> list[bytes]:
        """Fonts at several places, for little more than the price of one."""
        places = ffi.new("double[]", list(at))
        count = len(places)
        made, lengths = ffi.new("uint8_t *[]", count), ffi.new("size_t[]", count)
        self._work(lambda: int(lib.mt_blend_fonts(self._row, places, count, made, lengths)), progress)
        return [take_bytes(made + i, lengths + i) for i in range(count)]

    def save(self, path: Path, at: float = 0.5, progress: Optional[Progress] = None) -> None:
        """Writes the font in the format of the extension: .ttf, .woff2, or .ufo, which is a directory."""
        name = os.fspath(path)
        places, encoded = ffi.new("double[]", [at]), ffi.new("char[]", os.fsencode(name))
        paths = ffi.new("char *[]", [encoded])
        self._work(lambda: int(lib.mt_blend_save_fonts(self._row, places, 1, paths)), progress, name)

    @property
    def units_per_em(self) -> int:
        return int(lib.mt_blend_units_per_em(self._row))

    def draw(self, glyph: GlyphId, pen: Pen, at: float = 0.5) -> float:
        """Draws a glyph between both fonts, in units of `units_per_em`, and returns its advance. Lines and quadratic curves.
        `glyph` is a character, the name of one of the first font's glyphs with a slash before it, or its number. `Error`: NO_GLYPH where a font lacks it, and
        why it cannot be blended."""
        drawing, advance = Drawing(pen), ffi.new("double *")
        is_char = isinstance(glyph, str) and len(glyph) == 1
        number = ord(glyph) if is_char else self._fonts[0].glyph_number(glyph)  # type: ignore[arg-type]
        call = lib.mt_blend_glyph if is_char else lib.mt_blend_glyph_numbered
        try:
            self._work(lambda: int(call(self._row, number, at, DRAW, drawing.handle, advance)))
        except Error as error:
            name = None if is_char else str(glyph).lstrip("/")
            about = Glyph(-1 if is_char else number, name, str(glyph) if is_char else None, error.status)
            raise Error(f"{self._what}: {glyph}: {error.status.text}", error.status, about) from None
        drawing.finish()
        return float(advance[0])

    def report(self, progress: Optional[Progress] = None) -> Report:
        """Every glyph measured, the worst first."""
        return Report.from_json(self._report(progress, lib.MT_REPORT_JSON))

    def report_page(self, progress: Optional[Progress] = None) -> bytes:
        """The same as a page of HTML, with strips."""
        return self._report(progress, lib.MT_REPORT_HTML)

    def _report(self, progress: Optional[Progress], form: int) -> bytes:
        report, made, length = ffi.new("mt_report **"), ffi.new("uint8_t **"), ffi.new("size_t *")

        def measure() -> int:
            status = int(lib.mt_report_new(self._row, report))
            if status == lib.MT_OK:
                status = int(lib.mt_report_bytes(report[0], form, made, length))
            lib.mt_report_free(report[0])
            return status

        self._work(measure, progress)
        return take_bytes(made, length)

    def save_strip(
        self,
        path: Path,
        text: str,
        at: Sequence[float] = (0, 0.25, 0.5, 0.75, 1),
        size: float = 96,
        labels: bool = True,
    ) -> None:
        """Draws a text at several places, in the format of the extension: .png, .svg or .pdf. `size` is pixels or points an em. Sets the
        characters to the text's."""
        name, places = os.fspath(path), ffi.new("double[]", list(at))
        choices = ffi.new("mt_choice[]", [{"code_point": ord(char)} for char in text])
        wanted = {"text": choices, "length": len(text), "at": places, "step_count": len(places), "size": size}
        strip = ffi.new("mt_strip *", {**wanted, "labels": labels})
        self._work(lambda: int(lib.mt_strip_save(self._row, strip, os.fsencode(name))), None, name)


class Variable(_Row):
    """One font that varies from the first of two or more fonts to the last. It serves one call at a time."""

    _kind = "mt_variable"

    def __init__(self, *fonts: Source, params: Params = Params()) -> None:
        super().__init__(fonts, params)

    def _open(self, params: Any) -> Any:
        made, pointers = ffi.new("mt_variable **"), [font._font for font in self._fonts]
        check(lib.mt_variable_new(pointers, len(pointers), params, made), self._what or "variable")
        return self._keep(made[0])

    def set_style(self, name: Optional[str]) -> None:
        """Of the font as it stands without a setting; None: that of the first place."""
        check(lib.mt_variable_set_style(self._row, ffi.NULL if name is None else name.encode()), "style")

    def set_axis(self, tag: str, start: float, end: float) -> None:
        """Another axis than MORF from 0 to 100: its tag, and what users set for the first font and for the last."""
        check(lib.mt_variable_set_axis(self._row, tag.encode(), start, end), f"axis {tag}")

    def font(self, progress: Optional[Progress] = None) -> bytes:
        """The variable TrueType font."""
        made, length = ffi.new("uint8_t **"), ffi.new("size_t *")
        self._work(lambda: int(lib.mt_variable_font(self._row, made, length)), progress)
        return take_bytes(made, length)

    def save(self, path: Path, progress: Optional[Progress] = None) -> None:
        """Writes it in the format of the extension: .ttf, .woff2 or .designspace, with its masters as UFOs beside it."""
        name = os.fspath(path)
        self._work(lambda: int(lib.mt_variable_save(self._row, os.fsencode(name))), progress, name)

    def save_specimen(self, path: Path, text: Optional[str] = None, progress: Optional[Progress] = None) -> None:
        """Writes a page of HTML to try the font on, which has it in it."""
        name = os.fspath(path)
        kept = ffi.NULL if text is None else ffi.new("char[]", text.encode())
        request = ffi.new("mt_specimen_request *", {"variable": self._row, "text": kept})
        self._work(lambda: int(lib.mt_specimen_save(request, os.fsencode(name))), progress, name)
