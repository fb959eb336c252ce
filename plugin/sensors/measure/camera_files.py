"""The cameras of aerial photos from the files of other programs."""
from __future__ import annotations

import os
import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path
from typing import Any, Callable
from xml.etree.ElementTree import Element, ParseError

import numpy as np

from ...imagery.documents import json_document, looks_like_xml, xml_root
from ...imagery.errors import SensorModelError
from . import messages
from .frames import BrownLens, FisheyeLens, FrameInterior, Lens
from .sensor_model import file_content, yaml_document

MAX_SHAPE_DIFFERENCE = 0.01  # of an image's sides against its camera's: a reduced image is a pixel off at most
MAX_PIXELS = 1e9  # of an image's side, a focal length, or from the image to the principal point
MAX_PIXEL_RATIO = 1.5  # of a pixel's sides: film that has shrunk is far from it, interchanged sides are beyond
BROKEN = (ParseError, ArithmeticError, ValueError, TypeError, LookupError, AttributeError, StopIteration)
"""What a document that is none of these raises when it is taken apart."""
_ORTHORITY = ("type", "im_size", "focal_len", "sensor_size", "cx", "cy")
_BROWN = ("k1", "k2", "k3", "p1", "p2")
_LENSES = {
    "pinhole": (), "brown": _BROWN, "opencv": (*_BROWN, "k4", "k5", "k6", "s1", "s2", "s3", "s4"),
    "fisheye": ("k1", "k2", "k3", "k4"),
}  # fmt: skip
"""Types of lenses and the coefficients of each, as orthority and OpenCV name them."""
_OPENSFM = {
    "perspective": "brown", "simple_radial": "brown", "radial": "brown", "brown": "brown", "fisheye": "fisheye",
    "fisheye_opencv": "fisheye",
}  # fmt: skip
VERSION = "v2 "  # what OpenSfM has before cameras' names and OpenDroneMap leaves out in cameras.json
_RECONSTRUCTION = "reconstruction.json"
PIX4D_LINES = 9  # of a photo: three of the camera's matrix, two of its lens, its position, three of its rotation


@dataclass(frozen=True)
class FileCamera:
    """A camera as a file has it."""

    interior: FrameInterior  # in its own pixels
    size: np.ndarray  # (2,) its columns and rows
    mount: np.ndarray
    """(2, 2) its columns and rows by the axes that its file's rotations turn, x to the right and y upwards."""


@dataclass(frozen=True)
class Cameras:
    """The cameras of a file."""

    name: str  # the file's
    cameras: Mapping[str, Callable[[], FileCamera]]  # what makes each, by its name

    def chosen(self, camera: str) -> FileCamera:
        """Camera by name, of any part of a reconstruction after the slash, or the only one. Raises SensorModelError."""
        names = [camera, camera.partition("/")[2], *(self.cameras if len(self.cameras) == 1 else ())]
        found = next((name for name in names if name in self.cameras), None)
        if found is None and self.cameras:
            known = ", ".join(map(str, self.cameras))
            raise SensorModelError(messages.CAMERA_UNKNOWN(name=self.name, names=known))
        with np.errstate(all="ignore"):  # what is not finite is refused
            return self.cameras[str(found)]()

    def of(self, camera: str, size: tuple[int, int]) -> FrameInterior:
        """One scaled to an image of ``size`` (columns, rows). Raises SensorModelError for what can't be its camera."""
        try:
            found = self.chosen(camera)
            made, own_size = found.interior, found.size
            lens = map(np.atleast_1d, vars(made.lens).values())
            pixels = np.concatenate([made.focal, made.principal, made.centre, own_size])
            sound = (
                own_size.shape == (2,) and np.isfinite(np.concatenate([pixels, *lens])).all()
                and np.abs(pixels).max() <= MAX_PIXELS and min(*made.focal, *own_size) >= 1
            )
        except BROKEN:
            sound = False
        if not sound:
            raise SensorModelError(messages.NO_INTERIOR(name=self.name))
        scale = np.array(size) / own_size
        if abs(scale[0] / scale[1] - 1) > MAX_SHAPE_DIFFERENCE:
            (width, height), (columns, rows) = (round(float(side)) for side in own_size), size
            raise SensorModelError(messages.INTERIOR_OF_ANOTHER_SHAPE(
                name=self.name, width=width, height=height, columns=columns, rows=rows
            ))
        if not 1 / MAX_PIXEL_RATIO <= made.focal[0] / made.focal[1] <= MAX_PIXEL_RATIO:
            ratio = float(made.focal[1] / made.focal[0])
            raise SensorModelError(messages.PIXELS_NOT_SQUARE(name=self.name, ratio=ratio))
        return replace(made, focal=made.focal * scale, principal=made.principal * scale, centre=made.centre * scale)


