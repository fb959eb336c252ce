"""What goes back to the producer: each failure without a break, with all that is known of it."""
from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from .decision import DecidedPiece, Decision, FailureRun
from .delivery import SeenWindow


@dataclass(frozen=True, eq=False)
class Defect:
    """A failure without a break."""

    number: int
    """1 for the longest."""
    sheets: tuple[str, ...]
    length_m: float
    lines: tuple[np.ndarray, ...]
    """(n, 2) x and y of what it takes of each piece, in the delivery's reference system."""
    place: tuple[float, float]
    """A point half-way along it."""
    worst: DecidedPiece
    """The piece that kept least."""
    band_width_m: float | None
    """Of its widest band; None where none is known."""
    cause: str
    """Of the inspected window that lies nearest to the worst piece, else of another one on it; empty without any."""
    remarks: tuple[str, ...]
    """What operators wrote of the windows on it."""


def defects_of(decision: Decision) -> tuple[Defect, ...]:
    """The longest first."""
    return tuple(_defect(decision, run) for run in decision.runs)


def _defect(decision: Decision, run: FailureRun) -> Defect:
    pieces = [decision.pieces[number] for number in run.pieces]
    worst = min(pieces, key=_kept)
    widths = [one.piece.band_width_m for one in pieces if one.piece.band_width_m is not None]
    windows = _windows([worst, *pieces])
    lines = [part.line(decision.pieces[part.piece].piece) for part in run.parts]
    return Defect(
        run.number, run.sheets, run.length_m, tuple(lines), run.place, worst,
        max(widths, default=None), next((one.cause for one in windows if one.cause), ""),
        tuple(dict.fromkeys(words for one in windows for words in (one.remark, one.remark_2) if words)),
    )  # fmt: skip


def _kept(one: DecidedPiece) -> float:
    return float("inf") if one.piece.kept_1 is None else one.piece.kept_1


def _windows(pieces: list[DecidedPiece]) -> list[SeenWindow]:
    """Those that lie on any of the pieces, each once, those of the first piece in front."""
    return list({one.window_id: one for piece in pieces for one in piece.windows}.values())
