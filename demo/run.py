"""The main job on a demonstration block, or on the reader's own rasters: `make demo [DATA=folder]`.

Leaves in the output folder: windows.gpkg (layers placed and inspected), curves.csv, pairs.csv, profiles.csv,
report.html and curves.png, and prints what was found in each window, and of three a table like table 1 of Pyka 2010.
A folder of one's own holds one or more mosaics (mosaic*.tif), the orthoimages (all other rasters that can be one) and
the seamlines (seam*.gpkg, .shp or .geojson).
"""
from __future__ import annotations

import argparse
import json
import sys
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from osgeo import gdal
from qgis.core import QgsApplication, QgsProcessingContext, QgsProcessingFeedback, QgsVectorLayer
from seam_inspector.plugin.imagery import limits as imagery_limits
from seam_inspector.plugin.imagery.clips import read_overview
from seam_inspector.plugin.imagery.errors import SeamInspectorError
from seam_inspector.plugin.imagery.open_raster import describe, describe_mosaic
from seam_inspector.plugin.imagery.rasters import RasterRef
from seam_inspector.plugin.provider import SeamInspectorProvider
from seam_inspector.plugin.seams.measure.limits import MEASURABLE_SIDE_PX

from demo.block import Damage, make_block
from demo.canvas import Extent
from demo.findings import print_table, print_windows, read_curves, read_profiles, read_windows, representative
from demo.pictures import draw
from demo.project import write_project

RASTERS = {".tif", ".tiff", ".jp2", ".vrt", ".img", ".png", ".jpg"}
DONE = "done"  # the file that says that a folder of generated data is whole
EXTENT: Extent = (500.0, 400.0)  # m
VECTORS = {".gpkg", ".shp", ".geojson"}
FEWEST_VALUES = 32  # in an orthoimage; labels and masks have fewer
PROJECT = "block.qgz"
LOOK_PX = 512  # longer side of the overview in which they are counted


@dataclass(frozen=True)
class Inputs:
    """What is inspected."""

    mosaic: Path
    sources: tuple[Path, ...]
    seamlines: Path
    damage: tuple[Damage, ...] | None = None
    """Where the mosaicking was overdone; None where nobody knows."""


class Log(QgsProcessingFeedback):
    """What the algorithms say, for standard output."""

    def __init__(self) -> None:
        super().__init__()
        self.lines: list[str] = []

    def pushInfo(self, info: str) -> None:  # noqa: N802
        self.lines.append(f"    {info}")

    def pushWarning(self, warning: str) -> None:  # noqa: N802
        self.lines.append(f"    ! {warning}")

    def reportError(self, error: str, fatalError: bool = False) -> None:  # noqa: N802
        self.lines.append(f"    !! {error}")


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--output", type=Path, required=True, help="folder for the results")
    parser.add_argument("--data", type=Path, help="folder with mosaic*.tif, seam*.gpkg and the orthoimages")
    parser.add_argument("--side", type=float, help="window side in metres (100)")
    parser.add_argument("--spacing", type=float, help="metres along the seam (twice the side)")
    arguments = parser.parse_args()
    gdal.UseExceptions()  # GDAL 3.7 warns whoever leaves it open
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


