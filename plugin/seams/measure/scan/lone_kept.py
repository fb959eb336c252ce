"""What pieces of seam kept where no orthoimage is given, with intervals; which length of seam can be judged; verdicts.

kept_1 is the finest detail in the strip beside the seam over that of the ground on both sides, each over what ground
like that is expected to have. The figures behind the constants below: docs/appendix/seams_without_sources.md.

A verdict is given only where the interval allows one, and is that of a piece alone. Where its interval is too wide, the
stretch of pieces of the same seam that it belongs to may still tell: stretches are told beside the pieces."""
from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from ....imagery.errors import Message
from ....imagery.seam_totals import MOST_SPREAD, STANDARD_LEAST_KEPT, piece_state
from ....imagery.statistics import critical_t
from .. import messages
from ..judgement.verdicts import Verdict
from ..limits import MAX_SIGNIFICANT_KEPT
from ..profile.seam_profile import BAND_KEPT, ProfileBin, band_width_px
from ..seamlines.seam_pieces import SeamPiece, joined_pieces
from .lone_stretches import RANGES_PX, STRETCH_PX, STRIP, STRIP_PX, ZONES_PX, LoneStretches, ground_of
from .scan_result import JudgedPiece

EXCESS, DECAY = 1.5, 0.75
"""The variance of the mean of n stretches is that of one of them, times the first, over n to the power of the second:
ground changes slowly along a seam, so stretches are not independent of each other."""
SELECTION = 0.75
"""Seams are led through smooth ground. Of what the look of the ground explains of the difference between strip and
ground, over all seams, so much again may be there that it does not see."""
COLOURLESS = 0.17
"""What is added to the upper end of log kept where there is one band only: brightness alone can't tell meadow from
bitumen, and seams are led along the smoother one."""
LEAST_ERROR = 0.03
"""Least error of the logarithm of kept, however long the seam."""
MOST_TOO_HIGH = 0.12
"""Share by which kept may be too high: sources cut hard make edges of their own, which the ground beside has not."""

_CONFIDENCE = 0.95  # of all intervals, as of those with orthoimages
_RUN = 8  # stretches whose scatter is taken together
_BORROWED = 8.0  # stretches that the scatter of all seams counts as, beside that of a run
_FEWEST_RUNS = 6  # that tell how much runs differ
_LEAST_AREA = 0.4  # of the strip, and of the ground on either side: with less a stretch takes no part


@dataclass(frozen=True)
class LoneKept:
    """What a piece, a run of pieces or all seams kept."""

    kept: float
    low: float
    high: float
    """95 % interval."""
    band_width_px: float
    """Full width of the band in which less than 0.9 is kept; 0 where none shows for sure."""
    length_px: float
    """Length of the seam that was measured."""

    @property
    def tells_loss(self) -> bool:
        """Whether less is kept than all, for sure."""
        return self.high < 1

    @property
    def tells_sound(self) -> bool:
        """Whether more is kept than a significant loss would leave, and nothing says that it is less than all."""
        return self.low > MAX_SIGNIFICANT_KEPT and not self.tells_loss


