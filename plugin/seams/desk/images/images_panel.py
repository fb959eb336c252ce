"""The clips of the selected window, to be judged by eye: one large that flips, or all side by side, and a bar above."""
from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Callable

from qgis.core import QgsApplication, QgsSettings
from qgis.PyQt.QtCore import QEvent, QSize, Qt, pyqtSignal
from qgis.PyQt.QtGui import QHideEvent, QIcon, QResizeEvent, QShowEvent
from qgis.PyQt.QtWidgets import (
    QBoxLayout,
    QComboBox,
    QHBoxLayout,
    QLabel,
    QScrollArea,
    QStackedWidget,
    QToolButton,
    QVBoxLayout,
    QWidget,
)

from ....toolkit.desk.keyboard import SpaceKey
from ....toolkit.desk.widgets import ClippedLabel
from ....toolkit.picture_stretch import Stretch
from ....toolkit.resources import icon_path
from ....toolkit.translation import filled, formatted, tr
from ...clip_pictures import ClipPicture
from ...measure.window_records import COMPOSITE
from ..session import Session
from .picture_strip import PictureStrip
from .picture_view import LossImage, PictureView
from .viewport import BEST_ZOOM, Viewport

GAP = 4
"""Between views, px."""
_SIDE_BY_SIDE = "SeamInspector/images_side_by_side"


