"""A desk with the images panel, and what the mouse, the keys and the screen do there."""
from __future__ import annotations

from types import SimpleNamespace

import numpy as np
from qgis.core import QgsSettings
from qgis.PyQt.QtCore import QEvent, QObject, QPoint, QPointF, Qt, pyqtSignal
from qgis.PyQt.QtGui import QCursor, QImage, QKeyEvent, QWheelEvent
from qgis.PyQt.QtTest import QTest
from qgis.PyQt.QtWidgets import (
    QApplication,
    QLabel,
    QLineEdit,
    QPushButton,
    QVBoxLayout,
    QWidget,
)
from seam_inspector.plugin.seams.clip_pictures import ClipPicture
from seam_inspector.plugin.seams.desk.images.images_panel import ImagesPanel
from seam_inspector.plugin.seams.desk.images.picture_view import PictureView
from seam_inspector.plugin.seams.desk.inputs.project_inputs import Inputs
from seam_inspector.plugin.seams.desk.session import LossView
from seam_inspector.plugin.seams.measure.profile.window_detail import LossPicture
from seam_inspector.plugin.seams.measure.window_records import WindowRecord
from seam_inspector.plugin.toolkit.desk.widgets import ClippedLabel

SIDE = 512


class Session(QObject):
    """With pictures that arrive when the test says so."""

    selectionChanged = pyqtSignal()
    windowsChanged = pyqtSignal()
    inputsChanged = pyqtSignal()
    picturesArrived = pyqtSignal(int)
    resultArrived = pyqtSignal(int)

    def __init__(self) -> None:
        super().__init__()
        self.chosen: list[int] = []
        self.ready: dict[int, tuple[ClipPicture, ...]] = {}
        self.asked: list[int] = []
        self.mosaic: object | None = object()
        self.inputs = Inputs()
        self.loss_view = LossView(self)
        self.losses: dict[int, LossPicture] = {}
        self.composites: dict[int, tuple[ClipPicture, ...]] = {}

    def selected(self) -> list[int]:
        return self.chosen

    def select(self, fids: list[int]) -> None:
        self.chosen = fids
        self.selectionChanged.emit()

    def row(self, fid: int) -> WindowRecord:
        return WindowRecord(fid, (0.0, 0.0, 1.0, 1.0), fid=fid)

    def set_inputs(self, inputs: Inputs) -> None:
        self.inputs = inputs
        self.inputsChanged.emit()

    def mosaic_layer(self) -> object | None:
        return self.mosaic

    def pictures(self, fid: int) -> tuple[ClipPicture, ...] | None:
        self.asked.append(fid)
        return self.ready.get(fid)

    def composite(self, fid: int) -> tuple[ClipPicture, ...] | None:
        return self.composites.get(fid)

    def result(self, fid: int) -> SimpleNamespace | None:
        return SimpleNamespace(loss=self.losses[fid]) if fid in self.losses else None

    def arrive(self, fid: int, pictures: tuple[ClipPicture, ...]) -> None:
        self.ready[fid] = pictures
        self.picturesArrived.emit(fid)


def noise(seed: int, side: int = SIDE) -> np.ndarray:
    return np.random.default_rng(seed).integers(0, 256, (side, side, 3), np.uint8)


def make_pictures(sources: int = 2, side: int = SIDE, **options: float) -> tuple[ClipPicture, ...]:
    mosaic = ClipPicture("mosaic.tif", True, noise(0, side))
    return mosaic, *(ClipPicture(f"strip_{i}.tif", False, noise(i, side), **options) for i in range(1, sources + 1))


def open_desk(session: Session, side_by_side: bool = True) -> QWidget:
    """A window with a text field, a button that has the focus, and the panel."""
    QgsSettings().setValue("SeamInspector/images_side_by_side", side_by_side)
    desk = QWidget()
    box = QVBoxLayout(desk)
    for widget in (QLineEdit(), QPushButton("button"), ImagesPanel(session)):
        box.addWidget(widget)
    desk.resize(700, 500)
    QCursor.setPos(0, 0)  # where the test before left it there may be a view now
    desk.show()
    desk.activateWindow()
    QTest.qWaitForWindowActive(desk)
    desk.findChild(QPushButton).setFocus()
    QApplication.processEvents()
    return desk


def hover(view: PictureView, point: QPoint | None = None) -> None:
    """The mouse comes to a view and moves there."""
    QApplication.sendEvent(view, QEvent(QEvent.Type.Enter))
    QTest.mouseMove(view, point or view.image_rect().center())
    QApplication.processEvents()


def leave(view: PictureView) -> None:
    QApplication.sendEvent(view, QEvent(QEvent.Type.Leave))


def send_key(receiver: QWidget, kind: QEvent.Type, repeated: bool = False) -> None:
    event = QKeyEvent(kind, Qt.Key.Key_Space, Qt.KeyboardModifier.NoModifier, " ", repeated)
    QApplication.sendEvent(receiver, event)


def press(receiver: QWidget, repeated: bool = False) -> None:
    send_key(receiver, QEvent.Type.KeyPress, repeated)


def release(receiver: QWidget, repeated: bool = False) -> None:
    """A key is up once it is not pressed again."""
    send_key(receiver, QEvent.Type.KeyRelease, repeated)
    if not repeated:
        QTest.qWait(80)


def names(panel: ImagesPanel) -> list[str]:
    return [view.shown.raster for view in panel.views if view.shown is not None]


def text(panel: ImagesPanel) -> str:
    """All that the panel's labels say."""
    return " ".join(label.text() for label in panel.findChildren(QWidget) if isinstance(label, (QLabel, ClippedLabel)))


def turn_wheel(view: PictureView, notches: float, at: QPoint) -> None:
    nowhere = Qt.MouseButton.NoButton
    event = QWheelEvent(
        QPointF(at), QPointF(view.mapToGlobal(at)), QPoint(), QPoint(0, round(120 * notches)), nowhere,
        Qt.KeyboardModifier.NoModifier, Qt.ScrollPhase.NoScrollPhase, False,
    )
    QApplication.sendEvent(view, event)


def painted(view: PictureView) -> np.ndarray:
    """The picture as it is on the screen, (rows, columns, 3)."""
    view._viewport.set_cursor(None)
    image = view.grab(view.image_rect()).toImage().convertToFormat(QImage.Format.Format_RGB888)
    rows = np.frombuffer(image.constBits().asarray(image.sizeInBytes()), np.uint8)
    pixels = rows.reshape(image.height(), image.bytesPerLine())[:, : 3 * image.width()]
    return pixels.reshape(image.height(), -1, 3).copy()  # the image goes


def expected(pixels: np.ndarray, shape: tuple[int, ...], zoom: int) -> np.ndarray:
    """The middle of a picture, each pixel zoom x zoom on the screen."""
    large = pixels.repeat(zoom, axis=0).repeat(zoom, axis=1)
    top, left = (round(shape[i] / 2 - pixels.shape[i] * zoom / 2) for i in (0, 1))
    return large[-top : shape[0] - top, -left : shape[1] - left]
