"""Exterior orientations of aerial photos from the files of other programs."""
from __future__ import annotations

import csv
import math
import re
from collections.abc import Callable, Iterable, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path
from typing import Any
from xml.etree.ElementTree import Element

import numpy as np
from osgeo import osr
from scipy.spatial.transform import Rotation

from ...imagery.errors import Message, SensorModelError
from ...imagery.reference_systems import spatial_reference
from . import messages
from .camera_files import BROKEN, VERSION, document, inpho_blocks, inpho_value, numbers_of, pix4d_photos, read_cameras
from .frames import EARTH_CURVATURE, camera_axes
from .limits import ANGLE_UNITS, WGS84_SEMI_MAJOR_M
from .pushbroom import geocentric

AUTO, DEGREES, GON, RADIANS = ANGLE_UNITS
_IN_DEGREES = {DEGREES: 1.0, GON: 0.9, RADIANS: math.degrees(1)}
_UNIT_WORDS = ((GON, r"gons?|grads?|grades?"), (DEGREES, r"deg|degrees?|°"), (RADIANS, r"rad|radians?"))
_ANGLE_WORDS = "|".join(rf"[_ (\[](?:{words})\b[)\]]?" for _, words in _UNIT_WORDS)
_FIELDS = ("filename", "x", "y", "z", "omega", "phi", "kappa")
_ALIASES = {
    "filename": "filename file image imagename imageid imagefile photo photoid photoname label id name frame",
    "x": "x easting east e x0 xc xl xeasting xlongitude projectedx rechtswert",
    "y": "y northing north n y0 yc yl ynorthing ylatitude projectedy hochwert",
    "z": "z altitude alt height h z0 zc zl elevation zaltitude hoehe hhe ellipsoidheight orthometricheight",
    "omega": "omega om", "phi": "phi ph", "kappa": "kappa ka", "camera": "camera cameraid sensor",
}  # fmt: skip
_NAMES = {alias: name for name, aliases in _ALIASES.items() for alias in aliases.split()}
"""Names of columns, in small letters and digits and without units, and what they hold."""
_PAIRS = r"(?i)(ellipsoid|orthometric|photo|image|file|camera)[ _](height|id|name)"
_DIGITS = 1e-4  # how far from orthonormal axes in a text may be
_SHOWN = 5
_LONGEST_LINE = 10_000  # characters, of a table: patterns take the square of what they look through
_LEAST_RADIANS = 1.4  # a photo flown to the north or back has 1.57 or 3.14; in degrees nobody flies just so
_DOWN = np.diag([1.0, -1.0, -1.0])  # from x right, y up, z back to columns, rows and the view


@dataclass(frozen=True)
class FrameExterior:
    position: np.ndarray  # (3,) x, y, height, m
    axes: np.ndarray  # (3, 3), as ``FrameCamera.axes``
    camera: str = ""  # the camera's name, where the file says it
    wkt: str = ""  # reference system of x and y, anything that GDAL understands; empty where the file names none
    curvature: float = 0.0  # as ``FrameCamera.curvature``
    notices: tuple[Message, ...] = ()  # what to say of how it was read


Named = list[tuple[str, Callable[[], FrameExterior]]]
"""The name of each photo with the function that makes its orientation."""


@dataclass(frozen=True)
class Exteriors:
    name: str  # the file's
    photos: Named

    @property
    def names(self) -> list[str]:
        return [name for name, _ in self.photos]

    def of(self, image: str) -> FrameExterior:
        """Orientation of an image by its file's name, with ending or without. Raises SensorModelError unless there is
        just one."""
        stem = Path(image).stem
        alike = [make for name, make in self.photos if stem in (name, Path(name).stem)]
        makers = [make for name, make in self.photos if name == image] or alike
        if len(makers) != 1:
            names = ", ".join(self.names[:_SHOWN])
            raise SensorModelError(messages.IMAGE_NOT_ORIENTED(name=self.name, image=image, names=names))
        try:
            made = makers[0]()
            sound = np.isfinite(made.position).all() and (made.position.shape, made.axes.shape) == ((3,), (3, 3))
        except BROKEN:
            sound = False
        if not sound or not np.allclose(made.axes.T @ made.axes, np.eye(3), atol=_DIGITS):
            raise SensorModelError(messages.NO_EXTERIOR(name=self.name))
        return made


def read_exteriors(content: Any, path: Path, angles: str = AUTO) -> Exteriors:
    """Orientations of a ``document``; ``angles``: of ``limits.ANGLE_UNITS``. Raises SensorModelError without any."""
    with suppress(*BROKEN, csv.Error):
        if photos := _photos(content, path, angles):
            return Exteriors(path.name, photos)
    raise SensorModelError(messages.NO_EXTERIOR(name=path.name))


