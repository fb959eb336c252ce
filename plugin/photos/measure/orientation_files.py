"""The files that other programs take from an interior orientation."""
from __future__ import annotations

import json
import math
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from pathlib import Path
from xml.etree import ElementTree
from xml.etree.ElementTree import Element, ParseError, SubElement

import numpy as np

from ...imagery.documents import document_bytes, looks_like_xml, xml_root
from ...imagery.errors import PhotoError
from ...imagery.messages import system_reason
from . import messages
from .camera_calibration import CameraCalibration
from .orientation import FittedTransformation, MarkResult, PhotoOrientation
from .photo import Photo, Place


@dataclass(frozen=True)
class OrientationParameters:
    """What a transformation says of a scan."""

    pixel_size_um: dict[str, float]
    """``x`` along the rows, ``y`` along the columns."""
    rotation_deg: float
    """Of the rows against the x axis."""
    shear_deg: float
    mirrored: bool
    principal_point_px: dict[str, float]
    """``column`` and ``row``."""
    focal_length_px: float | None


def orientation_parameters(
    photo: Photo, calibration: CameraCalibration, made: PhotoOrientation
) -> OrientationParameters:
    """Of a photo that has a transformation; raises PhotoError where there is none."""
    fitted = _fitted(made)
    corners = np.array([[0.0, 0.0], [photo.columns, 0.0], [0.0, photo.rows], [photo.columns, photo.rows]])
    linear = fitted.to_mm.linear(corners)[:, :2]
    across, down = (float(size) for size in np.hypot(*linear))
    cosine = float(np.clip(linear[:, 0] @ linear[:, 1] / (across * down), -1, 1))
    column, row = fitted.to_pixels(np.array([calibration.principal_point]))[0]
    return OrientationParameters(
        {"x": 1000 * across, "y": 1000 * down},
        math.degrees(math.atan2(linear[1, 0], linear[0, 0])),
        math.degrees(math.asin(cosine)),
        bool(np.linalg.det(linear) > 0),
        {"column": float(column), "row": float(row)},
        None if calibration.focal_length is None else calibration.focal_length / math.sqrt(across * down),
    )


def parameters(photo: Photo, calibration: CameraCalibration, made: PhotoOrientation) -> dict[str, object]:
    """All there is to know about a transformation, ready for JSON. Raises PhotoError where there is none."""
    fitted, values = _fitted(made), orientation_parameters(photo, calibration, made)
    orientation = made.scan_orientation
    return {
        "photo": photo.ref.name,
        "columns": photo.columns,
        "rows": photo.rows,
        "pixel_coordinates": "column to the right, row downwards, the first pixel's centre at (0.5, 0.5)",
        "photo_coordinates": "mm, x to the right, y upwards",
        "model": fitted.to_mm.model.value,
        "to_mm": _rows(fitted.to_mm.matrix),
        "to_pixels": _rows(fitted.to_pixels.matrix),
        "pixel_size_um": values.pixel_size_um,
        "scale_px_per_mm": {axis: 1000 / size for axis, size in values.pixel_size_um.items()},
        "rotation_deg": values.rotation_deg,
        "shear_deg": values.shear_deg,
        "mirrored": values.mirrored,
        "lies": None if orientation is None else {
            "turned_deg": orientation.turned,
            "mirrored": orientation.mirrored,
            "known_by": None if made.evidence is None else made.evidence.value,
        },
        "marks": fitted.marks,
        "redundancy": fitted.redundancy,
        "rms_um": fitted.rms if fitted.redundancy else None,
        "rms_x_um": fitted.rms_x if fitted.redundancy else None,
        "rms_y_um": fitted.rms_y if fitted.redundancy else None,
        "principal_point_mm": {"x": calibration.principal_point[0], "y": calibration.principal_point[1]},
        "principal_point_px": values.principal_point_px,
        "focal_length_mm": calibration.focal_length,
        "focal_length_px": values.focal_length_px,
        "notices": [str(notice) for notice in made.notices],
    }


def world_file(photo: Photo, made: PhotoOrientation) -> str:
    """The six lines of a world file that puts a photo's pixels in millimetres.

    A projective transformation is replaced by the affine one that comes nearest at the photo's marks. Raises PhotoError
    where there is no transformation.
    """
    fitted = _fitted(made)
    places = np.array([mark.place for mark in made.marks if mark.place is not None])
    a, b, c, d, e, f = fitted.to_mm.linear(places).ravel()
    lines = (a, d, b, e, a / 2 + b / 2 + c, d / 2 + e / 2 + f)
    return "".join(f"{value:.15g}\n" for value in lines)


def parameters_text(photo: Photo, calibration: CameraCalibration, made: PhotoOrientation) -> str:
    """``parameters`` as JSON."""
    return json.dumps(parameters(photo, calibration, made), indent=2, ensure_ascii=False) + "\n"


def _fitted(made: PhotoOrientation) -> FittedTransformation:
    if made.fitted is None:
        raise PhotoError(messages.NO_TRANSFORMATION())
    return made.fitted


def _rows(matrix: np.ndarray) -> list[list[float]]:
    return [[float(value) for value in row] for row in matrix]


_SET, _PHOTO, _MARK = "SetOfMesureAppuisFlottants", "MesureAppuiFlottant1Im", "OneMesureAF1I"


def measures_text(photo: str, marks: Iterable[MarkResult]) -> str:
    """The document for one photo: every mark that has a place, its column and row with pixel centres at .5."""
    root = Element(_SET)
    image = SubElement(root, _PHOTO)
    SubElement(image, "NameIm").text = photo
    for mark in marks:
        if mark.place is not None:
            one = SubElement(image, _MARK)
            SubElement(one, "NamePt").text = mark.name
            SubElement(one, "PtIm").text = " ".join(f"{value:.6f}" for value in mark.place)
    ElementTree.indent(root, " " * 5)
    return '<?xml version="1.0" ?>\n' + ElementTree.tostring(root, encoding="unicode") + "\n"


def read_measures(path: Path) -> list[tuple[str, str, Place]]:
    """Photo, mark and its column and row, of all photos in a file; none where the XML is about something else.

    Raises PhotoError for a file that can't be read.
    """
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
        for one in image.iter(_MARK):
            mark = (one.findtext("NamePt") or "").strip()
            try:
                column, row = (float(part) for part in (one.findtext("PtIm") or "").split())
            except ValueError:
                raise PhotoError(messages.MEASURES_ROW(name=name, mark=mark)) from None
            yield photo, mark, (column, row)
