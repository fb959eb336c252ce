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
from .sensor_model import file_content

MAX_SHAPE_DIFFERENCE = 0.01  # of an image's sides against its camera's: a reduced image is a pixel off at most
MAX_PIXELS = 1e9  # of an image's side, a focal length, or from the image to the principal point
MAX_PIXEL_RATIO = 1.5  # of a pixel's sides: film that has shrunk is far from it, interchanged sides are beyond
BROKEN = (ParseError, ArithmeticError, ValueError, TypeError, LookupError, AttributeError, StopIteration)
"""The exceptions of a document that is of none of the known formats, when it is taken apart."""
_ORTHORITY = ("type", "im_size", "focal_len", "sensor_size", "cx", "cy")
_BROWN = ("k1", "k2", "k3", "p1", "p2")
_LENSES = {"pinhole": (), "brown": _BROWN, "opencv": _BROWN, "fisheye": ("k1", "k2", "k3", "k4")}
"""Types of lenses and the coefficients of each, named as orthority and OpenCV do."""
_OPENSFM = {
    "perspective": "brown", "simple_radial": "brown", "radial": "brown", "brown": "brown", "fisheye": "fisheye",
    "fisheye_opencv": "fisheye",
}  # fmt: skip
VERSION = "v2 "  # what OpenSfM has before cameras' names and OpenDroneMap leaves out in cameras.json
_RECONSTRUCTION = "reconstruction.json"
_STRAIGHT = np.diag([1.0, -1.0])  # the mount of all cameras but Inpho's, which says it
_MOST_YAML = 300_000  # characters, of some hundred cameras: PyYAML reads a hundred thousand in a second
PIX4D_LINES = 9  # of a photo: three of the camera's matrix, two of its lens, its position, three of its rotation


@dataclass(frozen=True)
class FileCamera:
    """The camera of a file, in its own pixels."""

    interior: FrameInterior
    size: np.ndarray  # (2,) columns and rows
    mount: np.ndarray  # (2, 2) columns and rows by the axes that the file's rotations turn, x to the right, y upwards


@dataclass(frozen=True)
class Cameras:
    name: str  # the file's
    cameras: Mapping[str, Callable[[], FileCamera]]  # what makes each, by its name

    def chosen(self, camera: str) -> FileCamera:
        """Camera by name, of any part of a reconstruction after the slash, or the only one. Raises SensorModelError."""
        names = [camera, camera.partition("/")[2], *(self.cameras if len(self.cameras) == 1 else ())]
        known = next((name for name in names if name in self.cameras), None)
        if known is None and self.cameras:
            raise SensorModelError(messages.CAMERA_UNKNOWN(name=self.name, names=", ".join(map(str, self.cameras))))
        with np.errstate(all="ignore"):  # what is not finite is refused
            return self.cameras[str(known)]()

    def of(self, camera: str, size: tuple[int, int]) -> FrameInterior:
        """A camera scaled to an image of ``size`` (columns, rows). Raises SensorModelError where they do not fit."""
        try:
            chosen = self.chosen(camera)
            made, sides = chosen.interior, chosen.size
            lens = map(np.atleast_1d, vars(made.lens).values())
            pixels = np.concatenate([made.focal, made.principal, sides])
            sound = (
                sides.shape == (2,) and np.isfinite(np.concatenate([pixels, *lens])).all()
                and np.abs(pixels).max() <= MAX_PIXELS and min(*made.focal, *sides) >= 1
            )
        except BROKEN:
            sound = False
        if not sound:
            raise SensorModelError(messages.NO_INTERIOR(name=self.name))
        scale = np.array(size) / sides
        if abs(scale[0] / scale[1] - 1) > MAX_SHAPE_DIFFERENCE:
            width, height = np.rint(sides).astype(int).tolist()
            raise SensorModelError(messages.INTERIOR_OF_ANOTHER_SHAPE(
                name=self.name, width=width, height=height, columns=size[0], rows=size[1]
            ))
        ratio = float(made.focal[1] / made.focal[0])
        if not 1 / MAX_PIXEL_RATIO <= ratio <= MAX_PIXEL_RATIO:
            raise SensorModelError(messages.PIXELS_NOT_SQUARE(name=self.name, ratio=ratio))
        return replace(made, focal=made.focal * scale, principal=made.principal * scale)


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
    for reconstruction in (path / "opensfm" / _RECONSTRUCTION, path / _RECONSTRUCTION):
        if reconstruction.is_file():
            return reconstruction
    raise SensorModelError(messages.NO_BLOCK())


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
    """The function that makes each camera, by the camera's name."""
    if isinstance(content, Element):
        if content.tag == "BlocksExchange":
            groups = enumerate(content.iter("Photogroup"))
            return {str(number): partial(_block_camera, group, path) for number, group in groups}
        if content.tag == "document":
            return {sensor.get("id", ""): partial(_metashape_camera, sensor, path) for sensor in content.iter("sensor")}
        return {"": partial(_metashape_camera, content, path)}
    if isinstance(content, (dict, list)):
        if isinstance(content, list):
            parts = {f"{number}/": part["cameras"] for number, part in enumerate(content)}  # of a reconstruction
        else:
            parts = {"": content.get("cameras", content)}
        cameras = {part + name.removeprefix(VERSION): camera for part in parts for name, camera in parts[part].items()}
        if not all("projection_type" in camera for camera in cameras.values()):
            raise ValueError
        return {name: partial(_opensfm_camera, camera, path) for name, camera in cameras.items()}
    if "$CAMERA_DEFINITION" in content:
        blocks = inpho_blocks(content, "CAMERA_DEFINITION")
        return {inpho_value(block, "ID"): partial(_inpho_camera, block, path) for block in blocks}
    if photos := pix4d_photos(content):

        def pix4d(numbers: Sequence[float]) -> FileCamera:
            matrix, lens = np.reshape(numbers[2:11], (3, 3)), lens_of("brown", dict(zip(_BROWN, numbers[11:16])))
            return _camera(numbers[:2], [matrix[0, 0], matrix[1, 1]], matrix[:2, 2], lens)

        return {name: partial(pix4d, numbers) for name, numbers in photos.items()}
    return _orthority_cameras(content, path)


