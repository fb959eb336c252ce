"""The place of the loss that a window's verdict goes by: along its seam or in all of it; and so its causes."""
from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from ..limits import MAX_SIGNIFICANT_SHARPNESS_SQUARED, SHARPNESS_TOLERANCE
from .causes import ALL_OVER, ALONG_THE_SEAM


@dataclass(frozen=True)
class LossPlace:
    """What a verdict by the seam was taken by; numbers that are not known are None."""

    verdict: str
    kept: float | None
    """kept_1."""
    high: float | None
    """Upper end of its interval."""
    sharpness: float | None

    @property
    def is_along(self) -> bool:
        """Whether a loss along the seam is sure; what is kept there says nothing where the whole is blurred badly."""
        is_sure = self.kept is not None and self.high is not None and self.high < 1
        return self.verdict in ("significant", "reduced") and is_sure and not self.is_blurred

    @property
    def kept_in_whole(self) -> float:
        """Share of the finest detail energy of the window's sources; all where that is not known."""
        return 1.0 if self.sharpness is None else self.sharpness**2

    @property
    def is_blurred(self) -> bool:
        """Whether the whole is blurred so badly that the ground around tells nothing of the seam."""
        return self.kept_in_whole <= MAX_SIGNIFICANT_SHARPNESS_SQUARED

    @property
    def is_whole_soft(self) -> bool:
        return self.kept_in_whole < (1 - SHARPNESS_TOLERANCE) ** 2

    @property
    def is_decisive(self) -> bool:
        """Whether the seam took the more, or made the verdict, so that its loss is the one told."""
        is_alone = self.verdict == "significant" or not self.is_whole_soft
        return self.is_along and (is_alone or (self.kept or 0.0) <= self.kept_in_whole)

    def decisive(self, causes: Sequence[str]) -> list[str]:
        """What took the detail that is told of, along the seam or in the whole, the strongest first; nothing where
        nothing is lost."""
        if self.verdict not in ("significant", "reduced"):
            return []
        at_seam = [cause for cause in causes if cause in ALONG_THE_SEAM]
        in_whole = [cause for cause in causes if cause in ALL_OVER and cause not in at_seam]
        if self.is_decisive:
            return at_seam or in_whole * self.is_whole_soft
        return in_whole or at_seam
