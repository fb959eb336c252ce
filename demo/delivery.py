"""A delivery to decide on: twelve sheets of one mosaic, four of them spoilt along their seams in known ways.

    python -m demo.delivery FOLDER [--seed 16] [--sound]

The mosaic (400 x 300 m at 0.10 m, RGB, 8 bit) is cut hard along seams that meander between six orthoimages, three in
the north and three in the south, and delivered as twelve sheets of 100 x 100 m. In four sheets a part of the seam was
hidden: by feathers of 3, 6 and 12 m, and by a soft brush 3 m wide. ``--sound`` leaves the seams as they were cut.
The folder holds the sheets and their index (`sheets.gpkg`, field `location`), `mosaic.vrt` over all of them, the
orthoimages in `sources`, and `seamlines.gpkg`.
"""
from __future__ import annotations

import argparse
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Callable

import numpy as np
from osgeo import gdal, ogr
from scipy import ndimage

from .block import Points, add_feature, map_line, ramp, reference_system, write_image
from .camera import Box, Exposure, take
from .canvas import PIXEL, Curve
from .mosaic import assemble, balance
from .scene import make_scene

SHEET, COLUMNS, ROWS = 100.0, 4, 3  # m, sheets
EXTENT = (COLUMNS * SHEET, ROWS * SHEET)
OVERLAP, MARGIN = 40.0, 8.0  # m, beyond the seam, beyond the mosaic
SOFT_PX = 2.0  # sigma of the soft brush
EXPOSURES = (
    Exposure("n_0001.tif", shift=(0.9, -0.8), gain=(0.94, 0.96, 1.0), bias=(5, 5, 6)),
    Exposure("n_0002.tif", shift=(-0.8, 0.9)),
    Exposure("n_0003.tif", shift=(1.0, 0.7), gain=(1.04, 1.0, 0.96), falloff=(0.03, -0.02)),
    Exposure("s_0011.tif", shift=(-1.0, 0.8), gamma=1.04),
    Exposure("s_0012.tif", shift=(0.8, -0.9), gain=(0.97, 1.02, 1.0), falloff=(-0.03, 0.02)),
    Exposure("s_0013.tif", shift=(-0.9, -0.9), bias=(3, 3, 5)),
)


@dataclass(frozen=True)
class Spoilt:
    """A part of a seam that was hidden, from ``start`` to ``stop``: m along y for seams of a strip, else along x."""

    seam: str
    start: float
    stop: float
    width: float
    """Width of the feather, or of the brush, m."""
    soft: bool = False
    """Brushed soft instead of feathered."""


SPOILT = (
    Spoilt("north_1", 20.0, 80.0, width=3.0),
    Spoilt("between", 10.0, 95.0, width=6.0),
    Spoilt("between", 320.0, 380.0, width=12.0),
    Spoilt("south_2", 215.0, 285.0, width=3.0, soft=True),
)


@dataclass(frozen=True)
class Delivery:
    """The files of a delivery and the truth about it."""

    mosaic: Path
    sheets: tuple[Path, ...]
    index: Path
    sources: tuple[Path, ...]
    seamlines: Path
    seam_metres: float
    spoilt_metres: tuple[float, ...]
    """Length along the seam of each spoilt part, in the order of ``SPOILT``; none in a sound delivery."""


