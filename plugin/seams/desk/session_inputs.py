"""The inputs of a session: which mosaic and sources are inspected and how, and what lies under the mouse."""
from __future__ import annotations

from qgis.core import QgsProject, QgsRasterLayer
from qgis.PyQt.QtCore import QObject, pyqtSignal
from qgis.PyQt.QtGui import QIcon
from qgis.PyQt.QtWidgets import QAction

from ...imagery.errors import Message
from ...imagery.grids import Grid, PixelWindow
from ...toolkit.background_tasks import BackgroundTasks
from ...toolkit.desk.message_bar import bar_level
from ...toolkit.resources import icon_path
from ...toolkit.translation import sentence, tr
from ..jobs import ScanOrder
from ..measure.window.explained_window import LiveWindow
from ..measure.window.inspection import Block
from .inputs.block_cache import BlockCache
from .inputs.project_inputs import Inputs, InputsWatch, load_inputs, save_inputs
from .map.under_mouse import ClickedPiece, LiveWindows, SeamFinder


class SessionInputs(QObject):
    """Follows the project's layers. Everything that reads pixels runs in tasks."""

    inputsChanged = pyqtSignal()
    liveChanged = pyqtSignal()
    messageRaised = pyqtSignal(str, int)

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._project = project = QgsProject.instance()
        self.lost_detail = QAction(QIcon(icon_path("loss")), tr("Lost detail"), self)
        """Checked while lost detail is painted over the map and the images."""
        self.lost_detail.setToolTip(
            tr("Show where detail was lost, over the map and the images (L while judging). One scale for all windows")
        )
        self.lost_detail.setCheckable(True)
        self._opening = BackgroundTasks(self)  # apart, since another window layer does not matter to it
        self._block = block = BlockCache(project, self._opening, self)
        self._seams = SeamFinder(block, self._opening)
        self._live = LiveWindows(block, self)
        self._layers = InputsWatch(project, self)
        self.piece: ClickedPiece | None = None  # of a scanned seam, which is looked at; ``liveChanged`` tells
        for signal, slot in (
            (self._live.changed, self.liveChanged),
            (block.opened, self._follow_block),
            (self._layers.layersChanged, self._files_changed),
            *((notifier, self._tell) for notifier in (self._opening.failed, self._live.failed, block.notified)),
        ):  # fmt: skip
            signal.connect(slot)

    def close(self) -> None:
        """Stop all work, and let go of the layers; once is enough."""
        self._layers.close()
        for part in (self._live, self._opening):
            part.close()

    @property
    def inputs(self) -> Inputs:
        """What is inspected and how."""
        return self._block.inputs

    def set_inputs(self, inputs: Inputs) -> None:
        """Change the inputs and remember them in the project. Inspected windows become stale when they matter."""
        if self.inputs == inputs:
            self._block.inputs = inputs  # the same, but chosen by whoever sets them now
            return
        self._block.inputs = inputs
        save_inputs(self._project, inputs)
        self._layers_changed()

    def mosaic_grid(self) -> Grid | None:
        """The mosaic's pixel grid; None while there is no mosaic that windows can lie on, or it is being opened."""
        block = self.block()
        return block.mosaic.grid if block is not None else None

    @property
    def live(self) -> LiveWindow | None:
        """The window that is being drawn or moved, as far as it is known; ``liveChanged`` tells."""
        return self._live.current

    def block(self) -> Block | None:
        """The mosaic and its sources; None while there are none, or they are being opened."""
        return self._block.silent()

    def problem(self) -> Message | None:
        """Why there is no block; None when there is one."""
        return self._block.problem()

    def mosaic_layer(self) -> QgsRasterLayer | None:
        """The mosaic, while it is there."""
        return self._block.mosaic_layer()

    def scan_order(self) -> ScanOrder:
        """What a scan of the mosaic is made of. Raises SeamInspectorError when the inputs do not allow one."""
        return self._block.scan_order()

    def seam_point_near(self, x: float, y: float, reach: float) -> tuple[float, float] | None:
        """The nearest point of a seam within reach; None where there is none, or while they are being found."""
        return self._seams.index.nearest(x, y, reach)

    def hover(self, window: PixelWindow, is_live: bool) -> None:
        """The mouse is over this window; ``is_live``: its curves follow."""
        self._live.hover(window, is_live)

    def leave(self) -> None:
        """The mouse is over no window any more."""
        self._live.leave()

    def _tell(self, message: Message) -> None:
        self.messageRaised.emit(sentence(message), bar_level(message))

    # What the project tells

    def _load(self, *_: object) -> None:
        self.lost_detail.setChecked(False)
        self._live.leave()
        self._live.let_go()
        self._opening.abandon()
        self._block.forget()
        self._seams.forget()
        self._block.inputs = load_inputs(self._project)
        self._layers_changed()

    def _layers_changed(self, *_: object) -> None:
        self._block.refresh()
        self._layers.follow(self.inputs)
        self._follow_block()

    def _follow_block(self) -> None:
        """There may be another block, or none any more."""
        self._seams.refresh()
        self.inputsChanged.emit()

    def _files_changed(self) -> None:
        self._live.let_go()
        self._block.refresh(anew=True)
        self._seams.refresh(anew=True)
        self._follow_block()

    def _forget_layers(self, ids: list[str]) -> None:
        self._live.let_go()  # or their files could not be moved or deleted
        self._layers.leave(ids)
