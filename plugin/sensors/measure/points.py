"""Control and check points: of a georeferencer's ``.points`` file, of an image that holds them, parted, written."""
from __future__ import annotations

import csv
from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
from osgeo import gdal

from ...imagery.atomic_files import save_text
from ...imagery.errors import Message, SensorModelError
from ...imagery.open_raster import OpenRaster
from ...imagery.rasters import ON_ITS_OWN_PIXELS
from . import messages
from .sensor_model import file_content

CONTROL, CHECK = "control", "check"
_COLUMNS = (("sourceX", "pixelX"), ("sourceY", "pixelY"), ("mapX",), ("mapY",))  # of a georeferencer's file
SIGMAS_PX = 1e-7, 1e7  # smaller and larger ones say nothing more, and squares of theirs are no numbers


@dataclass(frozen=True)
class Points:
    """Places known on the ground and in the image."""

    ids: tuple[str, ...]
    """n names."""
    image: np.ndarray
    """(n, 2) column, row in px."""
    ground: np.ndarray
    """(n, 3) x, y in the units of ``wkt`` and height in m above the ellipsoid; NaN where no height is known."""
    wkt: str
    """Reference system of x and y."""
    sigma_px: np.ndarray
    """(n,) standard deviation of a coordinate in the image; NaN where none is given."""
    check: np.ndarray
    """(n,) bool: whether a point only judges the fit."""
    heights_wkt: str = ""
    """Reference system that says what heights refer to, where ``wkt`` does not."""

    def __len__(self) -> int:
        return len(self.ids)

    def only(self, mask: np.ndarray) -> Points:
        """The points of a mask (n,)."""
        parts = {name: getattr(self, name)[mask] for name in ("image", "ground", "sigma_px", "check")}
        return replace(self, ids=tuple(self.named(mask)), **parts)

    def named(self, mask: np.ndarray) -> list[str]:
        """The names of the points of a mask (n,)."""
        return [name for name, chosen in zip(self.ids, mask) if chosen]

    @property
    def weights(self) -> np.ndarray:
        """(n,) 1 / standard deviation; where some points have none they get the median of the others, or 1."""
        known = np.isfinite(self.sigma_px) & (self.sigma_px > 0)
        usual = float(np.median(self.sigma_px[known])) if known.any() else 1.0
        return 1 / np.clip(np.where(known, self.sigma_px, usual), *SIGMAS_PX)

    @property
    def sigma_known(self) -> bool:
        """Whether any point comes with its standard deviation."""
        return bool((self.sigma_px > 0).any())


def control_points(ids: Sequence[str], image: np.ndarray, ground: np.ndarray, wkt: str) -> Points:
    """Points of which nothing else is known: none for check, and no heights where ``ground`` is (n, 2)."""
    count = len(ids)
    if ground.shape[1] == 2:
        ground = np.column_stack([ground, np.full(count, np.nan)])
    return Points(tuple(ids), image, ground, wkt, np.full(count, np.nan), np.zeros(count, bool))


def choose_check_points(points: Points, share: float) -> Points:
    """The points with a share of them for check, evenly spread, away from the outline, always the same."""
    check, extent = np.zeros(len(points), bool), np.ptp(points.image, axis=0)
    places = (points.image - points.image.min(axis=0)) / np.where(extent > 0, extent, 1)
    middle = np.abs(places - 0.5).max(axis=1)
    distance = 1 - middle  # the first one lies in the middle, then the one farthest from all chosen and the border
    nearest = np.full(len(points), np.inf)
    for _ in range(round(share * len(points))):
        index = int(np.argmax(np.where(check, -1.0, distance)))
        check[index] = True
        nearest = np.minimum(nearest, np.linalg.norm(places - places[index], axis=1))
        distance = np.minimum(nearest, 2 * (0.5 - middle) + 0.1)
    return replace(points, check=check)


