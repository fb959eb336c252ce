"""Which detail coefficients see only the clip itself, and not its opposite border.

The decomposition is periodised: beyond the last column comes the first. Where the two differ, as on any ramp, the
coefficients beside the border hold that step. They are part of the curve, whose shares have to add up, but say nothing
of noise.
"""
from __future__ import annotations

import pywt


def inner_ranges(length: int, wavelet: str, levels: int) -> list[slice]:
    """For level 1 (finest), 2, ..., R along an axis of ``length`` pixels: the coefficients free of the wrap-around.

    An empty slice where there is none. Coefficient k of a level is made of the samples 2 k + 1 - L/2 to 2 k + L/2 of
    the level before, L the filter's length.
    """
    half = pywt.Wavelet(wavelet).dec_len // 2
    first, last = 0, length - 1
    ranges = []
    for _ in range(levels):
        first, last = (first + half) // 2, (last - half) // 2  # the first rounded up: (first + half - 1) / 2
        ranges.append(slice(first, max(last + 1, first)))
    return ranges
