"""DEFECTS: one feature per failure, for the producer, with a picture of the mosaic around it in a folder beside."""
from __future__ import annotations

import errno
import math
import os
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from functools import lru_cache
from pathlib import Path
from typing import Any

import numpy as np
from qgis.core import QgsFeature, QgsGeometry, QgsLineString
from qgis.PyQt import sip
from qgis.PyQt.QtCore import QPointF, Qt
from qgis.PyQt.QtGui import QColor, QImage, QPen, QPolygonF

from ...imagery.atomic_files import whole_file
from ...imagery.errors import RasterError, SettingsError
from ...imagery.file_identity import DataPlace, check_outputs
from ...imagery.grids import PixelWindow
from ...imagery.messages import system_reason
from ...imagery.open_raster import OpenRaster
from ...imagery.rasters import Raster
from ...imagery.records import Column
from ...imagery.reference_systems import extent_on, transform_points
from ...toolkit.painting import painting
from ...toolkit.pictures import GreyRanges, Stretch, brightness, encoded, largest_of, ranges_with
from ...toolkit.table_fields import column_features
from ..measure import messages
from ..measure.decision import Decision, Defect
from .words import rounded

PROOF_PX = 106  # side of what is shown at 2x: three of them stand beside each other on A4
MOSAIC_PANEL, CUT_PANEL, IMAGE_PANEL = "mosaic", "cut", "image"


@dataclass(frozen=True, eq=False)
class ProofPanel:
    """One of the pictures of a place."""

    kind: str  # mosaic, cut (the composite: the same orthoimages cut hard) or image (an orthoimage)
    name: str  # name of the orthoimage's file; empty for the others
    pixels: np.ndarray  # (rows, columns, 3) uint8, pixel by pixel; all panels of a place are stretched alike


Prover = Callable[[Raster, PixelWindow, tuple[str, str]], Sequence[ProofPanel]]
"""From a mosaic, a part of it, and what the piece in its middle calls the two orthoimages beside it, to the panels of
that part: mosaic, cut and up to two orthoimages; empty where no orthoimage shows it."""


_NAME = "defect_{}.jpg"


def save_pictures(
    folder: Path, pictures: Mapping[int, DefectPicture], paths: dict[int, str], mosaics: Iterable[str] = ()
) -> None:
    """Write pictures into the folder beside a layer, from which those of an earlier one go, but no sheet of the
    ``mosaics``; ``paths``, by the failures' numbers, is added to. Nothing happens without a picture. Raises
    SettingsError where one can't be written.
    """
    if not pictures:
        return
    try:
        if folder.is_symlink():  # what it leads to is none of ours
            raise OSError(errno.ELOOP, os.strerror(errno.ELOOP))
        folder.mkdir(parents=True, exist_ok=True)
        older = list(folder.glob(_NAME.format("*")))
        check_outputs([(old.name, DataPlace(str(old))) for old in older], (), mosaics)
        for old in older:
            old.unlink()
    except OSError as error:
        raise SettingsError(messages.PICTURES_NOT_WRITTEN(folder=folder, error=system_reason(error))) from None
    for number, picture in pictures.items():
        path = folder / _NAME.format(f"{number:03d}")
        with whole_file(path) as unfinished:
            unfinished.write_bytes(picture.jpeg())
        paths[number] = str(path)


PICTURE_PX = 400  # side of the picture that shows where a failure lies
MOST_REDUCED = 8.0  # pixels of the mosaic, along a side, on one of it

_AROUND = 1.25  # of a failure's extent
_DASHES_PX = (7.0, 9.0)  # and gaps: what is lost has to be seen between the dashes
_EDGE_PX = 8  # of a panel: how far marks of the seam reach in, so that nothing lies on what is shown
_SEAM, _FRAME, _LINE_PX, _EDGES_PX = "#ffd600", "white", 2, 4
_GUTTER_PX = 8
_PROOF_SCALE = 2
_HELD = 8  # open sheets


@dataclass(frozen=True, eq=False)
class DefectPicture:
    """The mosaic around a failure, and pixel by pixel the middle of its piece that kept least, beside orthoimages."""

    around: np.ndarray  # (rows, columns, 3) uint8: where it lies, dashes along it, a frame around the panels' place
    side_m: float  # what that shows across
    is_whole: bool  # whether all of the failure is on it
    panels: tuple[ProofPanel, ...]  # the mosaic first, alone without orthoimages; the seam is marked at both edges

    def jpeg(self) -> bytes:
        """A JPEG of all: below the picture the panels at 2x in a row."""
        panels = _beside([panel.pixels.repeat(_PROOF_SCALE, 0).repeat(_PROOF_SCALE, 1) for panel in self.panels])
        columns = max(self.around.shape[1], panels.shape[1])
        rows = [np.pad(picture, ((0, _GUTTER_PX), (0, columns - picture.shape[1]), (0, 0)), constant_values=255)
                for picture in (self.around, panels)]
        return encoded(np.ascontiguousarray(np.concatenate(rows)[:-_GUTTER_PX]), "JPEG")


