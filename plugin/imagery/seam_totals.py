"""What counts of pieces of seam, and the totals of a layer of them.

One definition for the scan that measures pieces and for the decision that adds them up: whoever has the layer gets the
same metres with a pocket calculator. The scan writes the totals beside its rows, with how these were measured and of
which files, and seals all of it, so that a layer tells whether it is as the scan left it.
"""
from __future__ import annotations

import hashlib
import math
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from enum import Enum
from statistics import NormalDist
from typing import TYPE_CHECKING

from .statistics import NORMAL_95

if TYPE_CHECKING:
    import numpy as np

STANDARD_LEAST_KEPT = 0.7
"""A piece that keeps less fails, unless something else is agreed: docs/method/seam_profile.md."""
MOST_SPREAD = 2.0
"""From the lower to the upper end of the 95 % interval of what is kept: wider ones say nothing by themselves."""
MOST_KEPT = 3.0
"""A seam that was sharpened keeps more than 1; shares of three times that are none."""
PIECE, STRETCH = "piece", "stretch"
"""Words of the field ``level``: pieces add up, a stretch is what several of them keep together."""
TOTALS_DOMAIN = "SEAM_INSPECTOR"
"""Domain of the metadata in which a scan's layer holds its totals, and its picture of losses its settings."""


class PieceState(Enum):
    """What a piece counts as."""

    PASSED = "passed"
    FAILED = "failed"
    NOT_MEASURED = "not_measured"
    """It may have lost detail or not: nothing could be measured, or the interval is too wide to tell."""
    NO_DETAIL = "no_detail"
    """The ground has nothing that could be lost. It is no part of what is judged."""


def possible(value: float | None, most: float) -> float | None:
    """A measured value; None for what no measurement gives, below 0 or above the most."""
    return value if value is not None and 0 <= value <= most else None


def piece_state(
    kept: float | None, low: float | None, high: float | None, least: float, has_verdict: bool = True
) -> PieceState:
    """State of a piece by what it kept, with its 95 % interval; ``least``: with less it fails, with as much it passes.

    A number is measured where its interval lies on one side of the limit, or spans no more than a factor of two. A
    piece that keeps all, as far as can be told, never fails. Without an interval the scan's verdict vouches for it.
    """
    if kept is None:
        return PieceState.NOT_MEASURED
    state = PieceState.FAILED if kept < least else PieceState.PASSED
    if low is None or high is None:
        return state if has_verdict else PieceState.NOT_MEASURED
    if not holds(low, high, least):
        return state
    is_sure = has_verdict and high <= MOST_SPREAD * low and (state is PieceState.PASSED or high < 1)
    return state if is_sure else PieceState.NOT_MEASURED


def holds(low: float, high: float, limit: float) -> bool:
    """Whether an interval does not tell on which side of a limit a value lies."""
    return low < limit <= high


def failing_chance(kept: float | None, low: float | None, high: float | None, least: float) -> float:
    """How likely a piece keeps less than the least, by its interval: 0 or 1 where that lies on one side of it.

    Intervals are those of the logarithm.
    """
    if kept is None or low is None or high is None or not holds(low, high, least) or low <= 0:
        return float(kept is not None and kept < least)
    error = math.log(high / low) / (2 * NORMAL_95)
    return NormalDist().cdf(math.log(least / kept) / error)


@dataclass(frozen=True)
class KeptBeside:
    """What a piece kept on both sides of its seam, at some distance from it."""

    near_m: float
    far_m: float
    kept: float


def profile_text(strips: Iterable[KeptBeside]) -> str:
    """The field ``profile``: the judged strip, then what is kept step by step from the seam."""
    return "; ".join(f"{strip.near_m:.3g} {strip.far_m:.3g} {strip.kept:.3f}" for strip in strips)


def profile_of(text: str) -> tuple[KeptBeside, ...]:
    """The strips of a field ``profile``; none where it is no such text."""
    try:
        return tuple(KeptBeside(*map(float, strip.split())) for strip in text.split(";") if text)
    except (TypeError, ValueError):
        return ()


SYSTEM = "system"
"""Key, among what stands beside rows, of the reference system of their lines, as WKT."""
MOSAIC_FILES, SOURCE_FILES = "mosaic_files", "source_files"
"""Keys, among what stands beside rows, of which files were scanned, as ``file_identity`` writes them."""
METRES, NEIGHBOURS = "metres", "neighbours"
"""Keys, likewise and in what a scan tells, of the length of all its pieces, and of how many sheets it looked into."""
_SEAL, _FAILED = "digest", "failed_metres"
_SEALED = (
    "seam_id", "station", "length", "level", "state", "kept_1", "kept_low", "kept_high", "band_width", "feather_width",
    "visibility", "profile", "verdict", "left_source", "right_source", "left_date", "right_date", "sheet", "sample",
    "lot_size",
)  # fmt: skip
"""All fields that a decision reads, but words for people."""


class RowTotals:
    """Adds up the rows of a layer of seams: fields by name, and vertices, as ``add`` takes them."""

    def __init__(self, rows: Iterable[tuple[Mapping[str, object], np.ndarray]] = ()) -> None:
        self._lines: list[str] = []
        self._metres: list[float] = []
        self._failed: list[float] = []
        for row, line in rows:
            self.add(row, line)

    def add(self, row: Mapping[str, object], line: np.ndarray) -> None:
        """One feature's fields by name, and the vertices of its line, (n, 2), as its layer has them."""
        import numpy as np  # not when QGIS starts, which asks for the limits here

        place = hashlib.sha256((np.asarray(line, "<f8") + 0.0).tobytes()).hexdigest()
        self._lines.append("\t".join((*map(_written, map(row.get, _SEALED)), place)))
        if row.get("level") != STRETCH and isinstance(length := row.get("length"), (int, float)):
            self._metres.append(length)
            if row.get("state") == PieceState.FAILED.value:
                self._failed.append(length)

    @property
    def digest(self) -> str:
        """SHA-256 of what was measured and where, whatever the order of the rows."""
        return hashlib.sha256("\n".join(sorted(self._lines)).encode()).hexdigest()

    def sealed(self, notes: Mapping[str, str]) -> dict[str, str]:
        """What stands beside the rows: notes on how they were made, their totals, and a seal on all of it."""
        metres, failed_metres = (repr(math.fsum(lengths)) for lengths in (self._metres, self._failed))
        noted = {**notes, "rows": str(len(self._lines)), METRES: metres, _FAILED: failed_metres}
        noted.pop(_SEAL, None)
        return {**noted, _SEAL: self._seal(noted)}

    def is_sealed_by(self, notes: Mapping[str, str]) -> bool | None:
        """Whether rows, and what stands beside them, are as they were sealed; None without a seal."""
        others = {name: value for name, value in notes.items() if name != _SEAL}
        return notes[_SEAL] == self._seal(others) if _SEAL in notes else None

    def _seal(self, notes: Mapping[str, str]) -> str:
        lines = (self.digest, *(f"{name}\t{value}" for name, value in sorted(notes.items())))
        return hashlib.sha256("\n".join(lines).encode()).hexdigest()


def _written(value: object) -> str:
    """Text of a value, equal to that of what a file made of it."""
    if value is None or (isinstance(value, float) and not math.isfinite(value)):
        return ""
    return f"{value:.9g}" if isinstance(value, (int, float)) else str(value)
