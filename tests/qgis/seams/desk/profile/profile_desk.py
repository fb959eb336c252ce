"""A session with one window that was measured, on a map, without tasks."""
from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
from qgis.core import QgsCoordinateReferenceSystem, QgsCoordinateTransform, QgsProject, QgsRasterLayer
from qgis.PyQt.QtWidgets import QAction
from seam_inspector.plugin.imagery.grids import Grid, PixelWindow
from seam_inspector.plugin.seams.measure.judgement.verdicts import Judgement, Ratios, Verdict
from seam_inspector.plugin.seams.measure.profile.seam_profile import ProfileBin, SeamProfile
from seam_inspector.plugin.seams.measure.profile.window_detail import LossPicture
from seam_inspector.plugin.seams.measure.window.inspection import WindowResult
from seam_inspector.plugin.seams.measure.window_records import WindowRecord

from tests.qgis.scenes import ORIGIN, PIXEL
from tests.qgis.seams.desk.windows_session import WindowsSession

INFINITE = float("inf")
PROFILE = SeamProfile(
    (0.56, 0.81, None), 0.51, 0.62, 20.0, 0.05,
    (
        ProfileBin(1, 0, 8, 0.5, 0.45, 0.56, 0.5, 1200.0), ProfileBin(1, 8, 16, 0.8, 0.7, 0.9, 0.8, 1200.0),
        ProfileBin(1, 64, INFINITE, 1.0, 0.9, 1.1, 1.0, 5e4), ProfileBin(2, 0, 16, 0.7, 0.6, 0.8, 0.7, 1200.0),
    ),
)  # fmt: skip
WINDOW = PixelWindow(64, 32, 100, 120)  # no multiple of the cells of 8 px
SEAM_COLUMN = 40  # in the window, px; the seam runs from its top to its bottom


class Explained:
    """What a result's explanation tells the desk."""

    def __init__(self, profile: SeamProfile | None = PROFILE, loss: LossPicture | None = None) -> None:
        self.profile, self.has_seam = profile, profile is not None
        self.ground_left = self.sharpness = 1.0
        self.loss = loss if loss is not None else loss_of_window()


def loss_of_window() -> LossPicture:
    """Half of the detail is lost in the cells of the seam."""
    kept = np.ones((15, 13), np.float32)
    kept[:, SEAM_COLUMN // 8] = 0.55
    rows = np.arange(WINDOW.height // 2)
    seam = np.stack([rows, np.full_like(rows, SEAM_COLUMN // 2)], axis=1).astype(np.uint16)
    return LossPicture(kept, 8, seam)


def result(explained: Any = None, verdict: Verdict = Verdict.SIGNIFICANT) -> WindowResult:
    """Result of the window."""
    judgement = Judgement(verdict, Ratios((0.5, 0.6, 0.7), 1.0))
    measured = WindowResult(7, WINDOW, judgement, verdict, explanation=explained, ground_sample_distance=PIXEL)
    return replace(measured, explanation=explained if explained is not None else Explained())


class ProfileSession(WindowsSession):
    """One window, selected, and another that was not measured."""

    def __init__(self) -> None:
        super().__init__([WindowRecord(7, None, "significant", fid=1), WindowRecord(8, None, fid=2)])
        self.lost_detail = QAction(self)
        self.lost_detail.setCheckable(True)
        self.grid = Grid(*ORIGIN, PIXEL, PIXEL, 512, 512)
        self.results = {1: result()}
        self.chosen = [1]
        self.is_measuring = False
        self._layer = QgsRasterLayer("", "mosaic")
        self._layer.setCrs(QgsCoordinateReferenceSystem("EPSG:32633"))

    def mosaic_layer(self) -> QgsRasterLayer:
        return self._layer

    def mosaic_grid(self) -> Grid:
        return self.grid

    def select(self, fids: list[int]) -> None:
        self.chosen = list(fids)
        self.selectionChanged.emit()

    def is_pending(self, fid: int) -> bool:
        return self.is_measuring


def on_map(column: float, row: float, crs: QgsCoordinateReferenceSystem) -> tuple[float, float]:
    """A place in the mosaic's pixels, in the map's reference system."""
    utm = QgsCoordinateReferenceSystem("EPSG:32633")
    point = QgsCoordinateTransform(utm, crs, QgsProject.instance()).transform(
        ORIGIN[0] + column * PIXEL, ORIGIN[1] - row * PIXEL
    )
    return point.x(), point.y()
