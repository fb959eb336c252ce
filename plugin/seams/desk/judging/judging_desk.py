"""Puts judging together: the model, its bar and keys, the table that follows it, and what is hidden while blind."""
from __future__ import annotations

from functools import partial
from typing import TYPE_CHECKING

from qgis.core import QgsVectorLayer
from qgis.gui import QgsMapCanvas, QgsMapTool
from qgis.PyQt import sip
from qgis.PyQt.QtCore import QEvent, QObject, Qt
from qgis.PyQt.QtWidgets import QWidget

from ....toolkit.desk.widgets import is_confirmed
from ..map.shown_seamlines import toggle_seamlines
from ..windows.windows_panel import WindowsPanel
from .agreement_box import agreement_of, ask_for_disagreements
from .blind_style import hide_verdicts, show_verdicts
from .judge_bar import JudgeBar
from .judge_keys import JudgeKeys
from .judging import Judging

if TYPE_CHECKING:
    from ..session import Session

_NUMBER = "window_id"  # the one column that tells nothing


class JudgingDesk(QObject):
    """``model`` and ``bar`` are for the dock to use."""

    def __init__(
        self, session: Session, windows: WindowsPanel, canvas: QgsMapCanvas, main_window: QWidget, dock: QWidget
    ) -> None:
        super().__init__(dock)
        self._session = session
        self._windows = windows
        self._canvas = canvas
        self._dock = dock
        self._hidden: QgsVectorLayer | None = None  # the layer whose verdicts are hidden
        self.model = Judging(session, windows.ordered_fids, partial(is_confirmed, dock), self)
        self.bar = JudgeBar(session, self.model)
        self._keys = JudgeKeys(dock, main_window, self._is_editing)
        keys = self.bar.keys()
        keys[Qt.Key.Key_S] = partial(toggle_seamlines, session)
        self._keys.set_keys(keys, self.bar.REPEATING_KEYS)
        self.model.changed.connect(self._follow)
        self.bar.agreementAsked.connect(self.show_agreement)
        windows.orderChanged.connect(self.bar.refresh)
        windows.orderChosen.connect(self._choose_order)
        windows.filterChosen.connect(self._keep_filter)
        windows.judged.connect(self._judge)
        session.inputsChanged.connect(self._hide_on_map)
        session.loss_view.changed.connect(self._hide_loss)
        dock.installEventFilter(self)
        self._follow()

    def close(self) -> None:
        """Leave nothing behind."""
        self._dock.removeEventFilter(self)
        self._keys.close()
        self._show_on_map()
        self.model.close()
        self.bar.close()

    def show_agreement(self) -> None:
        """How well both operators agree, and where they do not when that is wanted."""
        if ask_for_disagreements(agreement_of(self._session.windows()), self._dock):
            self.model.change(order="operators")
            self._windows.set_filter("", "operators_differ")

    def eventFilter(self, _watched: QObject | None, event: QEvent | None) -> bool:
        """Keys judge while the desk is in sight."""
        if event is not None and event.type() in (QEvent.Type.Show, QEvent.Type.Hide):
            self._keys.listen(event.type() == QEvent.Type.Show)
        return False

    def _follow(self) -> None:
        """The operator, the order or what is hidden changed."""
        model, settings = self.model, self.model.settings
        self._windows.operator = model.operator
        own = frozenset((_NUMBER, *model.operator)) if model.is_blind else None
        self._windows.set_blind(own)
        self._windows.set_filter(settings.search, settings.shown)
        self._windows.show_order(model.order)
        self._hide_loss()
        self._hide_on_map()
        self.bar.refresh()

    def _choose_order(self, name: str) -> None:
        self.model.change(order=name)

    def _keep_filter(self) -> None:
        search, shown = self._windows.filter()
        self.model.change(search=search, shown=shown)

    def _judge(self, word: str) -> None:
        """From the table's menu."""
        if word:
            self.model.judge(word)
        else:
            self.model.take_back()

    def _is_editing(self) -> bool:
        """Whether a tool of QGIS is editing on the map: letters are its then."""
        tool = self._canvas.mapTool()
        return tool is not None and bool(tool.flags() & QgsMapTool.Flag.EditTool)

    # What the map tells

    def _hide_loss(self, *_: object) -> None:
        if self.model.is_blind:
            self._session.loss_view.show(False)

    def _hide_on_map(self) -> None:
        layer = self._session.window_layer()
        if self._hidden is not None and (layer is not self._hidden or not self.model.is_blind):
            self._show_on_map()
        if self.model.is_blind and layer is not None:
            self._hidden = layer
            hide_verdicts(layer, self.model.operator)
        elif layer is not None:
            show_verdicts(layer)  # a project that was saved blind

    def _show_on_map(self) -> None:
        layer, self._hidden = self._hidden, None
        if layer is not None and not sip.isdeleted(layer):
            show_verdicts(layer)
