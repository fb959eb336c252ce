"""Control and check points: read, parted and written; whether they can be what they are said to be, and how they cover
an image, before anything is fitted to them."""
from __future__ import annotations

import csv
from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
from osgeo import gdal, ogr

from ...imagery.atomic_files import save_text
from ...imagery.errors import Message, SensorModelError
from ...imagery.open_raster import OpenRaster
from ...imagery.rasters import ON_ITS_OWN_PIXELS
from ...imagery.reference_systems import is_geographic, metres_per_unit
from . import messages
from .polynomials import Rational
from .sensor_model import WGS84, file_content, reprojected

CONTROL, CHECK = "control", "check"
_COLUMNS = (("sourceX", "pixelX"), ("sourceY", "pixelY"), ("mapX",), ("mapY",))  # of a georeferencer's file
SIGMAS_PX = 1e-7, 1e7  # smaller and larger ones say nothing more, and squares of theirs are no numbers
LOWEST_M, HIGHEST_M = -12_000.0, 9000.0  # the Mariana Trench and Mount Everest, with what a geoid adds
FINEST_M, COARSEST_M = 1e-4, 1e5  # of a pixel on the ground: a scanned sample, a weather satellite's whole disk
MARGIN = 0.05  # of the image's sides: as far beyond its border a point may be measured
FEWEST_INSIDE = 0.5  # of the points, for a turned reading of them to be believed
_SHOWN = 5
MAX_EXTRAPOLATED = 0.5  # share of the image outside the control points' outline
RPC_HEIGHTS = 2.0  # of the range of heights that an RPC is made for: as far from its middle a point may be
UNDULATION_M = 100.0  # what heights above sea level may miss the ellipsoid by, and so an RPC's range
RPC_FAR, RPC_FAR_PX = 3.0, 2000.0  # half images, and pixels, from the image's middle: no vendor's RPC is so far off
TURNED_LEAVES = 0.1  # of what points miss the RPC by, once they are read in a turned image: then they are of such
TURNED_MISS, TURNED_MISS_PX = 0.02, 3.0  # of what they cover, and px: what they miss it by for that to be asked
_FEWEST_TURNED = 3  # fewer follow a turned reading by chance
FOOT_M = 0.3048
IN_FEET_PX = 3.0  # what points miss the RPC by at least, by a half of them or, where most lie at one height, by a fifth
IN_FEET_LEAVES = ((0.5, 0.15), (0.8, 0.05))  # of what such a share of them misses it by, once heights are feet
FLAT_FEET_PX, FLAT_FEET_LEAVES = 20.0, 0.1  # the same of points at one height, which miss it by a shift
_FEWEST_IN_FEET = 4


@dataclass(frozen=True)
class Points:
    """Places known on the ground and in the image."""

    ids: tuple[str, ...]  # n names
    image: np.ndarray  # (n, 2) column, row in px
    ground: np.ndarray  # (n, 3) x, y in units of ``wkt``, height in m above the ellipsoid; NaN where unknown
    wkt: str  # reference system of x and y
    sigma_px: np.ndarray  # (n,) standard deviation of a coordinate in the image; NaN where none is given
    check: np.ndarray  # (n,) bool: whether a point only judges the fit
    heights_wkt: str = ""  # reference system that says what heights refer to, where ``wkt`` does not

    def __len__(self) -> int:
        return len(self.ids)

    def only(self, mask: np.ndarray) -> Points:
        parts = {name: getattr(self, name)[mask] for name in ("image", "ground", "sigma_px", "check")}
        return replace(self, ids=tuple(self.named(mask)), **parts)

    def named(self, mask: np.ndarray) -> list[str]:
        return [name for name, chosen in zip(self.ids, mask) if chosen]

    @property
    def weights(self) -> np.ndarray:
        """(n,) 1 / standard deviation; where some points have none they get the median of the others, or 1."""
        known = np.isfinite(self.sigma_px) & (self.sigma_px > 0)
        usual = float(np.median(self.sigma_px[known])) if known.any() else 1.0
        return 1 / np.clip(np.where(known, self.sigma_px, usual), *SIGMAS_PX)