def make_demonstration(folder: Path, extent_m: Extent = EXTENT) -> Inputs:
    """The generated block, made once."""
    done = folder / DONE
    if not done.exists():
        block = make_block(folder, extent_m, progress=print)
        done.write_text(json.dumps([(one.cause, one.bounds) for one in block.damage]), encoding="utf-8")
    sources = sorted(path for path in folder.glob("*.tif") if path.name != "mosaic.tif")
    damage = (Damage(cause, tuple(bounds)) for cause, bounds in json.loads(done.read_text(encoding="utf-8")))
    mosaic, seamlines, project = folder / "mosaic.tif", folder / "seamlines.gpkg", folder / PROJECT
    if not project.exists():
        write_project(project, mosaic, sources, seamlines)
    return Inputs(mosaic, tuple(sources), seamlines, tuple(damage))


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
    package, curves, profiles = output / "windows.gpkg", output / "curves.csv", output / "profiles.csv"
    for wide in [side] if side else fitting_sides(job.mosaic):
        package.unlink(missing_ok=True)
        if place(job, package, wide, spacing or 2 * wide):  # as the desk does
            break
    else:
        print("No window has room on the mosaic.")
        return
    print(f"Inspecting them against {len(job.sources)} orthoimages")
    images = {"MOSAIC": str(job.mosaic), "SOURCES": [str(path) for path in job.sources]}
    tables = {"CURVES": str(curves), "PAIRS": str(output / "pairs.csv")}
    tell(run(
        "inspectwindows",
        WINDOWS=f"{package}|layername=placed",
        OUTPUT=f"ogr:dbname='{package}' table=\"inspected\" (geom)",
        PROFILES=str(profiles),
        **images,
        **tables,
    ))  # fmt: skip
    found = f"{package}|layername=inspected"
    tell(run("report", WINDOWS=found, OUTPUT=str(output / "report.html"), PROFILES=str(profiles), **images, **tables))
    inspected = read_windows(found)
    chosen = representative(inspected, job.damage)
    if not chosen:
        print("No window could be compared.")
        return
    by_window = read_curves(curves)
    draw(chosen, read_profiles(profiles), by_window, job.mosaic, job.sources, output / "curves.png")
    print_table(chosen, by_window)
    print_windows(inspected, job.damage)
    print(f"\nResults are in {output}: windows.gpkg, curves.csv, pairs.csv, profiles.csv, curves.png, report.html")
    if job.damage is not None:
        print(f"To do it by hand open {job.mosaic.with_name(PROJECT)} in QGIS: docs/start/first_inspection.md")


def place(job: Inputs, package: Path, side: float, spacing: float) -> int:
    """Place windows along the seams; how many had room."""
    print(f"Placing windows of {side:.4g} m along the seams of {job.mosaic.name}")
    seamlines = f"{job.seamlines}|layername=seamlines" if has_layer(job.seamlines, "seamlines") else job.seamlines
    log = run(
        "placewindows",
        SEAMLINES=str(seamlines),
        MOSAIC=str(job.mosaic),
        SIDE=side,
        SPACING=spacing,
        OUTPUT=f"ogr:dbname='{package}' table=\"placed\" (geom)",
    )
    count = int(QgsVectorLayer(f"{package}|layername=placed", "placed", "ogr").featureCount())
    if count:
        tell(log)
    else:
        print("    0 windows placed: none of this side has room.")
    return count


def fitting_sides(mosaic: Path) -> Iterator[float]:
    """100 m, or 256 px where these are longer, at most a quarter of the mosaic; then half as much again and again, for
    one that is a narrow strip."""
    raster = describe_mosaic(RasterRef(str(mosaic)))
    grid = raster.grid
    shorter = min(grid.columns * grid.metres_x * grid.pixel_width, grid.rows * grid.metres_y * grid.pixel_height)
    pixel = raster.ground_sample_distance
    side = min(max(imagery_limits.STANDARD_SIDE_M, MEASURABLE_SIDE_PX * pixel), shorter / 4)
    shortest = imagery_limits.MIN_SIDE_PX * pixel
    yield max(side, shortest)
    while (side := side / 2) >= shortest:
        yield side


def has_layer(path: Path, name: str) -> bool:
    """Whether a vector file has a layer of that name."""
    return gdal.OpenEx(str(path), gdal.OF_VECTOR).GetLayerByName(name) is not None


def tell(log: Log) -> None:
    """What an algorithm said."""
    print(*log.lines, sep="\n")


def run(name: str, **parameters: Any) -> Log:
    """Run one of our algorithms; what it said."""
    algorithm = QgsApplication.processingRegistry().createAlgorithmById(f"seaminspector:{name}")
    context, feedback = QgsProcessingContext(), Log()
    acceptable, why = algorithm.checkParameterValues(parameters, context)
    if not acceptable:
        raise SystemExit(why)
    if not algorithm.run(parameters, context, feedback)[1]:
        tell(feedback)
        raise SystemExit(f"{name} failed.")
    return feedback


if __name__ == "__main__":
    sys.exit(main())
