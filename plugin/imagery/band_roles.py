"""What the bands of a dataset are for."""
from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from osgeo import gdal

from .band_names import COLOURS


@dataclass(frozen=True)
class BandRoles:
    """How the bands of a dataset are to be used. Indices start at 0."""

    names: tuple[str, ...]
    indices: tuple[int, ...]
    alpha: int | None = None
    palette: np.ndarray | None = None
    """(entries, 4) red, green, blue, alpha of a paletted raster."""


def band_roles(dataset: gdal.Dataset) -> BandRoles:
    """Band roles from the colour interpretation.

    Where a raster of three bands or more names no red, green and blue, its first three are taken as
    such, and a fourth band without a name is near infrared.
    """
    colours = [
        gdal.GetColorInterpretationName(dataset.GetRasterBand(i + 1).GetColorInterpretation()).lower()
        for i in range(dataset.RasterCount)
    ]
    table = dataset.GetRasterBand(1).GetColorTable()
    if len(colours) == 1 and colours[0] == "palette" and table is not None:
        entries = [table.GetColorEntry(i) for i in range(table.GetCount())]
        return BandRoles(COLOURS, (0,), palette=np.array(entries, dtype=np.uint8))
    alpha = colours.index("alpha") if "alpha" in colours else None
    measured = [i for i in range(len(colours)) if i != alpha]
    named = {colour: i for i, colour in reversed(list(enumerate(colours))) if colour in (*COLOURS, "nir")}
    if not named.keys() >= set(COLOURS) and len(measured) >= 3:
        named = dict(zip(COLOURS, measured))
    if named.keys() >= set(COLOURS) and "nir" not in named:
        unnamed = [i for i in measured if i not in named.values()]
        if unnamed:
            named["nir"] = unnamed[0]
    order = [named[role] for role in (*COLOURS, "nir") if role in named]
    order += [i for i in measured if i not in order]
    roles = {i: role for role, i in named.items()}
    return BandRoles(tuple(roles.get(i, f"band_{i + 1}") for i in order), tuple(order), alpha)
