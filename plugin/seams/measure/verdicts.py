"""Curves of a mosaic and its sources -> ratios and the verdict of a window (Pyka 2010, section 5)."""
from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from enum import Enum

from ...imagery import limits as imagery_limits
from ...imagery.errors import SettingsError
from ...imagery.message import Message
from ...imagery.wavelets import Curve
from . import messages


class Verdict(str, Enum):
    """What a window's ratios say. The values are the words that tables hold."""

    SIGNIFICANT = "significant"
    REDUCED = "reduced"
    PRESERVED = "preserved"
    NOT_COMPARABLE = "not_comparable"


@dataclass(frozen=True)
class Ratios:
    """Shares of the mosaic divided by those of a source, same window and band."""

    detail: tuple[float | None, ...]
    """Levels 1..R; None where the source has no detail to be compared with."""
    background: float | None
    """Of the coarse components at level R."""


@dataclass(frozen=True)
class Judgement:
    """The verdict of one window against all of its sources."""

    verdict: Verdict
    ratios: Ratios
    """The largest over the sources, level by level, so that a flag means "against every source"."""
    reason: Message | None = None
    """Why the window can't be compared."""


def check_max_ratio(max_ratio: float) -> None:
    """Raise SettingsError unless the limit lies between 0 and 1."""
    if not 0 < max_ratio < 1:
        raise SettingsError(messages.MAX_RATIO_OUT_OF_RANGE(ratio=max_ratio))


def curve_ratios(mosaic: Curve, source: Curve) -> Ratios:
    """Detail and background of the mosaic as multiples of the source's."""
    detail = tuple(_ratio(m, s) for m, s in zip(mosaic.detail, source.detail))
    return Ratios(detail, _ratio(mosaic.background, source.background))


def judge(
    mosaic: Curve, sources: Sequence[Curve], max_ratio: float = imagery_limits.MAX_SIGNIFICANT_RATIO
) -> Judgement:
    """The verdict on a mosaic's curve against those of its sources in one window and band.

    ``significant`` when even against the least sharp source at most ``max_ratio`` of the finest detail is
    left, ``reduced`` when less than all of it is, else ``preserved``.
    """
    nothing = Ratios((None,) * len(mosaic.detail), None)
    if not sources:
        return Judgement(Verdict.NOT_COMPARABLE, nothing, messages.NO_SOURCES())
    if mosaic.variance == 0:
        return Judgement(Verdict.NOT_COMPARABLE, nothing, messages.MOSAIC_CONSTANT())
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
