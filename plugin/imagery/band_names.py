"""Names of bands, and which of them is judged. Plain Python, so that tables are read without numpy and GDAL."""
from __future__ import annotations

from collections.abc import Iterable, Sequence

COLOURS = ("red", "green", "blue")
LUMINANCE = "luminance"


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