class DefectPictures:
    """Cuts pictures from the sheets of a delivery, all shown by the same range of values."""

    def __init__(self, mosaics: Sequence[Raster], decision: Decision, prover: Prover | None = None) -> None:
        self._mosaics, self._wkt, self._prover = mosaics, decision.delivery.wkt, prover
        self._seams = [decided.piece.vertices for decided in decision.pieces]
        self._boxes = np.array([[*line.min(axis=0), *line.max(axis=0)] for line in self._seams]).reshape(-1, 4)
        self._open = lru_cache(_HELD)(OpenRaster)
        self._ranges: GreyRanges = {}

    def of(self, defect: Defect) -> DefectPicture | None:
        """None where no mosaic shows it, or that can't be read there."""
        for mosaic in self._mosaics:
            with suppress(RasterError):
                x, y = transform_points(np.array([defect.worst.piece.middle]), self._wkt, mosaic.wkt)[0]
                xmin, ymin, xmax, ymax = mosaic.extent
                if xmin <= x <= xmax and ymin <= y <= ymax:
                    return self._picture(mosaic, defect, mosaic.grid.to_pixels(np.array([[x, y]]))[0])
        return None

    def _picture(self, mosaic: Raster, defect: Defect, worst: np.ndarray) -> DefectPicture:
        lines = [self._path(mosaic, decided.piece.vertices) for decided in defect.pieces]
        window, is_whole = _window(np.concatenate(lines), worst)
        shown, part = _inside(window, mosaic), _inside(_square(worst, PROOF_PX), mosaic)
        around = self._pixels(mosaic, shown)
        shares = np.array(around.shape[1::-1]) / (shown.width, shown.height)
        for line in lines:
            _draw(around, (line - (shown.column, shown.row)) * shares, _SEAM, _DASHES_PX)
        corners = np.array([(0, 0), (part.width, 0), (part.width, part.height), (0, part.height), (0, 0)])
        _draw(around, (corners + (part.column - shown.column, part.row - shown.row)) * shares, _FRAME)
        piece = defect.worst.piece
        panels = () if self._prover is None else self._prover(mosaic, part, (piece.left_source, piece.right_source))
        panels = panels or (ProofPanel(MOSAIC_PANEL, "", self._pixels(mosaic, part)),)
        seams = [self._path(mosaic, line) - (part.column, part.row) for line in self._near(mosaic, part)]
        return DefectPicture(
            around, shown.width * mosaic.grid.pixel_width * mosaic.grid.metres_x, is_whole,
            tuple(replace(panel, pixels=_marked(panel.pixels, seams)) for panel in panels),
        )

    def _path(self, mosaic: Raster, line: np.ndarray) -> np.ndarray:
        """(n, 2) columns and rows of a line of the delivery."""
        return mosaic.grid.to_pixels(transform_points(line, self._wkt, mosaic.wkt))

    def _near(self, mosaic: Raster, part: PixelWindow) -> list[np.ndarray]:
        """All pieces of seam that may meet a part of the mosaic, whatever became of them."""
        xmin, ymin, xmax, ymax = extent_on(mosaic.grid.window_extent(part), mosaic.wkt, self._wkt)
        left, bottom, right, top = self._boxes.T
        is_near = (left <= xmax) & (right >= xmin) & (bottom <= ymax) & (top >= ymin)
        return [self._seams[number] for number in np.flatnonzero(is_near).tolist()]

    def _pixels(self, mosaic: Raster, inside: PixelWindow) -> np.ndarray:
        """(rows, columns, 3) uint8 of a window of the mosaic, no more than fit a picture."""
        scale = max(inside.width / PICTURE_PX, inside.height / PICTURE_PX, 1.0)
        size = max(1, round(inside.width / scale)), max(1, round(inside.height / scale))
        raster = self._open(mosaic.ref)
        block = raster.read(inside, size, averaged=scale > 1)
        bands = np.ascontiguousarray(block.bands[: 3 if mosaic.has_luminance else 1])
        if bands.dtype.name not in self._ranges:
            stretch = Stretch.DELIVERED if bands.dtype == np.uint8 else Stretch.COMMON
            self._ranges = ranges_with(self._ranges, stretch, [(raster, largest_of(bands))])
        pixels = brightness(bands, self._ranges)
        pixels[~block.valid] = 255
        return pixels


def _marked(pixels: np.ndarray, seams: Sequence[np.ndarray]) -> np.ndarray:
    """A copy with the seams drawn at its edges alone; ``seams``: (n, 2) columns and rows each."""
    marked = pixels.copy()
    for seam in seams:
        _draw(marked, seam, _SEAM)
    inner = slice(_EDGE_PX, -_EDGE_PX)
    marked[inner, inner] = pixels[inner, inner]
    return marked


