"""The C library: its statuses as exceptions, its parameters, and who may use a handle."""

from __future__ import annotations

import contextlib
import dataclasses
import enum
import os
import threading
from typing import Any, Iterator, Optional

from ._native import ffi, lib


class Status(enum.IntEnum):
    """Why a call came to nothing; ``mt_status`` of morphotype.h."""

    OK = 0
    NO_MEMORY = 1
    NO_FILE = 2
    NOT_A_FONT = 3
    NO_FACE = 4
    NO_AXIS = 5
    BAD_AXIS = 6
    NO_OUTLINES = 7
    NO_CHARMAP = 8
    NO_GLYPH = 9
    BAD_GLYPH = 10
    NO_COUNTERPART = 11
    TOO_LARGE = 12
    BAD_GEOMETRY = 13
    NOTHING_SHARED = 14
    BAD_PARAMETER = 15
    CANNOT_WRITE = 16
    UNKNOWN_FORMAT = 17
    BAD_HINTS = 18
    ENDLESS_LOOKUPS = 19
    NO_FEATURE = 20
    BAD_FEATURE = 21
    BLANK = 22
    BAD_DRAWING = 23
    TOO_COSTLY = 24
    BAD_MESH = 25
    NOT_SOLID = 26
    STOPPED = 27

    @property
    def text(self) -> str:
        """A line of English, as the command line prints it."""
        return text_of(lib.mt_status_text(int(self)))


@dataclasses.dataclass(frozen=True)
class Glyph:
    """A glyph that something is said of."""

    number: int  #: in the first font
    name: Optional[str]  #: there; None where it has none
    char: Optional[str]  #: the character that leads to it, or that it is a form of
    status: Status  #: what is said


class Error(Exception):
    """A call of the library that came to nothing; nothing was written."""

    def __init__(self, message: str, status: Status, glyph: Optional[Glyph] = None) -> None:
        super().__init__(message)
        self.status = status  #: why
        self.glyph = glyph  #: the glyph that is the reason, where one is


@dataclasses.dataclass(frozen=True)
class Params:
    """How glyphs are blended. What is None is the library's default; docs/guide.md has the ranges."""

    method: str = "joint"  #: "joint", or "paper" for the paper's own mapping throughout
    tolerance: Optional[float] = None  #: error bound of flattening, 1/1000 em
    fit: Optional[float] = None  #: error bound of curve fitting, 1/1000 em
    effort: Optional[float] = None  #: work and memory a glyph may take; 1 is about two seconds and 200 MB
    slant: Optional[float] = None  #: degrees by which the second font leans more to the right; None: measured
    threads: Optional[int] = None  #: 0: as many as there are cores

    def to_c(self) -> Any:
        if self.method not in ("joint", "paper"):
            raise ValueError(f'method: "joint" or "paper", not {self.method!r}')
        params = ffi.new("mt_params *", lib.mt_params_default())
        params.method = lib.MT_METHOD_PAPER if self.method == "paper" else lib.MT_METHOD_JOINT
        for name in ("tolerance", "fit", "effort", "threads"):
            if getattr(self, name) is not None:
                setattr(params, name, getattr(self, name))
        if self.slant is not None:
            params.slant = lib.MT_SLANT_GIVEN
            params.lean = self.slant
        return params


def text_of(pointer: Any) -> str:
    """A C string; "" for NULL."""
    return "" if pointer == ffi.NULL else str(ffi.string(pointer), "utf-8", "replace")


def check(status: int, what: str) -> None:
    """Raises what the status says of a file or a font, in the words of the command line."""
    if status == lib.MT_OK:
        return
    message = f"{what}: {Status(status).text}"
    if status in (lib.MT_NO_FILE, lib.MT_CANNOT_WRITE) and ffi.errno:
        message += f": {os.strerror(ffi.errno)}"
    raise Error(message, Status(status))


def take_bytes(pointer: Any, length: Any) -> bytes:
    """A copy of the library's bytes, which are given back."""
    try:
        return bytes(ffi.buffer(pointer[0], length[0]))
    finally:
        lib.mt_bytes_free(pointer[0])


class Turn:
    """Lets one thread at a time use a handle. A second one gets an exception rather than wrong results."""

    def __init__(self) -> None:
        self._lock = threading.Lock()

    def take(self) -> None:
        if not self._lock.acquire(blocking=False):
            raise RuntimeError("in use: a font serves one call at a time; open it once more for another thread")

    def give(self) -> None:
        self._lock.release()


@contextlib.contextmanager
def in_turn(turns: list[Turn]) -> Iterator[None]:
    """Takes all of them, each once, for as long as the block lasts."""
    taken: list[Turn] = []
    try:
        for turn in {id(turn): turn for turn in turns}.values():
            turn.take()
            taken.append(turn)
        ffi.errno = 0
        yield
    finally:
        for turn in taken:
            turn.give()


def version() -> str:
    """The version of the C library that runs."""
    return text_of(lib.mt_version())
