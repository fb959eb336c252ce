"""What `make benchmark-detection` prints of kept_1: against the truth, hard cuts against feathers, verdicts."""
from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np

from .figures import area, figure, grounds_of, known, median, percent, share, sides_of
from .operations import HARD, KINDS, RESAMPLED
from .outcomes import Outcome
from .timing import print_table

Measure = Callable[[Outcome], float]
Belongs = Callable[[Outcome], bool]

GROUPS = ("13 px", "33 px and more")
KIND_NAMES = tuple(making.kind for making in KINDS if making.group in GROUPS)
MEASURES: dict[str, Measure] = {
    "kept_1": lambda one: one.reading.kept,
    "composite_ratio_1": lambda one: one.reading.composite_ratio,
    "contrast_1 against the composite": lambda one: one.reading.contrast,
    "ratio_1 against the sources": lambda one: one.reading.ratio,
}
PEERS = ("variance of the Laplacian", "blur_effect of scikit-image", "SSIM against the true hard cut")
MOST_KEPT = 0.9
"""Greatest share kept of detail along the seam: where images are alike, even a wide feather takes less than a tenth."""
TAKE_DETAIL = ("blur", "resampled")
"""Causes of a loss in the whole window, which a hard cut doesn't save it from."""


def print_truth(title: str, outcomes: Sequence[Outcome]) -> None:
    """kept_1 against the detail energy that is truly left, a row for each kind of seam and side."""
    rows = [
        [f"{making.kind}, {side} px", *_truth_cells(own)]
        for making in KINDS for side in sides_of(outcomes)
        if (own := [one for one in outcomes if one.operation.making.kind == making.kind and one.window.side == side])
    ]
    head = ["seam, side", "windows", "verdict %", "kept_1", "truth", "kept_1 - truth", "absolute", "interval right %",
            "half width", "significant %", "surely < 1 %"]
    print_table(f"kept_1 against the truth, {title}", head, rows,
                "Truth: sum |sum of weight x W|^2 over sum |W of the source followed|^2 in the 8 px beside the\n"
                "  true seam, W the sources' finest detail by PyWavelets, before the aftermath: a hard cut keeps 1.\n"
                "  Verdict: other than not_comparable. kept_1: windows that have it. Medians of truth and errors.\n"
                "  Interval right: the 95 % interval holds the truth. Surely: its upper end.")


def _truth_cells(own: Sequence[Outcome]) -> list[str]:
    measured = [one for one in own if one.is_measured]
    errors = np.array([one.error for one in measured])
    return [
        str(len(own)),
        percent(one.reading.has_verdict for one in own),
        str(len(measured)),
        *map(figure, (median(one.truth for one in measured), median(errors), median(abs(errors)))),
        percent(one.holds_truth for one in measured),
        figure(median((one.reading.high - one.reading.low) / 2 for one in measured)),
        percent(one.reading.verdict == "significant" for one in own),
        percent(one.reading.high < 1 for one in measured),
    ]


def print_areas(title: str, outcomes: Sequence[Outcome]) -> None:
    """Under one limit for all that came over the mosaics afterwards, by kind of seam and side, and by ground."""
    sides = sides_of(outcomes)
    rows = [[name, *_areas(outcomes, of_kind(name))] for name in KIND_NAMES]
    rows += [[f"all of {group}", *_areas(outcomes, of_group(group))] for group in GROUPS]
    rows += [[f"all of {group}, lost", *_areas(outcomes, lost_of_group(group))] for group in GROUPS]
    for ground in grounds_of(outcomes) if len(grounds_of(outcomes)) > 1 else ():
        own = [outcome for outcome in outcomes if outcome.window.imagery == ground]
        rows += [[f"all of {group}, lost, {ground}", *_areas(own, lost_of_group(group), sides)] for group in GROUPS]
    print_table(f"Area under the ROC curve of kept_1, all hard cuts against feathers, {title}",
                ["seam", *(f"{side} px" for side in sides)], rows,
                "Windows that have kept_1, all aftermaths together; behind it how many, hard cuts first.\n"
                f"  Lost: at most {MOST_KEPT:g} is truly left; images that are alike lose less even by a wide feather.")


def print_measures(title: str, outcomes: Sequence[Outcome]) -> None:
    """The plugin's measures and usual ones beside each other."""
    if not outcomes or outcomes[0].finding.peers is None:
        return
    measures = {**MEASURES, **{name: _peer(number) for number, name in enumerate(PEERS)}}
    rows = [
        [name, *(_area(_on(outcomes, side), of_group(group), measure)
                 for side in sides_of(outcomes) for group in GROUPS)]
        for name, measure in measures.items()
    ]
    head = ["measure", *(f"{group}, {side} px" for side in sides_of(outcomes) for group in GROUPS)]
    print_table(f"Area under the ROC curve of all measures, {title}", head, rows)


