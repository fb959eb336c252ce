"""A mosaic of four orthoimages in strips, cut hard along three seams but for feathers planted at known places."""
from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from osgeo import gdal
from qgis.core import QgsVectorLayer

from tests.numbers.synthetic import texture, write_raster
from tests.qgis.scenes import layer, line, saved

ROWS, STRIP, STRIPS = 900, 400, 4
GSD = 0.1
OVERLAP = 160  # pixels that an orthoimage reaches beyond its seams
FEATHER_PX = 40.0
Planted = tuple[int, int, int]  # a seam, from 0, and the rows from and to which it is feathered
SHAPE = ROWS, STRIP * STRIPS


def seam_column(seam: int) -> np.ndarray:
    """The column where a seam crosses each row."""
    return STRIP * (seam + 1) + 12 * np.sin(np.arange(ROWS) / 60 + seam)


def stations(seam: int) -> np.ndarray:
    """Metres along a seam at each row."""
    return GSD * np.append(0, np.cumsum(np.hypot(np.diff(seam_column(seam)), 1)))


def seam_metres() -> float:
    return sum(float(stations(seam)[-1]) + GSD for seam in range(STRIPS - 1))


def planted_metres(planted: Sequence[Planted]) -> float:
    """That are feathered, along the seams."""
    return sum(float(np.diff(stations(seam)[[start, stop]])[0]) for seam, start, stop in planted)


@dataclass(frozen=True)
class Block:
    """The files of a mosaic."""

    mosaic: str
    sources: tuple[str, ...]
    seamlines: str
    folder: Path


def make_block(folder: Path, planted: Sequence[Planted] = (), smooth: int = 0, jpeg: int = 0) -> Block:
    """``smooth``: rows from the top without detail; ``jpeg``: quality of the mosaic's compression, 0 for none."""
    folder.mkdir(parents=True, exist_ok=True)
    scene = texture(SHAPE, 3.0, 40)
    fades = np.clip((np.arange(ROWS) - smooth) / 20 + 0.5, 0, 1)[:, np.newaxis] if smooth else 1.0
    images = []
    for number in range(STRIPS):
        plane = 110 + fades * (22 * scene + 9 * texture(SHAPE, 0.8, number + 1))
        images.append(np.clip(np.rint(np.stack([plane, plane + 6, plane - 6])), 1, 255).astype(np.uint8))
    made = images[0].astype(float)
    for seam in range(STRIPS - 1):
        aside = np.arange(SHAPE[1]) + 0.5 - seam_column(seam)[:, np.newaxis]
        share = (aside > 0).astype(float)
        for item, start, stop in planted:
            if item == seam:
                share[start:stop] = np.clip(aside[start:stop] / FEATHER_PX + 0.5, 0, 1)
        made = (1 - share) * made + share * images[seam + 1]
    mosaic = write_raster(folder / "mosaic.tif", np.rint(made).astype(np.uint8), GSD)
    if jpeg:
        options = ["COMPRESS=JPEG", f"JPEG_QUALITY={jpeg}", "TILED=YES", "PHOTOMETRIC=YCBCR"]
        mosaic = str(folder / "compressed.tif")
        gdal.Translate(mosaic, str(folder / "mosaic.tif"), creationOptions=options)
    sources = []
    for number, (image, name) in enumerate(zip(images, "abcd")):
        left, right = max(STRIP * number - OVERLAP, 0), min(STRIP * (number + 1) + OVERLAP, SHAPE[1])
        whole = gdal.Open(str(folder / "mosaic.tif")).GetGeoTransform()
        origin = whole[0] + GSD * left, whole[3]
        sources.append(write_raster(folder / f"{name}.tif", np.ascontiguousarray(image[:, :, left:right]), GSD, origin))
    return Block(mosaic, tuple(sources), saved(seam_layer(), folder / "seamlines.gpkg"), folder)


def seam_layer() -> QgsVectorLayer:
    """The seams as lines."""
    rows = np.append(np.arange(0, ROWS, 4), ROWS - 1)
    return layer("LineString", [
        line(*zip(seam_column(seam)[rows].tolist(), (rows + 0.5).tolist())) for seam in range(STRIPS - 1)
    ])
