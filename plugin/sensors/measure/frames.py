"""Aerial photos: the frame camera, its orientations from files, and both of one photo together.

The interior orientation comes from orthority's YAML or MicMac's AutoCal XML, the exterior one from a table, orthority's
GeoJSON or MicMac's Orientation XML.
"""
from __future__ import annotations

import csv
import math
from collections.abc import Mapping
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any, ClassVar
from xml.etree.ElementTree import Element, ParseError

import numpy as np
from scipy.spatial.transform import Rotation

from ...imagery.documents import json_document, looks_like_xml, xml_root
from ...imagery.errors import Message, SensorModelError
from ...imagery.grids import PixelWindow
from ...imagery.open_raster import OpenRaster
from ...imagery.rasters import RasterRef
from ...imagery.reference_systems import horizontal_wkt, is_geographic, metres_per_unit
from . import messages
from .heights import ELLIPSOID, HIGHEST_M, LOWEST_M, VERTICAL, Datum, Geoid, above_ellipsoid, first_band
from .lenses import BrownLens, FisheyeLens, Lens
from .limits import EXTERIOR_DATUMS
from .rpc import Domain
from .sensor_model import WGS84, SensorModel, file_content, newton, reprojected

MAX_SHAPE_DIFFERENCE = 0.01  # of an image's sides against its camera's: a reduced image is a pixel off at most
MAX_PIXEL_RATIO = 1.5  # of a pixel's sides: film that has shrunk is far from it, interchanged sides are beyond
START_REACH = 0.8  # of what the lens shows, where the search for the inverse of its distortion begins at most
TANGENT_STEP = 1e-6  # that derivatives of the distortion are taken with
SMALLEST_OFFSET = 1e-12  # tangents: the centre itself has no direction
_CAMERA = ("type", "im_size", "focal_len", "sensor_size", "cx", "cy")
_BROWN = ("k1", "k2", "k3", "p1", "p2")
_LENSES = {
    "pinhole": (),
    "brown": _BROWN,
    "opencv": (*_BROWN, "k4", "k5", "k6", "s1", "s2", "s3", "s4"),
    "fisheye": ("k1", "k2", "k3", "k4"),
}
"""orthority's types of cameras and the coefficients of each."""
_FIELDS = ("filename", "x", "y", "z", "omega", "phi", "kappa")
_DIGITS = 1e-4  # how far from orthonormal axes in a text may be
_SHOWN = 5
_LEAST_RADIANS = 1.4  # a photo flown to the north or back has 1.57 or 3.14; in degrees nobody flies just so
AS_TERRAIN = EXTERIOR_DATUMS[0]
MIN_DIP = 0.02  # sine of the angle below the horizon of the flattest view
HEIGHTS_PX = 512  # longer side of the overview of the terrain that the range of heights is taken from


