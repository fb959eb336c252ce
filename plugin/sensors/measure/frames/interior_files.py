"""Interior orientation from files: orthority's YAML, MicMac's AutoCal XML."""
from __future__ import annotations

import math
from collections.abc import Mapping
from pathlib import Path
from typing import Any
from xml.etree.ElementTree import Element, ParseError

import numpy as np

from ....imagery import messages as imagery_messages
from ....imagery.documents.document_files import document_bytes
from ....imagery.documents.xml_documents import looks_like_xml, xml_root
from ....imagery.errors import SensorModelError
from .. import messages
from ..models.frame_camera import FrameInterior

MAX_SHAPE_DIFFERENCE = 0.01  # of an image's sides against its camera's: a reduced image is a pixel off at most
MAX_PIXEL_RATIO = 1.5  # of a pixel's sides: film that has shrunk is far from it, interchanged sides are beyond
_RADIAL, _TANGENTIAL = ("k1", "k2", "k3"), ("p1", "p2")
_PLAIN = ("type", "im_size", "focal_len", "sensor_size", "cx", "cy")


def read_interior(path: Path, camera: str, size: tuple[int, int]) -> FrameInterior:
    """The camera of a file, scaled to an image of ``size`` (columns, rows); ``camera`` chooses among several.

    Raises SensorModelError for a file that is none, a camera of another shape than the image, a distortion that is
    not known here.
    """
    try:
        content = document_bytes(path)
    except OSError:
        raise SensorModelError(imagery_messages.NOT_FOUND(path=path)) from None
    try:
        made, own_size = _micmac(content, path) if looks_like_xml(content) else _orthority(content, path, camera)
        values = np.concatenate([made.focal, made.principal, made.radial, made.tangential, made.distortion_centre])
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
    return FrameInterior(
        made.focal * scale, made.principal * scale, made.radial, made.tangential, made.distortion_centre * scale
    )


def _orthority(content: bytes, path: Path, camera: str) -> tuple[FrameInterior, np.ndarray]:
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
    _refuse_others(values, path)
    size = np.array(values["im_size"], float)
    sensor = values.get("sensor_size")
    # Without a sensor's size the focal length is one of sensor widths.
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):  # what is not finite is refused
        focal = np.array(values["focal_len"], float) * (size / np.array(sensor, float) if sensor else size[0])
    offset = np.array([values.get("cx") or 0.0, values.get("cy") or 0.0], float)
    principal = size / 2 + offset * size.max()
    radial, tangential = (np.array([values.get(key) or 0.0 for key in keys], float) for keys in (_RADIAL, _TANGENTIAL))
    return FrameInterior(np.broadcast_to(focal, 2).copy(), principal, radial, tangential, principal), size


def _refuse_others(values: Mapping[str, Any], path: Path) -> None:
    """Raise SensorModelError where a distortion plays a part that is not computed here."""
    known = {*_PLAIN, *_RADIAL, *_TANGENTIAL}
    others = [str(key) for key, value in values.items() if key not in known and value]
    kind = str(values.get("type", "pinhole"))
    if kind not in ("pinhole", "brown", "opencv") or others:
        raise SensorModelError(messages.DISTORTION_UNKNOWN(name=path.name, kind=", ".join([kind, *others])))


def _micmac(content: bytes, path: Path) -> tuple[FrameInterior, np.ndarray]:
    """A conical camera without distortion, or with a radial one about a centre of its own (NoDist, ModRad)."""
    root = xml_root(content)
    inner = root if root.tag == "CalibrationInternConique" else root.find(".//CalibrationInternConique")
    if inner is None:
        raise ValueError
    focal, size = _numbers(inner, "F"), _numbers(inner, "SzIm")
    principal, centre, radial = _numbers(inner, "PP"), None, np.zeros(1)
    for kind in (part for distortion in inner.iterfind("CalibDistortion") for part in distortion):
        if kind.tag == "ModRad" and centre is None:
            centre = _numbers(kind, "CDist")
            coefficients = [float(one.text or "") for one in kind.iterfind("CoeffDist")]
            radial = np.array([one * focal[0] ** (2 * power) for power, one in enumerate(coefficients, 1)])
        elif kind.tag not in ("ModNoDist", "NoDist"):
            raise SensorModelError(messages.DISTORTION_UNKNOWN(name=path.name, kind=kind.tag))
    convention = inner.findtext("KnownConv") or inner.findtext("ConvOri/KnownConv") or "eConvApero_DistM2C"
    if radial.any() and convention != "eConvApero_DistM2C":  # which bends the way from the ground to the image
        raise SensorModelError(messages.DISTORTION_UNKNOWN(name=path.name, kind=convention))
    if math.isnan(size.sum()) or len(size) != 2 or len(principal) != 2:
        raise ValueError
    return (
        FrameInterior(
            np.repeat(focal[:1], 2), principal, radial, np.zeros(2), principal if centre is None else centre
        ),
        size,
    )


def _numbers(element: Element, name: str) -> np.ndarray:
    return np.array((element.findtext(name) or "nan").split(), float)
