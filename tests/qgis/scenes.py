"""A small mosaic with its orthoimages, and layers drawn on the mosaic's pixels."""
from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from osgeo import ogr, osr
from qgis.core import (
    QgsCoordinateReferenceSystem,
    QgsCoordinateTransformContext,
    QgsFeature,
    QgsGeometry,
    QgsRectangle,
    QgsVectorFileWriter,
    QgsVectorLayer,
)

from tests.numbers.synthetic import ORIGIN, UTM33, decompose, luminance, orthoimage, read_pixels, write_raster

PIXEL = 0.1  # metres
COLUMNS, ROWS = 512, 256  # of the mosaic and its sources
SHARP, BLURRED = (0, 0, 128, 128), (320, 64, 128, 128)
"""A window on the mosaic's sound half, and one on its blurred half."""

Box = tuple[float, float, float, float]  # column, row, width and height on the mosaic's grid


@dataclass(frozen=True)
class Scene:
    """A mosaic that was blurred in its eastern half, and the two orthoimages it was made from."""

    mosaic: Path
    west: Path
    east: Path

    @property
    def sources(self) -> list[str]:
        return [str(self.west), str(self.east)]


def make_scene(folder: Path) -> Scene:
    """Three bands, 8 bit, nodata 0; each raster has its own noise, each source its own tone."""
    random = np.random.default_rng(7)
    ground = orthoimage((ROWS, COLUMNS)).astype(np.float64)
    mosaic = ground.copy()
    mosaic[..., COLUMNS // 2 :] = blurred(ground)[..., COLUMNS // 2 :]
    scene = Scene(folder / "mosaic.tif", folder / "west.tif", folder / "east.tif")
    for path, pixels, noise in (
        (scene.mosaic, mosaic, 1.0),
        (scene.west, 0.9 * ground + 10, 2.0),
        (scene.east, 1.05 * ground - 6, 3.0),
    ):
        write_raster(path, to_bytes(pixels + random.normal(0, noise, ground.shape)), nodata=0)
    return scene


def blurred(pixels: np.ndarray) -> np.ndarray:
    """Every pixel the mean of the 3 x 3 around it."""
    rows = sum(np.roll(pixels, shift, axis=-2) for shift in (-1, 0, 1))
    return np.asarray(sum(np.roll(rows, shift, axis=-1) for shift in (-1, 0, 1)) / 9)


def to_bytes(pixels: np.ndarray) -> np.ndarray:
    """Rounded to 1..255, so that none is nodata."""
    return np.clip(np.rint(pixels), 1, 255).astype(np.uint8)


def whole(path: Path | str) -> np.ndarray:
    """All pixels of one of the scene's rasters."""
    return read_pixels(str(path), 0, 0, COLUMNS, ROWS)


def luminance_shares(path: Path | str, box: tuple[int, int, int, int], levels: int = 3) -> np.ndarray:
    """detail_1..detail_R and background of a clip's luminance, by GDAL and PyWavelets alone."""
    return decompose(luminance(read_pixels(str(path), *box)), levels=levels).shares


def at(column: float, row: float) -> tuple[float, float]:
    """The map point at a place of the mosaic's grid."""
    return ORIGIN[0] + column * PIXEL, ORIGIN[1] - row * PIXEL


def outline(box: Box) -> QgsGeometry:
    """The rectangle of pixels on the map."""
    column, row, width, height = box
    (left, top), (right, bottom) = at(column, row), at(column + width, row + height)
    return QgsGeometry.fromRect(QgsRectangle(left, bottom, right, top))


def line(*places: tuple[float, float]) -> QgsGeometry:
    """A line through columns and rows of the mosaic's grid."""
    points = (at(*place) for place in places)
    return QgsGeometry.fromWkt("LINESTRING(" + ", ".join(f"{float(x)!r} {float(y)!r}" for x, y in points) + ")")


def pixel_box(geometry: QgsGeometry) -> tuple[float, ...]:
    """Column, row, width and height of a geometry's bounding box on the mosaic's grid, to a thousandth of a pixel."""
    box = geometry.boundingBox()
    left, top = (box.xMinimum() - ORIGIN[0]) / PIXEL, (ORIGIN[1] - box.yMaximum()) / PIXEL
    return tuple(round(value, 3) for value in (left, top, box.width() / PIXEL, box.height() / PIXEL))


def moved(geometry: QgsGeometry, epsg: int) -> QgsGeometry:
    """A geometry of the mosaic's reference system in another one, by GDAL."""
    systems = []
    for code in (UTM33, epsg):
        systems.append(osr.SpatialReference())
        systems[-1].ImportFromEPSG(code)
        systems[-1].SetAxisMappingStrategy(osr.OAMS_TRADITIONAL_GIS_ORDER)
    shape = ogr.CreateGeometryFromWkb(bytes(geometry.asWkb()))
    shape.Transform(osr.CoordinateTransformation(*systems))
    result = QgsGeometry()
    result.fromWkb(bytes(shape.ExportToWkb()))
    return result


def layer(
    kind: str,
    geometries: Iterable[QgsGeometry | None],
    epsg: int | None = UTM33,
    **fields: tuple[str, Sequence[Any]],
) -> QgsVectorLayer:
    """A layer in memory; ``fields`` give each field's type and the features' values."""
    columns = "".join(f"&field={name}:{type_name}" for name, (type_name, _) in fields.items())
    made = QgsVectorLayer(f"{kind}?crs=EPSG:{epsg or UTM33}{columns}", "made", "memory")
    if epsg is None:
        made.setCrs(QgsCoordinateReferenceSystem())
    features = []
    for index, geometry in enumerate(geometries):
        feature = QgsFeature(made.fields())
        feature.setAttributes([values[index] for _, values in fields.values()])
        if geometry is not None:
            feature.setGeometry(geometry)
        features.append(feature)
    assert made.dataProvider().addFeatures(features)[0]
    return made


def windows(*boxes: Box, epsg: int = UTM33, **fields: tuple[str, Sequence[Any]]) -> QgsVectorLayer:
    """A layer of windows on the mosaic's pixels."""
    return layer("Polygon", [moved(outline(box), epsg) for box in boxes], epsg, **fields)


def saved(made: QgsVectorLayer, path: Path) -> str:
    """A layer as a file, in the format of its ending."""
    options = QgsVectorFileWriter.SaveVectorOptions()
    options.driverName = QgsVectorFileWriter.driverForExtension(path.suffix)
    QgsVectorFileWriter.writeAsVectorFormatV3(made, str(path), QgsCoordinateTransformContext(), options)
    return str(path)