def _photos(content: Any, path: Path, angles: str) -> Named:
    if isinstance(content, Element):
        if content.tag == "BlocksExchange":
            return _block_photos(content)
        return _metashape_photos(content)
    if isinstance(content, dict) and "features" in content:
        system = str(content.get("world_crs") or "")
        rows = [feature["properties"] for feature in content["features"]]

        def orthority(row: dict[str, Any]) -> FrameExterior:
            axes = camera_axes(*(math.degrees(float(angle)) for angle in row["opk"]))
            return FrameExterior(np.array(row["xyz"], float), axes, str(row.get("camera") or ""), system)

        return [(str(row["filename"]), partial(orthority, row)) for row in rows]
    if isinstance(content, (dict, list)):
        return _opensfm_photos(content, path)
    if "$PHOTO" in content:
        return _inpho_photos(content, path)
    if pix4d := pix4d_photos(content):
        beside = path.with_name(path.name.replace("calibrated_camera_parameters.txt", "offset.xyz"))
        is_there = beside != path and beside.is_file()
        words = beside.read_text(encoding="utf-8", errors="replace").split()[:3] if is_there else (0, 0, 0)
        offset = np.array(words, float)

        def exterior(name: str) -> FrameExterior:
            numbers = pix4d[name]
            return FrameExterior(np.array(numbers[16:19]) + offset, np.reshape(numbers[19:28], (3, 3)).T, name)

        return [(name, partial(exterior, name)) for name in pix4d]
    return _patb_photos(content) or _table_photos(content, path, angles)


def _opensfm_photos(content: Any, path: Path) -> Named:
    """The shots of all parts, each in the plane that touches the Earth at its part's reference. OpenDroneMap replaces
    it by one in UTM and keeps the exact one beside it; else the offset stands in another folder."""
    exact, offset = path.with_name("reconstruction.topocentric.json"), None
    coordinates = path.parent.parent / "odm_georeferencing" / "coords.txt"
    notice = messages.PLANE_TAKEN(name=path.name)
    if exact.is_file() and path.name != exact.name:
        content, notice = document(exact), messages.TOPOCENTRIC_TAKEN(name=path.name, exact=exact.name)
    elif coordinates.is_file() and path.name != exact.name:
        lines = coordinates.read_text(encoding="utf-8", errors="replace").splitlines()
        ((zone, side),) = re.findall(r"UTM (\d+)([NS])", lines[0])  # as in WGS84 UTM 32N
        system = f"EPSG:{(32600 if side == 'N' else 32700) + int(zone)}"
        offset = np.array([*map(float, lines[1].split()[:2]), 0.0])
        notice = messages.UTM_TAKEN(name=path.name, system=system, offsets=coordinates.name)

    def exterior(shot: dict[str, Any], part: int, origin: list[float]) -> FrameExterior:
        axes = Rotation.from_rotvec(np.array(shot["rotation"], float)).as_matrix().T
        position = -axes @ np.array(shot["translation"], float)
        is_plane = offset is None
        made = _from_plane(origin, position, axes) if is_plane else FrameExterior(position + offset, axes, wkt=system)
        return replace(made, camera=f"{part}/{str(shot['camera']).removeprefix(VERSION)}", notices=(notice,))

    photos: Named = []
    for number, part in enumerate(content if isinstance(content, list) else [content]):
        origin = [float(part["reference_lla"][name]) for name in ("longitude", "latitude", "altitude")]
        photos += [(name, partial(exterior, shot, number, origin)) for name, shot in part["shots"].items()]
    return photos


def _metashape_photos(root: Element) -> Named:
    """The cameras of a project that are aligned, in the chunk's own system, which its transform puts on the Earth."""
    photos: Named = []
    for chunk in root.iter("chunk"):
        components = {component.get("id"): component.find("transform") for component in chunk.iter("component")}
        for camera in chunk.iter("camera"):
            placed = components.get(camera.get("component_id"))
            placed = chunk.find("transform") if placed is None else placed
            if camera.findtext("transform") and placed is not None:
                photos.append((camera.get("label", ""), partial(_metashape_exterior, camera, placed)))
    return photos


def _metashape_exterior(camera: Element, placed: Element) -> FrameExterior:
    pose, turn = np.reshape(numbers_of(camera, "transform"), (4, 4)), np.reshape(numbers_of(placed, "rotation"), (3, 3))
    centre = float(placed.findtext("scale") or 1) * turn @ pose[:3, 3] + numbers_of(placed, "translation")
    if not 0.9 < np.linalg.norm(centre) / WGS84_SEMI_MAJOR_M < 1.1:  # a system of its own, and not the Earth's
        raise ValueError
    return replace(_from_geocentric(centre, turn @ pose[:3, :3]), camera=camera.get("sensor_id", ""))


