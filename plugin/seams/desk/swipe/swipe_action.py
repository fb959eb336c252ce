"""The dock's button that begins and ends a swipe, and its menu of what the mosaic is compared with."""
from __future__ import annotations

from typing import TYPE_CHECKING

from qgis.core import QgsProject
from qgis.gui import QgsMapCanvas
from qgis.PyQt.QtCore import QObject, pyqtSignal
from qgis.PyQt.QtGui import QIcon
from qgis.PyQt.QtWidgets import QAction, QActionGroup, QMenu, QWidget

from ....imagery.errors import Message
from ....imagery.grids import Extent, extents_meet
from ....toolkit.desk.message_bar import bar_level
from ....toolkit.desk.widgets import allow, plain_tip
from ....toolkit.layers import box_extent, transformed_box
from ....toolkit.resources import icon_path
from ....toolkit.translation import filled, sentence, tr
from ...measure import messages
from ...measure.inspection import Block
from ...measure.window.window_request import WindowRequest
from .swipe import Swipe
from .swiped_layer import SwipeChoice, source_layers

if TYPE_CHECKING:
    from ..session import Session


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
            tr("Compare the mosaic with a source on the map: drag the handle, X exchanges the sides, Esc ends")
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

    def choices(self) -> list[SwipeChoice]:
        """The sources over the selected window, those that cover most of it first; without one, those on the map."""
        block = self._session.block()
        if block is None:
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
            found.sort(key=lambda source: -_shared(source.extent, place))
        choices = [SwipeChoice(source.ref.name, source.ref) for source in found]
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
        self._compare(choice)

    def _compare(self, choice: SwipeChoice) -> None:
        mosaic, block = self._session.mosaic_layer(), self._session.block()
        if mosaic is None or block is None:
            return
        project = QgsProject.instance()
        sources = set(self._session.inputs.sources)
        sources |= source_layers(project, {source.ref.path for source in block.sources})
        self.swipe.start(mosaic, choice, sources - {mosaic.id()})

    def _toggle(self, is_wanted: bool) -> None:
        choices = self.choices() if is_wanted else []
        self._is_chosen = False
        if choices:
            self._compare(choices[0])
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
            self._compare(current if current is not None and current in choices else choices[0])
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
        flip = self.menu.addAction(tr("Exchange the sides (X)"), self.swipe.flip)
        flip.setEnabled(self.swipe.is_on)
        lying = self.menu.addAction(tr("Lying handle"))
        lying.setToolTip(tr("Compare above and below instead of left and right"))
        lying.setCheckable(True)
        lying.setChecked(not self.swipe.is_upright)
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


def _shared(first: Extent, second: Extent) -> float:
    """Area that two rectangles share."""
    width = min(first[2], second[2]) - max(first[0], second[0])
    height = min(first[3], second[3]) - max(first[1], second[1])
    return max(width, 0.0) * max(height, 0.0)
