"""The files that other programs take from an interior orientation."""
from __future__ import annotations

import json
import math
from dataclasses import dataclass

import numpy as np

from ...imagery.errors import PhotoError
from . import messages
from .camera_calibration import CameraCalibration
from .orientation import FittedTransformation, PhotoOrientation
from .photo import Photo


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