def of_kind(kind: str) -> Belongs:
    """Those of a row of the tables."""
    return lambda one: one.operation.making.kind == kind


def of_group(group: str) -> Belongs:
    """Those of several rows."""
    return lambda one: one.operation.making.group == group


def lost_of_group(group: str) -> Belongs:
    """Those that truly lost a tenth."""
    return lambda one: one.operation.making.group == group and one.truth <= MOST_KEPT


def _peer(number: int) -> Measure:
    return lambda one: one.finding.peers[number] if one.finding.peers else np.nan


def _areas(outcomes: Sequence[Outcome], belongs: Belongs, sides: Sequence[int] = ()) -> list[str]:
    return [_area(_on(outcomes, side), belongs) for side in sides or sides_of(outcomes)]


def _area(
    outcomes: Sequence[Outcome], belongs: Belongs, measure: Measure = MEASURES["kept_1"]
) -> str:
    sound = known(measure(outcome) for outcome in outcomes if of_group("hard")(outcome))
    spoilt = known(measure(outcome) for outcome in outcomes if belongs(outcome))
    return f"{figure(area(sound, spoilt))} ({len(sound)}, {len(spoilt)})"


def print_hard_cuts(title: str, outcomes: Sequence[Outcome]) -> None:
    """What is said of seams that took nothing, by ground and side."""
    hard = [outcome for outcome in outcomes if outcome.operation.making.group == "hard"]
    rows = []
    for ground in grounds_of(hard):
        for side in sides_of(hard):
            for kind in (HARD.kind, RESAMPLED.kind, ""):
                own = [one for one in _on(hard, side) if one.window.imagery == ground and of_kind(kind)(one)]
                if own:
                    rows.append([f"{ground}, {side} px, {kind or 'other hard cuts'}", *_hard_cells(own)])
    rows.append(["all", *_hard_cells(hard)])
    head = ["ground, side, seam", "windows", "significant", "untouched", "significant", "reduced %", "kept_1",
            "surely < 1 %"]
    print_table(f"Sound hard cuts, {title}", head, rows,
                "Whatever came over them. Untouched: those whose whole mosaic was neither blurred nor resampled, as\n"
                "  takes detail from all of the window; behind it what is said of them. Other: three sources meet, or\n"
                "  tones were balanced.")


def _hard_cells(own: Sequence[Outcome]) -> list[str]:
    sharp = [one for one in own if one.operation.aftermath.cause not in TAKE_DETAIL]
    measured = [one for one in own if one.has_kept]
    return [
        str(len(own)),
        str(sum(one.reading.verdict == "significant" for one in own)),
        str(len(sharp)),
        str(sum(one.reading.verdict == "significant" for one in sharp)),
        percent(one.reading.verdict == "reduced" for one in sharp),
        figure(median(one.reading.kept for one in own)),
        percent(one.reading.high < 1 for one in measured),
    ]


def print_usable(title: str, outcomes: Sequence[Outcome]) -> None:
    """Windows with a verdict, by ground, of those that have texture to judge by."""
    rows = []
    for ground in grounds_of(outcomes):
        for side in sides_of(outcomes):
            own = [one for one in _on(outcomes, side) if one.window.imagery == ground]
            if own:
                with_texture = [one for one in own if one.window.has_texture]
                rows.append([f"{ground}, {side} px", *_usable_cells(own, with_texture)])
    for side in sides_of(outcomes):
        own = _on(outcomes, side)
        rows.append([f"all, {side} px", *_usable_cells(own, [one for one in own if one.window.has_texture])])
    head = ["ground, side", "windows", "verdict", "with texture: verdict", "and kept_1", "texture, DN2"]
    print_table(f"Usable windows, {title}", head, rows,
                "With texture: the main sources' finest detail has a variance of 4 DN2 or more; last its median.")


def _usable_cells(own: Sequence[Outcome], with_texture: Sequence[Outcome]) -> list[str]:
    return [
        str(len(own)),
        percent(one.reading.has_verdict for one in own),
        share(one.reading.has_verdict for one in with_texture),
        percent(one.reading.has_verdict and one.has_kept for one in with_texture),
        f"{median(one.window.texture for one in own):.1f}",
    ]


def _on(outcomes: Sequence[Outcome], side: int) -> list[Outcome]:
    return [outcome for outcome in outcomes if outcome.window.side == side]
