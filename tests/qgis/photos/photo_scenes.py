"""A scanned photo and the camera it was taken with, as files, and layers of points on it."""
from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from qgis.core import QgsGeometry, QgsPointXY, QgsVectorLayer

from tests.numbers.photos.photos import CAMERA, Frame, Look, Place, make_frame
from tests.numbers.synthetic import write_plain
from tests.qgis.scenes import layer


@dataclass(frozen=True)
class PhotoScene:
    """What an interior orientation takes, and the truth."""

    photo: Path
    calibration: Path
    frame: Frame

    @property
    def inputs(self) -> dict[str, Any]:
        return {"PHOTO": str(self.photo), "CALIBRATION": str(self.calibration)}


def make_photo(folder: Path, look: Look | None = None, name: str = "photo.bmp", **options: Any) -> PhotoScene:
    """A photo with numbered marks in its corners, as a BMP without a place on the map."""
    frame = make_frame(look or Look(dots=True, diagonal=True, interrupted=True), **options)
    write_plain(folder / name, frame.pixels)
    return PhotoScene(folder / name, write_calibration(folder / "camera.csv"), frame)


def write_calibration(
    path: Path, marks: Mapping[str, Place] | None = None, factor: float = 1.0, more: str = ""
) -> Path:
    """A calibration as CSV, its coordinates multiplied by a factor."""
    rows = (f"{name},{x * factor!r},{y * factor!r}\n" for name, (x, y) in (marks or CAMERA).items())
    path.write_text("mark,x_mm,y_mm\n" + "".join(rows) + more, encoding="utf-8")
    return path


def points(places: Mapping[str, Place], **fields: Any) -> QgsVectorLayer:
    """A layer of points on a photo without a place on the map: x is the column, y the negative row."""
    shapes = [QgsGeometry.fromPointXY(QgsPointXY(column, -row)) for column, row in places.values()]
    return layer("Point", shapes, None, mark=("string(20)", list(places)), **fields)