@dataclass(frozen=True)
class Seams:
    """The seams by name: x by y within the strips, y by x between them; lengths in metres."""

    curves: dict[str, Curve]

    def spans(self) -> dict[str, tuple[float, float]]:
        """Where each seam begins and ends, in the coordinate that its curve takes."""
        depth = EXTENT[1]
        spans = {"between": (0.0, EXTENT[0])}
        for name, curve in self.curves.items():
            if name != "between":
                y = _meeting(curve, self.curves["between"])
                spans[name] = (0.0, y) if name.startswith("north") else (y, depth)
        return spans

    def across(self, name: str, x: np.ndarray, y: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """How far each point lies beyond a seam (m, negative before it), and where along it (as ``spans``)."""
        curve = self.curves[name]
        beyond, along = (y - curve(x), x) if name == "between" else (x - curve(y), y)
        return np.broadcast_arrays(beyond, along)[0], along

    def points(self, name: str, start: float, stop: float) -> Points:
        """Vertices from the mosaic's corner (x, y), some two to the metre."""
        t = np.linspace(start, stop, max(int(2 * (stop - start)), 1) + 1)
        u = self.curves[name](t)
        pairs = zip(t.tolist(), u.tolist()) if name == "between" else zip(u.tolist(), t.tolist())
        return list(pairs)


def make_delivery(folder: str | Path, seed: int = 16, spoilt: tuple[Spoilt, ...] = SPOILT,
                  progress: Callable[[str], None] = lambda message: None) -> Delivery:
    """Draw the scene, photograph it, cut the mosaic, hide parts of its seams, write the sheets."""
    folder = Path(folder)
    (folder / "sources").mkdir(parents=True, exist_ok=True)
    rng = np.random.default_rng(seed)
    progress("Drawing the scene")
    scene = make_scene(EXTENT, MARGIN + 2.0, rng)
    seams = _seams(rng)
    images = []
    for exposure, box in zip(EXPOSURES, _footprints()):
        progress(f"Taking orthoimage {exposure.name}")
        images.append(take(scene, exposure, box, rng))
        write_image(folder / "sources" / exposure.name, images[-1].pixels, images[-1].left, images[-1].top)
    del scene  # hundreds of megabytes
    progress("Assembling the mosaic")
    mosaic = assemble(images, balance(images), {}, lambda x, y: _weights(seams, spoilt, x, y), EXTENT)
    for one in spoilt:
        if one.soft:
            _brush(mosaic, seams, one)
    progress("Writing the sheets")
    sheets = _write_sheets(folder, mosaic)
    gdal.BuildVRT(str(folder / "mosaic.vrt"), [str(sheet) for sheet in sheets]).FlushCache()
    _write_index(folder / "sheets.gpkg", sheets)
    lengths = _write_seamlines(folder / "seamlines.gpkg", seams)
    return Delivery(
        folder / "mosaic.vrt", sheets, folder / "sheets.gpkg",
        tuple(folder / "sources" / one.name for one in EXPOSURES), folder / "seamlines.gpkg", sum(lengths),
        tuple(_length(seams.points(one.seam, one.start, one.stop)) for one in spoilt),
    )


def _seams(rng: np.random.Generator) -> Seams:
    def meander(middle: float) -> Curve:
        phases = rng.uniform(0, 2 * np.pi, 3)

        def curve(t: np.ndarray) -> np.ndarray:
            waves = ((4.0, 84.0), (1.5, 33.0), (0.5, 11.0))
            return middle + sum(
                size * np.sin(2 * np.pi * np.asarray(t) / length + phase)
                for (size, length), phase in zip(waves, phases)
            )
        return curve

    places = {"between": 150.0, "north_1": 133.0, "north_2": 267.0, "south_1": 145.0, "south_2": 255.0}
    return Seams({name: meander(place) for name, place in places.items()})


def _meeting(curve: Curve, between: Curve) -> float:
    """y where a strip's seam meets the seam between the strips, by fixed-point iteration."""
    y = EXTENT[1] / 2
    for _ in range(80):
        y = 0.5 * (y + float(between(curve(np.float64(y)))))
    return y


def _footprints() -> Iterator[Box]:
    width, depth = EXTENT
    for top, bottom in ((-MARGIN, depth / 2 + OVERLAP), (depth / 2 - OVERLAP, depth + MARGIN)):
        edges = (-MARGIN, width / 3, 2 * width / 3, width + MARGIN)
        for number, (left, right) in enumerate(zip(edges, edges[1:])):
            yield Box(left - (OVERLAP if number else 0), top, right + (OVERLAP if number < 2 else 0), bottom)


def _weights(seams: Seams, spoilt: tuple[Spoilt, ...], x: np.ndarray, y: np.ndarray) -> dict[str, np.ndarray]:
    """Share of each source in the mosaic."""
    beyond = {}
    for name in seams.curves:
        distance, along = seams.across(name, x, y)
        share = (distance >= 0).astype(np.float32)
        for one in spoilt:
            if one.seam == name and not one.soft:
                share = np.where((along >= one.start) & (along < one.stop), ramp(distance / one.width), share)
        beyond[name] = share
    south, shares = beyond["between"], {}
    for strip, part, names in (("north", 1 - south, EXPOSURES[:3]), ("south", south, EXPOSURES[3:])):
        first, second = beyond[f"{strip}_1"], beyond[f"{strip}_2"]
        for exposure, share in zip(names, (1 - first, first * (1 - second), first * second)):
            shares[exposure.name] = (part * share).astype(np.float32)
    return shares


def _brush(mosaic: np.ndarray, seams: Seams, one: Spoilt) -> None:
    """Blur what lies within half a width of a seam, in place."""
    x, y = ((np.arange(size) + 0.5) * PIXEL for size in (mosaic.shape[2], mosaic.shape[1]))
    distance, along = seams.across(one.seam, x[np.newaxis], y[:, np.newaxis])
    brushed = (np.abs(distance) <= one.width / 2) & (along >= one.start) & (along < one.stop)
    for band in mosaic:
        soft = ndimage.gaussian_filter(band.astype(np.float32), SOFT_PX)
        band[brushed] = np.rint(soft[brushed])


def _write_sheets(folder: Path, mosaic: np.ndarray) -> tuple[Path, ...]:
    side, sheets = round(SHEET / PIXEL), []
    for row in range(ROWS):
        for column in range(COLUMNS):
            path = folder / f"sheet_{row + 1}_{column + 1}.tif"
            part = mosaic[:, row * side:(row + 1) * side, column * side:(column + 1) * side]
            write_image(path, part, column * SHEET, row * SHEET)
            sheets.append(path)
    return tuple(sheets)


def _write_index(path: Path, sheets: tuple[Path, ...]) -> None:
    """Outlines of the sheets, as gdaltindex writes them."""
    path.unlink(missing_ok=True)
    package = ogr.GetDriverByName("GPKG").CreateDataSource(str(path))
    layer = package.CreateLayer("sheets", reference_system(), ogr.wkbPolygon)
    layer.CreateField(ogr.FieldDefn("location", ogr.OFTString))
    for number, sheet in enumerate(sheets):
        left, top = number % COLUMNS * SHEET, number // COLUMNS * SHEET
        ring = map_line([(left, top), (left + SHEET, top), (left + SHEET, top + SHEET), (left, top + SHEET)],
                        ogr.wkbLinearRing)
        ring.CloseRings()
        outline = ogr.Geometry(ogr.wkbPolygon)
        outline.AddGeometry(ring)
        add_feature(layer, outline, {"location": sheet.name})


def _write_seamlines(path: Path, seams: Seams) -> list[float]:
    """Write one line for each seam; the lengths of all."""
    path.unlink(missing_ok=True)
    package = ogr.GetDriverByName("GPKG").CreateDataSource(str(path))
    layer = package.CreateLayer("seamlines", reference_system(), ogr.wkbLineString)
    lengths = []
    for name, (start, stop) in seams.spans().items():
        points = seams.points(name, start, stop)
        lengths.append(_length(points))
        add_feature(layer, map_line(points, ogr.wkbLineString), {})
    return lengths


def _length(points: Points) -> float:
    """m."""
    return float(np.hypot(*np.diff(np.array(points), axis=0).T).sum())


def main() -> None:
    """Command line: write the delivery into a folder."""
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("folder", type=Path)
    parser.add_argument("--seed", type=int, default=16)
    parser.add_argument("--sound", action="store_true", help="leave all seams as they were cut")
    arguments = parser.parse_args()
    made = make_delivery(arguments.folder, arguments.seed, () if arguments.sound else SPOILT, print)
    print(f"{made.seam_metres:.0f} m of seam, spoilt: " + ", ".join(f"{metre:.0f} m" for metre in made.spoilt_metres))


if __name__ == "__main__":
    main()