def read_cameras(content: Any, path: Path) -> Cameras:
    """The cameras of a ``document``. Raises SensorModelError for a file that holds none."""
    try:
        return Cameras(path.name, _cameras(content, path))
    except BROKEN:
        raise SensorModelError(messages.NO_INTERIOR(name=path.name)) from None


def orientation_file(path: Path) -> Path:
    """The file, or the reconstruction of an OpenDroneMap project. Raises SensorModelError for another folder."""
    if not os.path.isdir(path):
        return path
    inside = (path / "opensfm" / _RECONSTRUCTION, path / _RECONSTRUCTION)
    found = next((one for one in inside if one.is_file()), None)
    if found is None:
        raise SensorModelError(messages.NO_PROJECT(folder=path))
    return found


def document(path: Path) -> Any:
    """An Element of XML, objects of JSON, or text; None for what looks like the first two and is neither."""
    content = file_content(path)
    try:
        if looks_like_xml(content):
            return xml_root(content)
        if content.lstrip()[:1] in (b"{", b"["):
            return json_document(content)
        return content.decode("utf-8-sig", errors="replace")
    except (ParseError, ValueError):
        return None


def _cameras(content: Any, path: Path) -> Mapping[str, Callable[[], FileCamera]]:
    """What makes each camera, by its name."""
    if isinstance(content, Element):
        if content.tag == "BlocksExchange":
            groups = enumerate(content.iter("Photogroup"))
            return {str(number): partial(_block_camera, group, path) for number, group in groups}
        if content.tag == "document":
            return {sensor.get("id", ""): partial(_metashape_camera, sensor, path) for sensor in content.iter("sensor")}
        return {"": partial(_metashape_camera if content.tag == "calibration" else _micmac_camera, content, path)}
    if isinstance(content, (dict, list)):
        if isinstance(content, list):  # of each part of a reconstruction
            cameras = {
                f"{part}/{name.removeprefix(VERSION)}": one
                for part, own in enumerate(content) for name, one in own["cameras"].items()
            }  # fmt: skip
        else:
            cameras = {name.removeprefix(VERSION): one for name, one in content.get("cameras", content).items()}
        if not all("projection_type" in one for one in cameras.values()):
            raise ValueError
        return {name: partial(_opensfm_camera, one, path) for name, one in cameras.items()}
    if "$CAMERA_DEFINITION" in content:
        return {
            inpho_value(block, "ID"): partial(_inpho_camera, block, path)
            for block in inpho_blocks(content, "CAMERA_DEFINITION")
        }
    photos = pix4d_photos(content)
    if photos:
        return {name: partial(_pix4d_camera, numbers) for name, numbers in photos.items()}
    return {name: partial(_orthority_camera, one, path) for name, one in _yaml_cameras(content, path).items()}


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


def _camera(
    size: Sequence[float], focal: Sequence[float], principal: Sequence[float], lens: Lens,
    centre: Sequence[float] | None = None, mount: np.ndarray | None = None,
) -> FileCamera:  # fmt: skip
    """All in pixels; ``principal`` and ``centre`` from the upper left corner of the first one."""
    point = np.array(principal, float)
    middle = point if centre is None else np.array(centre, float)
    interior = FrameInterior(np.broadcast_to(np.array(focal, float), 2).copy(), point, lens, middle)
    return FileCamera(interior, np.array(size, float), np.diag([1.0, -1.0]) if mount is None else mount)


def _yaml_cameras(content: str, path: Path) -> dict[str, Mapping[str, Any]]:
    cameras = yaml_document(content, path.name)
    if "im_size" in cameras:
        cameras = {"": cameras}
    if not all(isinstance(one, dict) and "im_size" in one for one in cameras.values()):
        raise ValueError
    return cameras


