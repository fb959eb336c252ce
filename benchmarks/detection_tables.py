"""What `make benchmark-detection` prints of its outcomes."""
from __future__ import annotations

from collections import Counter, defaultdict
from collections.abc import Callable, Iterable, Sequence

import numpy as np

from .operations import HARD
from .outcomes import Outcome
from .timing import print_table

MEASURES: dict[str, Callable[[Outcome], float]] = {
    "kept_1": lambda one: one.reading.kept,
    "composite_ratio_1": lambda one: one.reading.composite_ratio,
    "contrast_1 against the composite": lambda one: one.reading.contrast,
    "ratio_1 against the sources": lambda one: one.reading.ratio,
    "variance of the Laplacian": lambda one: one.peers[0],
    "blur_effect of scikit-image": lambda one: one.peers[1],
    "SSIM against the true hard cut": lambda one: one.peers[2],
}
SPOILT = ("13 px", "33 px and more", "256 px")
MOST_KEPT = 0.9
"""Of the detail along the seam: where images are alike, even a wide feather takes less than a tenth."""
TAKE_DETAIL = ("blur", "resampled", "misregistration")
"""Causes of a loss in the whole window, which a hard cut doesn't save it from."""


def area(sound: Sequence[float], spoilt: Sequence[float]) -> float:
    """Area under the ROC curve: how often a sound window has the higher figure, ties counted half."""
    difference = np.subtract.outer(np.asarray(sound), np.asarray(spoilt))
    return float(((difference > 0) + 0.5 * (difference == 0)).mean()) if difference.size else np.nan


def print_areas(title: str, outcomes: Sequence[Outcome]) -> None:
    """Under one limit for all that came over the mosaics afterwards."""
    rows = [_areas(name, outcomes, measure) for name, measure in MEASURES.items()]
    lost = [one for one in outcomes if one.operation.making.kind == HARD.kind or one.truth <= MOST_KEPT]
    rows.append(_areas(f"kept_1, at most {MOST_KEPT:g} truly left", lost, MEASURES["kept_1"]))
    head = ["measure", *SPOILT, "windows"]
    print_table(f"Area under the ROC curve, hard cuts against feathers, {title}", head, rows,
                "Windows: those with a figure, hard cuts first. All aftermaths together. Widths are full widths;\n"
                "  among 33 px and more are Gaussians with a sigma of 13 px.")


def _areas(name: str, outcomes: Sequence[Outcome], measure: Callable[[Outcome], float]) -> list[str]:
    of_kind = {kind: _known(measure(one) for one in _of(outcomes, kind)) for kind in (HARD.kind, *SPOILT)}
    areas = [area(of_kind[HARD.kind], of_kind[kind]) for kind in SPOILT]
    return [name, *map(_figure, areas), " ".join(str(len(values)) for values in of_kind.values())]


def print_operations(title: str, outcomes: Sequence[Outcome]) -> None:
    """Verdicts, causes and kept_1, operation by operation."""
    rows = []
    for name in dict.fromkeys(one.operation.name for one in outcomes):
        own = [one for one in outcomes if one.operation.name == name]
        verdicts = Counter(one.reading.verdict for one in own)
        causes = Counter(one.reading.cause for one in own)
        rows.append([
            name,
            " ".join(str(verdicts[word]) for word in ("significant", "reduced", "preserved", "not_comparable")),
            ", ".join(own[0].operation.true_causes),
            ", ".join(f"{cause} {count}" for cause, count in causes.most_common(3)),
            *(str(sum(right)) for right in _rights(own)),
            _figure(_median(one.reading.kept for one in own)),
            _figure(_median(one.truth for one in own)),
        ])
    head = ["operation", "s r p n", "true causes", "main causes found", "right", "true", "all", "kept_1", "truth"]
    print_table(f"Operations, {title}", head, rows,
                "s r p n: windows that are significant, reduced, preserved, not comparable. Right: windows whose main\n"
                "  cause is the main one of what was done; a feather that took less than 5 % need not be named.\n"
                "  True: whose main cause is among what was done. All: where all of it was named too.\n"
                "  kept_1 and its truth: medians.")


