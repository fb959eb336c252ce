"""The main job on a demonstration block, or on the reader's own rasters: `make demo [DATA=folder]`.

Leaves in the output folder: windows.gpkg (layers placed and inspected), curves.csv, pairs.csv, curves.png, and
prints a table like table 1 of Pyka 2010. A folder of one's own holds one or more mosaics (mosaic*.tif), the
orthoimages (all other rasters that can be one) and the seamlines (seam*.gpkg, .shp or .geojson).
"""
from __future__ import annotations

import argparse
import csv
import sys
from collections import defaultdict
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from matplotlib.figure import Figure
from osgeo import gdal
from qgis.core import QgsApplication, QgsProcessingContext, QgsProcessingFeedback, QgsVectorLayer
from seam_inspector.plugin.imagery import grids
from seam_inspector.plugin.imagery import limits as imagery_limits
from seam_inspector.plugin.imagery.clips import read_clip, read_overview
from seam_inspector.plugin.imagery.errors import SeamInspectorError
from seam_inspector.plugin.imagery.open_raster import OpenRaster, describe, describe_mosaic
from seam_inspector.plugin.imagery.rasters import Raster, RasterRef
from seam_inspector.plugin.provider import SeamInspectorProvider
from seam_inspector.plugin.seams.charts.chart_curves import ChartCurve
from seam_inspector.plugin.seams.charts.curve_chart import draw_curves

from demo.block import make_block

RASTERS = {".tif", ".tiff", ".jp2", ".vrt", ".img", ".png", ".jpg"}
VECTORS = {".gpkg", ".shp", ".geojson"}
FEWEST_VALUES = 32  # in an orthoimage; labels and masks have fewer
LOOK_PX = 512  # longer side of the overview in which they are counted
PICTURE_PX = (220, 150)  # width and height of the mosaic and a source below the curves, at about 2x magnification


@dataclass(frozen=True)
class Inputs:
    """What is inspected."""

    mosaic: Path
    sources: tuple[Path, ...]
    seamlines: Path


@dataclass(frozen=True)
class Inspected:
    """One row of the inspected windows."""

    window_id: int
    verdict: str
    ratio_1: float
    extent: grids.Extent


class Log(QgsProcessingFeedback):
    """What the algorithms say, on standard output."""

    def pushInfo(self, info: str) -> None:  # noqa: N802
        print("   ", info)

    def pushWarning(self, warning: str) -> None:  # noqa: N802
        print("    !", warning)

    def reportError(self, error: str, fatalError: bool = False) -> None:  # noqa: N802
        print("    !!", error)


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--output", type=Path, required=True, help="folder for the results")
    parser.add_argument("--data", type=Path, help="folder with mosaic*.tif, seam*.gpkg and the orthoimages")
    parser.add_argument("--side", type=float, help="window side in metres (100)")
    parser.add_argument("--spacing", type=float, help="metres along the seam (twice the side)")
    arguments = parser.parse_args()
    application = QgsApplication([], False)
    application.initQgis()
    provider = SeamInspectorProvider()
    QgsApplication.processingRegistry().addProvider(provider)
    try:
        jobs = find_inputs(arguments.data) if arguments.data else [make_demonstration(arguments.output / "block")]
        for job in jobs:
            folder = arguments.output / job.mosaic.stem if len(jobs) > 1 else arguments.output
            inspect(job, folder, arguments.side, arguments.spacing)
    except SeamInspectorError as error:
        print(error, file=sys.stderr)
        return 1
    return 0


def make_demonstration(folder: Path) -> Inputs:
    """The generated block, made once."""
    done = folder / "done"
    if not done.exists():
        make_block(folder, progress=print)
        done.touch()
    sources = sorted(path for path in folder.glob("*.tif") if path.name != "mosaic.tif")
    return Inputs(folder / "mosaic.tif", tuple(sources), folder / "seamlines.gpkg")


def find_inputs(folder: Path) -> list[Inputs]:
    """The mosaics of a folder, each with all rasters that can be its orthoimages, and the seamlines."""
    if not folder.is_dir():
        raise SystemExit(f"{folder} is no folder.")
    files = sorted(path for path in folder.iterdir() if path.is_file())
    images = [path for path in files if path.suffix.lower() in RASTERS]
    mosaics = [path for path in images if path.name.lower().startswith("mosaic")]
    seamlines = [path for path in files if path.suffix.lower() in VECTORS and path.name.lower().startswith("seam")]
    if not mosaics or not seamlines:
        raise SystemExit(f"{folder} needs a raster named mosaic* and a vector file named seam*.")
    others = [path for path in images if path not in mosaics]
    jobs = []
    for mosaic in mosaics:
        sources = tuple(path for path in others if is_orthoimage(path, mosaic))
        if len(sources) < len(others):
            print("No orthoimages of", mosaic.name + ":", ", ".join(p.name for p in others if p not in sources))
        jobs.append(Inputs(mosaic, sources, seamlines[0]))
    return jobs


