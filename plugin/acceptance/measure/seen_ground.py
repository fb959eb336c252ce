"""What the scans of a delivery saw of its ground: seams found beside seams given, ground that follows no orthoimage,
and pixels that lack within the mosaics.

Figures are of the seams that a layer holds, and a seam that is in none can't fail. So what the scan saw beside them is
held against them: where much of it may be seam, or one place as long as a failure may be, nothing is accepted.
"""
from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace

from ...imagery.errors import Message, Stated
from . import messages
from .acceptance_rules import FAILED_SHARE, LONGEST_FAILURE, AcceptanceRules
from .decision import MetreFigures
from .delivered_rows import united_settings
from .delivery import Delivery

MOST_APART = 0.05
"""Share of the metres that only the scan or only the seamlines may have as a seam: sound seamlines, and what a scan
finds of them in samples, differ by less."""


def _place(x: float, y: float, width_m: float | None = None, height_m: float | None = None) -> str:
    """A part of the ground by its middle in the reference system of its layer, and by its size where that is known."""
    size = "" if width_m is None or height_m is None else f" ({width_m:.0f} x {height_m:.0f} m)"
    return f"{x:.1f}, {y:.1f}{size}"


def numbers_in(text: str) -> list[float]:
    """The numbers of a text, between blanks, or commas where several scans say one each; none where a word is none."""
    try:
        return [float(word) for word in text.replace(",", " ").split()]
    except ValueError:
        return []


@dataclass(frozen=True)
class SeenGround:
    """What one scan says, or all scans of a delivery: metres together, the worst of their shares and lengths."""

    seams: frozenset[str]  # given, found; empty where nothing says
    is_known: bool  # whether it was looked at what the ground follows
    unchanged_m: float  # metres of given seams along which the mosaic does not change its orthoimage
    unseen_m: float  # metres of border of which no seam tells, in places as long as a piece
    longest_unseen_m: float
    hidden_m: float  # those of them along which no orthoimage explains the mosaic
    longest_hidden_m: float
    unexplained: float  # share of the ground with texture that follows no orthoimage, in which no seam is found
    border_m: float  # metres of border around that: as much seam may be in no figure
    nodata: float  # share of the mosaic within its outline that has no pixels
    unread: float  # share of the mosaic that could not be read
    looked_at: float  # share of the mosaic that was looked at
    unseen_at: tuple[str, ...]
    hidden_at: tuple[str, ...]
    unexplained_at: tuple[str, ...]
    nodata_at: tuple[str, ...]
    mixed_m: float  # metres of seam along which the mosaic was mixed into the orthoimages
    mixed_at: tuple[str, ...]

    @classmethod
    def of_settings(cls, settings: Mapping[str, str]) -> SeenGround:
        """What a scan wrote beside its rows, or what ``united_settings`` made of several."""
        def figures(name: str, nothing: float = 0.0) -> list[float]:
            return numbers_in(settings.get(name, "")) or [nothing]

        def places(name: str) -> tuple[str, ...]:
            held = map(numbers_in, settings.get(name, "").replace(",", ";").split(";"))
            return tuple(_place(*numbers) for numbers in held if len(numbers) in (2, 4))

        return cls(
            frozenset({"given", "found"}.intersection(settings.get("seams", "").split(", "))),
            "unexplained" in settings, sum(figures("unchanged_metres")),
            sum(figures("unseen_metres")), max(figures("unseen_longest")),
            sum(figures("hidden_metres")), max(figures("hidden_longest")), max(figures("unexplained")),
            sum(figures("unexplained_border")), max(figures("nodata_inside")), max(figures("unread")),
            min(figures("looked_at", 1.0)),
            places("unseen_at"), places("hidden_at"), places("unexplained_at"), places("nodata_at"),
            sum(figures("mixed_metres")), places("mixed_at"),
        )  # fmt: skip

    @classmethod
    def of_delivery(cls, delivery: Delivery) -> SeenGround:
        """All scans together, with the places of the scan that has most of it."""
        scans = [cls.of_settings(layer.settings) for layer in delivery.layers]
        united = cls.of_settings(united_settings(delivery.layers))
        if not scans:
            return united
        return replace(
            united, is_known=all(scan.is_known for scan in scans),
            unseen_at=max(scans, key=lambda scan: scan.longest_unseen_m).unseen_at,
            hidden_at=max(scans, key=lambda scan: scan.longest_hidden_m).hidden_at,
            unexplained_at=max(scans, key=lambda scan: scan.unexplained).unexplained_at,
            nodata_at=max(scans, key=lambda scan: scan.nodata).nodata_at,
        )


def unseen_seams(delivery: Delivery, whole: MetreFigures, rules: AcceptanceRules) -> Iterator[Message]:
    """Why seams that are in no figure may be what decides, what weighs most first."""
    ground = SeenGround.of_delivery(delivery)
    apart, every = ground.unseen_m + ground.unchanged_m, whole.total_m + ground.unseen_m
    if apart > MOST_APART * every:
        yield messages.SEAMS_DIFFER(
            judged=whole.total_m, unseen=ground.unseen_m, unchanged=ground.unchanged_m, limit=MOST_APART,
            place=_first(ground.unseen_at),
        )
    run = rules.rule(LONGEST_FAILURE)
    if run is not None and not run.passes(ground.longest_unseen_m):
        yield messages.BORDER_WITHOUT_SEAM(
            metres=ground.longest_unseen_m, limit=Stated(run.limit), place=_first(ground.unseen_at)
        )
    share = rules.rule(FAILED_SHARE)
    if ground.hidden_m and share is not None:
        failed = (whole.failed_m + ground.hidden_m) / (whole.measured_m + ground.hidden_m)
        if not share.passes(failed):
            yield messages.BORDER_HIDDEN(
                metres=ground.hidden_m, value=failed, limit=Stated(share.limit), place=_first(ground.hidden_at)
            )


def ground_sentences(name: str, settings: Mapping[str, str]) -> Iterator[Message]:
    """What one scan could not see."""
    if (looked_at := SeenGround.of_settings(settings).looked_at) < 1:
        yield messages.SCAN_PARTLY(name=name, share=looked_at)


def _first(places: tuple[str, ...]) -> str:
    return places[0] if places else "-"
