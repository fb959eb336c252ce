"""The decision on images: accepted, rejected, or open as long as something that a rule asks for is not known."""
from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from enum import Enum

from ...imagery.errors import Message
from .assessment import Assessment, CheckedFigure


class RadiometricOutcome(Enum):
    """What is decided."""

    ACCEPTED = "accepted"
    """Every figure that has a limit keeps it, those apart that could not be measured and that no rule requires."""
    REJECTED = "rejected"
    """At least one figure is beyond its limit."""
    UNDECIDED = "undecided"
    """Nothing is beyond its limit, and something that a rule requires is not known."""


@dataclass(frozen=True, eq=False)
class ImageDecision:
    """The decision on an image or a window of it."""

    result: Assessment
    outcome: RadiometricOutcome
    failed: tuple[CheckedFigure, ...]
    """Those beyond their limits."""
    missed: tuple[CheckedFigure, ...]
    """Those that are not known and would have to be."""
    unmeasured: tuple[CheckedFigure, ...]
    """Those that have a limit, are not known, and that the rules can do without."""


@dataclass(frozen=True, eq=False)
class RadiometricDecision:
    """The decision on all images together."""

    outcome: RadiometricOutcome
    images: tuple[ImageDecision, ...]
    left_out: tuple[Message, ...]
    """Why images or windows were not looked at; nothing is accepted unseen."""

    def those(self, outcome: RadiometricOutcome) -> list[ImageDecision]:
        """The images with this outcome."""
        return [image for image in self.images if image.outcome is outcome]


def decide_image(result: Assessment) -> ImageDecision:
    """A failed figure rejects, whatever else is unknown; an unknown one that is required leaves it open."""
    failed = tuple(one for one in result.checked_figures if one.passed is False)
    missed = tuple(one for one in result.checked_figures if one.is_missed)
    unmeasured = tuple(
        one for one in result.checked_figures
        if one.value is None and one.rule.has_limit and one.is_applicable and not one.is_missed
    )  # fmt: skip
    is_judged = any(one.passed is not None for one in result.checked_figures)
    outcome = RadiometricOutcome.UNDECIDED if missed or not is_judged else RadiometricOutcome.ACCEPTED
    if failed:
        outcome = RadiometricOutcome.REJECTED
    return ImageDecision(result, outcome, failed, missed, unmeasured)


def decide(results: Sequence[Assessment], left_out: Sequence[Message] = ()) -> RadiometricDecision:
    """One rejected image rejects all; one that is open, or was not looked at, leaves all open."""
    images = tuple(map(decide_image, results))
    outcomes = {image.outcome for image in images}
    if RadiometricOutcome.REJECTED in outcomes:
        outcome = RadiometricOutcome.REJECTED
    elif RadiometricOutcome.UNDECIDED in outcomes or left_out or not images:
        outcome = RadiometricOutcome.UNDECIDED
    else:
        outcome = RadiometricOutcome.ACCEPTED
    return RadiometricDecision(outcome, images, tuple(left_out))
