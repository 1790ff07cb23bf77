"""The report as data: docs/guide.md ("report") says what is measured."""

from __future__ import annotations

import dataclasses
import json
from typing import Any, Optional


@dataclasses.dataclass(frozen=True)
class Flag:
    """Why a glyph needs a look."""

    name: str  #: "failed", "components", "holes", "strays", "clots" or "ink"
    reason: str  #: a line of English


@dataclasses.dataclass(frozen=True)
class GlyphReport:
    """One glyph between two fonts."""

    char: Optional[str]  #: the character that leads to it; None: no character does
    name: Optional[str]  #: with a slash, of a glyph without a character
    severity: float  #: what an eye minds; flagged from 1 on
    flags: tuple[Flag, ...]
    figures: dict[str, Any]  #: all that was measured, as the JSON has it; areas are in em², the rest in 1/1000 em

    @property
    def failed(self) -> bool:
        """Whether it cannot be blended."""
        return any(flag.name == "failed" for flag in self.flags)


@dataclasses.dataclass(frozen=True)
class Report:
    """Every glyph of a blend, the worst first."""

    glyphs: tuple[GlyphReport, ...]
    unblended: tuple[str, ...]  #: glyphs that the second font has not: characters, or names with a slash
    summary: dict[str, Any]

    @property
    def flagged(self) -> tuple[GlyphReport, ...]:
        """The glyphs that need a look."""
        return tuple(glyph for glyph in self.glyphs if glyph.flags)

    @classmethod
    def from_json(cls, text: bytes) -> Report:
        data = json.loads(text)
        return cls(
            tuple(_glyph(glyph) for glyph in data["glyphs"]),
            tuple(glyph.get("character") or glyph["glyph"] for glyph in data["unblended"]),
            data["summary"],
        )


def _glyph(data: dict[str, Any]) -> GlyphReport:
    told = ("character", "code_point", "glyph", "severity", "flags")
    return GlyphReport(
        data.get("character"),
        data.get("glyph"),
        data["severity"],
        tuple(Flag(flag["flag"], flag["reason"]) for flag in data["flags"]),
        {key: value for key, value in data.items() if key not in told},
    )