def _orthority_camera(values: Mapping[str, Any], path: Path) -> FileCamera:
    kind = str(values.get("type", "pinhole"))
    others = [str(key) for key, value in values.items() if value and key not in (*_ORTHORITY, *_LENSES.get(kind, ()))]
    if kind not in _LENSES or others:  # a distortion that is not computed here
        raise SensorModelError(messages.DISTORTION_UNKNOWN(name=path.name, kind=", ".join([kind, *others])))
    size = np.array(values["im_size"], float)
    sensor = values.get("sensor_size")
    # Without a sensor's size the focal length is one of sensor widths.
    focal = np.array(values["focal_len"], float) * (size / np.array(sensor, float) if sensor else size[0])
    offset = np.array([values.get("cx") or 0.0, values.get("cy") or 0.0], float)
    given = {key: float(values.get(key) or 0.0) for key in _LENSES[kind]}
    return _camera(size, focal, size / 2 + offset * size.max(), lens_of(kind, given))


def _opensfm_camera(values: Mapping[str, Any], path: Path) -> FileCamera:
    """Lengths are shares of the longer side, from the middle of the image."""
    kind = _OPENSFM.get(str(values["projection_type"]).lower())
    if kind is None:
        raise SensorModelError(messages.DISTORTION_UNKNOWN(name=path.name, kind=values["projection_type"]))
    size = np.array([values["width"], values["height"]], float)
    focal = [values["focal"]] if "focal" in values else [values["focal_x"], values["focal_y"]]
    offset = np.array([values.get("c_x") or 0.0, values.get("c_y") or 0.0], float)
    given = {key: float(values.get(key) or 0.0) for key in _LENSES[kind]}
    return _camera(size, np.array(focal, float) * size.max(), size / 2 + offset * size.max(), lens_of(kind, given))


def _metashape_camera(sensor: Element, path: Path) -> FileCamera:
    """A sensor of a project, or a calibration by itself; its p1 and p2 are OpenCV's p2 and p1."""
    found = [one for one in sensor.iter("calibration") if one.find("f") is not None]
    calibration = next((one for one in found if one.get("class") == "adjusted"), found[0])
    words = ("resolution", "projection", "date")
    values = {one.tag: float(one.text or 0) for one in calibration if one.tag not in words and not len(one)}
    kind = calibration.get("type") or calibration.findtext("projection") or "frame"
    if kind not in ("frame", "equidistant_fisheye") or values.get("b2") or (kind == "frame" and values.get("k4")):
        raise SensorModelError(messages.DISTORTION_UNKNOWN(name=path.name, kind=kind))
    sides = calibration.find("resolution")
    size = [values[name] if sides is None else float(sides.get(name, 0)) for name in ("width", "height")]
    focal = values["f"]
    theirs = {"p1": "p2", "p2": "p1"}
    given = {name: values.get(theirs.get(name, name), 0.0) for name in ("k1", "k2", "k3", "k4", "p1", "p2")}
    if kind != "frame" and (given.pop("p1"), given.pop("p2")) != (0, 0):
        raise SensorModelError(messages.DISTORTION_UNKNOWN(name=path.name, kind=f"{kind} p1, p2"))
    principal = [size[0] / 2 + values.get("cx", 0.0), size[1] / 2 + values.get("cy", 0.0)]
    lens = lens_of("brown" if kind == "frame" else "fisheye", given)
    return _camera(size, [focal + values.get("b1", 0.0), focal], principal, lens)


def _block_camera(group: Element, path: Path) -> FileCamera:
    """A photogroup of ContextCapture's BlocksExchange; its P1 and P2 are OpenCV's p2 and p1."""
    kind, skew = group.findtext("CameraModelType") or "Perspective", float(group.findtext("Skew") or 0)
    if kind != "Perspective" or skew:
        raise SensorModelError(messages.DISTORTION_UNKNOWN(name=path.name, kind=kind if not skew else "Skew"))
    size = numbers_of(group, "ImageDimensions/Width", "ImageDimensions/Height")
    focal = float(group.findtext("FocalLengthPixels") or 0)
    if not focal:
        length, sensor = numbers_of(group, "FocalLength", "SensorSize")
        focal = length / sensor * max(size)
    ratio = float(group.findtext("AspectRatio") or 1)
    point = group.find("PrincipalPoint")
    principal = [side / 2 for side in size] if point is None else numbers_of(point, "x", "y")
    names = {"k1": "K1", "k2": "K2", "k3": "K3", "p1": "P2", "p2": "P1"}
    given = {ours: float(group.findtext(f"Distortion/{theirs}") or 0) for ours, theirs in names.items()}
    return _camera(size, [focal, focal * ratio], principal, lens_of("brown", given))


