"""What was measured in a window -> its verdict: by curves as in the paper (Pyka 2010, section 5), or by its seams."""
from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from enum import Enum

from ....imagery import limits as imagery_limits
from ....imagery.errors import Message
from ....imagery.seam_totals import MOST_SPREAD
from ....imagery.wavelets import Curve
from .. import messages
from ..limits import MAX_SIGNIFICANT_KEPT
from ..profile.seam_profile import SeamProfile
from ..window_records import MAY_BE_SIGNIFICANT, OF_THE_REST
from .causes import MIN_MIXED

MIN_EXPLAINED = 0.9  # of the pixels: else a seam may lie where no given source explains the mosaic
MAY_HIDE_SEAM = 0.98  # the same of a window whose sources meet nowhere that is explained
MAX_KEPT_LOW = 1.15  # lower end of kept_1: no seam adds detail, so the sources that are followed are not the mosaic's


class Verdict(str, Enum):
    """What became of the detail of a window or a piece of seam. The values are the words that tables hold."""

    SIGNIFICANT = "significant"
    """At most the limit is left by the best estimate, and some loss is certain."""
    REDUCED = "reduced"
    """Less is left than the sources have, surely."""
    PRESERVED = "preserved"
    """Nothing is lost, as far as can be told."""
    NOT_COMPARABLE = "not_comparable"
    """It can't be told; the reason says why."""


@dataclass(frozen=True)
class Ratios:
    """Shares of the mosaic divided by those of a source, same window and band."""

    detail: tuple[float | None, ...]
    """Levels 1..R; None where the source has no detail to be compared with."""
    background: float | None
    """Ratio of the coarse components at level R."""


_CODES = {
    messages.MAY_BE_SIGNIFICANT.template: MAY_BE_SIGNIFICANT, messages.VERDICT_OF_THE_REST.template: OF_THE_REST,
}  # fmt: skip


@dataclass(frozen=True)
class Judgement:
    """The verdict of one window against all of its sources."""

    verdict: Verdict
    """Verdict by the reference that was asked for."""
    ratios: Ratios
    """The largest over the sources, level by level, so that a flag means "against every source"."""
    reason: Message | None = None
    """Why the window can't be compared, or what its verdict lacks."""

    @property
    def reason_code(self) -> str:
        """The reason, or the one within it, as logic reads it: one of ``_CODES``; empty for others, and for none."""
        within = () if self.reason is None else (self.reason, *self.reason.values.values())
        templates = (message.template for message in within if isinstance(message, Message))
        return next((_CODES[template] for template in templates if template in _CODES), "")


def judge_profile(
    profile: SeamProfile, min_kept: float = MAX_SIGNIFICANT_KEPT, is_blurred: bool = False, explained: float = 1.0
) -> tuple[Verdict, Message | None]:
    """The verdict by what is kept along a seam, and why there is none.

    ``significant`` where the best estimate of kept_1 is at most ``min_kept`` and some loss is certain (its
    interval ends below the limit, or half-way to 1 unless it is wide), ``reduced`` where it is surely below 1 or the
    whole ``is_blurred``, else ``preserved``; none where the interval says nothing, or holds all that there was although
    so little is kept, or where both sources are the same along the seam. ``explained``: share of the pixels that the
    sources explain.
    """
    if profile.low > MAX_KEPT_LOW:
        return Verdict.NOT_COMPARABLE, messages.MORE_ALONG_THE_SEAM(low=100 * profile.low, high=100 * profile.high)
    is_wide = profile.high > MOST_SPREAD * profile.low
    kept = profile.kept[0]
    if kept is not None and kept <= min_kept and profile.high < 1:
        if profile.high <= (min_kept if is_wide else (min_kept + 1) / 2):
            return Verdict.SIGNIFICANT, None
        return Verdict.REDUCED, messages.MAY_BE_SIGNIFICANT(low=100 * profile.low, high=100 * profile.high)
    if profile.high >= 1 and (is_wide or (kept is not None and kept <= min_kept)):
        return Verdict.NOT_COMPARABLE, messages.INTERVAL_TOO_WIDE(low=100 * profile.low, high=100 * profile.high)
    if profile.is_between_copies:
        return Verdict.NOT_COMPARABLE, messages.SAME_ALONG_THE_SEAM()
    if profile.high < 1 or is_blurred:
        return Verdict.REDUCED, None
    if explained < MIN_EXPLAINED:  # that seam is sound, but there is another one
        return Verdict.NOT_COMPARABLE, messages.SEAM_UNEXPLAINED(share=100 * (1 - explained))
    return Verdict.PRESERVED, None


def judge_without_profile(
    has_seam: bool, is_blurred: bool, explained: float, mixed: float
) -> tuple[Verdict, Message | None]:
    """The verdict where nothing could be measured along a seam, and why there is none.

    ``explained``: share of the pixels that the sources explain, ``mixed`` of those that are a mixture of two of them.
    """
    if explained < (MAY_HIDE_SEAM if has_seam else MIN_EXPLAINED):
        return Verdict.NOT_COMPARABLE, messages.SEAM_UNEXPLAINED(share=100 * (1 - explained))
    if has_seam:
        return Verdict.NOT_COMPARABLE, messages.TOO_LITTLE_GROUND()
    if mixed >= MIN_MIXED:
        return Verdict.REDUCED if is_blurred else Verdict.NOT_COMPARABLE, messages.MIXED_ALL_OVER(share=100 * mixed)
    return Verdict.REDUCED if is_blurred else Verdict.PRESERVED, messages.NO_SEAM()


def curve_ratios(mosaic: Curve, source: Curve) -> Ratios:
    """Detail and background of the mosaic as multiples of the source's."""
    detail = tuple(_ratio(m, s) for m, s in zip(mosaic.detail, source.detail))
    return Ratios(detail, _ratio(mosaic.background, source.background))


def judge_curves(
    mosaic: Curve, sources: Sequence[Curve], max_ratio: float = imagery_limits.MAX_SIGNIFICANT_RATIO
) -> Judgement:
    """The verdict on a mosaic's curve against those of its sources in one window and band.

    ``significant`` when even against the least sharp source at most ``max_ratio`` of the finest detail is
    left, ``reduced`` when less than all of it is, else ``preserved``.
    """
    nothing = Ratios((None,) * len(mosaic.detail), None)
    if mosaic.variance == 0:
        return Judgement(Verdict.NOT_COMPARABLE, nothing, messages.MOSAIC_CONSTANT())
    if not sources:
        return Judgement(Verdict.NOT_COMPARABLE, nothing, messages.NO_SOURCES())
    against = [curve_ratios(mosaic, source) for source in sources]
    largest = Ratios(
        tuple(_largest([ratios.detail[level] for ratios in against]) for level in range(len(mosaic.detail))),
        _largest([ratios.background for ratios in against]),
    )
    finest = largest.detail[0]
    if finest is None:
        return Judgement(Verdict.NOT_COMPARABLE, largest, messages.SOURCES_WITHOUT_DETAIL())
    if finest <= max_ratio:
        return Judgement(Verdict.SIGNIFICANT, largest)
    return Judgement(Verdict.REDUCED if finest < 1 else Verdict.PRESERVED, largest)


def _ratio(mosaic: float, source: float) -> float | None:
    return mosaic / source if source > imagery_limits.MIN_SHARE else None


def _largest(ratios: list[float | None]) -> float | None:
    return max((ratio for ratio in ratios if ratio is not None), default=None)
