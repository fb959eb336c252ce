"""The verdict on pieces of seam where no orthoimage is given: only where the interval allows one.

A piece is judged by itself. Where its interval is too wide for that, the run of pieces of the same seam that it belongs
to may still tell, and the verdict says so.
"""
from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from .....imagery.errors import Message
from ...limits import MAX_SIGNIFICANT_KEPT
from ...verdicts import Verdict
from .. import messages
from .lone_kept import LoneKept, LoneSeams

RUNS_LENGTHS = (1.0, 2.0, 4.0)
"""Runs are tried that are so many times as long as what can be judged on this mosaic."""


@dataclass(frozen=True)
class LoneJudgement:
    """What is said of one piece."""

    kept: LoneKept | None
    """Of the piece itself; None where there is too little to be measured."""
    verdict: Verdict
    reason: Message | None
    """Why there is none, or that it is that of a longer run."""


def judge_pieces(seams: LoneSeams, lengths_px: Sequence[float], pixel_m: float) -> list[LoneJudgement]:
    """Every piece, in their order. ``pixel_m``: side of a pixel on the ground."""
    own = seams.by_piece(len(lengths_px))
    told: dict[int, tuple[Verdict, Message]] = {}
    least = seams.judgeable_px
    for length in [] if least is None else [factor * least for factor in RUNS_LENGTHS]:
        wanted = {n for n, kept in enumerate(own) if n not in told and kept is not None and verdict_of(kept) is None}
        for run in runs_of(seams.seam_ids, lengths_px, length) if wanted else ():
            if len(run) < 2 or wanted.isdisjoint(run):
                continue
            kept = seams.kept(run)
            verdict = None if kept is None else verdict_of(kept)
            if kept is not None and verdict is not None:
                reason = messages.JUDGED_WITH_RUN(
                    length=kept.length_px * pixel_m, low=100 * kept.low, high=100 * kept.high
                )
                told.update((number, (verdict, reason)) for number in run if number in wanted)
    return [_judged(kept, told.get(number), least, pixel_m) for number, kept in enumerate(own)]


def verdict_of(kept: LoneKept) -> Verdict | None:
    """None where the interval is too wide for one."""
    if kept.tells_loss:
        return Verdict.SIGNIFICANT if kept.kept <= MAX_SIGNIFICANT_KEPT else Verdict.REDUCED
    return Verdict.PRESERVED if kept.tells_sound else None


def runs_of(seam_ids: Sequence[int], lengths_px: Sequence[float], least_px: float) -> list[list[int]]:
    """Consecutive pieces of each seam, by number, in runs of nearly equal length of at least ``least_px`` or all."""
    ids, lengths = np.asarray(seam_ids), np.asarray(lengths_px, dtype=float)
    if not len(ids):
        return []
    runs: list[list[int]] = []
    starts = np.flatnonzero(np.diff(ids, prepend=ids[0] - 1))
    for start, stop in zip(starts.tolist(), [*starts[1:].tolist(), len(ids)]):
        along = np.cumsum(lengths[start:stop])
        count = max(1, int(along[-1] // least_px))
        middles = along - lengths[start:stop] / 2
        of = np.minimum((middles / along[-1] * count).astype(int), count - 1)
        runs += [(start + np.flatnonzero(of == number)).tolist() for number in np.unique(of)]
    return runs


def _judged(
    kept: LoneKept | None, told: tuple[Verdict, Message] | None, least_px: float | None, pixel_m: float
) -> LoneJudgement:
    if kept is None:
        return LoneJudgement(None, Verdict.NOT_COMPARABLE, messages.TOO_LITTLE_BESIDE_SEAM())
    verdict = verdict_of(kept)
    if verdict is not None:
        return LoneJudgement(kept, verdict, None)
    if told is not None:
        return LoneJudgement(kept, *told)
    low, high = 100 * kept.low, 100 * kept.high
    if least_px is None or kept.length_px >= least_px:
        return LoneJudgement(kept, Verdict.NOT_COMPARABLE, messages.LONE_INTERVAL_TOO_WIDE(low=low, high=high))
    reason = messages.LONE_PIECE_TOO_SHORT(needed=least_px * pixel_m, low=low, high=high)
    return LoneJudgement(kept, Verdict.NOT_COMPARABLE, reason)
