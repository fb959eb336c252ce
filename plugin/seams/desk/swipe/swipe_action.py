"""The mosaic against one of its sources, on the map, either side of a handle; the dock's button and menu for it."""
from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import TYPE_CHECKING
from uuid import uuid4

from qgis.core import QgsMapLayer, QgsProject, QgsRasterLayer
from qgis.gui import QgsMapCanvas
from qgis.PyQt import sip
from qgis.PyQt.QtCore import QEvent, QObject, QPointF, pyqtSignal
from qgis.PyQt.QtGui import QIcon
from qgis.PyQt.QtWidgets import QAction, QActionGroup, QMenu, QWidget

from ....imagery.errors import Message
from ....imagery.gdal_calls import drop_from_memory
from ....imagery.grids import Extent, extents_meet
from ....toolkit.background_tasks import BackgroundTasks, Job
from ....toolkit.connections import Connections
from ....toolkit.desk.message_bar import bar_level
from ....toolkit.desk.widgets import allow, plain_tip
from ....toolkit.layers import box_extent, transformed_box
from ....toolkit.reference_systems import keep_system
from ....toolkit.resources import icon_path
from ....toolkit.translation import filled, sentence, tr
from ...measure import messages
from ...measure.inputs.mosaic_copies import covered_share
from ...measure.inspection import Block
from ...measure.window.window_request import WindowRequest
from .swipe_item import Divider, MapPicture, SwipeHandle, SwipeItem, end_drawing
from .swiped_layer import (
    SwipeChoice,
    composite_job,
    exchanged,
    is_on_top,
    looks_alike,
    mended_mosaics,
    opening_job,
    source_layers,
)

if TYPE_CHECKING:
    from ..session import Session


class Swipe(QObject):
    """The one owner of all that lies on the canvas; ``stop`` takes it off, and nothing is left."""

    changed = pyqtSignal()
    """It began, ended, or compares with something else."""
    failed = pyqtSignal(object)
    """The Message why there is nothing to compare with; it has ended."""

    def __init__(self, canvas: QgsMapCanvas, parent: QObject, has_handle: bool = True) -> None:
        """``has_handle``: to be dragged; else the other picture has all of the map while it is shown."""
        super().__init__(parent)
        self._canvas = canvas
        self._has_handle = has_handle
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
        self._connections = Connections()
        self.divider = Divider() if has_handle else Divider(share=0.0)
        self.is_shown = has_handle
        """Whether what lies on the canvas is seen."""
        self._origin = QPointF()  # of what is seen of the scene

    @property
    def is_on(self) -> bool:
        """Whether the handle lies on the map."""
        return self.choice is not None

    @property
    def is_drawing(self) -> bool:
        """Whether what is swiped is being opened or drawn."""
        return self.is_on and (self._layer is None or self._own.is_drawing or self._other.is_drawing)

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
        item, handle, self._item, self._handle = self._item, self._handle, None, None
        if not sip.isdeleted(self._canvas):  # it owns them all
            self._connections.close()
            self._canvas.viewport().removeEventFilter(self)
            if item is not None:
                self._canvas.scene().removeItem(item)
            if handle is not None:
                handle.setParent(None)
                handle.deleteLater()
        self.changed.emit()

    def close(self) -> None:
        """It can't be used afterwards."""
        self.stop()
        self._background.close()

    def flip(self) -> None:
        """Exchange the sides."""
        self.divider.is_flipped = not self.divider.is_flipped
        self._place()

    def turn(self, is_upright: bool) -> None:
        """The handle upright, or lying."""
        self.divider.is_upright = is_upright
        self._place()

    def move(self, share: float) -> None:
        """The handle to a share of the map, from the left or from the top."""
        self.divider.share = share
        self._place()

    def show(self, is_shown: bool) -> None:
        """Let it be seen, or lie ready."""
        self.is_shown = is_shown
        if self._item is not None:
            self._item.setVisible(is_shown)

    # The canvas

    def _lay_on_canvas(self) -> None:
        canvas = self._canvas
        self._item = SwipeItem(canvas, self.divider, self._own, self._other, hides_loss=not self._has_handle)
        self._item.setVisible(self.is_shown)
        if self._has_handle:
            self._lay_handle(canvas)
        self._connections = Connections(
            (canvas.renderStarting, self._draw),
            (canvas.extentsChanged, self._repaint),
            (canvas.rotationChanged, self._repaint),
            (canvas.destinationCrsChanged, self._repaint),
            (canvas.xyCoordinates, self._follow_drag),
            (QgsProject.instance().layersWillBeRemoved, end_drawing),
            (self._own.drawn, self._repaint),
            (self._other.drawn, self._repaint),
        )
        canvas.viewport().installEventFilter(self)
        self._origin = canvas.sceneRect().topLeft()
        self._place()

    def _lay_handle(self, canvas: QgsMapCanvas) -> None:
        self._handle = SwipeHandle(canvas, self.divider)
        self._handle.moved.connect(self.move)
        self._handle.show()

    def eventFilter(self, _watched: QObject | None, event: QEvent | None) -> bool:
        if event is not None and event.type() == QEvent.Type.Resize:
            self._place()
        return False

    def _place(self) -> None:
        if self._handle is not None:
            self._handle.place()
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
            keep_system(layer)
            self._layer = layer
            self._draw()
        else:
            self.stop()
            self.failed.emit(layer)

    def _forget_file(self) -> None:
        """Forget the file of the composite before; what is still drawn keeps it open."""
        file, self._file = self._file, ""
        if file:
            drop_from_memory(file)

    def _draw(self, *_: object) -> None:
        """Draw both sides as the canvas is drawn now; it asks for it each time it begins."""
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


