"""A camera's calibrated fiducial marks: from CSV, or from MicMac's MeasuresCamera.xml."""
from __future__ import annotations

import csv
import io
import math
import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import combinations
from pathlib import Path
from typing import Any
from xml.etree.ElementTree import ParseError

import numpy as np

from ...imagery.documents import document_bytes, looks_like_xml, xml_root
from ...imagery.errors import PhotoError
from ...imagery.messages import system_reason
from . import messages
from .transformations import LEAST_MARKS, fit_transformation

MIN_FRAME_MM = 24.0  # the short side of 35 mm film, the smallest frame; 23 cm given in centimetres is below it
MAX_FRAME_MM = 1000.0  # no frame is that long; 23 cm given in micrometres is far above it
MIN_MARK_DISTANCE = 0.01  # of the frame: nearer ones are one mark with two names

Point = tuple[float, float]

FOCAL_LENGTH = "focal_length"
OTHER_ROWS = ("principal_point", FOCAL_LENGTH, "data_strip")  # rows of the CSV that are no marks


@dataclass(frozen=True)
class CameraCalibration:
    """The content of a camera's certificate. Millimetres, x to the right, y upwards."""

    marks: Mapping[str, Point]  # the marks by name, in the file's order
    principal_point: Point = (0.0, 0.0)  # where the optical axis meets the film
    focal_length: float | None = None  # mm
    data_strip: Point | None = None  # somewhere in the strip of instruments or writing beside the picture

    @property
    def points(self) -> np.ndarray:
        """(n, 2) mm, in the order of the marks."""
        return np.array(list(self.marks.values()), dtype=np.float64)

    @property
    def span(self) -> float:
        return float(np.ptp(self.points, axis=0).max())


def read_calibration(path: Path) -> CameraCalibration:
    """The calibration in a file. Raises PhotoError when there is none."""
    try:
        content = document_bytes(path)
        in_xml = looks_like_xml(content)
        calibration = _micmac(content, path.name) if in_xml else _table(content.decode("utf-8-sig"), path.name)
    except OSError as error:
        raise PhotoError(messages.CALIBRATION_NOT_READ(path=path, error=system_reason(error))) from None
    except (UnicodeDecodeError, ParseError, csv.Error):
        raise PhotoError(messages.CALIBRATION_UNKNOWN(name=path.name)) from None
    if not calibration.marks:
        raise PhotoError(messages.CALIBRATION_EMPTY(name=path.name))
    return calibration


def check_calibration(calibration: CameraCalibration, model: str) -> None:
    """Raise PhotoError for a calibration from which no interior orientation can be had."""
    count, least = len(calibration.marks), LEAST_MARKS[model]
    if count < least:
        raise PhotoError(messages.TOO_FEW_CALIBRATED(count=count, model=messages.WORDS[model], least=least))
    span = calibration.span
    if not MIN_FRAME_MM <= span <= MAX_FRAME_MM:
        raise PhotoError(messages.CALIBRATION_UNIT(span=span, least=MIN_FRAME_MM, most=MAX_FRAME_MM))
    for (mark, place), (other, other_place) in combinations(calibration.marks.items(), 2):
        if math.dist(place, other_place) < MIN_MARK_DISTANCE * span:
            raise PhotoError(messages.MARKS_AT_ONE_PLACE(mark=mark, other=other))
    fit_transformation(model, calibration.points, calibration.points)  # refuses marks on a line


def _micmac(content: bytes, name: str) -> CameraCalibration:
    marks: dict[str, Point] = {}
    for measure in xml_root(content).iter("OneMesureAF1I"):
        mark = (measure.findtext("NamePt") or "").strip()
        point = _point((measure.findtext("PtIm") or "").split())
        _add(marks, mark, point, name, mark or len(marks) + 1)
    return CameraCalibration(marks)


def _table(text: str, name: str) -> CameraCalibration:
    first = text.lstrip().splitlines()[0] if text.strip() else ""
    separator = max(",;\t", key=first.count)
    rows = csv.DictReader(io.StringIO(text.lstrip()), delimiter=separator, skipinitialspace=True)
    rows.fieldnames = [(field or "").strip().lower() for field in rows.fieldnames or ()]
    if not {"mark", "x_mm", "y_mm"} <= set(rows.fieldnames):
        raise PhotoError(messages.CALIBRATION_UNKNOWN(name=name))
    marks: dict[str, Point] = {}
    others: dict[str, Any] = {}
    for number, row in enumerate(rows, 2):
        mark, texts = (row["mark"] or "").strip(), (row["x_mm"], row["y_mm"])
        values = [_number(text) for text in texts]
        if not mark and values == [None, None]:
            continue
        key = re.sub(r"[\s-]+", "_", mark.lower())
        if key not in OTHER_ROWS:
            _add(marks, mark, _point(texts), name, number)
            continue
        others[key] = values[0] if key == FOCAL_LENGTH else _point(texts)
        if others[key] is None:
            raise PhotoError(messages.CALIBRATION_ROW(name=name, row=number))
    return CameraCalibration(marks, **others)


def _add(marks: dict[str, Point], mark: str, point: Point | None, name: str, row: object) -> None:
    if not mark or point is None:
        raise PhotoError(messages.CALIBRATION_ROW(name=name, row=row))
    if mark in marks:
        raise PhotoError(messages.CALIBRATION_TWICE(name=name, mark=mark))
    marks[mark] = point


def _point(texts: Sequence[str | None]) -> Point | None:
    """Two numbers; None for anything else."""
    values = [value for value in map(_number, texts) if value is not None]
    return (values[0], values[1]) if len(values) == len(texts) == 2 else None


def _number(text: str | None) -> float | None:
    """A number with a point or a comma; None for anything else."""
    try:
        value = float((text or "").strip().replace(",", "."))
    except ValueError:
        return None
    return value if math.isfinite(value) else None
