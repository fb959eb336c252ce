"""The statistics of whole rasters against the bare GDAL read of all their pixels."""
from __future__ import annotations

from functools import partial
from pathlib import Path

import numpy as np
from osgeo import gdal
from seam_inspector.plugin.core.radiometry.assessment import assess
from seam_inspector.plugin.core.radiometry.rules import default_rules
from seam_inspector.plugin.core.radiometry.statistics import stream
from seam_inspector.plugin.core.rasters import Pixels, RasterRef

from .ground import COMPRESSED, FORMATS, Ground
from .timing import Goal, interleaved, print_table

MOST_OF_BARE_READ = 1.5


def bare_read(path: Path) -> np.ndarray:
    """All pixels by GDAL alone; the dataset is opened and closed, so no block is in the cache."""
    return gdal.Open(str(path)).ReadAsArray()


def histograms(path: Path) -> object:
    """Histograms and areas only."""
    pixels = Pixels(RasterRef(str(path)))
    image = pixels.image()
    return stream(pixels, image, image.whole)


def whole(path: Path) -> object:
    """All figures of the default rules."""
    pixels = Pixels(RasterRef(str(path)))
    image = pixels.image()
    return assess(pixels, image, image.whole, default_rules())


def run(ground: Ground, quick: bool) -> list[Goal]:
    """Print the streamed statistics of a mosaic against the bare read of the same pixels."""
    repetitions = 5 if quick else 15
    rows, goals = [], []
    for tile_format in FORMATS:
        path = ground.files[tile_format][0]
        calls = (partial(bare_read, path), partial(histograms, path), partial(whole, path))
        bare, streamed, all_figures = interleaved(calls, repetitions)
        ratio = all_figures.over(bare)
        rows.append([tile_format, bare.milliseconds, streamed.milliseconds, str(streamed.over(bare)),
                     all_figures.milliseconds, str(ratio), f"{all_figures.cpu_over(bare):.2f}"])
        if tile_format in COMPRESSED:
            text = f"radiometry of a whole raster, {tile_format}: times the bare read"
            goals.append(Goal(text, MOST_OF_BARE_READ, ratio.median, at_least=False))
    size = ground.pixels().shape
    print_table(
        f"Radiometry of a whole raster of {size[2]} x {size[1]} px, RGB, against the bare GDAL read",
        ["tiles of 256 px", "bare read", "statistics", "ratio (least-most)", "all figures", "ratio (least-most)",
         "CPU"],
        rows,
        f"Medians of {repetitions} interleaved repetitions, ratios pair by pair. Bare read: open and ReadAsArray of\n"
        "  everything at once. Statistics: blocks of a million pixels, one read ahead in a thread of its own,\n"
        "  histograms and areas. CPU: the last ratio in processor time. Goal: close to the bare read, taken as\n"
        f"  {MOST_OF_BARE_READ}.",
    )
    return goals
