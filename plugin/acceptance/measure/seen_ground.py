"""What the scans of a delivery saw of its ground: seams found beside seams given, ground that follows no orthoimage,
and pixels that lack within the mosaics.

Figures are of the seams that a layer holds, and a seam that is in none can't fail. So what the scan saw beside them is
held against them: where much of it may be seam, or one place as long as a failure may be, nothing is accepted.
"""
from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import partial

from ...imagery.errors import Message, Stated
from . import messages
from .acceptance_rules import FAILED_SHARE, LONGEST_FAILURE, AcceptanceRules
from .decision import MetreFigures
from .delivery import Delivery

MOST_APART = 0.05
"""Share of the metres that only the scan or only the seamlines may have as a seam: sound seamlines, and what a scan
finds of them in samples, differ by less."""


def place_words(place: Sequence[float]) -> str:
    """A part of the ground by its middle in the reference system of its layer, and by its size, m, where it has one."""
    words = ", ".join(f"{along:.1f}" for along in place[:2])
    return words + (" ({:.0f} x {:.0f} m)".format(*place[2:]) if len(place) > 2 else "")


def numbers_in(text: str) -> list[float]:
    """The numbers of a text, between blanks, or commas where several scans say one each; none where a word is none."""
    try:
        return [float(word) for word in text.replace(",", " ").split()]
    except ValueError:
        return []


@dataclass(frozen=True)
class SeenGround:
    """What scans wrote of the ground beside their rows, one of them or all of a delivery, under the names of
    ``ScanResult.told``."""

    scans: tuple[Mapping[str, str], ...]

    @classmethod
    def of_delivery(cls, delivery: Delivery) -> SeenGround:
        """All scans together."""
        return cls(tuple(layer.settings for layer in delivery.layers))

    @property
    def is_known(self) -> bool:
        """Whether all looked at what the ground follows."""
        return bool(self.scans) and all("unexplained" in scan for scan in self.scans)

    def total(self, name: str) -> float:
        """Metres of all scans."""
        return math.fsum(number for scan in self.scans for number in numbers_in(scan.get(name, "")))

    def most(self, name: str) -> float:
        """The worst share or length."""
        return max(map(partial(_most, name), self.scans), default=0.0)

    @property
    def looked_at(self) -> float:
        """The least share of a mosaic that was looked at."""
        return min((number for scan in self.scans for number in numbers_in(scan.get("looked_at", ""))), default=1.0)

    def place(self, name: str, by: str) -> str:
        """The largest place in words, of the scan that has most by a figure; empty where none is named."""
        held = max(self.scans, key=partial(_most, by), default={}).get(name, "")
        numbers = map(numbers_in, held.replace(",", ";").split(";"))
        return next((place_words(place) for place in numbers if len(place) in (2, 4)), "")


def _most(name: str, scan: Mapping[str, str]) -> float:
    return max(numbers_in(scan.get(name, "")), default=0.0)


def unseen_seams(delivery: Delivery, whole: MetreFigures, rules: AcceptanceRules) -> Iterator[Message]:
    """Why seams that are in no figure may be what decides, what weighs most first."""
    ground = SeenGround.of_delivery(delivery)
    unseen, unchanged = map(ground.total, ("unseen_metres", "unchanged_metres"))
    hidden = math.fsum(  # what a scan lacks that looked for seams by itself is nobody's choice
        SeenGround((scan,)).total("unseen_metres" if scan.get("seams") == "given" else "hidden_metres")
        for scan in ground.scans
    )
    unseen_at = ground.place("unseen_at", "unseen_longest") or "-"
    if unseen + unchanged > MOST_APART * (whole.total_m + unseen):
        if unseen:
            yield messages.SEAMS_NOT_JUDGED(judged=whole.total_m, metres=unseen, place=unseen_at, limit=MOST_APART)
        if unchanged:
            yield messages.SEAMS_UNCHANGED(judged=whole.total_m, metres=unchanged, limit=MOST_APART)
    run, longest = rules.rule(LONGEST_FAILURE), ground.most("unseen_longest")
    if run is not None and not run.passes(longest):
        yield messages.BORDER_WITHOUT_SEAM(metres=longest, limit=Stated(run.limit), place=unseen_at)
    share = rules.rule(FAILED_SHARE)
    if hidden and share is not None:
        failed = (whole.failed_m + hidden) / (whole.measured_m + hidden)
        if not share.passes(failed):
            yield messages.BORDER_HIDDEN(
                metres=hidden, value=failed, limit=Stated(share.limit),
                place=ground.place("hidden_at", "hidden_longest") or unseen_at,
            )
