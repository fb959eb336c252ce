"""Small pictures in a row: a click chooses the one that the large picture is compared with."""
from __future__ import annotations

import os
import re
from collections.abc import Sequence

from qgis.PyQt.QtCore import QSize, Qt, pyqtSignal
from qgis.PyQt.QtGui import QIcon, QPixmap
from qgis.PyQt.QtWidgets import QBoxLayout, QButtonGroup, QScrollArea, QToolButton, QWidget

from ....toolkit.desk.widgets import rich_tip
from ....toolkit.resources import icon_path
from ....toolkit.translation import filled, tr
from ...clip_pictures import ClipPicture
from ...measure.window_records import COMPOSITE
from .picture_view import PictureImages

_SIDE = 5.0  # of a small picture, text heights
_LEAST, _MOST = 5.8, 6.4  # width of its button, text heights: within these as its name asks for


class PictureStrip(QScrollArea):
    """Lies below the large picture or stands beside it; scrolled where there are many."""

    chosen = pyqtSignal(str)
    """Name of the picture that was clicked."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.buttons: list[QToolButton] = []
        self._is_upright = False
        self._width = self._heights(_LEAST)
        self._group = QButtonGroup(self)
        self._body = QWidget()
        self._row = QBoxLayout(QBoxLayout.Direction.LeftToRight, self._body)
        self._row.setContentsMargins(0, 0, 0, 0)
        self._row.setSpacing(2)
        self._row.addStretch()
        self.setWidget(self._body)
        self.setWidgetResizable(True)
        self.setFrameShape(QScrollArea.Shape.NoFrame)
        self.setFocusPolicy(Qt.FocusPolicy.NoFocus)
        self.stand(False)

    def stand(self, is_upright: bool) -> None:
        """One above the other, or side by side."""
        self._is_upright = is_upright
        ways = QBoxLayout.Direction.TopToBottom, QBoxLayout.Direction.LeftToRight
        self._row.setDirection(ways[0] if is_upright else ways[1])
        bars = Qt.ScrollBarPolicy.ScrollBarAsNeeded, Qt.ScrollBarPolicy.ScrollBarAlwaysOff
        self.setVerticalScrollBarPolicy(bars[0] if is_upright else bars[1])
        self.setHorizontalScrollBarPolicy(bars[1] if is_upright else bars[0])
        size, bar = self._size(), self.style().pixelMetric(self.style().PixelMetric.PM_ScrollBarExtent)
        most = 16777215  # Qt's own: no limit
        self.setMaximumSize(size.width() + bar if is_upright else most, most if is_upright else size.height() + bar)
        self.setMinimumSize(size.width() + bar if is_upright else 0, 0 if is_upright else size.height() + bar)

    def show_pictures(self, pictures: Sequence[ClipPicture]) -> None:
        """Make a button of each, and one of their composite; none is pressed."""
        for button in self.buttons:
            self._group.removeButton(button)
            self._row.removeWidget(button)
            button.deleteLater()
        labels = distinct([picture.raster for picture in pictures])
        self.buttons = []
        if pictures:
            name = tr("the hard-cut composite: each pixel from the source that the mosaic follows")
            self.buttons.append(self._button(COMPOSITE, tr("composite"), name, QIcon(icon_path("composite"))))
        self.buttons += [
            self._button(picture.raster, label, picture.raster, QIcon(self._thumbnail(picture)))
            for picture, label in zip(pictures, labels)
        ]
        self._fit_names()
        for place, button in enumerate(self.buttons):
            self._group.addButton(button)
            self._row.insertWidget(place, button)

    def mark(self, chosen: str) -> None:
        """Press the button of a picture."""
        for button in self.buttons:
            button.setChecked(button.objectName() == chosen)

    def _button(self, key: str, label: str, name: str, icon: QIcon) -> QToolButton:
        button = QToolButton()
        button.setObjectName(key)
        button.setCheckable(True)
        button.setAutoRaise(True)
        button.setToolButtonStyle(Qt.ToolButtonStyle.ToolButtonTextUnderIcon)
        button.setIconSize(QSize(self._side(), self._side()))
        button.setIcon(icon)
        button.setText(label)
        button.setToolTip(rich_tip(filled(tr("Compare the large picture with {name}"), name=name)))
        button.setAccessibleName(name)
        button.clicked.connect(lambda _checked, key=key: self.chosen.emit(key))
        return button

    def _fit_names(self) -> None:
        """Buttons as wide as the longest name asks for, with what the style puts around it; too long ones are cut."""
        asked = [button.sizeHint().width() for button in self.buttons]
        self._width = min(max([self._heights(_LEAST), *asked]), self._heights(_MOST))
        for button, width in zip(self.buttons, asked):
            if width > self._width:
                metrics, over = button.fontMetrics(), width - self._width
                room = metrics.horizontalAdvance(button.text()) - over
                button.setText(metrics.elidedText(button.text(), Qt.TextElideMode.ElideMiddle, room))
            button.setFixedSize(self._size())
        self.stand(self._is_upright)

    def _thumbnail(self, picture: ClipPicture) -> QPixmap:
        ratio, side = self.devicePixelRatioF(), self._side()
        longest = max(picture.pixels.shape[:2])
        image, _ = PictureImages(picture).at(side * ratio / longest)
        pixels = round(side * ratio)
        ways = Qt.AspectRatioMode.KeepAspectRatio, Qt.TransformationMode.SmoothTransformation
        pixmap = QPixmap.fromImage(image.scaled(pixels, pixels, *ways))
        pixmap.setDevicePixelRatio(ratio)
        return pixmap

    def _side(self) -> int:
        return self._heights(_SIDE)

    def _size(self) -> QSize:
        return QSize(self._width, self._heights(_SIDE + 2))

    def _heights(self, count: float) -> int:
        return round(count * self.fontMetrics().height())


def distinct(names: Sequence[str]) -> list[str]:
    """What file names do not have in common, by whole words: ``0025`` of ``DJI_0025_ortho.tif`` among its like."""
    if len(set(names)) < 2:
        return list(names)
    start = os.path.commonprefix(list(names))  # noqa: RUF071 - of characters it is
    end = os.path.commonprefix([name[len(start) :][::-1] for name in names])[::-1]  # noqa: RUF071
    start = re.sub(r"[^\W_]+$", "", start)
    end = re.sub(r"^[^\W_]+", "", end)
    return [name[len(start) : len(name) - len(end)] or name for name in names]
