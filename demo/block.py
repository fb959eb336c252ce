"""A photogrammetric block to show Seam Inspector on: orthoimages of one scene, their seamlines and their mosaic.

    python -m demo.block FOLDER [--seed 2010] [--extent 500 400]

Five overlapping orthoimages (0.10 m, RGB, 8 bit, nodata 0, EPSG:2180) lie in two strips: three in the north, two in
the south. Each has its own light, tone, blur, noise, misregistration and ragged, slightly turned footprint.
`strip1_0143` is a gap-filler (dolotka): flown on another day under high cloud, with a wide histogram, on a grid 0.3 px
off the mosaic's, and never tied to the other images. `mosaic.tif` comes from an ordinary line: tones balanced
in the overlaps, the shifts of the adjustment applied, bicubic resampling, a cut along `seamlines.gpkg`, a feather of
1.5 m. So the usual seam loses a little of its detail, as the usual seam does. In two places the line went too far:

- the seam between `strip1_0142` and the gap-filler is hidden by a feather 140 m wide, so that a whole window is the
  mean of two images that do not lie on each other;
- the light around the seam between `strip2_0212` and `strip2_0213` was evened out by a dodger that works on a blurred
  overview and gives back only a part of the detail.

Lengths scale with the extent, so a small block holds the same story.
"""
from __future__ import annotations

import argparse
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Callable

import numpy as np
from osgeo import gdal, ogr, osr

from .camera import Box, Exposure, Orthoimage, take
from .canvas import PIXEL, Curve, Extent
from .mosaic import Dodging, assemble, balance, dodge
from .scene import Scene, make_scene

EPSG = 2180
EASTING, NORTHING = 566200.0, 244700.0  # of the mosaic's upper left corner, south of Krakow
WIDTH = 500.0  # m; the extent that the lengths below are meant for
FEATHER, WIDE_FEATHER, OVERLAP, MARGIN = 1.5, 140.0, 184.0, 11.0  # m

FIRST, MIDDLE, GAP_FILLER = "strip1_0141.tif", "strip1_0142.tif", "strip1_0143.tif"
SOUTH_WEST, SOUTH_EAST = "strip2_0212.tif", "strip2_0213.tif"
EXPOSURES = (
    Exposure(MIDDLE, turn=0.6, shift=(0.42, -0.34), falloff=(0.03, -0.02)),
    Exposure(FIRST, turn=-0.8, gain=(0.90, 0.93, 1.00), bias=(6, 6, 9), falloff=(-0.05, 0.02), shift=(-0.12, 0.22)),
    Exposure(SOUTH_WEST, turn=1.1, gain=(1.06, 1.00, 0.93), bias=(0, 2, 3), gamma=0.93, falloff=(0.04, 0.05),
             shift=(0.17, 0.30)),
    Exposure(SOUTH_EAST, turn=-0.5, gain=(0.95, 1.03, 0.98), bias=(3, 3, 8), gamma=1.04, falloff=(-0.04, 0.03),
             shift=(-0.44, -0.22)),
    Exposure(GAP_FILLER, turn=0.9, sun=0.70, blur=0.32, gain=(1.22, 1.27, 1.46), bias=(-32, -30, -24), gamma=1.15,
             falloff=(0.03, 0.04), shift=(1.45, -1.30), warp=0.25, origin=(0.4, 0.3)),
)

TIES = {one.name: one.shift for one in EXPOSURES if one.name != GAP_FILLER}
"""What the block's adjustment corrects, px to the east and south."""

Points = list[tuple[float, float]]


@dataclass(frozen=True)
class Damage:
    """A place where the mosaicking was overdone: bounds in map coordinates (xmin, ymin, xmax, ymax)."""

    cause: str
    bounds: tuple[float, float, float, float]


@dataclass(frozen=True)
class Block:
    """The files of a block; the seamlines' GeoPackage has the layers `seamlines` and `cells`."""

    mosaic: Path
    sources: tuple[Path, ...]
    seamlines: Path
    damage: tuple[Damage, ...]