class LoneSeams:
    """All seams of a mosaic, by their stretches."""

    def __init__(self, stretches: LoneStretches, seam_ids: Sequence[int]) -> None:
        """``seam_ids``: of each piece; the pieces of a seam follow one another."""
        self.seam_ids = tuple(seam_ids)
        order = np.argsort(stretches.piece, kind="stable")
        self._stretches = stretches.chosen(order)
        self._seam = np.asarray(seam_ids, dtype=np.intp)[self._stretches.piece]
        runs = runs_of(self._seam, np.ones(len(self._seam)), _RUN)
        self._run = np.repeat(np.arange(len(runs)), list(map(len, runs)))
        self.range = 0
        """Place in ``RANGES_PX`` of what the strips are compared with."""
        self._prepare()
        if self._reaches_beyond():
            self.range = 1
            self._prepare()

    def kept(self, pieces: Sequence[int] | None = None) -> LoneKept | None:
        """What pieces that follow one another kept together, or all; None where too little of them or of the ground can
        be measured."""
        first, last = (pieces[0], pieces[-1]) if pieces is not None else (0, len(self.seam_ids))
        span = slice(*np.searchsorted(self._stretches.piece, (first, last + 1)).tolist())
        return self._kept(span.start + np.flatnonzero(self._usable[span]))

    def by_piece(self) -> list[LoneKept | None]:
        """What every piece kept for itself."""
        return [self.kept((number,)) for number in range(len(self.seam_ids))]

    @property
    def judgeable_px(self) -> float | None:
        """From which length of seam on a significant loss shows for sure, as the ground of this mosaic is."""
        if self._scatter is None:
            return None
        shift = -np.log(MAX_SIGNIFICANT_KEPT) - self._raised
        room = (shift / critical_t(_CONFIDENCE, np.inf)) ** 2 - LEAST_ERROR**2
        if room <= 0 or shift <= 0:
            return None
        return float(STRETCH_PX * max(1.0, (EXCESS * self._scatter / room) ** (1 / DECAY)))

    @property
    def _raised(self) -> float:
        """How much the upper end of log kept is raised for seams that are led through smooth ground."""
        return max(-self._selection, 0.0) + (0.0 if self._stretches.has_colour.all() else COLOURLESS)

    def _has_ground(self, range_: int) -> np.ndarray:
        """Stretches with enough ground on both sides, (n,) bool."""
        s, parts, (near, far) = self._stretches, ground_of(range_), RANGES_PX[range_]
        return np.asarray(
            ((s.area[parts] >= _LEAST_AREA * (far - near) * s.length_px) & (s.plain[parts] > 0)).all(axis=0)
        )

    def _prepare(self) -> None:
        """The stretches that take part, and what the intervals of all pieces follow from."""
        s = self._stretches
        self._usable = (s.area[0] >= _LEAST_AREA * 2 * STRIP_PX * s.length_px) & self._has_ground(self.range)
        self._selection, self._scatter = 0.0, None
        self._variance = np.zeros(len(s))
        used = np.flatnonzero(self._usable)
        if not len(used):
            return
        self._selection = SELECTION * (self._compared(used, plain=True)[0] - self._compared(used)[0])
        runs, first = np.unique(self._run[used], return_index=True)
        sums, counts = np.zeros(self._run[-1] + 1), np.zeros(self._run[-1] + 1)
        for run, chosen in zip(runs, np.split(used, first[1:])):
            if len(chosen) > 1:
                influence = self._compared(chosen)[1]
                sums[run] = len(chosen) ** 2 * (influence**2).sum()  # of one stretch, times their number less one
                counts[run] = len(chosen) - 1
        if counts.any():
            self._scatter = float(sums.sum() / counts.sum())
            self._variance = ((sums + self._scatter * _BORROWED) / (counts + _BORROWED))[self._run]

    def _kept(self, chosen: np.ndarray) -> LoneKept | None:
        """What some stretches kept."""
        if not len(chosen) or self._scatter is None:
            return None
        log_kept, influence = self._compared(chosen)
        error = self._error(chosen, influence)
        factor = np.exp(critical_t(_CONFIDENCE, _BORROWED + len(chosen) - 1) * error)
        kept = float(np.exp(log_kept))
        low = kept / factor * np.exp(-max(self._selection, 0.0)) * (1 - MOST_TOO_HIGH)
        high = kept * factor * np.exp(self._raised)
        width = self._width_px(chosen) if high < 1 and kept < BAND_KEPT else 0.0
        return LoneKept(kept, float(low), float(high), width, float(self._stretches.length_px[chosen].sum()))

    def _compared(self, chosen: np.ndarray, plain: bool = False, beyond: bool = False) -> tuple[float, np.ndarray]:
        """Logarithm of the strip over the ground on both sides, and what each stretch adds to it.

        ``plain``: as the detail is; ``beyond``: not of the strip but of the nearer ground, over that farther off.
        """
        s = self._stretches
        area, values = (by_stretch[:, chosen] for by_stretch in (s.area, s.plain if plain else s.matched))
        influence, log_kept = np.zeros(len(chosen)), 0.0
        for sign, parts in (
            (1, ground_of(0) if beyond else STRIP), (-1, ground_of(1 if beyond else self.range)),
        ):
            weights = area[parts] / area[parts].sum(axis=1, keepdims=True)
            means = (weights * values[parts]).sum(axis=1)
            level = max(float(means.mean()), 1e-12)
            log_kept += sign * float(np.log(level))
            apart = values[parts] - means[:, np.newaxis]
            influence += sign * (weights * apart).sum(axis=0) / (level * len(means))
        return log_kept, influence

    def _error(self, chosen: np.ndarray, influence: np.ndarray) -> float:
        """Standard error of the logarithm of kept."""
        weights = self._stretches.area[0, chosen] / self._stretches.area[0, chosen].sum()
        squares = weights**2
        scatter = float(squares @ self._variance[chosen]) / float(squares.sum())
        variance = EXCESS * scatter * float(squares.sum()) ** DECAY
        runs = np.unique(self._run[chosen], return_inverse=True)[1]
        count = int(runs.max()) + 1
        if count >= _FEWEST_RUNS:  # many differ by what they are, too
            between = float((np.bincount(runs, influence) ** 2).sum()) * count / (count - 1)
            variance = max(variance, between)
        return float(np.sqrt(variance + LEAST_ERROR**2))

    def _reaches_beyond(self) -> bool:
        """Whether, beside a loss along the seams, the nearer ground has lost detail itself."""
        whole = self.kept()
        if whole is None or not whole.tells_loss:
            return False
        chosen = np.flatnonzero(self._usable & self._has_ground(1))
        if len(np.unique(self._run[chosen])) < _FEWEST_RUNS:
            return False
        log_kept, influence = self._compared(chosen, beyond=True)
        plain, _ = self._compared(chosen, plain=True, beyond=True)
        error = self._error(chosen, influence)
        return bool(log_kept + critical_t(_CONFIDENCE, _BORROWED) * error + SELECTION * max(log_kept - plain, 0.0) < 0)

    def _width_px(self, chosen: np.ndarray) -> float:
        """Width of the band along some stretches."""
        s, ground = self._stretches, ground_of(self.range)
        areas = s.area[ground, chosen]
        level = (areas * s.matched[ground, chosen]).sum(axis=1) / areas.sum(axis=1)
        bins = []
        for zone, (near, far) in enumerate(zip(ZONES_PX, ZONES_PX[1:])):
            area = s.zone_area[zone, chosen]
            if area.any():
                kept = float((area * s.zone_matched[zone, chosen]).sum() / area.sum() / level.mean())
                bins.append(ProfileBin(1, near, far, kept, np.nan, np.nan, np.nan, float(area.sum())))
        return band_width_px(bins)