def compare(session: Session, swipe: Swipe, choice: SwipeChoice) -> None:
    """The present mosaic with this, if there is one."""
    mosaic, block = session.mosaic_layer(), session.block()
    if mosaic is None or block is None:
        return
    shown = {source.ref.path for source in block.sources} | ({choice.ref.path} if choice.ref is not None else set())
    sources = {*session.inputs.sources, *source_layers(QgsProject.instance(), shown)}
    swipe.start(mosaic, choice, sources - {mosaic.id()})


class SwipeAction(QObject):
    """Follows the selected window: what covers most of it, until a source is chosen that covers it too."""

    told = pyqtSignal(str, int)
    """A sentence for the user, and its level in the message bar."""

    def __init__(self, canvas: QgsMapCanvas, session: Session, parent: QWidget) -> None:
        super().__init__(parent)
        self._canvas = canvas
        self._session = session
        self.swipe = Swipe(canvas, self)
        self.swipe.changed.connect(self._show_state)
        self.swipe.failed.connect(self._tell_failure)
        self.menu = QMenu(parent)
        self.menu.setToolTipsVisible(True)
        self.menu.aboutToShow.connect(self._fill_menu)
        self.action = QAction(QIcon(icon_path("swipe")), tr("Swipe"), parent)
        self.action.setToolTip(
            tr("Compare the mosaic with a source on the map: drag the handle, X swaps the sides, Esc ends")
        )
        self.action.setCheckable(True)
        self.action.setMenu(self.menu)
        self.action.triggered.connect(self._toggle)
        self._is_chosen = False  # by the operator; else it is the source that covers most
        self._followed = [session.selectionChanged, session.inputsChanged, session.picturesArrived]
        for signal in self._followed:
            signal.connect(self._follow)
        self._follow()

    def close(self) -> None:
        """Leave nothing on the map; once is enough."""
        while self._followed:
            self._followed.pop().disconnect(self._follow)
        self.swipe.close()

    def key_actions(self) -> dict[str, Callable[[], object]]:
        """What the keys of swiping do, by their names."""
        return {"exchange": self.swipe.flip, "end": self.swipe.stop}

    def choices(self) -> list[SwipeChoice]:
        """The sources over the selected window, those that cover most of it first; without one, those on the map. Then
        the mended mosaic, and the composite."""
        block, mosaic = self._session.block(), self._session.mosaic_layer()
        if block is None or mosaic is None:
            return []
        place = self._place(block)
        if place is None:
            return []
        found = [source for source in block.sources if extents_meet(source.extent, place)]
        request = self._request()
        covered = self._covered() if request is not None else None
        if covered is not None:
            found = [source for source in found if covered.get(source.ref.name)]
            found.sort(key=lambda source: -covered[source.ref.name])  # stable: else in the order of the inputs
        else:
            found.sort(key=lambda source: -covered_share(place, source.extent))
        choices = [SwipeChoice(source.ref.name, source.ref) for source in found]
        choices += mended_mosaics(QgsProject.instance(), mosaic, {source.ref.path for source in block.sources})
        if request is not None and choices:
            choices.append(SwipeChoice(tr("composite"), request=request))
        return choices

    def _covered(self) -> dict[str, float] | None:
        """In what share of the selected window each source has pixels; None until its pictures are read."""
        pictures = self._session.pictures(self._session.selected()[0])
        return {picture.raster: picture.covered for picture in pictures[1:]} if pictures else None

    def start(self, choice: SwipeChoice) -> None:
        """Compare the mosaic with this, which the operator chose."""
        self._is_chosen = True
        compare(self._session, self.swipe, choice)

    def _toggle(self, is_wanted: bool) -> None:
        choices = self.choices() if is_wanted else []
        self._is_chosen = False
        if choices:
            compare(self._session, self.swipe, choices[0])
        else:
            self.swipe.stop()
        if is_wanted and not choices:
            message = messages.NO_SOURCES()
            self.told.emit(sentence(message), bar_level(message))
        self._show_state()

    def _follow(self, *_: object) -> None:
        """Another window, or other inputs: on with what covers it."""
        problem = self._session.problem()
        mosaic, block = self._session.mosaic_layer(), self._session.block()
        why_not = sentence(problem) if problem is not None else ""
        allow(self.action, why_not)
        if not self.swipe.is_on:
            return
        if mosaic is None:
            self.swipe.stop()
        elif block is not None and (choices := self.choices()):
            current = self.swipe.choice if self._is_chosen else None
            if current is not None and current.ref is None:
                current = choices[-1]  # of another window
            self._is_chosen = current in choices
            compare(self._session, self.swipe, current if current is not None and current in choices else choices[0])
        elif problem is not None and problem != messages.MOSAIC_OPENING():
            self.swipe.stop()

    def _fill_menu(self) -> None:
        self.menu.clear()
        group = QActionGroup(self.menu)
        choices = self.choices()
        for choice in choices:
            entry = self.menu.addAction(choice.title)
            entry.setCheckable(True)
            entry.setChecked(choice == self.swipe.choice)
            entry.setToolTip(plain_tip(filled(tr("Compare the mosaic with {name}"), name=choice.title)))
            entry.triggered.connect(lambda _checked, choice=choice: self.start(choice))
            group.addAction(entry)
        if not choices:
            self.menu.addAction(tr("No source here")).setEnabled(False)
        self.menu.addSeparator()
        flip = self.menu.addAction(tr("Swap the sides (X)"), self.swipe.flip)
        flip.setEnabled(self.swipe.is_on)
        lying = self.menu.addAction(tr("Horizontal handle"))
        lying.setToolTip(tr("Compare above and below instead of left and right"))
        lying.setCheckable(True)
        lying.setChecked(not self.swipe.divider.is_upright)
        lying.triggered.connect(lambda is_lying: self.swipe.turn(not is_lying))

    def _show_state(self) -> None:
        self.action.setChecked(self.swipe.is_on)

    def _tell_failure(self, message: Message) -> None:
        self.told.emit(sentence(message), bar_level(message))

    def _request(self) -> WindowRequest | None:
        """The selected window."""
        selected = self._session.selected()
        request = self._session.request(selected[0]) if selected else None
        return request if request is not None and request.window is not None else None

    def _place(self, block: Block) -> Extent | None:
        """The selected window, else what is seen of the map, on the mosaic."""
        request = self._request()
        if request is not None and request.window is not None:
            return block.mosaic.grid.window_extent(request.window)
        mosaic = self._session.mosaic_layer()
        if mosaic is None:
            return None
        settings = self._canvas.mapSettings()
        seen = transformed_box(settings.visibleExtent(), settings.destinationCrs(), mosaic.crs())
        return box_extent(seen) if seen is not None else None