@dataclass(frozen=True)
class Layout:
    """Seams as curves: x by y between the columns of a strip, y by x between the strips; lengths in metres."""

    extent_m: Extent
    scale: float
    north: tuple[Curve, ...]
    south: tuple[Curve, ...]
    between: Curve
    feather_m: float = FEATHER

    def weights(self, x: np.ndarray, y: np.ndarray) -> dict[str, np.ndarray]:
        """Share of each source in the mosaic; the shares add up to 1."""
        feather, wide = self.feather_m * self.scale, WIDE_FEATHER * self.scale
        south = ramp((y - self.between(x)) / feather)
        first, second = (ramp((x - seam(y)) / width) for seam, width in zip(self.north, (feather, wide)))
        east = ramp((x - self.south[0](y)) / feather)
        return {
            FIRST: (1 - south) * (1 - first), MIDDLE: (1 - south) * first * (1 - second),
            GAP_FILLER: (1 - south) * first * second, SOUTH_WEST: south * (1 - east), SOUTH_EAST: south * east,
        }


def make_block(folder: str | Path, extent_m: Extent = (500.0, 400.0), seed: int = 2010,
               progress: Callable[[str], None] = lambda message: None, feather_m: float = FEATHER) -> Block:
    """Draw the scene, photograph it, mosaic it and write the files into a folder. ``feather_m``: of the usual seam."""
    folder = Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    images, layout = photograph(extent_m, seed, progress)
    layout = replace(layout, feather_m=feather_m)
    for image in images:
        write_image(folder / image.name, image.pixels, image.left, image.top)
    progress("Assembling the mosaic")
    mosaic = assemble(images, balance(images), TIES, layout.weights, extent_m)
    scale = layout.scale
    dodging = Dodging(0.44 * extent_m[0], 0.79 * extent_m[1], 64 * scale, 62 * scale, reach=20 * scale)
    dodge(mosaic, dodging)
    write_image(folder / "mosaic.tif", mosaic, 0.0, 0.0)
    progress("Writing the seamlines")
    write_seams(folder / "seamlines.gpkg", layout)
    return Block(folder / "mosaic.tif", tuple(sorted(folder / one.name for one in EXPOSURES)),
                 folder / "seamlines.gpkg", damage_places(layout, dodging))


def photograph(
    extent_m: Extent, seed: int, progress: Callable[[str], None] = lambda message: None
) -> tuple[list[Orthoimage], Layout]:
    """The orthoimages of a scene, and the seams that their mosaic is cut along."""
    rng = np.random.default_rng(seed)
    progress("Drawing the scene")
    scene = make_scene(extent_m, MARGIN * extent_m[0] / WIDTH + 1.5, rng)
    layout = make_layout(extent_m, scene, rng)
    images = []
    for exposure in EXPOSURES:
        progress(f"Taking orthoimage {exposure.name}")
        images.append(take(scene, exposure, footprints(layout)[exposure.name], rng))
    return images, layout


def ramp(distance: np.ndarray) -> np.ndarray:
    """Linear feather: 0 before -1/2, 1 after 1/2."""
    return np.clip(distance + np.float32(0.5), 0, 1)


def make_layout(extent_m: Extent, scene: Scene, rng: np.random.Generator) -> Layout:
    """Seams that meander across the fields and follow the edge of a road where there is one."""
    width, _depth = extent_m
    scale = width / WIDTH

    def meander(base: Callable[[np.ndarray], np.ndarray], swing: float) -> Curve:
        phases = rng.uniform(0, 2 * np.pi, 3)

        def curve(t: np.ndarray) -> np.ndarray:
            waves = ((1.0, 84.0), (0.5, 33.0), (0.22, 11.0))
            return base(t) + sum(swing * size * scale * np.sin(2 * np.pi * t / (length * scale) + phase)
                                 for (size, length), phase in zip(waves, phases))
        return curve

    return Layout(
        extent_m, scale,
        north=(meander(lambda y: scene.main_road(y) + 5.0, 1.2), meander(lambda y: 0.67 * width + 0 * y, 5.0)),
        south=(meander(lambda y: 0.44 * width + 0 * y, 5.0),),
        between=meander(lambda x: scene.side_road(x) + 4.5, 1.2),
    )