def image_points(image: OpenRaster) -> Points:
    """The points of an image, all for control; heights that are all 0 are none. Raises SensorModelError without any."""
    found = image.dataset.GetGCPs() or ()
    if not found:
        raise SensorModelError(messages.NO_POINTS_IN_IMAGE(name=image.ref.name))
    wkt = image.dataset.GetGCPProjection() or image.ref.wkt
    if not wkt:
        raise SensorModelError(messages.POINTS_WITHOUT_SYSTEM(name=image.ref.name))
    numbers = np.array([(one.GCPPixel, one.GCPLine, one.GCPX, one.GCPY, one.GCPZ) for one in found], float)
    if not np.isfinite(numbers).all():
        raise SensorModelError(messages.IMAGE_POINTS_BROKEN(name=image.ref.name))
    if not numbers[:, 4].any():
        numbers[:, 4] = np.nan
    names = [one.Id or str(number) for number, one in enumerate(found, 1)]
    return control_points(names, numbers[:, :2], numbers[:, 2:], wkt)


def file_points(path: Path, wkt: str, geotransform: Sequence[float] | None) -> tuple[Points, list[Message]]:
    """The enabled points of a georeferencer's file by their number, all for control, and what was left out. ``wkt``: of
    files from before QGIS 3.26; ``geotransform``: the image's own. Raises SensorModelError."""
    lines = file_content(path).decode("utf-8-sig", errors="replace").splitlines()
    named = next((line[len("#CRS:") :].strip() for line in lines if line.startswith("#CRS:")), "")
    rows = [(number, line) for number, line in enumerate(lines, 1) if line.strip() and not line.startswith("#")]
    header = [name.strip() for name in rows[0][1].split(",")] if rows else []
    indices = [next((header.index(name) for name in names if name in header), -1) for names in _COLUMNS]
    if -1 in indices:
        raise SensorModelError(messages.NO_POINTS_FILE(name=path.name))
    enable = header.index("enable") if "enable" in header else -1
    found = {}
    for count, (number, line) in enumerate(rows[1:], 1):
        try:
            parts = next(csv.reader([line]))
            values = [float(parts[index]) for index in indices]
        except (ValueError, IndexError, csv.Error):
            raise SensorModelError(messages.POINTS_LINE_UNREADABLE(name=path.name, line=number)) from None
        if enable < 0 or len(parts) <= enable or parts[enable].strip().lower() not in ("0", "false", ""):
            found[str(count)] = values
    if not found:
        raise SensorModelError(messages.NO_POINTS())
    if not named and not wkt:
        raise SensorModelError(messages.POINTS_WITHOUT_SYSTEM(name=path.name))
    numbers = np.array([*found.values()])
    image = _transformed(numbers[:, :2], gdal.InvGeoTransform(_source_transform(geotransform)))
    disabled = len(rows) - 1 - len(found)
    notices = [messages.POINTS_DISABLED(count=disabled)] if disabled else []
    return control_points([*found], image, numbers[:, 2:], named or wkt), notices


def write_point_file(
    path: Path, points: Points, used: np.ndarray, residuals_px: np.ndarray, geotransform: Sequence[float] | None
) -> None:
    """Write a file that QGIS's georeferencer loads, with residuals (n, 2) px; points not ``used`` (n,) are switched
    off. Raises SettingsError where no file can be."""
    lines = [f"#CRS: {' '.join(points.wkt.split())}", "mapX,mapY,sourceX,sourceY,enable,dX,dY,residual"]
    source = _transformed(points.image, _source_transform(geotransform))
    before = np.column_stack([points.ground[:, :2], source])
    after = np.column_stack([residuals_px, np.linalg.norm(residuals_px, axis=1)])
    for first, on, last in zip(before.tolist(), used, after.tolist()):
        lines.append(",".join([*map(repr, first), str(int(on)), *map(repr, last)]))
    save_text("\n".join(lines) + "\n", path)


def _source_transform(geotransform: Sequence[float] | None) -> Sequence[float]:
    """From columns and rows to the georeferencer's: minus the row, or map coordinates of an image that has some."""
    placed = geotransform is not None and tuple(geotransform) != (0.0, 1.0, 0.0, 0.0, 0.0, 1.0)
    return geotransform if placed and geotransform else ON_ITS_OWN_PIXELS


def _transformed(places: np.ndarray, transform: Sequence[float]) -> np.ndarray:
    """(n, 2) by a geotransform."""
    left, across, skew_x, top, skew_y, down = transform
    x, y = places.T
    with np.errstate(invalid="ignore", over="ignore"):  # what has no place is told where points are looked at
        return np.column_stack([left + across * x + skew_x * y, top + skew_y * x + down * y])