def _micmac_camera(root: Element, path: Path) -> FileCamera:
    """A conical camera without distortion, or with a radial one about a centre of its own (NoDist, ModRad)."""
    inner = next(root.iter("CalibrationInternConique"))
    focal, size = numbers_of(inner, "F"), numbers_of(inner, "SzIm")
    principal, centre = numbers_of(inner, "PP"), None
    radial: tuple[float, ...] = ()
    for kind in (part for distortion in inner.iterfind("CalibDistortion") for part in distortion):
        if kind.tag == "ModRad" and centre is None:
            centre = numbers_of(kind, "CDist")
            coefficients = [float(one.text or "") for one in kind.iterfind("CoeffDist")]
            radial = tuple(one * focal[0] ** (2 * power) for power, one in enumerate(coefficients, 1))
        elif kind.tag not in ("ModNoDist", "NoDist"):
            raise SensorModelError(messages.DISTORTION_UNKNOWN(name=path.name, kind=kind.tag))
    convention = inner.findtext("KnownConv") or inner.findtext("ConvOri/KnownConv") or "eConvApero_DistM2C"
    if any(radial) and convention != "eConvApero_DistM2C":  # which bends the way from the ground to the image
        raise SensorModelError(messages.DISTORTION_UNKNOWN(name=path.name, kind=convention))
    if len(size) != 2 or len(principal) != 2:
        raise ValueError
    return _camera(size, focal[:1], principal, BrownLens(radial) if any(radial) else Lens(), centre)


def numbers_of(element: Element, *names: str) -> list[float]:
    """The numbers, one or several, of elements inside another one. Raises ValueError where one is missing."""
    return [float(word) for name in names for word in (element.findtext(name) or "missing").split()]


def pix4d_photos(content: str) -> dict[str, list[float]]:
    """Values by photo of ``..._calibrated_camera_parameters.txt``: sides, matrix, lens, position, rotation; or {}."""
    lines = content.splitlines()
    if not lines or not lines[0].startswith("fileName imageWidth imageHeight"):
        return {}
    photos = {}
    for number, line in enumerate(lines, 1):
        named = re.fullmatch(r"\s*(.*\S)\s+(\d+)\s+(\d+)\s*", line)
        if named and not re.fullmatch(r"[-+\d.eE\s]+", named[1]):
            words = " ".join([named[2], named[3], *lines[number : number + PIX4D_LINES]]).split()
            photos[named[1]] = [float(word) for word in words]
    return photos


def _pix4d_camera(numbers: Sequence[float]) -> FileCamera:
    matrix = np.reshape(numbers[2:11], (3, 3))
    given = dict(zip(("k1", "k2", "k3", "p1", "p2"), numbers[11:16]))
    return _camera(numbers[:2], [matrix[0, 0], matrix[1, 1]], matrix[:2, 2], lens_of("brown", given))


def inpho_blocks(content: str, name: str) -> list[str]:
    """The parts ``$NAME ... $END`` of an Inpho project."""
    ended = re.split(r"^\$END\b", content, flags=re.MULTILINE)[:-1]
    found = (re.search(rf"^\${name}\b(.*)", part, re.DOTALL | re.MULTILINE) for part in ended)
    return [one[1] for one in found if one]


def inpho_value(block: str, name: str) -> str:
    """What follows ``$NAME :`` up to the next key; empty where there is none."""
    found = re.search(rf"\${name}\s*:([^$]*)", block)
    return found[1].strip() if found else ""


def _inpho_camera(block: str, path: Path) -> FileCamera:
    """A digital camera without distortion, as Inpho resamples its images; its places are those of pixels' middles."""
    if inpho_value(block, "LENS_DISTORTION_FLAG").lower() == "on":
        raise SensorModelError(messages.DISTORTION_UNKNOWN(name=path.name, kind="LENS_DISTORTION"))
    affine = np.reshape([float(word) for word in inpho_value(block, "CCD_INTERIOR_ORIENTATION").split()], (2, 3))
    per_mm = np.linalg.norm(affine[:, :2], axis=1)
    point = np.array([float(word) for word in (inpho_value(block, "PRINCIPAL_POINT_PPA") or "0 0").split()[:2]])
    half = 0.5 if inpho_value(block, "PIXEL_REFERENCE") in ("", "CenterTopLeft") else 0.0
    size = [float(inpho_value(block, name)) for name in ("CCD_COLUMNS", "CCD_ROWS")]
    principal = affine[:, :2] @ point + affine[:, 2] + half
    focal = float(inpho_value(block, "FOCAL_LENGTH")) * per_mm
    return _camera(size, focal, principal, Lens(), mount=affine[:, :2] / per_mm[:, None])