def footprints(layout: Layout) -> dict[str, Box]:
    """Ground covered by each source: its cell, half the overlap inwards, a little beyond the mosaic outwards."""
    width, depth = layout.extent_m
    half, out = OVERLAP / 2 * layout.scale, 5.0 * layout.scale
    west, east, centre, middle = 0.33 * width, 0.67 * width, 0.44 * width, 0.5 * depth
    north, south = (-out, middle + half), (middle - half, depth + out)
    return {
        FIRST: Box(-out, north[0], west + half, north[1]),
        MIDDLE: Box(west - half, north[0], east + half, north[1]),
        GAP_FILLER: Box(east - half, north[0], width + out, north[1]),
        SOUTH_WEST: Box(-out, south[0], centre + half, south[1]),
        SOUTH_EAST: Box(centre - half, south[0], width + out, south[1]),
    }


def damage_places(layout: Layout, dodging: Dodging) -> tuple[Damage, ...]:
    """Where the mosaicking was overdone, for demonstrations and tests."""
    depth = layout.extent_m[1]
    seam, half = 0.67 * layout.extent_m[0], WIDE_FEATHER / 2 * layout.scale
    wide = Box(seam - half, 0.0, seam + half, 0.49 * depth)
    calm = Box(dodging.x - dodging.half_x, dodging.y - dodging.half_y,
               dodging.x + dodging.half_x, min(dodging.y + dodging.half_y, depth))
    return tuple(Damage(cause, (EASTING + box.left, NORTHING - box.bottom, EASTING + box.right, NORTHING - box.top))
                 for cause, box in ((f"feather of {WIDE_FEATHER:g} m", wide), ("dodging", calm)))


def seam_pieces(layout: Layout) -> list[tuple[str, str, Points]]:
    """Left source, right source and vertices of every seam; strips' seams run north, the one between them east."""
    _width, depth = layout.extent_m
    pieces = []
    for left, right, seam, edge in ((FIRST, MIDDLE, layout.north[0], 0.0), (MIDDLE, GAP_FILLER, layout.north[1], 0.0),
                                    (SOUTH_WEST, SOUTH_EAST, layout.south[0], depth)):
        line = vertices(seam, crossing(seam, layout)[1], edge, layout.scale)
        pieces.append((left, right, line if edge == 0.0 else line[::-1]))
    pairs = ((FIRST, SOUTH_WEST), (MIDDLE, SOUTH_WEST), (MIDDLE, SOUTH_EAST), (GAP_FILLER, SOUTH_EAST))
    knots = junctions(layout)
    for (left, right), start, stop in zip(pairs, knots, knots[1:]):
        pieces.append((left, right, between_strips(layout, start, stop)))
    return pieces


def cell_rings(layout: Layout) -> list[tuple[str, Points]]:
    """Source and outline of every cell of the mosaic."""
    width, depth = layout.extent_m
    cells = []
    for names, seams, edge in (((FIRST, MIDDLE, GAP_FILLER), layout.north, 0.0),
                               ((SOUTH_WEST, SOUTH_EAST), layout.south, depth)):
        sides: list[Curve] = [lambda y: 0 * y, *seams, lambda y: 0 * y + width]
        for name, left, right in zip(names, sides, sides[1:]):
            (x0, y0), (x1, y1) = crossing(left, layout), crossing(right, layout)
            ring = vertices(left, y0, edge, layout.scale) + vertices(right, y1, edge, layout.scale)[::-1]
            cells.append((name, ring + between_strips(layout, x0, x1)[-2:0:-1]))
    return cells


def junctions(layout: Layout) -> list[float]:
    """Where the seam between the strips begins, meets each of their seams and ends, x."""
    return [0.0, *sorted(crossing(seam, layout)[0] for seam in layout.north + layout.south), layout.extent_m[0]]


def between_strips(layout: Layout, start: float, stop: float) -> Points:
    """The seam between the strips from one junction to another: neighbours on both sides share its vertices."""
    knots = [x for x in junctions(layout) if start <= x <= stop]
    points: Points = []
    for a, b in zip(knots, knots[1:]):
        points += [(x, y) for y, x in vertices(layout.between, a, b, layout.scale)][1 if points else 0:]
    return points


def crossing(seam: Curve, layout: Layout) -> tuple[float, float]:
    """Where a seam of a strip meets the seam between the strips, by fixed-point iteration."""
    y = layout.extent_m[1] / 2
    for _ in range(60):
        y = 0.5 * (y + float(layout.between(seam(np.float64(y)))))
    return float(seam(np.float64(y))), y