class PictureFlow(QWidget):
    """Views of one size in as many columns as make them largest; scrolled when they would become too small."""

    def __init__(self, scrolled: QScrollArea) -> None:
        super().__init__()
        self._scrolled = scrolled
        self._views: list[PictureView] = []

    def set_views(self, views: list[PictureView]) -> None:
        self._views = views
        self.arrange()

    def arrange(self) -> None:
        """Arrange by the room without a scroll bar, or it would come and go; only then within the width it leaves."""
        if not self._views:
            return
        least, area = self._views[0].minimumSizeHint(), self._scrolled.maximumViewportSize()
        columns = max(range(1, len(self._views) + 1), key=lambda columns: self._worth(columns, area, least))
        rows, _, height = self._shares(columns, area)
        fits = height >= least.height()
        height = max(height, least.height())
        self.setMinimumHeight(0 if fits else rows * (height + GAP) - GAP)
        width = (min(area.width(), self.width()) - (columns - 1) * GAP) // columns
        for i, view in enumerate(self._views):
            row, column = divmod(i, columns)
            view.setGeometry(column * (width + GAP), row * (height + GAP), width, height)

    def _shares(self, columns: int, area: QSize) -> tuple[int, int, int]:
        """Rows, and the width and height that each view gets."""
        rows = -(-len(self._views) // columns)
        return rows, (area.width() - (columns - 1) * GAP) // columns, (area.height() - (rows - 1) * GAP) // rows

    def _worth(self, columns: int, area: QSize, least: QSize) -> tuple[bool, int, int]:
        """The shorter side of a view's picture counts, where columns are not too narrow; then little scrolling."""
        _, width, height = self._shares(columns, area)
        side = min(width, max(height, least.height()) - self._views[0].image_rect().top())
        return columns == 1 or width >= least.width(), side, columns

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self.arrange()


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
        zoom_out = self._button(
            _theme_icon("ZoomOut"), tr("Zoom all pictures out (wheel, -)"), lambda: viewport.zoom_by(-1)
        )
        zoom_in = self._button(
            _theme_icon("ZoomIn"), tr("Zoom all pictures in (wheel, +)"), lambda: viewport.zoom_by(1)
        )
        self._zoom_to_all = self._button(
            _theme_icon("ZoomFullExtent"), tr("Show the whole picture"), lambda: viewport.set_zoom(None)
        )
        self.zoom_to_best = self._button(
            QIcon(), tr("Back to 2x, at which loss of detail is best judged: each pixel is 2 x 2 on the screen"),
            lambda: viewport.set_zoom(BEST_ZOOM),
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
             tr("Most contrast: each window's darkest and brightest 2 % are cut off. Windows can't be compared, "
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


def _theme_icon(name: str) -> QIcon:
    return QgsApplication.getThemeIcon(f"/mAction{name}.svg")


class ImagesPanel(QWidget):
    """Pictures of the first selected window: the mosaic's and each source's."""

    def __init__(self, session: Session, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._session = session
        self._fid: int | None = None
        self._pictures: Sequence[ClipPicture] | None = None
        self._chosen = ""  # name of the picture that the large one flips to, as it was clicked
        self._why_not = ""  # there is no composite
        self._loss: LossImage | None = None
        self.viewport = Viewport(self)
        self.views: list[PictureView] = []
        """Those side by side, the mosaic's first."""
        self._space = SpaceKey(self)
        self._space.changed.connect(self._flip)
        self._build()
        self.viewport.changed.connect(self._show_zoom)
        session.selectionChanged.connect(self._refresh)
        session.windowsChanged.connect(self._refresh)
        session.inputsChanged.connect(self._refresh)
        session.picturesArrived.connect(self._arrived)
        session.resultArrived.connect(self._arrived)
        session.loss_view.changed.connect(self._show_loss)
        self._refresh()

    # Parts

    def _build(self) -> None:
        self.bar = ImagesBar(self._session, self.viewport)
        self.bar.arrangementChanged.connect(self._rearrange)
        self._hint = QLabel()
        self._hint.setTextFormat(Qt.TextFormat.PlainText)
        self._hint.setWordWrap(True)
        self._hint.setAlignment(Qt.AlignmentFlag.AlignCenter)
        self._hint.setMargin(12)
        self._scroll = QScrollArea()
        self._flow = PictureFlow(self._scroll)
        self._scroll.setFrameShape(QScrollArea.Shape.NoFrame)
        self._scroll.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self._scroll.setWidgetResizable(True)
        self._scroll.setFocusPolicy(Qt.FocusPolicy.NoFocus)
        self._scroll.setWidget(self._flow)
        self._one = QWidget()
        self.large = self._new_view(self._one)
        self.strip = PictureStrip()
        self.strip.chosen.connect(self._choose)
        self._one_box = QBoxLayout(QBoxLayout.Direction.TopToBottom, self._one)
        self._one_box.setContentsMargins(0, 0, 0, 0)
        self._one_box.setSpacing(GAP)
        self._one_box.addWidget(self.large, 1)
        self._one_box.addWidget(self.strip)
        self._pages = QStackedWidget()
        for page in (self._hint, self._scroll, self._one):
            self._pages.addWidget(page)
        box = QVBoxLayout(self)
        box.setContentsMargins(0, 0, 0, 0)
        box.setSpacing(GAP)
        box.addWidget(self.bar)
        box.addWidget(self._pages, 1)
        self._show_zoom()

    def _new_view(self, parent: QWidget) -> PictureView:
        view = PictureView(self.viewport, parent)
        view.hovered.connect(self._space.set_hovered)
        view.focused.connect(self._space.set_focused)
        return view

    def minimumSizeHint(self) -> QSize:
        side = 10 * self.fontMetrics().height()
        return QSize(side, side)

    # What is shown

    def _refresh(self, *_: object) -> None:
        """Ask for what is selected; out of sight nothing is read."""
        if not self.isVisible():
            return
        selected = self._session.selected()
        self._fid = selected[0] if selected else None
        if self._fid is None:
            self.bar.status.setText("")
            self._say(tr("Select a window, in the table or on the map, to see its pictures."))
            return
        pictures = self._session.pictures(self._fid)
        if pictures is None and self._session.mosaic_layer() is None:
            self._say(tr("Choose the mosaic under Inputs to see the pictures of this window."))
        elif pictures is None:
            self._say_reading()
        elif not pictures:
            self._say(tr("No picture: neither the mosaic nor a source can be read in this window."))
        elif pictures is not self._pictures or not self._is_showing():
            self._show(pictures)
        self._show_status(pictures)

    def _arrived(self, fid: int) -> None:
        """Its pictures, its composite, or its result."""
        if fid != self._fid:
            return
        self._refresh()
        if self._pictures and self.large.isVisible():
            self._compare(self._pictures)
        self._show_loss()

    def _is_showing(self) -> bool:
        return self._pages.currentWidget() is not self._hint

    def _shown_views(self) -> list[PictureView]:
        return self.views if self.bar.side_by_side.isChecked() else [self.large]

    def _say(self, hint: str) -> None:
        self._pictures = None
        self._space.release()
        self._hint.setText(hint)
        self._pages.setCurrentWidget(self._hint)

    def _say_reading(self) -> None:
        """The pictures of the window before stay in place, dimmed, so that nothing flickers."""
        self._pictures = None
        if self._is_showing():
            for view in self._shown_views():
                view.set_reading()
        else:
            self._say(tr("Reading the pictures ..."))

    def _show(self, pictures: Sequence[ClipPicture]) -> None:
        shown = len(self._pictures or ())
        self._pictures = pictures
        size = (pictures[0].pixels.shape[1], pictures[0].pixels.shape[0])
        if size != self.viewport.window or len(pictures) != shown:
            self.viewport.set_cursor(None)  # the mouse is somewhere else now
        self.viewport.window = size
        if self.bar.side_by_side.isChecked():
            self._show_all(pictures)
        else:
            self._show_one(pictures)
        self._show_loss()
        self._show_zoom()

    def _show_all(self, pictures: Sequence[ClipPicture]) -> None:
        while len(self.views) < len(pictures):
            view = self._new_view(self._flow)
            view.show()
            self.setTabOrder(self.views[-1] if self.views else self.bar.zoom_to_best, view)
            self.views.append(view)
        while len(self.views) > len(pictures):
            self._drop_view()
        mosaic = next((picture for picture in pictures if picture.is_mosaic), None)
        for view, picture in zip(self.views, pictures):
            view.set_pictures(picture, mosaic)
        self._flow.set_views(self.views)
        self._pages.setCurrentWidget(self._scroll)

    def _show_one(self, pictures: Sequence[ClipPicture]) -> None:
        """The mosaic large, the others small; the one chosen before stays chosen where it is."""
        self.strip.show_pictures(sorted(pictures[1:], key=lambda one: -one.covered))
        for before, after in zip((self.large, *self.strip.buttons), self.strip.buttons):
            self.setTabOrder(before, after)
        self.strip.setVisible(len(pictures) > 1)
        self._compare(pictures)
        self._pages.setCurrentWidget(self._one)

    def _compare(self, pictures: Sequence[ClipPicture]) -> None:
        """The mosaic with what is chosen, by default the source that covers most."""
        other = next((one for one in pictures[1:] if one.raster == self._chosen), None)
        self._why_not = ""
        if other is None and self._chosen == COMPOSITE and len(pictures) > 1 and self._fid is not None:
            made = self._session.composite(self._fid)
            other = made[0] if made else None
            if not made:
                self._why_not = tr("composite: reading ...") if made is None else tr("no source explains it")
            self.strip.mark(COMPOSITE)
        else:
            other = other or max(pictures[1:], key=lambda one: one.covered, default=None)
            self.strip.mark(other.raster if other is not None else "")
        self.large.set_pictures(pictures[0], other)
        self._show_status(pictures)

    def _choose(self, name: str) -> None:
        self._chosen = name
        if self._pictures:
            self._compare(self._pictures)

    def _show_loss(self, *_: object) -> None:
        """Over all pictures, where it was measured and is asked for."""
        result = self._session.result(self._fid) if self._fid is not None else None
        loss = result.loss if result is not None and self._session.loss_view.is_shown else None
        if loss is None:
            self._loss = None
        elif self._loss is None or self._loss.loss is not loss:
            self._loss = LossImage(loss)
        for view in (*self.views, self.large):
            view.set_loss(self._loss)

    def _rearrange(self) -> None:
        self._space.release()
        if self._pictures and self._is_showing():
            self._show(self._pictures)
        self._refresh()

    def _drop_view(self) -> None:
        view = self.views.pop()
        self._space.set_hovered(view, False)
        self._space.set_focused(view, False)
        view.hide()
        view.deleteLater()

    def _show_status(self, pictures: Sequence[ClipPicture] | None) -> None:
        row = self._session.row(self._fid) if self._fid is not None else None
        if row is None or pictures == () or (pictures is None and self._session.mosaic_layer() is None):
            self.bar.status.setText("")
            return
        if pictures is None:
            text = tr("{window}: reading ...")
        elif len(pictures) == 1 and pictures[0].is_mosaic:
            text = tr("{window}: no source covers it")
        elif self._why_not and not self.bar.side_by_side.isChecked():
            text = "{window} · " + self._why_not
        else:
            text = "{window}"
        self.bar.status.setText(filled(text, window=filled(tr("Window {number}"), number=row.window_id)))

    def _show_zoom(self) -> None:
        self.bar.show_zoom(self._is_showing())

    # Flipping

    def _flip(self) -> None:
        flipped = self._space.view
        for view in (*self.views, self.large):
            view.set_flipped(view is flipped)

    # Coming and going

    def showEvent(self, event: QShowEvent) -> None:
        super().showEvent(event)
        self._refresh()

    def hideEvent(self, event: QHideEvent) -> None:
        super().hideEvent(event)
        self._space.release()

    def resizeEvent(self, event: QResizeEvent) -> None:
        """The strip lies along the longer side."""
        super().resizeEvent(event)
        is_upright = self._pages.width() > 1.2 * self._pages.height()
        ways = QBoxLayout.Direction.LeftToRight, QBoxLayout.Direction.TopToBottom
        self._one_box.setDirection(ways[0] if is_upright else ways[1])
        self.strip.stand(is_upright)

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() == QEvent.Type.FontChange:
            self._flow.arrange()