def _beside(panels: Sequence[np.ndarray]) -> np.ndarray:
    """Panels in a row, white between and below them."""
    rows = max(len(panel) for panel in panels)
    padded = [np.pad(panel, ((0, rows - len(panel)), (0, _GUTTER_PX), (0, 0)), constant_values=255) for panel in panels]
    return np.ascontiguousarray(np.concatenate(padded, axis=1)[:, :-_GUTTER_PX])


def _inside(window: PixelWindow, mosaic: Raster) -> PixelWindow:
    """Moved as far as it takes to lie on the mosaic, and cut where that is smaller."""
    return window.moved_into(mosaic.columns, mosaic.rows).cut_to(mosaic.columns, mosaic.rows)


def _square(middle: np.ndarray, side: int) -> PixelWindow:
    column, row = np.floor(middle - side / 2).astype(int).tolist()
    return PixelWindow(column, row, side, side)


def _window(places: np.ndarray, worst: np.ndarray) -> tuple[PixelWindow, bool]:
    """A square around a failure, or around its worst place where it is too long for a picture; and which it is.

    ``places``: (n, 2) columns and rows along the failure; ``worst``: (2,).
    """
    low, high = places.min(axis=0), places.max(axis=0)
    wanted = _AROUND * float((high - low).max())
    is_whole = wanted <= MOST_REDUCED * PICTURE_PX
    side = math.ceil(min(max(wanted, PICTURE_PX), MOST_REDUCED * PICTURE_PX))
    return _square((low + high) / 2 if is_whole else worst, side), is_whole


def _draw(pixels: np.ndarray, path: np.ndarray, colour: str, dashes: Sequence[float] = ()) -> None:
    """Draw a line with black edges along a path of (n, 2) columns and rows, in place; ``dashes`` and gaps, pixels."""
    rows, columns = pixels.shape[:2]
    points = QPolygonF([QPointF(x, y) for x, y in path.tolist()])
    memory: Any = sip.voidptr(pixels.ctypes.data)  # of which PyQt 6 knows no type
    image = QImage(memory, columns, rows, pixels.strides[0], QImage.Format.Format_RGB888)
    with painting(image) as painter:
        for width, ink in ((_EDGES_PX, "black"), (_LINE_PX, colour)):
            pen = QPen(QColor(ink), width)
            pen.setCapStyle(Qt.PenCapStyle.FlatCap)
            if dashes:
                pen.setDashPattern([length / width for length in dashes])
            painter.setPen(pen)
            painter.drawPolyline(points)


def _coordinate(value: float) -> float:
    """To a millimetre or so, in metres as in degrees."""
    return float(f"{value:.10g}")


def _of_worst(name: str) -> Column[Defect]:
    return Column(name, "text", lambda defect: getattr(defect.worst.piece, name) or None)


DEFECT_COLUMNS: tuple[Column[Defect], ...] = (
    Column("defect", "integer", lambda defect: defect.run.number),
    Column("sheet", "text", lambda defect: ", ".join(defect.run.sheets)),
    Column("length", "real", lambda defect: rounded(defect.run.length_m)),
    Column("kept_1", "real", lambda defect: rounded(defect.worst.piece.kept_1)),
    Column("kept_low", "real", lambda defect: rounded(defect.worst.piece.kept_low)),
    Column("kept_high", "real", lambda defect: rounded(defect.worst.piece.kept_high)),
    Column("band_width", "real", lambda defect: rounded(defect.worst.piece.band_width_m)),
    Column("visibility", "real", lambda defect: rounded(defect.worst.piece.visibility)),
    Column("cause", "text", lambda defect: defect.cause or None),
    *(_of_worst(name) for name in ("left_source", "right_source", "left_date", "right_date")),
    Column("x", "real", lambda defect: _coordinate(defect.run.place[0])),
    Column("y", "real", lambda defect: _coordinate(defect.run.place[1])),
    Column("remark", "text", lambda defect: "; ".join(defect.remarks) or None),
    Column("picture", "text", lambda _: None),  # its path from the layer's folder, once there is one
)


def defect_features(defects: Sequence[Defect], pictures: Mapping[int, str]) -> Iterator[QgsFeature]:
    """``pictures``: paths from the layer's folder, by the failures' numbers."""
    for defect, feature in zip(defects, column_features(DEFECT_COLUMNS, defects)):
        lines = (QgsGeometry(QgsLineString(*decided.piece.vertices.T.tolist())) for decided in defect.pieces)
        whole = QgsGeometry.collectGeometry(list(lines)).mergeLines()
        whole.convertToMultiType()
        feature.setGeometry(whole)
        feature.setAttribute("picture", pictures.get(defect.run.number))
        yield feature