def is_orthoimage(path: Path, mosaic: Path) -> bool:
    """Whether a raster can be a source of a mosaic: on the map, with its colours, and no few values as labels have."""
    try:
        raster = describe_mosaic(RasterRef(str(path)))
        if describe(RasterRef(str(mosaic))).has_luminance and not raster.has_luminance:
            return False
        overview = read_overview(raster, raster.extent, LOOK_PX)
    except SeamInspectorError:
        return False
    return overview is None or len(np.unique(overview[0].bands)) >= FEWEST_VALUES  # none: too large for a look


def inspect(job: Inputs, output: Path, side: float | None, spacing: float | None) -> None:
    """Place windows, inspect them, draw and print what was found."""
    output.mkdir(parents=True, exist_ok=True)
    package, curves = output / "windows.gpkg", output / "curves.csv"
    for wide in [side] if side else fitting_sides(job.mosaic):
        package.unlink(missing_ok=True)
        if place(job, package, wide, spacing or wide):
            break
    else:
        print("No window has room on the mosaic.")
        return
    print(f"Inspecting them against {len(job.sources)} orthoimages")
    run(
        "inspectwindows",
        WINDOWS=f"{package}|layername=placed",
        MOSAIC=str(job.mosaic),
        SOURCES=[str(path) for path in job.sources],
        OUTPUT=f"ogr:dbname='{package}' table=\"inspected\" (geom)",
        CURVES=str(curves),
        PAIRS=str(output / "pairs.csv"),
    )
    inspected = read_windows(f"{package}|layername=inspected")
    chosen = representative(inspected)
    if not chosen:
        print("No window could be compared.")
        return
    by_window = read_curves(curves)
    draw(chosen, by_window, job, output / "curves.png")
    print_table(chosen, by_window)
    print(f"Results are in {output}: windows.gpkg, curves.csv, pairs.csv, curves.png")


def place(job: Inputs, package: Path, side: float, spacing: float) -> int:
    """Place windows along the seams; how many had room."""
    print(f"Placing windows of {side:.4g} m along the seams of {job.mosaic.name}")
    seamlines = f"{job.seamlines}|layername=seamlines" if has_layer(job.seamlines, "seamlines") else job.seamlines
    run(
        "placewindows",
        SEAMLINES=str(seamlines),
        MOSAIC=str(job.mosaic),
        SIDE=side,
        SPACING=spacing,
        OUTPUT=f"ogr:dbname='{package}' table=\"placed\" (geom)",
    )
    return int(QgsVectorLayer(f"{package}|layername=placed", "placed", "ogr").featureCount())


def fitting_sides(mosaic: Path) -> Iterator[float]:
    """100 m, or a quarter of a smaller mosaic; then half as much again and again, for one that is a narrow strip."""
    raster = describe_mosaic(RasterRef(str(mosaic)))
    grid = raster.grid
    shorter = min(grid.columns * grid.metres_x * grid.pixel_width, grid.rows * grid.metres_y * grid.pixel_height)
    side = min(imagery_limits.STANDARD_SIDE_M, shorter / 4)
    yield side
    while side / 2 >= imagery_limits.MIN_SIDE_PX * raster.ground_sample_distance:
        side /= 2
        yield side


def has_layer(path: Path, name: str) -> bool:
    """Whether a vector file has a layer of that name."""
    return gdal.OpenEx(str(path), gdal.OF_VECTOR).GetLayerByName(name) is not None


def run(name: str, **parameters: Any) -> None:
    """Run one of our algorithms."""
    algorithm = QgsApplication.processingRegistry().createAlgorithmById(f"seaminspector:{name}")
    context, feedback = QgsProcessingContext(), Log()
    acceptable, why = algorithm.checkParameterValues(parameters, context)
    if not acceptable:
        raise SystemExit(why)
    if not algorithm.run(parameters, context, feedback)[1]:
        raise SystemExit(f"{name} failed.")


def read_windows(uri: str) -> list[Inspected]:
    """The windows that could be compared, most spoilt first."""
    layer = QgsVectorLayer(uri, "inspected", "ogr")
    rows = []
    for feature in layer.getFeatures():
        if feature["verdict"] != "not_comparable":
            box = feature.geometry().boundingBox()
            extent = (box.xMinimum(), box.yMinimum(), box.xMaximum(), box.yMaximum())
            rows.append(Inspected(feature["window_id"], feature["verdict"], feature["ratio_1"], extent))
    return sorted(rows, key=lambda row: row.ratio_1)


