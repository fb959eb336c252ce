"""The statistics of whole rasters against the bare GDAL read of all their pixels."""
from __future__ import annotations

import tempfile
from functools import partial
from pathlib import Path

import numpy as np
from osgeo import gdal
from seam_inspector.plugin.imagery.open_raster import OpenRaster
from seam_inspector.plugin.imagery.rasters import RasterRef
from seam_inspector.plugin.radiometry.measure.assessment import judge
from seam_inspector.plugin.radiometry.measure.image_statistics import known_range, stream_statistics
from seam_inspector.plugin.radiometry.measure.measured_image import measure
from seam_inspector.plugin.radiometry.measure.rules import DEFAULT_RULES, load_rules, ready_rule_files

from .ground import COMPRESSED, FORMATS, TILES, Ground
from .timing import Goal, interleaved, print_table

MOST_OF_BARE_READ = 1.5
TIMES = 3


def large_rasters(ground: Ground, folder: Path) -> dict[str, Path]:
    """The mosaic three times side by side and three times below, 44 million pixels, in every format."""
    pixels = np.tile(ground.pixels(), (1, TIMES, TIMES))
    memory = gdal.GetDriverByName("MEM").Create("", pixels.shape[2], pixels.shape[1], len(pixels), gdal.GDT_Byte)
    memory.WriteArray(pixels)
    paths = {}
    for tile_format, options in FORMATS.items():
        paths[tile_format] = folder / f"large_{tile_format.replace(' ', '_').lower()}.tif"
        gdal.Translate(str(paths[tile_format]), memory, creationOptions=TILES + options)
    return paths


def bare_read(path: Path) -> None:
    """All pixels by GDAL alone, tile row by tile row, so that memory is flat; the cache is empty as it is new."""
    dataset = gdal.Open(str(path))
    height = dataset.GetRasterBand(1).GetBlockSize()[1]
    for top in range(0, dataset.RasterYSize, height):
        dataset.ReadAsArray(0, top, dataset.RasterXSize, min(height, dataset.RasterYSize - top))


def histograms(path: Path) -> object:
    """Histograms of all bands and areas only."""
    source = OpenRaster(RasterRef(str(path)))
    names = source.raster.band_names
    return stream_statistics(source, source.raster.whole, names, names)


def whole(path: Path) -> object:
    """All figures of the default rules, of the luminosity where they say so."""
    source = OpenRaster(RasterRef(str(path)))
    rules = load_rules(ready_rule_files()[DEFAULT_RULES])
    measured = measure(source, source.raster.whole, rules)
    assert measured is not None
    of_image = known_range(source.raster, measured.largest_value, None)
    assert of_image is not None
    return judge(measured, rules, of_image)


def run(ground: Ground, quick: bool) -> list[Goal]:
    """Print the streamed statistics of a large raster against the bare read of the same pixels."""
    with tempfile.TemporaryDirectory(prefix="seam_inspector_") as folder:
        return _run(large_rasters(ground, Path(folder)), 2 if quick else 4)


def _run(paths: dict[str, Path], repetitions: int) -> list[Goal]:
    rows, goals = [], []
    for tile_format, path in paths.items():
        calls = (partial(bare_read, path), partial(histograms, path), partial(whole, path))
        bare, streamed, all_figures = interleaved(calls, repetitions)
        ratio = all_figures.over(bare)
        rows.append([tile_format, bare.milliseconds, streamed.milliseconds, str(streamed.over(bare)),
                     all_figures.milliseconds, str(ratio), f"{all_figures.cpu_over(bare):.2f}"])
        if tile_format in COMPRESSED:
            text = f"radiometry of a whole raster, {tile_format}: times the bare read"
            goals.append(Goal(text, MOST_OF_BARE_READ, ratio.median, at_least=False))
    dataset = gdal.Open(str(path))
    print_table(
        f"Radiometry of a whole raster of {dataset.RasterXSize} x {dataset.RasterYSize} px, RGB, against the bare read",
        ["tiles of 256 px", "bare read", "statistics", "ratio (least-most)", "all figures", "ratio (least-most)",
         "CPU"],
        rows,
        f"Medians of {repetitions} interleaved repetitions, ratios pair by pair. Bare read: by GDAL alone, tile row\n"
        "  by tile row. Statistics: blocks of a million pixels, one read ahead in a thread of its own, histograms\n"
        "  and areas. CPU: the last ratio in processor time. Goal: close to the bare read, taken as\n"
        f"  {MOST_OF_BARE_READ}.",
    )
    return goals