def _block_photos(root: Element) -> Named:
    """ContextCapture's: the rotation takes the ground to the camera, whose y is up or down as the group says."""
    systems = {system.findtext("Id"): (system.findtext("Definition") or "").strip() for system in root.iter("SRS")}
    photos: Named = []
    groups = [(block, group) for block in root.iter("Block") for group in block.iter("Photogroup")]
    for number, (block, group) in enumerate(groups):
        system = systems.get(group.findtext("SRSId") or block.findtext("SRSId"), "")
        for photo in group.iter("Photo"):
            name = re.split(r"[\\/]", photo.findtext("ImagePath") or "")[-1]
            photos.append((name, partial(_block_exterior, photo, group, str(number), system)))
    return photos


def _block_exterior(photo: Element, group: Element, camera: str, system: str) -> FrameExterior:
    turn = next(photo.iterfind("Pose/Rotation"))
    if turn.find("Omega") is not None:
        from_camera = Rotation.from_euler("XYZ", numbers_of(turn, "Omega", "Phi", "Kappa"), degrees=True).as_matrix()
    else:
        names = [f"M_{row}{column}" for row in range(3) for column in range(3)]
        from_camera = np.reshape(numbers_of(turn, *names), (3, 3)).T
    convention = {"XRightYDown": np.eye(3), "XRightYUp": _DOWN}[group.findtext("CameraOrientation") or "XRightYDown"]
    axes = from_camera @ convention
    centre = np.array(numbers_of(photo, *(f"Pose/Center/{axis}" for axis in "xyz")))
    plane = re.match(r"ENU:([-\d.]+),([-\d.]+)", system)
    if plane:
        return replace(_from_plane([float(plane[2]), float(plane[1]), 0.0], centre, axes), camera=camera)
    return FrameExterior(centre, axes, camera, system)


def _inpho_photos(content: str, path: Path) -> Named:
    """The photos of an Inpho project, which holds rotations from the ground to the camera."""

    def exterior(block: str) -> FrameExterior:
        values = [float(word) for word in inpho_value(block, "EXT_ORI").partition("\n")[2].split()[:13]]
        camera = inpho_value(block, "CAMERA_ID")
        mount = np.diag([0.0, 0.0, -1.0])
        mount[:2, :2] = read_cameras(content, path).chosen(camera).mount
        notices = (messages.ROTATION_TAKEN(name=path.name, way="$EXT_ORI"),)
        axes = (mount @ np.reshape(values[4:], (3, 3))).T
        return FrameExterior(np.array(values[1:4]), axes, camera, notices=notices)

    def name(block: str) -> str:
        return re.split(r"[\\/]", inpho_value(block, "PHOTO_FILE"))[-1] or inpho_value(block, "PHOTO_NUM")

    return [(name(block), partial(exterior, block)) for block in inpho_blocks(content, "PHOTO")]


def _from_plane(origin: Sequence[float], position: np.ndarray, axes: np.ndarray) -> FrameExterior:
    """Exterior in the plane (east, north, up) that touches the ellipsoid at a longitude, latitude and height."""
    up = _local_axes(*origin[:2])
    return _from_geocentric(geocentric(np.array([origin]))[0] + up.T @ position, up.T @ axes)


def _from_geocentric(position: np.ndarray, axes: np.ndarray) -> FrameExterior:
    """Exterior of a camera in geocentric coordinates (WGS 84): in the plane below, from which the Earth curves away."""
    systems = spatial_reference("EPSG:4978"), spatial_reference("EPSG:4979")
    longitude, latitude, height = osr.CoordinateTransformation(*systems).TransformPoint(*position.tolist())
    plane = f"+proj=tmerc +lon_0={longitude:.12f} +lat_0={latitude:.12f} +k_0=1 +ellps=WGS84 +units=m +type=crs"
    local = _local_axes(longitude, latitude) @ axes
    return FrameExterior(np.array([0.0, 0.0, height]), local, wkt=plane, curvature=EARTH_CURVATURE)


def _local_axes(longitude: float, latitude: float) -> np.ndarray:
    """(3, 3) rows: east, north and up at a place, in geocentric coordinates."""
    return Rotation.from_euler("ZX", [longitude + 90, 90 - latitude], degrees=True).as_matrix().T