def representative(inspected: list[Inspected]) -> list[Inspected]:
    """The best, the median and the worst window."""
    if len(inspected) < 3:
        return inspected[::-1]
    return [inspected[-1], inspected[len(inspected) // 2], inspected[0]]


def read_curves(path: Path) -> dict[int, list[ChartCurve]]:
    """The curves that decided each window's verdict: of luminance, or of the only band."""
    values: dict[tuple[int, str, bool, str], dict[tuple[str, int], float]] = defaultdict(dict)
    with open(path, newline="", encoding="utf-8") as file:
        for row in csv.DictReader(file):
            key = int(row["window_id"]), row["raster"], row["role"] == "mosaic", row["band"]
            values[key][row["component"], int(row["level"])] = float(row["relative_variance"] or "nan")
    bands = {band for _, _, _, band in values}
    decisive = "luminance" if "luminance" in bands else min(bands)
    curves = defaultdict(list)
    for (window, raster, is_mosaic, band), shares in values.items():
        if band == decisive:
            levels = len(shares) - 1
            detail = tuple(shares["detail", level] for level in range(1, levels + 1))
            curves[window].append(ChartCurve(raster, is_mosaic, detail, shares["background", levels]))
    return curves


def draw(chosen: Iterable[Inspected], curves: dict[int, list[ChartCurve]], job: Inputs, path: Path) -> None:
    """For each window its curves, and the mosaic beside the least sharp source at 2x."""
    chosen = list(chosen)
    figure = Figure(figsize=(4.6 * len(chosen), 9.4), layout="constrained")
    grid = figure.subplots(2, len(chosen), squeeze=False, gridspec_kw={"height_ratios": [0.72, 1.0]})
    mosaic = describe_mosaic(RasterRef(str(job.mosaic)))
    shares = [curve.detail[0] for window in chosen for curve in curves[window.window_id]]
    limits = min(shares) * imagery_limits.MAX_SIGNIFICANT_RATIO, 1.2
    for column, window in enumerate(chosen):
        chart, picture = grid[0][column], grid[1][column]
        draw_curves(chart, curves[window.window_id], imagery_limits.MAX_SIGNIFICANT_RATIO)
        chart.set_title(f"Window {window.window_id}: {window.verdict}, ratio {window.ratio_1:.2f}", fontweight="bold")
        chart.set_ylim(*limits)
        chart.legend(fontsize=7.5, frameon=False)
        draw_pictures(picture, window, curves[window.window_id], mosaic, job)
    figure.savefig(path, dpi=100)


def draw_pictures(axes: Any, window: Inspected, curves: list[ChartCurve], mosaic: Raster, job: Inputs) -> None:
    """The middle of a window in the mosaic and in the least sharp source, one above the other."""
    files = {path.name: path for path in job.sources}  # the composite is no file
    source = min((curve for curve in curves if curve.label in files), key=lambda curve: curve.detail[0]).label
    whole = grids.snap_window(mosaic.grid, window.extent)
    width, height = min(PICTURE_PX[0], whole.width), min(PICTURE_PX[1], whole.height)
    middle = grids.PixelWindow(
        whole.column + (whole.width - width) // 2, whole.row + (whole.height - height) // 2, width, height
    )
    clips = [read_clip(OpenRaster(RasterRef(str(file))), mosaic, middle) for file in (job.mosaic, files[source])]
    images = [np.moveaxis(clip.bands[[0, 1, 2] if clip.raster.has_luminance else [0, 0, 0]], 0, -1) for clip in clips]
    gap = np.full((4, width, 3), 255, dtype=np.uint8)
    axes.imshow(np.concatenate([stretched(images[0]), gap, stretched(images[1])]), interpolation="nearest")
    axes.set_title(f"above the mosaic, below {source}", fontsize=9)
    axes.axis("off")


def stretched(image: np.ndarray) -> np.ndarray:
    """To 8 bit for the eye, one stretch for all bands."""
    low, high = np.percentile(image, (1, 99))
    return np.clip((image - low) / max(high - low, 1) * 255, 0, 255).astype(np.uint8)


def print_table(chosen: Iterable[Inspected], curves: dict[int, list[ChartCurve]]) -> None:
    """Like table 1 of the paper: relative variances of the mosaic and its sources, window by window."""
    widest = max(len(curve.label) for rows in curves.values() for curve in rows)
    levels = len(next(iter(curves.values()))[0].detail)
    heads = [*(f"detail {level}" for level in range(1, levels + 1)), f"background {levels}"]
    line = "-" * (22 + widest + 14 * len(heads))
    print(f"\n{'window':22}{'raster':{widest}}" + "".join(f"{head:>14}" for head in heads), line, sep="\n")
    for window in chosen:
        titles = iter([f"{window.window_id} {window.verdict}", f"  ratio 1: {window.ratio_1:.2f}"])
        for curve in sorted(curves[window.window_id], key=lambda curve: not curve.is_mosaic):
            shares = "".join(f"{share:14.3f}" for share in (*curve.detail, curve.background))
            print(f"{next(titles, ''):22}{curve.label:{widest}}{shares}")
        print(line)


if __name__ == "__main__":
    sys.exit(main())
