"""The hard cut in place of the mosaic, on the map itself: as long as a key is held, or from one tap to the next."""
from __future__ import annotations

from typing import TYPE_CHECKING

from qgis.core import QgsProject, QgsRasterLayer
from qgis.gui import QgsMapCanvas
from qgis.PyQt import sip
from qgis.PyQt.QtCore import QObject, Qt, pyqtSignal
from qgis.PyQt.QtWidgets import QLabel

from ....imagery.errors import Message
from ....toolkit.connections import Connections
from ....toolkit.desk.message_bar import bar_level
from ....toolkit.desk.widgets import single_shot
from ....toolkit.project_settings import unmodified
from ....toolkit.translation import sentence, tr
from .compared_layer import Compared, ComparedLayer, looks_alike

if TYPE_CHECKING:
    from ..session import Session

_HELD_S = 0.3  # a key that is let go of sooner was tapped
_REST_MS = 400  # on a window, before its hard cut is made ready: those that are passed by are not waited for
_LABEL = "color: white; background: rgba(20, 20, 20, 220); border-radius: 4px; padding: 3px 6px;"


class Flicker(QObject):
    """Puts a layer of the hard cut above the map's rasters. QGIS keeps both drawn, so that one follows the other at
    once; once it was asked for, that of each window that is gone to lies ready."""

    notified = pyqtSignal(str, int)  # a sentence for the user, and its level in the message bar
    shown = pyqtSignal(bool)  # whether the map shows it from now on

    def __init__(self, canvas: QgsMapCanvas, session: Session, parent: QObject) -> None:
        super().__init__(parent)
        self._canvas, self._session = canvas, session
        self.is_shown = False  # whether it is to be seen, be it still being cut
        self._was_asked = False
        self.hard_cut = ComparedLayer(self)
        self.hard_cut.failed.connect(self._tell)
        self._on_map: QgsRasterLayer | None = None
        self._label = QLabel(canvas)
        self._label.setStyleSheet(_LABEL)
        self._label.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents)
        self._label.hide()
        self._preparer = single_shot(self, self._prepare, _REST_MS)
        self._placer = single_shot(self, self._place)  # never while QGIS takes layers off its map
        self._connections = Connections(
            (session.selectionChanged, self.hide), (session.inputsChanged, self._renew),
            (self.hard_cut.changed, self._place), (canvas.layersChanged, self._placer.start),
        )  # fmt: skip

    def close(self) -> None:
        """Leave nothing on the map."""
        self._preparer.stop()
        self._show(False)
        self._connections.close()
        self._placer.stop()
        self.hard_cut.close()
        if not sip.isdeleted(self._label):
            self._label.deleteLater()

    def press(self) -> bool:
        """Show it, or take it off where it stayed. Whether there is a window whose hard cut can be shown."""
        self._show(not self.is_shown)
        return self._prepare() if self.is_shown else True

    def release(self, seconds: float) -> None:
        """It stays where the key was but tapped."""
        if seconds >= _HELD_S:
            self._show(False)

    def hide(self, *_: object) -> None:
        """What is judged is the mosaic: another window begins with it."""
        self._show(False)
        if self._was_asked:
            self._preparer.start()

    def _renew(self) -> None:
        """There may be another mosaic, or none any more, as in a new project."""
        if self._was_asked:
            self._prepare()

    def _prepare(self) -> bool:
        selected = self._session.selected()
        request = self._session.request(selected[0]) if len(selected) == 1 else None
        self._was_asked = request is not None and request.window is not None and bool(request.sources)
        if not self._was_asked:
            self._show(False)
        self.hard_cut.ask(Compared(request) if request is not None and self._was_asked else None)
        return self._was_asked

    def _show(self, is_shown: bool) -> None:
        if is_shown != self.is_shown:
            self.is_shown = is_shown
            self._place()
            self.shown.emit(is_shown)

    def _place(self) -> None:
        """On the map where it belongs: QGIS sets the map's layers anew when one of them is made visible."""
        if sip.isdeleted(self._canvas):
            return
        cut, mosaic, now = self.hard_cut.layer, self._session.mosaic_layer(), self._canvas.layers()
        layers = [layer for layer in now if layer is not self._on_map]
        self._on_map = cut if self.is_shown else None
        if cut is not None and mosaic is not None and self.is_shown:
            place = next((i for i, layer in enumerate(layers) if isinstance(layer, QgsRasterLayer)), len(layers))
            layers.insert(place, cut)
            if cut not in now:
                looks_alike(cut, mosaic)
        if layers != now:
            with unmodified(QgsProject.instance()):
                self._canvas.setLayers(layers)
        self._label.setText(tr("hard cut of the sources") if cut is not None else tr("hard cut: reading ..."))
        self._label.adjustSize()
        gap = self._label.height() // 3
        self._label.move(gap, self._canvas.height() - self._label.height() - gap)
        self._label.setVisible(self.is_shown)

    def _tell(self, message: Message) -> None:
        was_asked = self.is_shown
        self._show(False)
        self.hard_cut.close()  # the next tap may have more luck
        if was_asked:
            self.notified.emit(sentence(message), bar_level(message))
