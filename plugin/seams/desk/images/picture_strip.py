"""Small pictures in a row: a click chooses the one that the large picture is compared with."""
from __future__ import annotations

from collections.abc import Sequence

from qgis.PyQt.QtCore import QSize, Qt, pyqtSignal
from qgis.PyQt.QtGui import QIcon, QPixmap
from qgis.PyQt.QtWidgets import QBoxLayout, QButtonGroup, QScrollArea, QToolButton, QWidget

from ....toolkit.translation import tr
from ...clip_pictures import ClipPicture
from .picture_images import PictureImages
from .picture_title import kind_of

_SIDE = 5.0  # of a small picture, text heights


class PictureStrip(QScrollArea):
    """Lies below the large picture or stands beside it; scrolled where there are many."""

    chosen = pyqtSignal(str)
    """Name of the picture that was clicked."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.buttons: list[QToolButton] = []
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
        ways = QBoxLayout.Direction.TopToBottom, QBoxLayout.Direction.LeftToRight
        self._row.setDirection(ways[0] if is_upright else ways[1])
        bars = Qt.ScrollBarPolicy.ScrollBarAsNeeded, Qt.ScrollBarPolicy.ScrollBarAlwaysOff
        self.setVerticalScrollBarPolicy(bars[0] if is_upright else bars[1])
        self.setHorizontalScrollBarPolicy(bars[1] if is_upright else bars[0])
        size, bar = self._size(), self.style().pixelMetric(self.style().PixelMetric.PM_ScrollBarExtent)
        most = 16777215  # Qt's own: no limit
        self.setMaximumSize(size.width() + bar if is_upright else most, most if is_upright else size.height() + bar)
        self.setMinimumSize(size.width() + bar if is_upright else 0, 0 if is_upright else size.height() + bar)

    def show_pictures(self, pictures: Sequence[ClipPicture], chosen: str) -> None:
        """Make a button of each; the one named ``chosen`` is pressed."""
        for button in self.buttons:
            self._group.removeButton(button)
            self._row.removeWidget(button)
            button.deleteLater()
        self.buttons = [self._button(picture) for picture in pictures]
        for place, button in enumerate(self.buttons):
            self._group.addButton(button)
            self._row.insertWidget(place, button)
        self.mark(chosen)

    def mark(self, chosen: str) -> None:
        """Press the button of a picture."""
        for button in self.buttons:
            button.setChecked(button.objectName() == chosen)

    def _button(self, picture: ClipPicture) -> QToolButton:
        button = QToolButton()
        name = picture.raster if not picture.is_composite else kind_of(picture)
        button.setObjectName(picture.raster)
        button.setCheckable(True)
        button.setAutoRaise(True)
        button.setToolButtonStyle(Qt.ToolButtonStyle.ToolButtonTextUnderIcon)
        button.setFixedSize(self._size())
        side = round(_SIDE * self.fontMetrics().height())
        button.setIconSize(QSize(side, side))
        button.setIcon(QIcon(self._thumbnail(picture, side)))
        button.setText(self.fontMetrics().elidedText(name, Qt.TextElideMode.ElideMiddle, side))
        button.setToolTip(tr("{name}: compare the large picture with this one").format(name=name))
        button.setAccessibleName(name)
        button.clicked.connect(lambda _checked, name=picture.raster: self.chosen.emit(name))
        return button

    def _thumbnail(self, picture: ClipPicture, side: int) -> QPixmap:
        ratio = self.devicePixelRatioF()
        longest = max(picture.pixels.shape[:2])
        image, _ = PictureImages(picture).at(side * ratio / longest)
        pixels = round(side * ratio)
        ways = Qt.AspectRatioMode.KeepAspectRatio, Qt.TransformationMode.SmoothTransformation
        pixmap = QPixmap.fromImage(image.scaled(pixels, pixels, *ways))
        pixmap.setDevicePixelRatio(ratio)
        return pixmap

    def _size(self) -> QSize:
        height = self.fontMetrics().height()
        return QSize(round((_SIDE + 0.8) * height), round((_SIDE + 2) * height))