def control_points(ids: Sequence[str], image: np.ndarray, ground: np.ndarray, wkt: str) -> Points:
    """Points of which nothing else is known: none for check, and no heights where ``ground`` is (n, 2)."""
    unknown = np.full(len(ids), np.nan)
    ground = ground if ground.shape[1] > 2 else np.column_stack([ground, unknown])
    return Points(tuple(ids), image, ground, wkt, unknown, np.zeros(len(ids), bool))


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
    gcps, wkt = image.dataset.GetGCPs() or (), image.dataset.GetGCPProjection() or image.ref.wkt
    numbers = np.array([(gcp.GCPPixel, gcp.GCPLine, gcp.GCPX, gcp.GCPY, gcp.GCPZ) for gcp in gcps], float)
    if not gcps or not np.isfinite(numbers).all():
        raise SensorModelError(messages.NO_POINTS_IN_IMAGE(name=image.ref.name))
    if not wkt:
        raise SensorModelError(messages.POINTS_WITHOUT_SYSTEM(name=image.ref.name))
    if not numbers[:, 4].any():
        numbers[:, 4] = np.nan
    names = [gcp.Id or str(number) for number, gcp in enumerate(gcps, 1)]
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
    points = {}
    for count, (number, line) in enumerate(rows[1:], 1):
        try:
            parts = next(csv.reader([line]))
            values = [float(parts[index]) for index in indices]
            if not np.isfinite(values).all():
                raise ValueError
        except (ValueError, IndexError, csv.Error):
            raise SensorModelError(messages.POINTS_LINE_UNREADABLE(name=path.name, line=number)) from None
        if enable < 0 or len(parts) <= enable or parts[enable].strip().lower() not in ("0", "false", ""):
            points[str(count)] = values
    if not points:
        raise SensorModelError(messages.NO_POINTS())
    if not named and not wkt:
        raise SensorModelError(messages.POINTS_WITHOUT_SYSTEM(name=path.name))
    numbers = np.array([*points.values()])
    image = _transformed(numbers[:, :2], gdal.InvGeoTransform(_source_transform(geotransform)))
    disabled = len(rows) - 1 - len(points)
    notices = [messages.POINTS_DISABLED(count=disabled)] if disabled else []
    return control_points([*points], image, numbers[:, 2:], named or wkt), notices


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
    """(n, 2) places by a geotransform."""
    matrix = np.reshape(transform, (2, 3))
    with np.errstate(invalid="ignore", over="ignore"):  # what has no place is told where points are looked at
        return np.asarray(matrix[:, 0] + places @ matrix[:, 1:].T)


def check_plausible(points: Points) -> None:
    """Raise SensorModelError for degrees and metres that were mistaken for each other and heights that are none."""
    x, y, z = points.ground.T
    if is_geographic(points.wkt) and not (np.abs(x).max() <= 360 and np.abs(y).max() <= 90):
        raise SensorModelError(messages.POINTS_NO_DEGREES(x=float(x[0]), y=float(y[0])))
    if (heights := z[np.isfinite(z)]).size:
        wrong = points.named((z < LOWEST_M) | (z > HIGHEST_M))
        check_heights(float(heights.min()), float(heights.max()), ", ".join(wrong[:_SHOWN]))
    across, metres = np.ptp(points.image, axis=0).max(), metres_per_unit(points.wkt, (x.mean(), y.mean()))
    if across > 0 and len(points) > 1:
        pixel = float((np.ptp(points.ground[:, :2], axis=0) * metres).max() / across)
        if not FINEST_M <= pixel <= COARSEST_M:
            raise SensorModelError(messages.PIXEL_IMPLAUSIBLE(size=pixel))


def check_heights(low: float, high: float, name: str) -> None:
    """Raise SensorModelError for heights, m, that are impossible on Earth."""
    if not LOWEST_M <= low <= high <= HIGHEST_M:
        raise SensorModelError(messages.HEIGHTS_IMPLAUSIBLE(name=name, low=low, high=high))