def lens_of(kind: str, values: Mapping[str, Any]) -> Lens:
    """A lens of ``_LENSES`` by its coefficients as OpenCV names them; those that are not given are 0."""
    terms = tuple(float(values.get(name) or 0.0) for name in _LENSES[kind])
    if kind == "fisheye":
        return FisheyeLens(terms)
    return BrownLens(terms[:3], (terms[3], terms[4])) if any(terms) else Lens()


def _camera(
    size: Sequence[float], focal: Sequence[float], principal: Sequence[float], lens: Lens, mount: np.ndarray = _STRAIGHT
) -> FileCamera:
    """A camera in pixels; ``principal`` from the upper left corner of the first one."""
    sides = np.broadcast_to(np.array(focal, float), 2).copy()
    return FileCamera(FrameInterior(sides, np.array(principal, float), lens), np.array(size, float), mount)


def _orthority_cameras(content: str, path: Path) -> Mapping[str, Callable[[], FileCamera]]:
    """Raises SensorModelError without PyYAML."""
    try:
        import yaml
    except ImportError:
        raise SensorModelError(messages.YAML_MISSING(name=path.name)) from None
    try:
        cameras: Any = yaml.safe_load(content) if len(content) <= _MOST_YAML else None
    except (yaml.YAMLError, RecursionError):
        raise ValueError from None
    cameras = {"": cameras} if "im_size" in cameras else cameras
    if not all(isinstance(camera, dict) and "im_size" in camera for camera in cameras.values()):
        raise ValueError
    return {name: partial(_orthority_camera, camera, path) for name, camera in cameras.items()}


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
    return _camera(size, focal, size / 2 + offset * size.max(), lens_of(kind, values))


def _opensfm_camera(values: Mapping[str, Any], path: Path) -> FileCamera:
    """A camera of OpenSfM, whose lengths are shares of the longer side, from the middle of the image."""
    kind = _OPENSFM.get(str(values["projection_type"]).lower())
    if kind is None:
        raise SensorModelError(messages.DISTORTION_UNKNOWN(name=path.name, kind=values["projection_type"]))
    size = np.array([values["width"], values["height"]], float)
    focal = [values["focal"]] if "focal" in values else [values["focal_x"], values["focal_y"]]
    offset = np.array([values.get("c_x") or 0.0, values.get("c_y") or 0.0], float)
    return _camera(size, np.array(focal, float) * size.max(), size / 2 + offset * size.max(), lens_of(kind, values))


def _metashape_camera(sensor: Element, path: Path) -> FileCamera:
    """A sensor of a project, or a calibration by itself; its p1 and p2 are OpenCV's p2 and p1."""
    calibrations = [element for element in sensor.iter("calibration") if element.find("f") is not None]
    calibration = next((element for element in calibrations if element.get("class") == "adjusted"), calibrations[0])
    words = ("resolution", "projection", "date")
    values = {term.tag: float(term.text or 0) for term in calibration if term.tag not in words and not len(term)}
    kind = calibration.get("type") or calibration.findtext("projection") or "frame"
    if kind not in ("frame", "equidistant_fisheye") or values.get("b2") or (kind == "frame" and values.get("k4")):
        raise SensorModelError(messages.DISTORTION_UNKNOWN(name=path.name, kind=kind))
    sides = calibration.find("resolution")
    size = [values[name] if sides is None else float(sides.get(name, 0)) for name in ("width", "height")]
    focal = values["f"]
    if kind != "frame" and (values.get("p1") or values.get("p2")):
        raise SensorModelError(messages.DISTORTION_UNKNOWN(name=path.name, kind=f"{kind} p1, p2"))
    principal = [size[0] / 2 + values.get("cx", 0.0), size[1] / 2 + values.get("cy", 0.0)]
    terms = {**values, "p1": values.get("p2"), "p2": values.get("p1")}
    lens = lens_of("brown" if kind == "frame" else "fisheye", terms)
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
    terms = {name: group.findtext(f"Distortion/{term}") for name, term in zip(_BROWN, ("K1", "K2", "K3", "P2", "P1"))}
    return _camera(size, [focal, focal * ratio], principal, lens_of("brown", terms))


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


def inpho_blocks(content: str, name: str) -> list[str]:
    """The parts ``$NAME ... $END`` of an Inpho project."""
    ended = re.split(r"^\$END\b", content, flags=re.MULTILINE)[:-1]
    matches = (re.search(rf"^\${name}\b(.*)", part, re.DOTALL | re.MULTILINE) for part in ended)
    return [match[1] for match in matches if match]


def inpho_value(block: str, name: str) -> str:
    """The text after ``$NAME :`` up to the next key; empty where there is none."""
    match = re.search(rf"\${name}\s*:([^$]*)", block)
    return match[1].strip() if match else ""


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
