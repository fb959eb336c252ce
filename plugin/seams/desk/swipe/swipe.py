"""The mosaic against one of its sources, on the map itself, either side of a handle."""
from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import Any
from uuid import uuid4

from qgis.core import QgsMapLayer, QgsProject, QgsRasterLayer
from qgis.gui import QgsMapCanvas
from qgis.PyQt import sip
from qgis.PyQt.QtCore import QEvent, QObject, QPointF, Qt, pyqtSignal
from qgis.PyQt.QtGui import QKeySequence
from qgis.PyQt.QtWidgets import QShortcut

from ....imagery.gdal_calls import drop_from_memory
from ....toolkit.background_tasks import BackgroundTasks, Job
from ....toolkit.translation import filled, tr
from .composite_layer import composite_job
from .map_picture import MapPicture, end_drawing
from .swipe_handle import SwipeHandle
from .swipe_item import SwipeItem
from .swiped_layer import SwipeChoice, exchanged, is_on_top, looks_alike, opening_job

_FLIP_KEY, _END_KEY = Qt.Key.Key_X, Qt.Key.Key_Escape


class Swipe(QObject):
    """The one owner of all that lies on the canvas; ``stop`` takes it off, and nothing is left."""

    changed = pyqtSignal()
    """It began, ended, or compares with something else."""
    failed = pyqtSignal(object)
    """The Message why there is nothing to compare with; it has ended."""

    def __init__(self, canvas: QgsMapCanvas, parent: QObject) -> None:
        super().__init__(parent)
        self._canvas = canvas
        self._background = BackgroundTasks(self)
        self._mosaic: QgsRasterLayer | None = None
        self._sources: set[str] = set()  # ids of layers that would hide the mosaic
        self._layer: QgsRasterLayer | None = None  # what it is compared with
        self._file = ""  # in memory: the composite
        self._turn = 0
        self.choice: SwipeChoice | None = None
        """What the mosaic is compared with; None when it is not."""
        self._own = MapPicture(self)
        self._other = MapPicture(self)
        self._item: SwipeItem | None = None
        self._handle: SwipeHandle | None = None
        self._keys: list[QShortcut] = []
        self._connections: list[tuple[Any, Callable[..., None]]] = []
        self._share, self._is_upright, self._is_flipped = 0.5, True, False
        self._origin = QPointF()  # of what is seen of the scene

    @property
    def is_on(self) -> bool:
        """Whether the handle lies on the map."""
        return self.choice is not None

    @property
    def is_drawing(self) -> bool:
        """Whether what is swiped is being opened or drawn."""
        return self.is_on and (self._layer is None or self._own.is_drawing or self._other.is_drawing)

    @property
    def is_upright(self) -> bool:
        """Whether the handle is."""
        return self._is_upright

    def start(self, mosaic: QgsRasterLayer, choice: SwipeChoice, sources: set[str]) -> None:
        """Compare a mosaic; ``sources``: ids of the project's layers of its sources."""
        is_same = self.is_on and self._mosaic is mosaic and choice == self.choice
        self._mosaic, self._sources = mosaic, sources
        if is_same:
            self._draw()
            return
        self.choice, self._layer = choice, None
        self._other.close()
        if self._item is None:
            self._lay_on_canvas()
        self._turn += 1
        self._background.cancel_others({self._turn})
        self._forget_file()
        self._background.start(
            filled(tr("Open {name}"), name=choice.title), self._job(choice), partial(self._take, self._turn), self._turn
        )
        self._draw()
        self.changed.emit()

    def stop(self) -> None:
        """Take everything off the canvas."""
        if not self.is_on:
            return
        self.choice = self._mosaic = self._layer = None
        self._turn += 1
        self._background.cancel_others(set())
        self._own.close()
        self._other.close()
        self._forget_file()
        while self._connections:
            signal, slot = self._connections.pop()
            if not sip.isdeleted(self._canvas):
                signal.disconnect(slot)
        item, handle, self._item, self._handle = self._item, self._handle, None, None
        keys, self._keys = self._keys, []
        if not sip.isdeleted(self._canvas):  # it owns them all
            self._canvas.viewport().removeEventFilter(self)
            if item is not None:
                self._canvas.scene().removeItem(item)
            for widget in (handle, *keys):
                if widget is not None:
                    widget.setParent(None)
                    widget.deleteLater()
        self.changed.emit()

    def close(self) -> None:
        """It can't be used afterwards."""
        self.stop()
        self._background.close()

    def flip(self) -> None:
        """Exchange the sides."""
        self._is_flipped = not self._is_flipped
        self._place()

    def turn(self, is_upright: bool) -> None:
        """The handle upright, or lying."""
        self._is_upright = is_upright
        self._place()

    def move(self, share: float) -> None:
        """The handle to a share of the map, from the left or from the top."""
        self._share = share
        self._place()

    # The canvas

    def _lay_on_canvas(self) -> None:
        canvas, window = self._canvas, self._canvas.window()
        self._item = SwipeItem(canvas, self._own, self._other)
        self._handle = SwipeHandle(canvas)
        self._handle.moved.connect(self.move)
        for key, slot in ((_FLIP_KEY, self.flip), (_END_KEY, self.stop)):
            shortcut = QShortcut(QKeySequence(key), window)
            shortcut.activated.connect(slot)
            self._keys.append(shortcut)
        self._connections = [
            (canvas.renderStarting, self._draw),
            (canvas.extentsChanged, self._repaint),
            (canvas.rotationChanged, self._repaint),
            (canvas.destinationCrsChanged, self._repaint),
            (canvas.xyCoordinates, self._follow_drag),
            (QgsProject.instance().layersWillBeRemoved, self._end_drawing),
            (self._own.drawn, self._repaint),
            (self._other.drawn, self._repaint),
        ]
        for signal, slot in self._connections:
            signal.connect(slot)
        canvas.viewport().installEventFilter(self)
        self._origin = canvas.sceneRect().topLeft()
        self._place()
        self._handle.show()

    def eventFilter(self, _watched: QObject | None, event: QEvent | None) -> bool:
        if event is not None and event.type() == QEvent.Type.Resize:
            self._place()
        return False

    def _end_drawing(self, *_: object) -> None:
        end_drawing()

    def _place(self) -> None:
        if self._item is None or self._handle is None:
            return
        self._item.share, self._item.is_upright, self._item.is_flipped = self._share, self._is_upright, self._is_flipped
        self._handle.place(self._share, self._is_upright)
        self._repaint()

    def _repaint(self, *_: object) -> None:
        if self._item is not None:
            self._item.prepareGeometryChange()
            self._item.update()

    def _follow_drag(self, *_: object) -> None:
        """The map is dragged: the handle stays where it is on the screen."""
        origin = self._canvas.sceneRect().topLeft()
        if origin != self._origin:
            self._origin = origin
            self._repaint()

    # What is drawn

    def _job(self, choice: SwipeChoice) -> Job:
        if choice.ref is not None:
            return opening_job(choice.ref)
        assert choice.request is not None
        self._file = f"/vsimem/seam_inspector_composite_{uuid4().hex}.tif"
        return composite_job(choice.request, self._file)

    def _take(self, turn: int, layer: object) -> None:
        if turn != self._turn:
            return
        if isinstance(layer, QgsRasterLayer):
            self._layer = layer
            self._draw()
        else:
            self.stop()
            self.failed.emit(layer)

    def _forget_file(self) -> None:
        """Of the composite before; what is still drawn keeps it open."""
        file, self._file = self._file, ""
        if file:
            drop_from_memory(file)

    def _draw(self, *_: object) -> None:
        """As the canvas is drawn now; it asks for it each time it begins."""
        mosaic, item = self._mosaic, self._item
        if mosaic is None or item is None or self.choice is None or sip.isdeleted(mosaic):
            return
        settings = self._canvas.mapSettings()
        settings.setBackgroundColor(self._canvas.canvasColor())
        shown: list[QgsMapLayer] = settings.layers()
        if is_on_top(shown, mosaic, self._sources):
            self._own.close()
        else:
            self._own.draw(settings, exchanged(shown, mosaic, self._sources, [mosaic]))
        title = self.choice.title
        if self._layer is not None:
            if not looks_alike(self._layer, mosaic):
                title = filled(tr("{name} (its own stretch)"), name=title)
            beneath = [] if self.choice.ref is not None else [mosaic]  # a composite is of one window
            self._other.draw(settings, exchanged(shown, mosaic, self._sources, [self._layer, *beneath]))
        else:
            title = filled(tr("{name}: reading ..."), name=title)
        item.names = tr("mosaic"), title
        self._repaint()