RUNS_LENGTHS = (1.0, 2.0, 4.0)
"""Runs are tried that are so many times as long as what can be judged on this mosaic."""


def judge_pieces(
    seams: LoneSeams, pieces: Sequence[SeamPiece], pixel_m: float, levels: int = 1
) -> list[JudgedPiece]:
    """Every piece by itself, in their order; levels beyond the first are not told. ``pixel_m``: side of a pixel."""
    return [_judged(piece, kept, seams.judgeable_px, pixel_m, levels) for piece, kept in zip(pieces, seams.by_piece())]


def judge_stretches(
    seams: LoneSeams, judged: Sequence[JudgedPiece], pixel_m: float, levels: int = 1
) -> list[JudgedPiece]:
    """Pieces together that tell what one of them at least does not by itself, the shortest that do."""
    least = seams.judgeable_px
    open_verdicts = Verdict.NOT_COMPARABLE, Verdict.REDUCED
    wanted = {
        number for number, piece in enumerate(judged) if piece.kept is not None and piece.verdict in open_verdicts
    }
    lengths = [piece.piece.length_m / pixel_m for piece in judged]
    stretches: list[JudgedPiece] = []
    for length in [] if least is None else [factor * least for factor in RUNS_LENGTHS]:
        for run in runs_of(seams.seam_ids, lengths, length) if wanted else ():
            if len(run) < 2 or wanted.isdisjoint(run):
                continue
            kept = seams.kept(run)
            if kept is not None and verdict_of(kept) is not None:
                whole = joined_pieces([judged[number].piece for number in run])
                stretches.append(replace(_judged(whole, kept, least, pixel_m, levels), is_stretch=True))
                wanted.difference_update(run)
    return stretches


def verdict_of(kept: LoneKept) -> Verdict | None:
    """None where the interval is too wide for one."""
    if kept.tells_loss:
        is_number = kept.high <= MOST_SPREAD * kept.low or kept.high <= MAX_SIGNIFICANT_KEPT
        return Verdict.SIGNIFICANT if kept.kept <= MAX_SIGNIFICANT_KEPT and is_number else Verdict.REDUCED
    return Verdict.PRESERVED if kept.tells_sound else None


def runs_of(
    seam_ids: Sequence[int] | np.ndarray, lengths_px: Sequence[float] | np.ndarray, least_px: float
) -> list[list[int]]:
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
    piece: SeamPiece, kept: LoneKept | None, least_px: float | None, pixel_m: float, levels: int
) -> JudgedPiece:
    left, right = (side if isinstance(side, str) else None for side in (piece.left, piece.right))
    if kept is None:
        why: Message | None = messages.TOO_LITTLE_BESIDE_SEAM()
        return JudgedPiece(piece, left, right, None, None, None, None, Verdict.NOT_COMPARABLE, why)
    verdict, why = verdict_of(kept), None
    state = piece_state(kept.kept, kept.low, kept.high, STANDARD_LEAST_KEPT, verdict is not None)
    if verdict is None:
        verdict, low, high = Verdict.NOT_COMPARABLE, 100 * kept.low, 100 * kept.high
        if least_px is None or kept.length_px >= least_px:
            why = messages.LONE_INTERVAL_TOO_WIDE(low=low, high=high)
        else:
            why = messages.LONE_PIECE_TOO_SHORT(needed=least_px * pixel_m, low=low, high=high)
    return JudgedPiece(
        piece, left, right, (kept.kept, *[None] * (levels - 1)), kept.low, kept.high, kept.band_width_px * pixel_m,
        verdict, why, state=state,
    )
