"""Medians, shares and areas of many windows as the benchmark's tables print them."""
from __future__ import annotations

from collections.abc import Iterable, Sequence

import numpy as np

from .outcomes import Outcome


def area(sound: Sequence[float], spoilt: Sequence[float]) -> float:
    """Area under the ROC curve: how often a sound window has the higher figure, ties counted half."""
    difference = np.subtract.outer(np.asarray(sound), np.asarray(spoilt))
    return float(((difference > 0) + 0.5 * (difference == 0)).mean()) if difference.size else np.nan


def known(values: Iterable[float]) -> list[float]:
    """Without nan."""
    return [value for value in values if value == value]


def median(values: Iterable[float]) -> float:
    """Median of those that are known."""
    found = known(values)
    return float(np.median(found)) if found else np.nan


def figure(value: float) -> str:
    """With three decimals."""
    return "." if np.isnan(value) else f"{value:.3f}"


def percent(held: Iterable[bool]) -> str:
    """The share of those that hold."""
    values = list(held)
    return f"{100 * np.mean(values):.1f}" if values else "."


def share(held: Iterable[bool]) -> str:
    """The share of those that hold, and of how many."""
    values = list(held)
    return f"{np.mean(values):.1%} of {len(values)}" if values else "."


def sides_of(outcomes: Sequence[Outcome]) -> list[int]:
    """Largest first, px."""
    return sorted({outcome.window.side for outcome in outcomes}, reverse=True)


def grounds_of(outcomes: Sequence[Outcome]) -> list[str]:
    """In the order in which they came."""
    return list(dict.fromkeys(outcome.window.imagery for outcome in outcomes))