@dataclass(frozen=True)
class FrameInterior:
    """A camera, in pixels of the image that it is used for: (0, 0) is the upper left corner of the first pixel."""

    focal: np.ndarray
    """(2,) focal length along columns and rows, px."""
    principal: np.ndarray
    """(2,) column and row of the principal point."""
    lens: Lens
    """Its distortion, about ``centre``."""
    centre: np.ndarray
    """(2,) column and row that distortion is symmetric about."""

    def shown(self, across: np.ndarray, down: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Column and row of views whose tangents along the camera's columns and rows are given."""
        x, y = self.lens.distorted(*(
            tangent + (principal - centre) / focal
            for tangent, principal, centre, focal in zip((across, down), self.principal, self.centre, self.focal)
        ))
        return self.centre[0] + self.focal[0] * x, self.centre[1] + self.focal[1] * y

    def tangents(self, image: np.ndarray) -> np.ndarray:
        """(n, 2) column, row -> (n, 2) tangents of the views that are shown there; NaN where the lens shows none."""
        offset = (image - self.centre) / self.focal
        share = START_REACH * self.lens.reach / np.maximum(np.hypot(*offset.T), SMALLEST_OFFSET)
        start = offset * np.minimum(share, 1.0)[:, None] + (self.centre - self.principal) / self.focal
        return newton(lambda tangents: np.column_stack(self.shown(*tangents.T)), image, start, TANGENT_STEP)


@dataclass(frozen=True)
class FrameCamera(SensorModel):
    """Collinearity: x and y of a plane system and heights are taken as one Cartesian space, as aerotriangulation does.

    A point behind the camera has no place in the image: NaN.
    """

    GEOGRAPHIC: ClassVar[bool] = False

    interior: FrameInterior
    position: np.ndarray
    """(3,) projection centre: x, y, height, m."""
    axes: np.ndarray
    """(3, 3) columns: the camera's axes along columns, along rows and along the view, on the ground."""

    def project(self, ground: np.ndarray) -> np.ndarray:
        """(n, 3) x, y, height -> (n, 2) column, row."""
        return np.column_stack(self.seen(*ground.T))

    def seen(self, x: np.ndarray, y: np.ndarray, height: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Column and row of places whose x, y and height are given in arrays that numpy broadcasts."""
        (x, y, height), axes = (one - origin for one, origin in zip((x, y, height), self.position)), self.axes
        depth = x * axes[0, 2] + y * axes[1, 2] + height * axes[2, 2]
        depth[depth <= 0] = np.nan
        ideal = []
        for axis in (0, 1):
            along = x * axes[0, axis] + y * axes[1, axis] + height * axes[2, axis]
            along /= depth
            ideal.append(along)
        return self.interior.shown(*ideal)

    def views(self, image: np.ndarray) -> np.ndarray:
        """(n, 3) directions on the ground, of length 1, in which the camera sees (n, 2) column, row.

        Raises SensorModelError for places that the lens can't show.
        """
        tangents = self.interior.tangents(image)
        if not np.isfinite(tangents).all():
            raise SensorModelError(messages.LENS_FOLDS())
        views = np.column_stack([tangents, np.ones(len(tangents))]) @ self.axes.T
        return np.asarray(views / np.linalg.norm(views, axis=1, keepdims=True))

    def places_at(self, views: np.ndarray, heights: np.ndarray) -> np.ndarray:
        """(n, 2) x and y where views (n, 3) that go down meet heights (n,) below the camera."""
        return np.asarray(self.position[:2] + views[:, :2] * ((heights - self.position[2]) / views[:, 2])[:, None])


def camera_axes(omega: float, phi: float, kappa: float) -> np.ndarray:
    """(3, 3) axes of a camera by the angles (degrees) of photogrammetry, about x, the turned y and the turned z.

    With all angles 0 it looks down, columns to the east. Source: Kraus, Photogrammetry: Rx(omega) Ry(phi) Rz(kappa),
    its second and third axis turned round, since rows run downwards and the view away from the camera.
    """
    turned = Rotation.from_euler("XYZ", [omega, phi, kappa], degrees=True).as_matrix()
    return np.asarray(turned @ np.diag([1.0, -1.0, -1.0]))


def read_interior(path: Path, camera: str, size: tuple[int, int]) -> FrameInterior:
    """The camera of a file, scaled to an image of ``size`` (columns, rows); ``camera`` chooses among several.

    Raises SensorModelError for a file that is none, a camera of another shape than the image, a distortion that is
    not known here.
    """
    content = file_content(path)
    try:
        if looks_like_xml(content):
            made, own_size = _micmac_interior(content, path)
        else:
            made, own_size = _orthority_interior(content, path, camera)
        lens = map(np.atleast_1d, vars(made.lens).values())
        values = np.concatenate([made.focal, made.principal, made.centre, *lens])
        sound = own_size.shape == (2,) and np.isfinite(values).all() and min(*made.focal, *own_size) > 0
    except (ParseError, ValueError, TypeError, KeyError, IndexError, AttributeError):
        sound = False
    if not sound:
        raise SensorModelError(messages.NO_INTERIOR(name=path.name))
    scale = np.array(size) / own_size
    if abs(scale[0] / scale[1] - 1) > MAX_SHAPE_DIFFERENCE:
        width, height = (round(float(side)) for side in own_size)
        raise SensorModelError(
            messages.INTERIOR_OF_ANOTHER_SHAPE(
                name=path.name, width=width, height=height, columns=size[0], rows=size[1]
            )
        )
    if not 1 / MAX_PIXEL_RATIO <= made.focal[0] / made.focal[1] <= MAX_PIXEL_RATIO:
        raise SensorModelError(messages.PIXELS_NOT_SQUARE(name=path.name, ratio=float(made.focal[1] / made.focal[0])))
    return replace(made, focal=made.focal * scale, principal=made.principal * scale, centre=made.centre * scale)


def _orthority_interior(content: bytes, path: Path, camera: str) -> tuple[FrameInterior, np.ndarray]:
    """A pinhole or a Brown camera (OpenSfM's, with k1, k2, k3, p1, p2)."""
    try:
        import yaml
    except ImportError:
        raise SensorModelError(messages.YAML_MISSING(name=path.name)) from None
    try:
        cameras = yaml.safe_load(content)
    except (yaml.YAMLError, RecursionError):
        raise ValueError from None
    if not isinstance(cameras, dict) or not cameras:
        raise ValueError
    if "im_size" in cameras:
        cameras = {"": cameras}
    if not all(isinstance(one, dict) and "im_size" in one for one in cameras.values()):
        raise ValueError
    name = camera if camera in cameras else next(iter(cameras)) if len(cameras) == 1 else None
    if name is None:
        raise SensorModelError(messages.CAMERA_UNKNOWN(name=path.name, names=", ".join(map(str, cameras))))
    values: Mapping[str, Any] = cameras[name]
    kind = str(values.get("type", "pinhole"))
    others = [str(key) for key, value in values.items() if value and key not in (*_CAMERA, *_LENSES.get(kind, ()))]
    if kind not in _LENSES or others:  # a distortion that is not computed here
        raise SensorModelError(messages.DISTORTION_UNKNOWN(name=path.name, kind=", ".join([kind, *others])))
    size = np.array(values["im_size"], float)
    sensor = values.get("sensor_size")
    # Without a sensor's size the focal length is one of sensor widths.
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):  # what is not finite is refused
        focal = np.array(values["focal_len"], float) * (size / np.array(sensor, float) if sensor else size[0])
    offset = np.array([values.get("cx") or 0.0, values.get("cy") or 0.0], float)
    principal = size / 2 + offset * size.max()
    given = {key: float(values.get(key) or 0.0) for key in _LENSES[kind]}
    return FrameInterior(np.broadcast_to(focal, 2).copy(), principal, lens_of(kind, given), principal), size


def lens_of(kind: str, given: Mapping[str, float]) -> Lens:
    """One of ``_LENSES`` by its coefficients as OpenCV names them; those that are not given are 0."""

    def of(*names: str) -> tuple[float, ...]:
        return tuple(given.get(name, 0.0) for name in names)

    if not any(given.values()) and kind != "fisheye":
        return Lens()
    if kind == "fisheye":
        return FisheyeLens(of("k1", "k2", "k3", "k4"))
    first, second = of("p1", "p2")
    return BrownLens(of("k1", "k2", "k3"), (first, second), of("k4", "k5", "k6"), of("s1", "s2", "s3", "s4"))


def _micmac_interior(content: bytes, path: Path) -> tuple[FrameInterior, np.ndarray]:
    """A conical camera without distortion, or with a radial one about a centre of its own (NoDist, ModRad)."""
    root = xml_root(content)
    inner = root if root.tag == "CalibrationInternConique" else root.find(".//CalibrationInternConique")
    if inner is None:
        raise ValueError
    focal, size = _numbers(inner, "F"), _numbers(inner, "SzIm")
    principal, centre = _numbers(inner, "PP"), None
    radial: tuple[float, ...] = ()
    for kind in (part for distortion in inner.iterfind("CalibDistortion") for part in distortion):
        if kind.tag == "ModRad" and centre is None:
            centre = _numbers(kind, "CDist")
            coefficients = [float(one.text or "") for one in kind.iterfind("CoeffDist")]
            radial = tuple(one * float(focal[0]) ** (2 * power) for power, one in enumerate(coefficients, 1))
        elif kind.tag not in ("ModNoDist", "NoDist"):
            raise SensorModelError(messages.DISTORTION_UNKNOWN(name=path.name, kind=kind.tag))
    convention = inner.findtext("KnownConv") or inner.findtext("ConvOri/KnownConv") or "eConvApero_DistM2C"
    if any(radial) and convention != "eConvApero_DistM2C":  # which bends the way from the ground to the image
        raise SensorModelError(messages.DISTORTION_UNKNOWN(name=path.name, kind=convention))
    if math.isnan(size.sum()) or len(size) != 2 or len(principal) != 2:
        raise ValueError
    lens = BrownLens(radial) if any(radial) else Lens()
    return FrameInterior(np.repeat(focal[:1], 2), principal, lens, principal if centre is None else centre), size


def _numbers(element: Element, name: str) -> np.ndarray:
    return np.array((element.findtext(name) or "nan").split(), float)


@dataclass(frozen=True)
class FrameExterior:
    """Where a camera was and how it looked."""

    position: np.ndarray
    """(3,) x, y, height, m."""
    axes: np.ndarray
    """(3, 3), as ``FrameCamera.axes``."""
    camera: str
    """The camera's name, where the file says it."""
    wkt: str
    """Reference system of x and y, anything that GDAL understands; empty where the file names none."""
    perhaps_radians: bool = False
    """Whether angles that are taken as degrees look like radians."""


def read_exterior(path: Path, image: str) -> FrameExterior:
    """The orientation of an image by its file's name, with or without its ending.

    Raises SensorModelError for a file that is none and for one that does not name the image.
    """
    content = file_content(path)
    try:
        if looks_like_xml(content):
            found = _micmac_exterior(content)
        elif content.lstrip()[:1] == b"{":
            found = _orthority_exterior(content, path, image)
        else:
            found = _exterior_table(content, path, image)
    except (ParseError, ValueError, TypeError, KeyError, IndexError, AttributeError, csv.Error):
        raise SensorModelError(messages.NO_EXTERIOR(name=path.name)) from None
    sound = found.position.shape == (3,) and found.axes.shape == (3, 3) and np.isfinite(found.position).all()
    if not sound or not np.allclose(found.axes.T @ found.axes, np.eye(3), atol=_DIGITS):
        raise SensorModelError(messages.NO_EXTERIOR(name=path.name))
    return found


def _micmac_exterior(content: bytes) -> FrameExterior:
    """``Orientation-IMAGE.xml``: centre and axes (rows down, view forward) as a matrix; one file an image."""
    root = xml_root(content)
    outer = root if root.tag == "Externe" else root.find(".//Externe")
    if outer is None:
        raise ValueError
    rows = [(outer.findtext(f"ParamRotation/CodageMatr/L{number}") or "").split() for number in (1, 2, 3)]
    return FrameExterior(np.array((outer.findtext("Centre") or "").split(), float), np.array(rows, float), "", "")


def _orthority_exterior(content: bytes, path: Path, image: str) -> FrameExterior:
    """orthority's: angles in radians, the reference system beside the features."""
    document = json_document(content)
    rows = [one["properties"] for one in document["features"]]
    row = rows[_index([str(one["filename"]) for one in rows], path, image)]
    return FrameExterior(
        np.array(row["xyz"], float), camera_axes(*(math.degrees(float(angle)) for angle in row["opk"])),
        str(row.get("camera") or ""), str(document.get("world_crs") or ""),
    )  # fmt: skip


def _exterior_table(content: bytes, path: Path, image: str) -> FrameExterior:
    """Values parted by commas, semicolons, tabs or blanks, with a header or in the order of ``_FIELDS``; degrees."""
    lines = [line for line in content.decode("utf-8-sig", errors="replace").splitlines() if line.strip()]
    parted = next((mark for mark in ",;\t" if mark in lines[0]), " ")
    rows = [[cell.strip() for cell in row] for row in csv.reader(lines, delimiter=parted, skipinitialspace=True)]
    header = [name.lower() for name in rows[0]]
    if set(_FIELDS[1:]) <= set(header):
        fields, rows = header, rows[1:]
    else:
        fields = list(_FIELDS)
    if "filename" not in fields:
        raise ValueError
    names = [row[fields.index("filename")] for row in rows]
    row = dict(zip(fields, rows[_index(names, path, image)]))
    position, angles = ([float(row[name]) for name in names] for names in (_FIELDS[1:4], _FIELDS[4:]))
    all_angles = [abs(float(one[fields.index(name)])) for one in rows for name in _FIELDS[4:]]
    return FrameExterior(
        np.array(position), camera_axes(*angles), row.get("camera") or "", "",
        _LEAST_RADIANS < max(all_angles) <= math.pi,
    )


def _index(names: list[str], path: Path, image: str) -> int:
    """Which of the names is the image's. Raises SensorModelError where none is, or several are."""
    stem = Path(image).stem
    alike = [index for index, name in enumerate(names) if name == image or stem in (name, Path(name).stem)]
    exact = [index for index in alike if names[index] == image]
    found = exact or alike
    if len(found) != 1:
        raise SensorModelError(
            messages.IMAGE_NOT_ORIENTED(name=path.name, image=image, names=", ".join(names[:_SHOWN]))
        )
    return found[0]


@dataclass(frozen=True)
class FrameFiles:
    """What a photo's orientation is read from."""

    interior: Path
    exterior: Path
    wkt: str
    """Reference system of the exterior orientation, if it is stated; empty: what its file says, else the image's."""
    datum: Datum
    """What the projection centre's height refers to: one of ``limits.EXTERIOR_DATUMS``, or a grid."""


@dataclass(frozen=True)
class OrientedFrame:
    """A photo's camera on the ground."""

    camera: FrameCamera
    wkt: str
    """Reference system of its position."""
    domain: Domain
    terrain_datum: Datum
    """What the terrain model's heights are to be taken as: the camera's are of the same kind then."""
    notices: tuple[Message, ...]


def oriented_frame(
    image: OpenRaster, files: FrameFiles, dem: RasterRef | None, dem_datum: Datum, height: float
) -> OrientedFrame:
    """The camera of an image; the ground's heights from ``dem``, else one ``height`` everywhere.

    Raises SensorModelError for files that can't be used and for cameras that don't see the ground.
    """
    exterior = read_exterior(files.exterior, image.ref.name)
    interior = read_interior(files.interior, exterior.camera, (image.columns, image.rows))
    wkt, notices = _system(image, files, exterior.wkt)
    if exterior.perhaps_radians:
        notices = (*notices, messages.ANGLES_PERHAPS_RADIANS(name=files.exterior.name))
    camera = FrameCamera(interior, exterior.position, exterior.axes)
    vertical = files.datum if isinstance(files.datum, Geoid) else VERTICAL.get(files.datum)
    if vertical is not None:
        place = reprojected(camera.position[None], wkt, WGS84)
        camera = replace(camera, position=np.append(camera.position[:2], above_ellipsoid(place, vertical)))
    low, high = (height, height) if dem is None else _range_of_heights(dem)
    if camera.position[2] <= high:
        raise SensorModelError(
            messages.CAMERA_BELOW_TERRAIN(name=image.ref.name, height=float(camera.position[2]), low=low, high=high)
        )
    corners = np.array([[0, 0], [image.columns, 0], [0, image.rows], [image.columns, image.rows]], float)
    views = camera.views(np.vstack([corners, corners.mean(axis=0)]))
    if views[:, 2].max() > -MIN_DIP:
        raise SensorModelError(messages.CAMERA_LOOKS_UP(name=image.ref.name))
    (middle,) = camera.places_at(views[-1:], np.array([(low + high) / 2]))
    domain = Domain((0.0, image.columns), (0.0, image.rows), (low, high), (float(middle[0]), float(middle[1])))
    return OrientedFrame(camera, wkt, domain, ELLIPSOID if files.datum == AS_TERRAIN else dem_datum, notices)


def _system(image: OpenRaster, files: FrameFiles, named: str) -> tuple[str, tuple[Message, ...]]:
    """The horizontal system of the exterior orientation, and what to say of it."""
    own = image.raster.own_wkt
    wkt = files.wkt or named or own
    if not wkt:
        raise SensorModelError(messages.EXTERIOR_WITHOUT_SYSTEM(name=files.exterior.name))
    if is_geographic(wkt) or metres_per_unit(wkt, 0.0) != (1.0, 1.0):
        raise SensorModelError(messages.EXTERIOR_NOT_METRIC())
    return horizontal_wkt(wkt), () if files.wkt or named else (messages.EXTERIOR_SYSTEM_TAKEN(),)


def _range_of_heights(dem: RasterRef) -> tuple[float, float]:
    """Lowest and highest terrain as the terrain model has it, m; over all of it, which costs an overview only."""
    source = OpenRaster(dem)
    whole = PixelWindow(0, 0, source.columns, source.rows)
    share = max(source.columns, source.rows) / HEIGHTS_PX
    size = (max(round(source.rows / share), 1), max(round(source.columns / share), 1)) if share > 1 else None
    heights = first_band(source, whole, size)
    heights = heights[(heights >= LOWEST_M) & (heights <= HIGHEST_M)]  # others stand for none, and no nodata says so
    if not heights.size:
        raise SensorModelError(messages.TERRAIN_EMPTY(name=dem.name))
    return float(heights.min()), float(heights.max())
