"""What `make benchmark-detection` prints of causes, missing sources, tones and places."""
from __future__ import annotations

from collections import Counter, defaultdict
from collections.abc import Sequence

import numpy as np

from .figures import figure, grounds_of, known, median, percent, share, sides_of
from .outcomes import Outcome
from .timing import print_table

MISSING = "missing source"


def print_causes(title: str, outcomes: Sequence[Outcome]) -> None:
    """What is said for each true main cause, side by side with how often it is right."""
    rows = []
    for true in dict.fromkeys(outcome.true_causes[0] for outcome in outcomes):
        for side in sides_of(outcomes):
            own = [outcome for outcome in outcomes if outcome.true_causes[0] == true and outcome.window.side == side]
            wrong = Counter(one.reading.cause for one in own if not one.is_main_right)
            if own:
                rows.append([f"{true}, {side} px", *_right_cells(own),
                             ", ".join(f"{said} {count}" for said, count in wrong.most_common(4))])
    for side in sides_of(outcomes):
        rows.append([f"all, {side} px", *_right_cells([one for one in outcomes if one.window.side == side]), ""])
    for ground in grounds_of(outcomes) if len(grounds_of(outcomes)) > 1 else ():
        for side in sides_of(outcomes):
            own = [outcome for outcome in outcomes if outcome.window.imagery == ground and outcome.window.side == side]
            if own:
                rows.append([f"{ground}, {side} px", *_right_cells(own), ""])
    head = ["what was done", "windows", "right %", "true %", "all named %", "wrong"]
    print_table(f"Main causes, {title}", head, rows,
                "Right: the main cause is the main one of what was done; a feather that took less than 5 % need not\n"
                "  be named, and where images lie 0.7 px or more off each other their misfit is as right as it;\n"
                "  so is what came over the whole mosaic where that took half as much detail of the window or more.\n"
                "  True: the main cause is among what was done. All named: all that was done is.")


def _right_cells(own: Sequence[Outcome]) -> list[str]:
    rights = ([one.is_main_right for one in own], [one.is_true for one in own], [one.are_all_named for one in own])
    return [str(len(own)), *map(percent, rights)]


def print_operations(title: str, outcomes: Sequence[Outcome]) -> None:
    """Verdicts, causes and kept_1, operation by operation."""
    rows = []
    for name in dict.fromkeys(outcome.operation.name for outcome in outcomes):
        own = [outcome for outcome in outcomes if outcome.operation.name == name]
        verdicts = Counter(one.reading.verdict for one in own)
        causes = Counter(one.reading.cause for one in own)
        rows.append([
            name,
            " ".join(str(verdicts[word]) for word in ("significant", "reduced", "preserved", "not_comparable")),
            ", ".join(own[0].operation.true_causes),
            ", ".join(f"{cause} {count}" for cause, count in causes.most_common(3)),
            str(sum(one.is_main_right for one in own)),
            figure(median(one.reading.kept for one in own)),
            figure(median(one.truth for one in own)),
        ])
    print_table(f"Operations, {title}",
                ["operation", "s r p n", "true causes", "main causes found", "right", "kept_1", "truth"], rows,
                "s r p n: windows that are significant, reduced, preserved, not comparable. kept_1, truth: medians.")


def print_missing(title: str, outcomes: Sequence[Outcome]) -> None:
    """Whether a source that is missing is named, by its share of the pixels and by ground."""
    shares = sorted({outcome.operation.making.missing for outcome in outcomes} - {0.0})
    rows = []
    for ground in (*grounds_of(outcomes), "all"):
        for side in sides_of(outcomes):
            own = [one for one in outcomes if ground in (one.window.imagery, "all") and one.window.side == side]
            if own:
                rows.append([f"{ground}, {side} px", *(_named(own, part) for part in (*shares, 0.0))])
    print_table(f"Missing source named, {title}",
                ["ground, side", *(f"{part:.0%} missing" for part in shares), "none missing"], rows,
                "Shares of all windows in which it is among the causes.")


def _named(own: Sequence[Outcome], part: float) -> str:
    wanted = [one for one in own if one.operation.making.missing == part and (part or MISSING not in one.allowed)]
    return share(MISSING in one.reading.causes for one in wanted)


def print_tones(title: str, outcomes: Sequence[Outcome]) -> None:
    """Grey values and places of the sources against what was done to them."""
    found: dict[str, list[float]] = defaultdict(list)
    for outcome in outcomes:
        for what, error in outcome.tone_errors():
            found[what].append(error)
    rows = []
    for what, errors in found.items():
        values = np.abs(known(errors))
        figures = (np.median(values), np.percentile(values, 95), values.max()) if len(values) else (np.nan,) * 3
        rows.append([what, str(len(errors)), *map(figure, figures), str(len(errors) - len(values))])
    print_table(f"Measured less true, absolute, source by source, {title}",
                ["", "sources", "median", "95 %", "largest", "not measured"], rows)
