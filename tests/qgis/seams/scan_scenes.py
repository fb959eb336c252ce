"""Small mosaics to be scanned, as files with the two orthoimages they were made from, and how far lines lie apart."""
from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from qgis.core import QgsGeometry
from scipy.spatial import cKDTree

from tests.numbers.synthetic import texture, write_raster
from tests.qgis.scenes import layer, line

COLUMNS, ROWS = 700, 520
SEAM_METRES = 57.4  # length of ``seam_columns`` at 0.1 m
PIECE_M = 20.0  # long enough for a verdict at 0.1 m


@dataclass(frozen=True)
class Files:
    """A mosaic and what it was made from."""

    mosaic: str
    west: str
    east: str

    @property
    def sources(self) -> list[str]:
        return [self.west, self.east]

    def given(self, **more: Any) -> dict[str, Any]:
        """Parameters of a scan."""
        return {"MOSAIC": self.mosaic, "SOURCES": self.sources, "PIECE": PIECE_M, **more}


def images(
    shape: tuple[int, int] = (ROWS, COLUMNS), bands: int = 3, scale: float = 1.0, dtype: type = np.uint8
) -> list[np.ndarray]:
    """Two of one scene, each with fine detail of its own, (bands, rows, columns); no pixel is 0."""
    scene, most = texture(shape, 3.0, 40), 255 if np.dtype(dtype).kind == "f" else np.iinfo(dtype).max
    base = np.stack([110 + 6 * band + 22 * scene + 5 * texture(shape, 3.0, 41 + band) for band in range(bands)])
    return [np.clip(np.rint(scale * (base + 9 * texture(shape, 0.8, seed))), 1, most).astype(dtype) for seed in (1, 2)]


def seam_columns(rows: int, columns: int) -> np.ndarray:
    """The column where the seam crosses each row."""
    return 0.3 * columns + 0.04 * columns * np.sin(np.arange(rows) / 40)


def cut(west: np.ndarray, east: np.ndarray, width: float = 0.0) -> np.ndarray:
    """Their mosaic, hard or with a linear feather of a full width in px."""
    rows, columns = west.shape[-2:]
    place = np.arange(columns) + 0.5 - seam_columns(rows, columns)[:, np.newaxis]
    share = np.clip(place / width + 0.5, 0, 1) if width else (place > 0).astype(float)
    return np.asarray(np.rint((1 - share) * west + share * east)).astype(west.dtype)


def write_scene(
    folder: Path, made: Sequence[np.ndarray] | None = None, width: float = 0.0, name: str = "mosaic", **options: Any
) -> Files:
    """The two images and their mosaic as GeoTIFFs; ``options`` as ``write_raster`` takes them."""
    west, east = made or images()
    return Files(
        write_raster(folder / f"{name}.tif", cut(west, east, width), **options),
        write_raster(folder / "west.tif", west, **options), write_raster(folder / "east.tif", east, **options),
    )


def drawn_seam() -> Any:
    """The seam as a layer of one line."""
    columns = seam_columns(ROWS, COLUMNS)
    return layer("LineString", [line(*((columns[row], row + 0.5) for row in range(0, ROWS, 4)))])


def points_along(geometries: Iterable[QgsGeometry], step: float) -> np.ndarray:
    """(n, 2) map places, every so many map units along lines."""
    items = []
    for geometry in geometries:
        for part in geometry.asMultiPolyline() if geometry.isMultipart() else [geometry.asPolyline()]:
            path = np.array([(point.x(), point.y()) for point in part])
            station = np.append(0, np.cumsum(np.hypot(*np.diff(path, axis=0).T)))
            at = np.arange(0, station[-1], step)
            items.append(np.column_stack([np.interp(at, station, axis) for axis in path.T]))
    return np.concatenate(items)


def share_within(places: np.ndarray, of: np.ndarray, distance: float) -> float:
    """Share of places that lie within a distance of others."""
    return float(np.mean(cKDTree(of).query(places)[0] <= distance))