def print_summary(title: str, outcomes: Sequence[Outcome]) -> None:
    """What is promised, in shares."""
    hard = _of(outcomes, HARD.kind)
    sound = [one for one in hard if one.operation.true_causes[0] not in TAKE_DETAIL]
    changed = [one for one in outcomes if one.true_causes != ("none",)]
    missing = [one for one in outcomes if one.operation.true_causes[0] == "missing source"]
    rows = [
        ["windows with a verdict", _share(one.reading.has_verdict for one in outcomes)],
        ["  and with kept_1", _share(one.reading.has_verdict and one.has_kept for one in outcomes)],
        ["sound hard cuts: significant", _share(one.reading.verdict == "significant" for one in sound)],
        ["sound hard cuts, not compressed: reduced",
         _share(one.reading.verdict == "reduced" for one in sound if one.operation.true_causes[0] != "compressed")],
        ["all hard cuts: interval of kept_1 below 1", _share(one.reading.high < 1 for one in hard if one.has_kept)],
        *([f"feathers of {kind}: significant",
           _share(one.reading.verdict == "significant" for one in _of(outcomes, kind))]
          for kind in SPOILT),
        ["main cause right", _share(one.is_main_right for one in changed)],
        ["main cause true", _share(one.is_true for one in changed)],
        ["all true causes named", _share(one.are_all_named for one in changed)],
        ["nothing changed: cause none", _share(one.is_main_right for one in outcomes if one not in changed)],
        ["missing source found", _share("missing source" in one.reading.causes for one in missing)],
        ["missing source named where there is none",
         _share("missing source" in one.reading.causes for one in outcomes if "missing source" not in one.allowed)],
        ["pixels took no part and nobody said so", _share(one.is_unsaid for one in outcomes if one.foreign > 0)],
    ]
    print_table(f"Shares, {title}", ["", "share"], rows,
                "Sound: neither blurred, resampled nor moved afterwards, which takes detail from the whole window.")


def print_truth(title: str, outcomes: Sequence[Outcome]) -> None:
    """kept_1 against the detail energy that is truly left."""
    rows = []
    for kind in (HARD.kind, *SPOILT):
        own = [one for one in _of(outcomes, kind) if one.has_kept and not np.isnan(one.truth)]
        errors = np.array([one.reading.kept - one.truth for one in own])
        large = float(np.percentile(abs(errors), 95)) if own else np.nan
        widths = [one.reading.high - one.reading.low for one in own]
        figures = (_median(one.truth for one in own), _median(errors), _median(abs(errors)), large, _median(widths))
        rows.append([kind, str(len(own)), *map(_figure, figures), _share(one.holds_truth for one in own)])
    head = ["seam", "windows", "truth", "error", "absolute", "95 %", "interval's width", "holds the truth"]
    print_table(f"kept_1 against the truth, {title}", head, rows,
                "Truth: detail energy against the known hard cut after the same aftermath, by PyWavelets, in the 8 px\n"
                "  by distance from the true seam that lost most. Medians, but for 95 %.")


def print_tones(title: str, outcomes: Sequence[Outcome]) -> None:
    """Grey values and places of the sources against what was done to them."""
    found: dict[str, list[float]] = defaultdict(list)
    for one in outcomes:
        for what, error in one.tone_errors():
            found[what].append(error)
    rows = []
    for what, errors in found.items():
        known = np.abs(_known(errors))
        figures = (np.median(known), np.percentile(known, 95), known.max()) if len(known) else (np.nan,) * 3
        rows.append([what, str(len(errors)), *map(_figure, figures), str(len(errors) - len(known))])
    print_table(f"Measured less true, absolute, source by source, {title}",
                ["", "sources", "median", "95 %", "largest", "not measured"], rows)


def _of(outcomes: Sequence[Outcome], kind: str) -> list[Outcome]:
    return [one for one in outcomes if one.operation.making.kind == kind]


def _rights(own: Sequence[Outcome]) -> tuple[list[bool], list[bool], list[bool]]:
    return [one.is_main_right for one in own], [one.is_true for one in own], [one.are_all_named for one in own]


def _known(values: Iterable[float]) -> list[float]:
    return [value for value in values if value == value]


def _median(values: Iterable[float]) -> float:
    known = _known(values)
    return float(np.median(known)) if known else np.nan


def _figure(value: float) -> str:
    return "." if np.isnan(value) else f"{value:.3f}"


def _share(held: Iterable[bool]) -> str:
    values = list(held)
    return f"{np.mean(values):.1%} of {len(values)}" if values else "."
