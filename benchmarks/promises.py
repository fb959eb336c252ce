"""What the detection promises, beside what was measured: the last table of `make benchmark-detection`."""
from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence

import numpy as np

from .cause_tables import MISSING
from .figures import area, known, median, sides_of
from .kept_tables import TAKE_DETAIL, lost_of_group
from .misfit_cases import is_misfit, is_right_case
from .operations import KINDS
from .outcomes import Outcome
from .timing import print_table

MOST_ERROR = {512: 0.02, 256: 0.03, 128: 0.05}
INTERVALS = (92.0, 98.0)
MANY = 100
"""Windows of a row, for its intervals to be called too wide."""
LEAST_VERDICTS = {512: 99.0, 256: 97.0, 128: 85.0}
LEAST_AREAS = {
    ("13 px", 256): 0.985, ("33 px and more", 256): 0.99, ("13 px", 128): 0.97, ("33 px and more", 128): 0.97,
}
LEAST_RIGHT = {512: 97.0, 256: 92.0}
MOST_BELOW_1, LEAST_FITS, LEAST_MISSING, MOST_FALSE, NAMED_FROM = 3.0, 95.0, 95.0, 3.0, 0.15

Row = tuple[str, str, float, Callable[[float], bool]]
"""What, the promise in words, what was measured, whether that holds it."""


def print_promises(title: str, outcomes: Sequence[Outcome]) -> None:
    """One line for each; of errors and intervals the worst row counts."""
    misfits, found = [one for one in outcomes if is_misfit(one)], [one for one in outcomes if not is_misfit(one)]
    rows: list[Row] = []
    for side in sides_of(found):
        rows += _of_side(side, [one for one in found if one.window.side == side])
    rows += [*_of_all(found), *_of_misfits(misfits)]
    cells = [[what, goal, f"{value:.3g}", "yes" if holds(value) else "NO"] for what, goal, value, holds in rows
             if not np.isnan(value)]
    print_table(f"Promises, {title}", ["", "promised", "measured", "held"], cells)


def _of_side(side: int, own: Sequence[Outcome]) -> Iterable[Row]:
    measured = [one for one in own if one.is_measured]
    of_kinds = [[one for one in measured if one.operation.making.kind == making.kind] for making in KINDS]
    errors = [abs(median(one.error for one in of_kind)) for of_kind in of_kinds if of_kind]
    rights = [_percent(one.holds_truth for one in of_kind) for of_kind in of_kinds if of_kind]
    most, (low, high) = MOST_ERROR[side], INTERVALS
    yield f"{side} px: largest median error of a row", f"<= {most:g}", max(errors, default=np.nan), _at_most(most)
    yield f"{side} px: least share of intervals right", f">= {low:g} %", min(rights, default=np.nan), _at_least(low)
    many = [_percent(one.holds_truth for one in of_kind) for of_kind in of_kinds if len(of_kind) >= MANY]
    yield f"{side} px: largest share of intervals right", f"<= {high:g} %", max(many, default=np.nan), _at_most(high)
    with_texture = [one for one in own if one.window.has_texture and not one.foreign]
    least = LEAST_VERDICTS[side]
    yield (f"{side} px: windows with texture and a verdict", f">= {least:g} %",
           _percent(one.reading.has_verdict for one in with_texture), _at_least(least))
    hard = known(one.reading.kept for one in own if one.operation.making.group == "hard")
    for (group, of_side), wanted in LEAST_AREAS.items():
        if of_side == side:
            spoilt = known(one.reading.kept for one in own if lost_of_group(group)(one))
            yield f"{side} px: area for {group} that lost", f">= {wanted:g}", area(hard, spoilt), _at_least(wanted)
    if side in LEAST_RIGHT:
        right = _percent(one.is_main_right for one in own)
        yield f"{side} px: main cause right", f">= {LEAST_RIGHT[side]:g} %", right, _at_least(LEAST_RIGHT[side])


def _of_all(found: Sequence[Outcome]) -> Iterable[Row]:
    hard = [one for one in found if one.operation.making.group == "hard"]
    sound = [one for one in hard if one.operation.aftermath.cause not in TAKE_DETAIL]
    below = _percent(one.reading.high < 1 for one in hard if one.has_kept)
    yield ("sound hard cuts that are significant", "0 %",
           _percent(one.reading.verdict == "significant" for one in sound), _at_most(0))
    yield "hard cuts surely below 1", f"<= {MOST_BELOW_1:g} %", below, _at_most(MOST_BELOW_1)
    missing = [one for one in found if one.operation.making.missing >= NAMED_FROM]
    named = _percent(MISSING in one.reading.causes for one in missing)
    yield (f"missing source of {NAMED_FROM:.0%} or more named", f">= {LEAST_MISSING:g} %", named,
           _at_least(LEAST_MISSING))
    false = _percent(MISSING in one.reading.causes for one in found if MISSING not in one.allowed)
    yield "missing source named where none is", f"<= {MOST_FALSE:g} %", false, _at_most(MOST_FALSE)


def _of_misfits(misfits: Sequence[Outcome]) -> Iterable[Row]:
    right = _percent(map(is_right_case, misfits))
    yield "misregistration as placed right", f">= {LEAST_FITS:g} %", right, _at_least(LEAST_FITS)


def _percent(held: Iterable[bool]) -> float:
    values = list(held)
    return float(100 * np.mean(values)) if values else np.nan


def _at_most(limit: float) -> Callable[[float], bool]:
    return lambda value: value <= limit


def _at_least(limit: float) -> Callable[[float], bool]:
    return lambda value: value >= limit
