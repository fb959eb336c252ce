"""Round numbers of axes and scale bars."""
from __future__ import annotations

import math

_BARELY = 1e-9  # relative: of a number that is round but for its last digits


def round_below(value: float) -> float:
    """The largest of 1, 2 and 5 times a power of ten that is not above a value."""
    decade = 10.0 ** math.floor(math.log10(value))
    return max(digit * decade for digit in (1, 2, 5) if digit * decade <= value * (1 + _BARELY))


def even_ticks(low: float, high: float, most: float) -> list[float]:
    """Ticks of a linear axis: round numbers in even steps, about as many as ``most``."""
    least = (high - low) / most
    decade = 10.0 ** math.floor(math.log10(least))
    step = next(digit * decade for digit in (1, 2, 5, 10) if digit * decade >= least * (1 - _BARELY))
    return [step * number for number in range(math.ceil(low / step), math.floor(high / step) + 1)]


def decade_ticks(low: float, high: float, most: float) -> list[float]:
    """Ticks of a logarithmic axis: 1, 2, 5, 10, or fewer, until there are no more than ``most``."""
    first, last = math.floor(math.log10(low)), math.ceil(math.log10(high))
    ticks: list[float] = []
    for digits, step in (((1, 2, 5), 1), ((1, 3), 1), ((1,), 1), ((1,), 2), ((1,), 3)):
        numbers = (digit * 10.0**decade for decade in range(last, first - 1, -step) for digit in digits)
        ticks = sorted(number for number in numbers if low * (1 - _BARELY) <= number <= high)
        if len(ticks) <= most:
            break
    return ticks