def check_inside(points: Points, size: tuple[int, int], rpc: Rational | None) -> list[Message]:
    """Notices of points outside an image of ``size`` that its RPC, but for a shift, sees there too: it is a part.
    Raises SensorModelError for others: rows counted upwards, columns and rows interchanged, or out of the image."""
    inside = _inside(points.image, size)
    if inside.all():
        return []
    if rpc is not None:
        misses = points.image - _seen(points, rpc)
        shift = np.median(misses, axis=0) if len(points) >= _FEWEST_TURNED else np.zeros(2)
        agrees = (np.abs(misses - shift) <= TURNED_MISS * np.abs(rpc.image.scale)).all(axis=1)
        if agrees[~inside].all():
            names = points.named(~inside)
            return [messages.POINTS_BEYOND_IMAGE(count=len(names), names=", ".join(names[:_SHOWN]))]
        inside |= agrees
    upwards, interchanged = points.image * [1, -1], points.image[:, ::-1]
    for turned, why in ((upwards, messages.ROWS_NEGATIVE), (interchanged, messages.COLUMNS_AND_ROWS_INTERCHANGED)):
        if _inside(turned, size).mean() > max(inside.mean(), FEWEST_INSIDE):
            raise SensorModelError(why())
    names = points.named(~inside)
    raise SensorModelError(messages.POINTS_OUTSIDE_IMAGE(
        count=len(names), names=", ".join(names[:_SHOWN]), columns=size[0], rows=size[1]
    ))


def _inside(image: np.ndarray, size: tuple[int, int]) -> np.ndarray:
    margin = MARGIN * np.array(size)
    return np.asarray(((image >= -margin) & (image <= size + margin)).all(axis=1))


def check_against_rpc(points: Points, rpc: Rational) -> list[Message]:
    """Notices of points whose heights (above the ellipsoid) the image's own RPC is not made for. Raises
    SensorModelError for places it sees far off, for a mirrored or turned image, and for heights in feet."""
    points = points.only(np.isfinite(points.ground).all(axis=1))
    if not len(points):
        return []
    seen = _seen(points, rpc)
    half = np.abs(rpc.image.scale)
    away = np.abs(seen - rpc.image.offset)
    far = ~(away <= np.maximum(RPC_FAR * half, RPC_FAR_PX)).all(axis=1)
    if far.mean() > FEWEST_INSIDE:
        beyond = (away - half).max(axis=1)
        beyond[np.isnan(beyond)] = np.inf
        raise SensorModelError(messages.RPC_SEES_NO_POINTS(distance=float(np.median(beyond))))
    _check_turned((points.image - rpc.image.offset)[~far], (seen - rpc.image.offset)[~far])
    in_metres, in_feet = ((points.image - places)[~far] for places in (seen, _seen(points, rpc, FOOT_M)))
    notices = _feet_notices(in_metres, in_feet) if len(in_metres) >= _FEWEST_IN_FEET else []
    return notices + _beyond_rpc_heights(points, rpc, _scatter(in_metres))


def _feet_notices(in_metres: np.ndarray, in_feet: np.ndarray) -> list[Message]:
    """Notices of misses (n, 2) px that are much smaller in feet. Raises SensorModelError for more than a shift."""
    for share, leaves in IN_FEET_LEAVES:
        metres, feet = (_scatter(misses, share) for misses in (in_metres, in_feet))
        if metres > IN_FEET_PX and feet < leaves * metres:
            raise SensorModelError(messages.HEIGHTS_IN_FEET(metres=metres, feet=feet))
    metres, feet = (float(np.median(np.linalg.norm(misses, axis=1))) for misses in (in_metres, in_feet))
    if metres > FLAT_FEET_PX and feet < FLAT_FEET_LEAVES * metres:
        return [messages.HEIGHTS_IN_FEET(metres=metres, feet=feet).as_warning()]
    return []