def vertices(seam: Curve, start: float, stop: float, scale: float) -> Points:
    """Points (seam(t), t) of a seam, about one to the metre."""
    t = np.linspace(start, stop, max(int(abs(stop - start) / scale), 1) + 1)
    return list(zip(seam(t).tolist(), t.tolist()))


def reference_system() -> osr.SpatialReference:
    """EPSG:2180 with easting first, as rasters and layers store it."""
    system = osr.SpatialReference()
    system.ImportFromEPSG(EPSG)
    system.SetAxisMappingStrategy(osr.OAMS_TRADITIONAL_GIS_ORDER)
    return system


def write_image(path: Path, pixels: np.ndarray, left: float, top: float) -> None:
    """Write bands (3, rows, cols) as a tiled GeoTIFF; `left` and `top` from the mosaic's corner in metres."""
    bands, rows, cols = pixels.shape
    options = ["TILED=YES", "BLOCKXSIZE=256", "BLOCKYSIZE=256", "COMPRESS=DEFLATE", "PREDICTOR=2", "ZLEVEL=6",
               "PHOTOMETRIC=RGB"]
    dataset = gdal.GetDriverByName("GTiff").Create(str(path), cols, rows, bands, gdal.GDT_Byte, options)
    if dataset is None:
        raise OSError(f"Cannot write {path}: {gdal.GetLastErrorMsg()}")
    dataset.SetProjection(reference_system().ExportToWkt())
    dataset.SetGeoTransform((EASTING + left, PIXEL, 0.0, NORTHING - top, 0.0, -PIXEL))
    for band in range(bands):
        dataset.GetRasterBand(band + 1).SetNoDataValue(0)
    dataset.WriteArray(pixels)
    dataset.FlushCache()


def write_seams(path: Path, layout: Layout) -> None:
    """Write the layers `seamlines` (lines) and `cells` (polygons) into a GeoPackage."""
    driver = ogr.GetDriverByName("GPKG")
    if path.exists():
        driver.DeleteDataSource(str(path))
    package = driver.CreateDataSource(str(path))
    if package is None:
        raise OSError(f"Cannot write {path}: {gdal.GetLastErrorMsg()}")
    lines = package.CreateLayer("seamlines", reference_system(), ogr.wkbLineString)
    lines.CreateField(ogr.FieldDefn("seam_id", ogr.OFTInteger))
    for name in ("left_source", "right_source"):
        lines.CreateField(ogr.FieldDefn(name, ogr.OFTString))
    for number, (left, right, points) in enumerate(seam_pieces(layout), start=1):
        add_feature(lines, map_line(points, ogr.wkbLineString),
                    {"seam_id": number, "left_source": left, "right_source": right})
    cells = package.CreateLayer("cells", reference_system(), ogr.wkbPolygon)
    cells.CreateField(ogr.FieldDefn("source", ogr.OFTString))
    for source, points in cell_rings(layout):
        polygon = ogr.Geometry(ogr.wkbPolygon)
        ring = map_line(points, ogr.wkbLinearRing)
        ring.CloseRings()
        polygon.AddGeometry(ring)
        add_feature(cells, polygon, {"source": source})


def map_line(points: Points, kind: int) -> ogr.Geometry:
    """A line or ring in map coordinates."""
    line = ogr.Geometry(kind)
    for x, y in points:
        line.AddPoint_2D(EASTING + x, NORTHING - y)
    return line


def add_feature(layer: ogr.Layer, geometry: ogr.Geometry, fields: dict[str, int | str]) -> None:
    """Append a feature with its fields."""
    feature = ogr.Feature(layer.GetLayerDefn())
    for name, value in fields.items():
        feature.SetField(name, value)
    feature.SetGeometry(geometry)
    layer.CreateFeature(feature)


def main() -> None:
    """Command line: write the block into a folder."""
    parser = argparse.ArgumentParser(description="Write the demonstration block of Seam Inspector.")
    parser.add_argument("folder", type=Path)
    parser.add_argument("--seed", type=int, default=2010)
    parser.add_argument("--extent", type=float, nargs=2, default=(500.0, 400.0), metavar=("WIDTH", "DEPTH"), help="m")
    arguments = parser.parse_args()
    gdal.UseExceptions()  # GDAL 3.7 warns whoever leaves it open
    make_block(arguments.folder, tuple(arguments.extent), arguments.seed, print)


if __name__ == "__main__":
    main()
