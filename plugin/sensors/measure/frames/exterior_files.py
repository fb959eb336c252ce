"""Exterior orientation from files: tables, orthority's GeoJSON, MicMac's Orientation XML."""
from __future__ import annotations

import csv
import math
from dataclasses import dataclass
from pathlib import Path
from xml.etree.ElementTree import ParseError

import numpy as np

from ....imagery import messages as imagery_messages
from ....imagery.documents.document_files import document_bytes, json_document
from ....imagery.documents.xml_documents import looks_like_xml, xml_root
from ....imagery.errors import SensorModelError
from .. import messages
from ..models.frame_camera import camera_axes

_FIELDS = ("filename", "x", "y", "z", "omega", "phi", "kappa")
_DIGITS = 1e-4  # how far from orthonormal axes in a text may be
_SHOWN = 5
_LEAST_RADIANS = 1.4  # a photo flown to the north or back has 1.57 or 3.14; in degrees nobody flies just so


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
    try:
        content = document_bytes(path)
    except OSError:
        raise SensorModelError(imagery_messages.NOT_FOUND(path=path)) from None
    try:
        if looks_like_xml(content):
            found = _micmac(content)
        elif content.lstrip()[:1] == b"{":
            found = _geojson(content, path, image)
        else:
            found = _table(content, path, image)
    except (ParseError, ValueError, TypeError, KeyError, IndexError, AttributeError, csv.Error):
        raise SensorModelError(messages.NO_EXTERIOR(name=path.name)) from None
    sound = found.position.shape == (3,) and found.axes.shape == (3, 3) and np.isfinite(found.position).all()
    if not sound or not np.allclose(found.axes.T @ found.axes, np.eye(3), atol=_DIGITS):
        raise SensorModelError(messages.NO_EXTERIOR(name=path.name))
    return found


def _micmac(content: bytes) -> FrameExterior:
    """``Orientation-IMAGE.xml``: centre and axes (rows down, view forward) as a matrix; one file an image."""
    root = xml_root(content)
    outer = root if root.tag == "Externe" else root.find(".//Externe")
    if outer is None:
        raise ValueError
    rows = [(outer.findtext(f"ParamRotation/CodageMatr/L{number}") or "").split() for number in (1, 2, 3)]
    return FrameExterior(np.array((outer.findtext("Centre") or "").split(), float), np.array(rows, float), "", "")


def _geojson(content: bytes, path: Path, image: str) -> FrameExterior:
    """orthority's: angles in radians, the reference system beside the features."""
    document = json_document(content)
    rows = [one["properties"] for one in document["features"]]
    row = rows[_index([str(one["filename"]) for one in rows], path, image)]
    return FrameExterior(
        np.array(row["xyz"], float), camera_axes(*(math.degrees(float(angle)) for angle in row["opk"])),
        str(row.get("camera") or ""), str(document.get("world_crs") or ""),
    )  # fmt: skip


def _table(content: bytes, path: Path, image: str) -> FrameExterior:
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
