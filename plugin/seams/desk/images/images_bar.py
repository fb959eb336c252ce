"""What stands above the pictures: which window, how large, how bright, one large picture or all side by side."""
from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING, Callable

from qgis.core import QgsApplication, QgsSettings
from qgis.PyQt.QtCore import Qt, pyqtSignal
from qgis.PyQt.QtGui import QIcon
from qgis.PyQt.QtWidgets import QComboBox, QHBoxLayout, QLabel, QToolButton, QWidget

from ....toolkit.desk.widgets import ClippedLabel
from ....toolkit.picture_stretch import Stretch
from ....toolkit.resources import icon_path
from ....toolkit.translation import formatted, tr
from .picture_flow import GAP
from .viewport import BEST_ZOOM, Viewport

if TYPE_CHECKING:
    from ..session import Session

_SIDE_BY_SIDE = "SeamInspector/images_side_by_side"


class ImagesBar(QWidget):
    """The stretch is the project's, side by side or not is the operator's own habit."""

    arrangementChanged = pyqtSignal()

    def __init__(self, session: Session, viewport: Viewport, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._session = session
        self._viewport = viewport
        self.status = ClippedLabel(1)
        self.stretch = self._stretch_box()
        self.side_by_side = self._button(
            QIcon(icon_path("side_by_side")), tr("All pictures side by side, or one large one"), self._arrange
        )
        self.side_by_side.setCheckable(True)
        self.side_by_side.setChecked(QgsSettings().value(_SIDE_BY_SIDE, False, bool))
        self._zoom = QLabel()
        self._zoom.setToolTip(tr("Screen pixels per image pixel"))
        self._zoom.setMinimumWidth(self.fontMetrics().horizontalAdvance("0.00x"))
        self._zoom.setAlignment(Qt.AlignmentFlag.AlignCenter)
        zoom_out = self._button(_theme_icon("ZoomOut"), tr("Zoom all pictures out (wheel, -)"), self._zoom_out)
        zoom_in = self._button(_theme_icon("ZoomIn"), tr("Zoom all pictures in (wheel, +)"), self._zoom_in)
        self._zoom_to_all = self._button(_theme_icon("ZoomFullExtent"), tr("Show the whole picture"), self._show_all)
        self.zoom_to_best = self._button(
            QIcon(), tr("Back to 2x, at which loss of detail is best judged: each pixel is 2 x 2 on the screen"),
            self._reset,
        )
        self.zoom_to_best.setText("2x")
        for button in (self._zoom_to_all, self.zoom_to_best):
            button.setCheckable(True)
        row = QHBoxLayout(self)
        row.setContentsMargins(0, 0, 0, 0)
        row.setSpacing(GAP)
        row.addWidget(self.status, 1)
        parts = (self.stretch, self.side_by_side, zoom_out, self._zoom, zoom_in, self._zoom_to_all, self.zoom_to_best)
        for widget in parts:
            row.addWidget(widget)
        session.inputsChanged.connect(self._show_stretch)
        self._show_stretch()

    def show_zoom(self, is_showing: bool = True) -> None:
        """Unchecking by a click is no choice, so the buttons are set anew each time."""
        self._zoom.setText(formatted(self._viewport.scale, ".2g") + "\u00d7" if is_showing else "")
        self._zoom_to_all.setChecked(self._viewport.zoom is None)
        self.zoom_to_best.setChecked(self._viewport.zoom == BEST_ZOOM)

    def _stretch_box(self) -> QComboBox:
        box = QComboBox()
        for stretch, words, tip in (
            (Stretch.DELIVERED, tr("As delivered"),
             tr("8 bit as it is, 16 bit by its range of values: the same in all windows")),
            (Stretch.COMMON, tr("One stretch"),
             tr("More contrast: the mosaic's darkest and brightest 2 % cut off, the same in all windows")),
            (Stretch.WINDOW, tr("Each window"),
             tr("Most contrast: each window's darkest and brightest 2 % cut off. Windows look unlike each other, "
                "and grey may look coloured.")),
        ):  # fmt: skip
            box.addItem(words, stretch.value)
            box.setItemData(box.count() - 1, tip, Qt.ItemDataRole.ToolTipRole)
        box.setToolTip(tr("How grey values are shown; never band by band, so that colours stay as they are"))
        box.activated.connect(self._choose_stretch)
        return box

    def _choose_stretch(self, place: int) -> None:
        self._session.set_inputs(replace(self._session.inputs, stretch=self.stretch.itemData(place)))

    def _show_stretch(self) -> None:
        self.stretch.setCurrentIndex(self.stretch.findData(self._session.inputs.stretch))

    def _arrange(self, is_side_by_side: bool) -> None:
        QgsSettings().setValue(_SIDE_BY_SIDE, is_side_by_side)
        self.arrangementChanged.emit()

    def _button(self, icon: QIcon, tip: str, slot: Callable[..., None]) -> QToolButton:
        button = QToolButton()
        button.setAutoRaise(True)
        button.setToolTip(tip)
        button.setAccessibleName(tip)
        button.setIcon(icon)
        button.clicked.connect(slot)
        return button

    def _zoom_in(self) -> None:
        self._viewport.zoom_by(1)

    def _zoom_out(self) -> None:
        self._viewport.zoom_by(-1)

    def _show_all(self) -> None:
        self._viewport.set_zoom(None)

    def _reset(self) -> None:
        self._viewport.set_zoom(BEST_ZOOM)


def _theme_icon(name: str) -> QIcon:
    return QgsApplication.getThemeIcon(f"/mAction{name}.svg")
