"""The request and the result of an interior orientation, the files that other programs take of it and MicMac's marks.

MicMac keeps them in ``Ori-InterneScan/MeasuresIm-PHOTO.xml``, a photo's marks in pixels.
"""
from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any
from xml.etree import ElementTree
from xml.etree.ElementTree import Element, ParseError, SubElement

import numpy as np

from ...imagery.documents import document_bytes, looks_like_xml, xml_root
from ...imagery.errors import Message, PhotoError
from ...imagery.messages import system_reason
from . import limits, messages
from .camera_calibration import CameraCalibration
from .mark_templates import CutOut, MarkShape
from .measuring_marks import MeasuredMark
from .photo import Photo, PhotoView, Place
from .scan_orientation import ScanOrientation
from .transformations import Transformation


@dataclass(frozen=True)
class FittedTransformation:
    to_mm: Transformation  # columns and rows to photo coordinates, mm
    to_pixels: Transformation  # back, fitted the same way's inverse
    marks: int  # how many took part
    redundancy: int  # degrees of freedom left over; with 0 the residuals are 0 and tell nothing
    rms_x: float  # root mean square of the residuals in x, um
    rms_y: float  # root mean square of the residuals in y, um

    @property
    def rms(self) -> float:
        """Root mean square of the residual vectors' lengths, um."""
        return math.hypot(self.rms_x, self.rms_y)


@dataclass(frozen=True)
class OrientationSettings:
    template: CutOut | None = None  # the user's own; else marks are drawn
    shapes: tuple[MarkShape, ...] = ()  # the marks that are drawn, their sizes of no meaning; none for all there are
    sign: int | None = None
    """1 for marks lighter than their ground (or like the template), -1 for darker ones; None for either."""
    search_mm: float = limits.DEFAULT_SEARCH_MM  # distance around a position within which its mark is looked for, mm
    min_correlation: float = limits.DEFAULT_MIN_CORRELATION  # smallest correlation of a measured mark
    surface: str = limits.CORRELATION  # what a mark is placed to a fraction of a pixel by
    model: str = limits.AFFINE  # the transformation from the scan to the calibration


@dataclass(frozen=True)
class GivenPosition:
    place: Place  # column and row, px, pixel centres at .5
    measure: bool = True  # whether it is approximate and to be measured; else it is taken as it is


@dataclass(frozen=True)
class MarkResult:
    """A mark of the calibration, as measured or failed."""

    name: str
    calibrated: Place  # mm
    status: str
    place: Place | None  # column and row, px, pixel centres at .5; None where it failed
    correlation: float | None = None
    reason: Message | None = None  # why it failed
    residual: Place | None = None  # transformed less calibrated, um in x and y; None without a transformation


@dataclass(frozen=True)
class PhotoOrientation:
    marks: tuple[MarkResult, ...]  # in the order of the calibration
    fitted: FittedTransformation | None  # the transformation; None where too few marks were found
    scan_orientation: ScanOrientation | None  # the way the photo lies in the scan; None where it is not known
    evidence: str | None  # the evidence for that
    template: MarkShape | CutOut | None  # the template that the marks were measured with
    notices: tuple[Message, ...] = ()  # warnings and remarks for the user
    views: Mapping[str, PhotoView] = field(default_factory=dict)
    """The surroundings of each mark, for pictures; of a failed one where it should be."""
    expected: Mapping[str, Place] = field(default_factory=dict)  # where failed marks should be, px

    def count(self, status: str) -> int:
        return sum(mark.status == status for mark in self.marks)


@dataclass(frozen=True)
class MarkSearch:
    """The marks that were looked for, as measured or failed."""

    results: Mapping[str, MeasuredMark] = field(default_factory=dict)  # by the calibration's names, but for given marks
    template: MarkShape | CutOut | None = None  # what they were measured with
    scan_orientation: ScanOrientation | None = None  # how the photo lies, where the search told
    evidence: str | None = None  # what told
    notices: tuple[Message, ...] = ()  # what the user should know

    @property
    def count(self) -> int:
        return sum(mark.place is not None for mark in self.results.values())


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
            "known_by": made.evidence,
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