def _seen(points: Points, rpc: Rational, unit: float = 1.0) -> np.ndarray:
    """(n, 2) px, the places where an RPC sees points whose heights are in a ``unit`` of so many metres; the middle of
    its own heights where a point has none."""
    heights = np.where(np.isfinite(points.ground[:, 2]), points.ground[:, 2] * unit, rpc.ground.offset[2])
    ground = np.column_stack([points.ground[:, :2], heights])
    return np.asarray(rpc.project(reprojected(ground, points.wkt, WGS84)))


def _beyond_rpc_heights(points: Points, rpc: Rational, missed: float) -> list[Message]:
    heights, middle, half = points.ground[:, 2], float(rpc.ground.offset[2]), abs(float(rpc.ground.scale[2]))
    beyond = np.abs(heights - middle) > max(RPC_HEIGHTS * half, half + UNDULATION_M)
    if not beyond.any():
        return []
    names, heights = points.named(beyond), heights[beyond]
    return [messages.POINTS_BEYOND_RPC_HEIGHTS(
        count=len(names), names=", ".join(names[:_SHOWN]), low=float(heights.min()), high=float(heights.max()),
        first=middle - half, last=middle + half, missed=missed,
    )]  # fmt: skip


def _check_turned(image: np.ndarray, seen: np.ndarray) -> None:
    """Raise SensorModelError where an image mirrored or turned lies as the RPC sees its points but for a shift."""
    if len(image) < _FEWEST_TURNED:
        return
    as_given = _scatter(image - seen)
    if as_given < max(TURNED_MISS * float(np.ptp(seen, axis=0).min()), TURNED_MISS_PX):
        return
    for axes in ([0, 1], [1, 0]):
        for signs in ([1, 1], [-1, 1], [1, -1], [-1, -1]):
            if _scatter(image[:, axes] * signs - seen) < TURNED_LEAVES * as_given:
                plain = axes == [1, 0] and signs == [1, 1]
                why = messages.COLUMNS_AND_ROWS_INTERCHANGED if plain else messages.RPC_SEES_TURNED
                raise SensorModelError(why())


def _scatter(misses: np.ndarray, share: float = 0.5) -> float:
    """The distance from their median within which a share of misses (n, 2) lies: a shift and blunders play no part."""
    return float(np.quantile(np.linalg.norm(misses - np.median(misses, axis=0), axis=1), share))


ImageBox = tuple[float, float, float, float]  # first column, first row, last column, last row


@dataclass(frozen=True)
class ControlCoverage:
    """The part of an image that control points cover."""

    extrapolated: float  # share of the image outside the points' outline
    outline: np.ndarray  # (k, 2) corners of the points' convex hull, px; the last is the first

    @property
    def notices(self) -> list[Message]:
        share = self.extrapolated
        return [messages.CONTROL_LEAVES_OPEN(share=share)] if share > MAX_EXTRAPOLATED else []


def control_coverage(control: np.ndarray, image: ImageBox) -> ControlCoverage:
    """The part of an image that (n, 2) control points cover."""
    places = ", ".join(f"{x!r} {y!r}" for x, y in control.tolist())
    hull = ogr.CreateGeometryFromWkt(f"MULTIPOINT ({places})" if places else "MULTIPOINT EMPTY").ConvexHull()
    corners = hull.GetGeometryRef(0) if hull.GetGeometryType() == ogr.wkbPolygon else hull
    outline = np.array(corners.GetPoints() or np.zeros((0, 2)))[:, :2]
    box = ogr.CreateGeometryFromWkt("POLYGON (({0} {1}, {2} {1}, {2} {3}, {0} {3}, {0} {1}))".format(*image))
    inside = hull.Intersection(box)  # points may be measured a little beyond the image
    within, area = inside.GetArea() if inside.GetDimension() == 2 else 0.0, box.GetArea()
    return ControlCoverage(float(np.clip(1 - within / area, 0, 1)) if area > 0 else 1.0, outline)
