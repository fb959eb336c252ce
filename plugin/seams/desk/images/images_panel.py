"""The selected window at 2x, to be judged by eye: the mosaic beside its hard cut or a source, on two maps that move as
one."""
from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import TYPE_CHECKING

from qgis.core import QgsCoordinateReferenceSystem, QgsMapLayer, QgsPointXY, QgsRectangle
from qgis.gui import QgsMapCanvas, QgsMapToolPan
from qgis.PyQt.QtCore import QSize, Qt
from qgis.PyQt.QtGui import QResizeEvent, QShowEvent
from qgis.PyQt.QtWidgets import QBoxLayout, QComboBox, QFrame, QHBoxLayout, QLabel, QStackedWidget, QVBoxLayout, QWidget

from ....imagery.grids import covered_share
from ....toolkit.desk.widgets import ClippedLabel, single_shot
from ....toolkit.reference_systems import known_system
from ....toolkit.translation import filled, sentence, tr
from ..map.hard_cut import Compared, ComparedLayer, looks_alike
from ..map.lost_detail import PictureOverlay, picture_of, placed_picture
from ..map.window_view import WindowOutline, WindowView

if TYPE_CHECKING:
    from ...measure.window.measured_window import WindowRequest
    from ..session import Session

_GAP = 4  # px


class WindowMap(QgsMapCanvas):
    """A map of one raster around a window, with the window's outline and its lost detail."""

    def __init__(self, parent: QWidget) -> None:
        super().__init__(parent)
        self.setFocusPolicy(Qt.FocusPolicy.NoFocus)  # keys judge
        self.setFrameShape(QFrame.Shape.NoFrame)
        self.enableAntiAliasing(True)
        self.setMapTool(QgsMapToolPan(self))
        self.outline = WindowOutline(self)
        self.loss = PictureOverlay(self)

    def minimumSizeHint(self) -> QSize:
        side = 7 * self.fontMetrics().height()
        return QSize(side, side)

    def show_layers(self, layers: list[QgsMapLayer], crs: QgsCoordinateReferenceSystem) -> None:
        """These and no others, the topmost first, in this reference system."""
        if self.mapSettings().destinationCrs() != crs:
            self.setDestinationCrs(known_system(crs))
        if self.layers() != layers:
            self.setLayers(layers)

    def look_at(self, centre: QgsPointXY, units_per_pixel: float) -> None:
        """Show what lies around a point, as large as that."""
        size = self.width() * units_per_pixel, self.height() * units_per_pixel
        self.setExtent(QgsRectangle.fromCenterAndSize(centre, *size))
        self.refresh()

    def close_map(self) -> None:
        """Nothing is drawn any more."""
        self.stopRendering()
        self.setLayers([])
        self.outline.close()
        self.loss.close()


