"""Limits and defaults that several files here share, each with its source; names of bands, and which is judged.

Plain Python, so that tables are read and the toolbox is filled without numpy and GDAL.
"""
from __future__ import annotations

import math
import os
import reprlib
from collections.abc import Iterable, Sequence
from dataclasses import fields
from numbers import Integral, Real

from . import messages
from .errors import SettingsError

# The decomposition
DEFAULT_WAVELET = "coif3"  # Pyka 2009: Coiflet of order 3
DEFAULT_LEVELS = 3  # Pyka 2010, section 5: three levels, 1024 px down to 128 px
MIN_LEVELS = 1
WAVELETS = (  # the orthogonal ones of PyWavelets (dmey is not, by 0.2 %); so the toolbox lists them without loading it
    "haar",
    *(f"db{n}" for n in range(1, 39)),
    *(f"sym{n}" for n in range(2, 21)),
    *(f"coif{n}" for n in range(1, 18)),
)
MAX_LEVELS = 8  # 256 px a coarse pixel: beyond it no window of about 100 m is left

# The windows
STANDARD_SIDE_M = 100.0  # Pyka 2010, section 5: rectangles with sides a little over 100 m
MIN_SIDE_PX = 64  # below it a level-3 component has fewer than 8 x 8 coefficients

# The pixels
MAX_INVALID_SHARE = 0.001  # filled with the mean up to here; 0.1 % moves a share by less than 0.001 of itself
MAX_PIXEL_SIZE_DIFFERENCE = 0.01  # relative; 10 px over a window of 1024 px
MAX_WINDOW_PIXELS = 8192 * 8192  # 67 million: some 2 GB while it is measured
MAX_AVERAGED_PIXELS = 2**30  # of a finer source in a window: averaging more takes minutes

# The verdict
MIN_SHARE = 1e-20  # of the variance: smaller ones are rounding of float64, and ratios to them mean nothing
MAX_SIGNIFICANT_RATIO = 0.5  # Pyka 2010, section 5: detail at level 1 at least halved in the visible cases
LUMINANCE_WEIGHTS = (0.299, 0.587, 0.114)  # red, green, blue; ITU-R BT.601, Pyka 2009
MAX_REASONS = 3  # sources named in the reason of a window; more would not be read
MOST_BLOCK_BYTES = 250_000_000  # of all bands: GDAL holds two whole for each thread, whatever is read of them
MOST_READ_BYTES = 1_000_000_000  # at once; a window of 16 million pixels has less, with many bands too
MOST_PIXELS = 10**13  # a country of 300 000 km2 at 0.2 m
LARGEST_VALUE = 1e15  # beyond it no pixel is a measurement, and sums of squares leave float32
COLOURS = ("red", "green", "blue")
LUMINANCE = "luminance"

PATH_TYPES = (str, os.PathLike)
_NUMBERS: dict[type, tuple[type, str]] = {int: (Integral, "a whole number"), float: (Real, "a finite number")}
_MADE_BY = {
    "Block": "open_block", "WindowRequest": "Block.window", "WindowResult": "inspect_window", "ScanResult": "scan",
    "AcceptanceRules": "limit_rules",
}  # types that nobody makes by their names


def check_type(name: str, value: object, *types: type) -> None:
    """Raise SettingsError unless a value that a caller gave is of one of these types, numbers finite and no bool."""
    allowed = [_NUMBERS.get(kind, (kind, kind.__name__)) for kind in types]
    is_endless = isinstance(value, Real) and not math.isfinite(value)
    is_truth = isinstance(value, bool) and bool not in types
    if is_endless or is_truth or not any(isinstance(value, kind) for kind, _ in allowed):
        words = " / ".join(f"{word} of {_MADE_BY[word]}(...)" if word in _MADE_BY else word for _, word in allowed)
        shown = reprlib.repr(value) if isinstance(value, (str, Real, type(None))) else type(value).__name__
        raise SettingsError(messages.NOT_OF_TYPE(name=name, value=shown, expected=words))


def check_settings(settings: object, kind: type) -> None:
    """Raise SettingsError unless settings are of a class, and its fields of the types of their standard values."""
    check_type("settings", settings, kind)
    for field in fields(kind):
        check_type(field.name, getattr(settings, field.name), type(field.default))


def has_colours(names: Sequence[str]) -> bool:
    """Whether the first three bands are red, green and blue, so that there is a luminance to mix."""
    return tuple(names[:3]) == COLOURS


def measured_bands(names: Sequence[str]) -> tuple[str, ...]:
    """What is measured of such bands: their luminance first where there is one."""
    return (LUMINANCE, *names) if has_colours(names) else tuple(names)


def judged_band(measured: Iterable[str]) -> str:
    """The band that a verdict is taken from: luminance where it was measured, else the first."""
    names = list(measured)
    return LUMINANCE if LUMINANCE in names else names[0]
