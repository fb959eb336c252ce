"""The clips of the selected window side by side, to be judged by eye."""
from __future__ import annotations

from typing import Callable

from qgis.core import QgsApplication
from qgis.PyQt.QtCore import QEvent, QSize, Qt
from qgis.PyQt.QtGui import QHideEvent, QShowEvent
from qgis.PyQt.QtWidgets import QHBoxLayout, QLabel, QScrollArea, QStackedWidget, QToolButton, QVBoxLayout, QWidget

from ....toolkit.desk.clipped_label import ClippedLabel
from ....toolkit.desk.space_key import SpaceKey
from ....toolkit.translation import tr
from ...clip_pictures import ClipPicture
from ..session import Session
from .picture_flow import GAP, PictureFlow
from .picture_view import PictureView
from .viewport import BEST_ZOOM, Viewport


class ImagesPanel(QWidget):
    """Pictures of the first selected window: the mosaic's and each source's."""

    def __init__(self, session: Session, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._session = session
        self._fid: int | None = None
        self._pictures: list[ClipPicture] | None = None
        self.viewport = Viewport(self)
        self.views: list[PictureView] = []
        """Those in use, the mosaic's first."""
        self._space = SpaceKey(self)
        self._space.changed.connect(self._flip)
        self._build()
        self.viewport.changed.connect(self._show_zoom)
        session.selectionChanged.connect(self._refresh)
        session.windowsChanged.connect(self._refresh)
        session.inputsChanged.connect(self._refresh)
        session.picturesArrived.connect(self._arrived)
        self._refresh()

    # Parts

    def _build(self) -> None:
        self._status = ClippedLabel(1)
        self._zoom = QLabel()
        self._zoom.setToolTip(tr("Screen pixels per image pixel"))
        self._zoom.setMinimumWidth(self.fontMetrics().horizontalAdvance("0.00x"))
        self._zoom.setAlignment(Qt.AlignmentFlag.AlignCenter)
        zoom_out = self._button("/mActionZoomOut.svg", tr("Zoom all pictures out (wheel, -)"), self._zoom_out)
        zoom_in = self._button("/mActionZoomIn.svg", tr("Zoom all pictures in (wheel, +)"), self._zoom_in)
        self._zoom_to_all = self._button("/mActionZoomFullExtent.svg", tr("Show all of the window"), self._show_all)
        self._zoom_to_best = self._button(
            "", tr("Back to 2x, at which loss of detail is best judged: each pixel is 2 x 2 on the screen"), self._reset
        )
        self._zoom_to_best.setText("2x")
        for button in (self._zoom_to_all, self._zoom_to_best):
            button.setCheckable(True)
        top = QHBoxLayout()
        top.setSpacing(GAP)
        top.addWidget(self._status, 1)
        for widget in (zoom_out, self._zoom, zoom_in, self._zoom_to_all, self._zoom_to_best):
            top.addWidget(widget)
        self._hint = QLabel()
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
        self._pages = QStackedWidget()
        self._pages.addWidget(self._hint)
        self._pages.addWidget(self._scroll)
        box = QVBoxLayout(self)
        box.setContentsMargins(0, 0, 0, 0)
        box.setSpacing(GAP)
        box.addLayout(top)
        box.addWidget(self._pages, 1)
        self._show_zoom()

    def _button(self, icon: str, tip: str, slot: Callable[[], None]) -> QToolButton:
        button = QToolButton()
        button.setAutoRaise(True)
        button.setToolTip(tip)
        button.setAccessibleName(tip)
        if icon:
            button.setIcon(QgsApplication.getThemeIcon(icon))
        button.clicked.connect(slot)
        return button

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
        self._show_status()

    def _arrived(self, fid: int) -> None:
        if fid == self._fid:
            self._refresh()

    def _is_showing(self) -> bool:
        return self._pages.currentWidget() is self._scroll

    def _say(self, hint: str) -> None:
        self._pictures = None
        self._status.setText("")
        self._space.release()
        self._hint.setText(hint)
        self._pages.setCurrentWidget(self._hint)

    def _say_reading(self) -> None:
        """The pictures of the window before stay in place, dimmed, so that nothing flickers."""
        self._pictures = None
        if self._is_showing():
            for view in self.views:
                view.set_reading()
        else:
            self._say(tr("Reading the pictures ..."))

    def _show(self, pictures: list[ClipPicture]) -> None:
        self._pictures = pictures
        size = (pictures[0].pixels.shape[1], pictures[0].pixels.shape[0])
        if size != self.viewport.window or len(pictures) != len(self.views):
            self.viewport.set_cursor(None)  # the mouse is somewhere else now
        self.viewport.window = size
        while len(self.views) < len(pictures):
            self._add_view()
        while len(self.views) > len(pictures):
            self._drop_view()
        mosaic = next((picture for picture in pictures if picture.is_mosaic), None)
        for view, picture in zip(self.views, pictures):
            view.set_pictures(picture, mosaic)
        self._flow.set_views(self.views)
        self._pages.setCurrentWidget(self._scroll)
        self._show_zoom()

    def _add_view(self) -> None:
        view = PictureView(self.viewport, self._flow)
        view.hovered.connect(self._space.set_hovered)
        view.focused.connect(self._space.set_focused)
        view.show()
        self.setTabOrder(self.views[-1] if self.views else self._zoom_to_best, view)
        self.views.append(view)

    def _drop_view(self) -> None:
        view = self.views.pop()
        self._space.set_hovered(view, False)
        self._space.set_focused(view, False)
        view.hide()
        view.deleteLater()

    def _show_status(self) -> None:
        row = self._session.row(self._fid) if self._fid is not None else None
        if row is None:
            return
        if self._pictures is None:
            text = tr("{window}: reading ...")
        elif len(self._pictures) == 1 and self._pictures[0].is_mosaic:
            text = tr("{window}: no source covers it")
        else:
            text = tr("{window} · Space: mosaic")
        self._status.setText(text.format(window=tr("Window {number}").format(number=row.window_id)))

    # Zoom

    def _zoom_in(self) -> None:
        self.viewport.zoom_by(1)

    def _zoom_out(self) -> None:
        self.viewport.zoom_by(-1)

    def _show_all(self) -> None:
        self.viewport.set_zoom(None)

    def _reset(self) -> None:
        self.viewport.set_zoom(BEST_ZOOM)

    def _show_zoom(self) -> None:
        """Unchecking by a click is no choice, so the buttons are set anew each time."""
        self._zoom.setText(f"{self.viewport.scale:.2g}x" if self._is_showing() else "")
        self._zoom_to_all.setChecked(self.viewport.zoom is None)
        self._zoom_to_best.setChecked(self.viewport.zoom == BEST_ZOOM)

    # Flipping

    def _flip(self) -> None:
        flipped = self._space.view
        for view in self.views:
            view.set_flipped(view is flipped)

    # Coming and going

    def showEvent(self, event: QShowEvent) -> None:
        super().showEvent(event)
        self._refresh()

    def hideEvent(self, event: QHideEvent) -> None:
        super().hideEvent(event)
        self._space.release()

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() == QEvent.Type.FontChange:
            self._flow.arrange()