class ImagesPanel(QWidget):
    """Follows the selected window while it is in sight."""

    def __init__(self, session: Session, is_blind: Callable[[], bool] = lambda: False) -> None:
        """``is_blind``: whether it is hidden where detail was lost."""
        super().__init__()
        self._session = session
        self._shown: tuple[int, object] | None = None  # feature id and outline of the window that is looked at
        self._is_moving = False
        self.mosaic, self.other = WindowMap(self), WindowMap(self)
        self._view = WindowView(self.mosaic, session, is_blind)
        self.compared = ComparedLayer(self)  # what stands beside the mosaic
        self.compared.changed.connect(self._show_compared)
        self.compared.failed.connect(self._show_compared)
        self._is_alike = True  # what is compared has the mosaic's look
        self._looker = single_shot(self, self._look)  # when the maps have their sizes
        self._build()
        for canvas, beside in ((self.mosaic, self.other), (self.other, self.mosaic)):
            canvas.extentsChanged.connect(partial(self._link, canvas, beside))
        for signal in (session.selectionChanged, session.windowsChanged, session.inputsChanged):
            signal.connect(self._refresh)
        session.resultArrived.connect(self._show_loss)
        session.lost_detail.toggled.connect(self._show_loss)

    def close(self) -> bool:
        """Leave nothing open."""
        self.compared.close()
        for canvas in (self.mosaic, self.other):
            canvas.close_map()
        return bool(super().close())

    def _build(self) -> None:
        self.status = ClippedLabel(1)
        self.choice = QComboBox()
        self.choice.setToolTip(tr("What the mosaic is compared with"))
        self.choice.setSizeAdjustPolicy(QComboBox.SizeAdjustPolicy.AdjustToMinimumContentsLengthWithIcon)
        self.choice.setMinimumContentsLength(14)
        self.choice.activated.connect(self._refresh)
        row = QHBoxLayout()
        row.addWidget(self.status, 1)
        row.addWidget(self.choice, 2)
        self._hint = QLabel()
        self._hint.setWordWrap(True)
        self._hint.setAlignment(Qt.AlignmentFlag.AlignCenter)
        maps = QWidget()
        self._maps = QBoxLayout(QBoxLayout.Direction.LeftToRight, maps)
        self._maps.setContentsMargins(0, 0, 0, 0)
        self._maps.setSpacing(_GAP)
        for canvas in (self.mosaic, self.other):
            self._maps.addWidget(canvas, 1)
        self._pages = QStackedWidget()
        self._pages.addWidget(self._hint)
        self._pages.addWidget(maps)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.setSpacing(_GAP)
        layout.addLayout(row)
        layout.addWidget(self._pages, 1)

    def showEvent(self, event: QShowEvent) -> None:
        super().showEvent(event)
        self._refresh()

    def resizeEvent(self, event: QResizeEvent) -> None:
        """Side by side, or one above the other where there is more room for it."""
        super().resizeEvent(event)
        ways = QBoxLayout.Direction.LeftToRight, QBoxLayout.Direction.TopToBottom
        self._maps.setDirection(ways[0] if self._pages.width() > self._pages.height() else ways[1])
        self._looker.start()

    def _refresh(self, *_: object) -> None:
        if not self.isVisible():
            return
        selected, mosaic = self._session.selected(), self._session.mosaic_layer()
        row = self._session.row(selected[0]) if selected else None
        request = self._session.request(row.fid) if row is not None else None
        self.status.setText("" if row is None else filled(tr("Window {number}"), number=row.window_id))
        if row is None or mosaic is None or request is None or request.window is None:
            why_not = self._session.problem() if request is None else request.reason
            self._say(sentence(why_not) if row is not None and why_not is not None else tr(
                "Select a window, in the table or on the map, to see its pictures."))
            return
        self._pages.setCurrentIndex(1)
        self._offer(request)
        self.mosaic.show_layers([mosaic], mosaic.crs())
        source = next((source.ref for source in request.sources if source.ref.name == self.choice.currentData()), None)
        self.compared.ask(Compared(request, source) if request.sources else None)
        self._show_compared()
        self._show_loss()
        if (row.fid, row.extent) != self._shown:
            self._shown = row.fid, row.extent
            self._looker.start()

    def _say(self, hint: str) -> None:
        self._shown = None
        self.compared.ask(None)
        self.choice.setEnabled(False)
        self._hint.setText(hint)
        self._pages.setCurrentIndex(0)

    def _offer(self, request: WindowRequest) -> None:
        """The hard cut and the sources, those that cover most first; what was chosen stays chosen where it is there."""
        assert request.window is not None
        place = request.mosaic.grid.window_extent(request.window)
        sources = sorted(request.sources, key=lambda source: -covered_share(place, source.extent))
        chosen, names = self.choice.currentData(), [source.ref.name for source in sources]
        self.choice.setEnabled(bool(names))
        if names != [self.choice.itemData(place) for place in range(1, self.choice.count())]:
            self.choice.clear()
            self.choice.addItem(tr("hard cut of the sources"), "")
            for name in names:
                self.choice.addItem(name, name)
            self.choice.setCurrentIndex(max(self.choice.findData(chosen), 0))

    def _show_compared(self, *_: object) -> None:
        """What stands beside the mosaic, once it is there; and the window's outline on both."""
        mosaic, layer = self._session.mosaic_layer(), self.compared.layer
        if mosaic is None or self._pages.currentIndex() == 0:
            return
        title = self.choice.currentText()
        if layer is not None and layer not in self.other.layers():
            self._is_alike = looks_alike(layer, mosaic)
        if self.compared.why_not is not None:
            title = sentence(self.compared.why_not)
        elif layer is None:
            title = filled(tr("{name}: reading ..."), name=title) if self.choice.isEnabled() else tr("no source here")
        elif not self._is_alike:
            title = filled(tr("{name} (its own stretch)"), name=title)
        is_cut = not self.choice.currentData()  # which is of the window alone
        self.other.show_layers([] if layer is None else [layer, mosaic] if is_cut else [layer], mosaic.crs())
        selected, windows = self._session.selected(), self._session.window_layer()
        row = self._session.row(selected[0]) if selected else None
        if row is not None and row.extent is not None and windows is not None:
            for canvas, words in ((self.mosaic, tr("mosaic")), (self.other, title)):
                canvas.outline.show(QgsRectangle(*row.extent), words, windows.crs())

    def _show_loss(self, *_: object) -> None:
        """Over both maps, where it was measured and is asked for."""
        selected, grid = self._session.selected(), self._session.mosaic_grid()
        row = self._session.row(selected[0]) if selected and self._session.lost_detail.isChecked() else None
        result = self._session.result(row.fid) if row is not None else None
        picture = picture_of(row, result) if row is not None and result is not None else None
        placed = []
        if picture is not None and picture.image is not None and picture.window is not None and grid is not None:
            placed = [placed_picture(picture.image, picture.window, picture.cell_px, grid)]
        for canvas in (self.mosaic, self.other):
            canvas.loss.show(placed, canvas.mapSettings().destinationCrs())

    def _look(self, *_: object) -> None:
        """At the window at 2x, where it lost most if it is larger than the map."""
        views = self._view.views(self._shown[0]) if self._shown is not None and self.isVisible() else []
        if views:
            self.mosaic.look_at(views[0].center(), views[0].width() / max(self.mosaic.width(), 1))

    def _link(self, moved: WindowMap, beside: WindowMap) -> None:
        """Move the map beside to where this one was moved."""
        if not self._is_moving:
            self._is_moving = True
            beside.look_at(moved.center(), moved.mapUnitsPerPixel())
            self._is_moving = False