def _patb_photos(content: str) -> Named:
    """A number, perhaps a focal length, a position, nine elements of the rotation to the ground; else no photos."""
    records = [line.split() for line in content.splitlines() if line.strip() and line.strip() != "-99"]
    photos: Named = []
    while len(records) > 2:
        first = records.pop(0)
        words = first[-3:]
        while records and len(words) < 12:
            words += records.pop(0)
        values = _numbers(words)
        if len(first) not in (4, 5) or len(values) != 12:
            return []
        notices = (messages.ROTATION_TAKEN(name=first[0], way="PATB"),)
        axes = np.reshape(values[3:], (3, 3)) @ _DOWN
        photos.append((first[0], partial(FrameExterior, np.array(values[:3]), axes, notices=notices)))
    return photos


def _numbers(words: Iterable[str]) -> list[float]:
    """The numbers of words with decimal points or commas; empty where a word is no number."""
    try:
        values = [float(word.replace(",", ".")) for word in words]
    except ValueError:
        return []
    return values if all(map(math.isfinite, values)) else []


def _table_photos(content: str, path: Path, angles: str) -> Named:
    """Photos of a table parted by semicolons, tabs, commas or blanks, with a header or in the order of ``_FIELDS``."""
    lines = [line for line in content.splitlines() if line.strip()]
    if any(len(line) > _LONGEST_LINE for line in lines):
        raise ValueError
    headers = ((number, *_header(line)) for number, line in enumerate(lines, 1))
    headerless = 0, {name: place for place, name in enumerate(_FIELDS)}, 0
    start, fields, count = next((header for header in headers if header[1]), headerless)
    if "filename" not in fields or (start == 0 and any(re.search("(?i)omega.*kappa", line) for line in lines)):
        raise ValueError  # nor are columns guessed where a header names others
    rows = _rows([line for line in lines[start:] if not line.lstrip().startswith("#")], fields, count)
    turned = np.array([row[1] for row in rows])[:, 3:]
    around = " ".join(lines[: start + 1]).lower()
    named = [unit for unit, words in _UNIT_WORDS if re.search(rf"(?<![a-z])(?:{words})(?![a-z])", around)]
    unit = angles if angles != AUTO else named[0] if len(named) == 1 else ""
    largest = float(np.abs(turned).max())
    perhaps = RADIANS if _LEAST_RADIANS < largest <= math.pi else GON if largest > 180 else ""
    doubt = messages.ANGLES_PERHAPS_OTHERS(name=path.name, angle=largest, unit=perhaps)
    notices = (doubt,) if perhaps and not unit else ()
    system = re.search(r"(PROJCS|COMPD_CS|PROJCRS)\[.*\]", "\n".join(lines[:start]))  # in a comment, as by Metashape

    def exterior(cells: list[str], numbers: list[float]) -> FrameExterior:
        axes = camera_axes(*(np.array(numbers[3:]) * _IN_DEGREES[unit or DEGREES]).tolist())
        camera = cells[fields["camera"]] if "camera" in fields else ""
        return FrameExterior(np.array(numbers[:3]), axes, camera, system[0] if system else "", notices=notices)

    return [(row[0][fields["filename"]], partial(exterior, *row)) for row in rows]


def _header(line: str) -> tuple[dict[str, int], int]:
    """The places of columns, {} for too few; and how many there are where blanks part them: rows have as many."""
    line = re.sub(_PAIRS, r"\1\2", re.sub(r"(?i)#\s*event", "event", line)).strip().lstrip("#")
    line = re.sub(r" +([(\[])", r"\1", line)  # a unit is no column of its own
    for parted in (";", "\t", ",", None):
        names = [re.sub(r"\(.*?\)|\[.*?\]|[^a-z0-9]", "", re.sub(_ANGLE_WORDS, "", word.lower()))
                 for word in line.split(parted)]  # fmt: skip
        places = {_NAMES[name]: place for place, name in reversed(list(enumerate(names))) if name in _NAMES}
        if set(_FIELDS[1:]) <= set(places):
            return places, 0 if parted else len(names)
    return {}, 0


_Rows = list[tuple[list[str], list[float]]]


def _rows(lines: Sequence[str], fields: dict[str, int], count: int) -> _Rows:
    """The cells of each row with its six numbers, parted as most rows are."""
    places = [fields[name] for name in _FIELDS[1:]]
    rows: dict[str, _Rows] = {parted: [] for parted in (";", "\t", ",", " ")}
    for parted, known in rows.items():
        for line in lines:
            quote = "'" if line.lstrip().startswith("'") else '"'
            cells = [cell.strip() for cell in next(csv.reader([line.strip()], delimiter=parted, quotechar=quote))]
            cells = [cell for cell in cells if cell] if parted == " " else cells
            is_whole = len(cells) > max(places) and count in (0, len(cells))
            if values := _numbers(cells[place] for place in places) if is_whole else []:
                known.append((cells, values))
    return max(rows.values(), key=len)
