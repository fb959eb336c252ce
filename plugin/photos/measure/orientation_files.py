"""The files that other programs take from an interior orientation, and MicMac's measured marks.

MicMac keeps them in ``Ori-InterneScan/MeasuresIm-PHOTO.xml``, a photo's marks in pixels.
"""
from __future__ import annotations

import math
from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import Any
from xml.etree import ElementTree
from xml.etree.ElementTree import Element, ParseError, SubElement

import numpy as np

from ...imagery.documents import document_bytes, looks_like_xml, xml_root
from ...imagery.errors import PhotoError
from ...imagery.messages import system_reason
from . import messages
from .camera_calibration import CameraCalibration
from .orientation import MarkResult, PhotoOrientation
from .photo import Photo, Place

_SET, _PHOTO, _MARK = "SetOfMesureAppuisFlottants", "MesureAppuiFlottant1Im", "OneMesureAF1I"


def parameters(photo: Photo, calibration: CameraCalibration, made: PhotoOrientation) -> dict[str, Any]:
    """All there is to know about the transformation of a photo that has one, ready for JSON."""
    fitted, orientation = made.fitted, made.scan_orientation
    assert fitted is not None
    corners = np.array([[0.0, 0.0], [photo.columns, 0.0], [0.0, photo.rows], [photo.columns, photo.rows]])
    linear = fitted.to_mm.linear(corners)[:, :2]
    across, down = (float(size) for size in np.hypot(*linear))
    pixel_size = {"x": 1000 * across, "y": 1000 * down}
    cosine = float(np.clip(linear[:, 0] @ linear[:, 1] / (across * down), -1, 1))
    column, row = fitted.to_pixels(np.array([calibration.principal_point]))[0]
    focal_length = calibration.focal_length
    return {
        "photo": photo.ref.name,
        "columns": photo.columns,
        "rows": photo.rows,
        "pixel_coordinates": "column to the right, row downwards, the first pixel's centre at (0.5, 0.5)",
        "photo_coordinates": "mm, x to the right, y upwards",
        "model": fitted.to_mm.model,
        "to_mm": fitted.to_mm.matrix.tolist(),
        "to_pixels": fitted.to_pixels.matrix.tolist(),
        "pixel_size_um": pixel_size,  # along the rows and along the columns
        "scale_px_per_mm": {axis: 1000 / size for axis, size in pixel_size.items()},
        "rotation_deg": math.degrees(math.atan2(linear[1, 0], linear[0, 0])),  # of the rows against the x axis
        "shear_deg": math.degrees(math.asin(cosine)),
        "mirrored": bool(np.linalg.det(linear) > 0),
        "lies": None if orientation is None else {
            "turned_deg": orientation.turned,
            "mirrored": orientation.mirrored,
            "known_by": None if made.evidence is None else made.evidence,
        },
        "marks": fitted.marks,
        "redundancy": fitted.redundancy,
        "rms_um": fitted.rms if fitted.redundancy else None,
        "rms_x_um": fitted.rms_x if fitted.redundancy else None,
        "rms_y_um": fitted.rms_y if fitted.redundancy else None,
        "principal_point_mm": {"x": calibration.principal_point[0], "y": calibration.principal_point[1]},
        "principal_point_px": {"column": float(column), "row": float(row)},
        "focal_length_mm": focal_length,
        "focal_length_px": None if focal_length is None else focal_length / math.sqrt(across * down),
        "notices": [str(notice) for notice in made.notices],
    }


def world_file(made: PhotoOrientation) -> str:
    """The six lines of a world file that puts a photo's pixels in millimetres. A projective transformation is replaced
    by the affine one that comes nearest at the photo's marks."""
    assert made.fitted is not None
    places = np.array([mark.place for mark in made.marks if mark.place is not None])
    a, b, c, d, e, f = made.fitted.to_mm.linear(places).ravel()
    lines = (a, d, b, e, a / 2 + b / 2 + c, d / 2 + e / 2 + f)
    return "".join(f"{value:.15g}\n" for value in lines)


def measures_text(photo: str, marks: Iterable[MarkResult]) -> str:
    """The document for one photo: every mark that has a place, its column and row with pixel centres at .5."""
    root = Element(_SET)
    image = SubElement(root, _PHOTO)
    SubElement(image, "NameIm").text = photo
    for mark in marks:
        if mark.place is not None:
            measure = SubElement(image, _MARK)
            SubElement(measure, "NamePt").text = mark.name
            SubElement(measure, "PtIm").text = " ".join(f"{value:.6f}" for value in mark.place)
    ElementTree.indent(root, " " * 5)
    return '<?xml version="1.0" ?>\n' + ElementTree.tostring(root, encoding="unicode") + "\n"


def read_measures(path: Path) -> list[tuple[str, str, Place]]:
    """Photo, mark and its column and row, of all photos in a file; none where the XML is about something else. Raises
    PhotoError for a file that can't be read."""
    try:
        content = document_bytes(path)
        if not looks_like_xml(content):
            raise ParseError
        return list(_measures(xml_root(content), path.name))
    except OSError as error:
        raise PhotoError(messages.MEASURES_NOT_READ(name=path.name, error=system_reason(error))) from None
    except ParseError:
        raise PhotoError(messages.MEASURES_NOT_READ(name=path.name, error="no XML")) from None


def _measures(root: Element, name: str) -> Iterator[tuple[str, str, Place]]:
    for image in root.iter(_PHOTO):
        photo = (image.findtext("NameIm") or "").strip()
        for measure in image.iter(_MARK):
            mark = (measure.findtext("NamePt") or "").strip()
            try:
                column, row = (float(part) for part in (measure.findtext("PtIm") or "").split())
            except ValueError:
                raise PhotoError(messages.MEASURES_ROW(name=name, mark=mark)) from None
            yield photo, mark, (column, row)
