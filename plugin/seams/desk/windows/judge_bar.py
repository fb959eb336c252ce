"""Says what was found in the selected window, takes the operator's judgement, and goes on to the next one."""
from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING

from qgis.core import QgsApplication
from qgis.PyQt.QtCore import QEvent, QSize, Qt, pyqtSignal
from qgis.PyQt.QtGui import QKeySequence, QResizeEvent
from qgis.PyQt.QtWidgets import QAction, QBoxLayout, QHBoxLayout, QLabel, QPushButton, QToolButton, QWidget

from ....toolkit.desk.clipped_label import ClippedLabel
from ....toolkit.desk.tooltips import rich_tip
from ....toolkit.translation import tr
from ...window_summary import window_sentence
from .verdict_chips import verdict_chip, window_tip, windows_sentence

if TYPE_CHECKING:
    from ...measure.window_records import WindowRecord
    from ..session import Session

_SENTENCE_LINES = 3
_SENTENCE_CHARACTERS = 50  # room for these beside the buttons puts the sentence there, else it goes above them


class JudgeBar(QWidget):
    """Sentence, judgement, position. ``order`` gives the windows as the operator sees them, by default the layer's."""

    stepped = pyqtSignal(int)
    """Feature id of the window that the operator went on to."""

    def __init__(
        self, session: Session, parent: QWidget | None = None, order: Callable[[], Sequence[int]] | None = None
    ) -> None:
        super().__init__(parent)
        self._session = session
        self._order = order
        self._fids: list[int] = []
        self._place = -1
        self._last_place = -1
        self._asked = 0

        self._chip = QLabel(self)
        self._sentence = ClippedLabel(_SENTENCE_LINES, self)
        self._visible = self._push_button(
            tr("Visible (V)"), "mActionShowAllLayers", self._toggle_visible,
            tr("The loss of detail can be seen at 2x magnification. Click again to take it back."),
        )
        self._invisible = self._push_button(
            tr("Invisible (I)"), "mActionHideAllLayers", self._toggle_invisible,
            tr("The loss of detail can't be seen at 2x magnification. Click again to take it back."),
        )
        self._visible.setCheckable(True)
        self._invisible.setCheckable(True)
        self._next = self._push_button(
            tr("Next (N)"), "", self.select_next, tr("Selects the next compared window that is not judged yet.")
        )
        self._back = self._arrow(Qt.ArrowType.LeftArrow, self.step_back, tr("Selects the window before this one."))
        self._position = QLabel(self)
        self._position.setAlignment(Qt.AlignmentFlag.AlignCenter)
        self._forth = self._arrow(Qt.ArrowType.RightArrow, self.step_forth, tr("Selects the window after this one."))
        self._actions = [
            self._action(tr("Judge visible"), Qt.Key.Key_V, self.judge_visible),
            self._action(tr("Judge invisible"), Qt.Key.Key_I, self.judge_invisible),
            self._action(tr("Next window to judge"), Qt.Key.Key_N, self.select_next),
        ]
        self.addActions(self._actions)
        self._lay_out()
        session.windowsChanged.connect(self.refresh)
        session.selectionChanged.connect(self.refresh)
        session.progressChanged.connect(self._follow_progress)
        self.refresh()

    def actions_for_dock(self) -> list[QAction]:
        """The keys V, I and N, to be added to every widget in which they shall work; text fields keep their letters.

        The keys set a judgement and never take it back, so that pressing one twice does no harm.
        """
        return list(self._actions)

    def sentence(self) -> str:
        """What is said about the selected windows."""
        return self._sentence.text()

    def refresh(self) -> None:
        """Show the selected windows' state, and where they stand among the others."""
        windows = {row.fid: row for row in self._session.windows()}
        selected = [windows[fid] for fid in self._session.selected() if fid in windows]
        shown = self._order() if self._order is not None else windows
        self._fids = [fid for fid in shown if fid in windows]
        self._find_place(selected)
        self._say(selected, bool(windows))
        for button, word in ((self._visible, "visible"), (self._invisible, "invisible")):
            button.setEnabled(bool(selected))
            button.setChecked(bool(selected) and all(row.observer == word for row in selected))
        compared = [row for row in windows.values() if row.is_compared]
        judged = sum(bool(row.observer) for row in compared)
        tip = tr("{judged} of {count} compared windows are judged.").format(judged=judged, count=len(compared))
        self._position.setToolTip(rich_tip(tip))
        self._back.setEnabled(self._neighbour(-1) is not None)
        self._forth.setEnabled(self._neighbour(1) is not None)
        following = self._next_fid(windows) is not None
        self._next.setEnabled(following)
        for action, enabled in zip(self._actions, (bool(selected), bool(selected), following)):
            action.setEnabled(enabled)

    # What the operator asks for

    def judge_visible(self) -> None:
        """Of the selected windows."""
        self._judge("visible")

    def judge_invisible(self) -> None:
        """Of the selected windows."""
        self._judge("invisible")

    def select_next(self) -> None:
        """The next compared window without the observer's word; after the last one the first."""
        self._go_to(self._next_fid({row.fid: row for row in self._session.windows()}))

    def step_back(self) -> None:
        """To the window before this one."""
        self._step(-1)

    def step_forth(self) -> None:
        """To the window after this one."""
        self._step(1)

    def _follow_progress(self, _done: int, asked: int) -> None:
        """Windows are being inspected that were not before, or none any more."""
        if asked != self._asked:
            self._asked = asked
            self.refresh()

    def _toggle_visible(self, checked: bool) -> None:
        self._judge("visible" if checked else "")

    def _toggle_invisible(self, checked: bool) -> None:
        self._judge("invisible" if checked else "")

    def _judge(self, observer: str) -> None:
        fids = self._session.selected()
        if fids:
            self._session.judge(fids, observer)
        self.refresh()  # the buttons show what was written, also when nothing could be

    def _step(self, by: int) -> None:
        self._go_to(self._neighbour(by))

    def _go_to(self, fid: int | None) -> None:
        row = None if fid is None else self._session.row(fid)
        if row is not None:
            self._session.select([row.fid])
            self._find_place([row])  # the next key may come before the selection is told
            self.stepped.emit(row.fid)

    # Where the selected window stands

    def _find_place(self, selected: Sequence[WindowRecord]) -> None:
        places = {fid: place for place, fid in enumerate(self._fids)}
        found = [places[row.fid] for row in selected if row.fid in places]
        self._place = max(found, default=-1)
        if self._place >= 0:
            self._last_place = self._place

    def _neighbour(self, by: int) -> int | None:
        """The window before or after. One that the filter took away once it was judged still has its place."""
        if self._place >= 0:
            place = self._place + by
        else:
            place = max(self._last_place, 0) + min(by, 0) if self._last_place >= 0 else 0
        return self._fids[place] if 0 <= place < len(self._fids) else None

    def _next_fid(self, windows: dict[int, WindowRecord]) -> int | None:
        start = self._place + 1 if self._place >= 0 else max(self._last_place, 0)
        current = self._fids[self._place] if self._place >= 0 else None
        for fid in [*self._fids[start:], *self._fids[:start]]:
            row = windows.get(fid)
            if row is not None and fid != current and row.is_compared and not row.observer:
                return fid
        return None

    def _say(self, selected: Sequence[WindowRecord], any_windows: bool) -> None:
        tip = ""
        if len(selected) == 1:
            row = selected[0]
            if self._session.is_pending(row.fid):
                sentence = tr("Measuring ...")
            else:
                result = self._session.result(row.fid)
                sentence, tip = window_sentence(row, result), window_tip(row, result)
            side = self.fontMetrics().ascent()
            self._chip.setPixmap(verdict_chip(row.verdict, row.stale).pixmap(side, side))
        elif selected:
            sentence = windows_sentence(selected)
        else:
            sentence = tr("Select a window to judge it.") if any_windows else ""
        self._chip.setVisible(len(selected) == 1)
        self._sentence.setText(sentence, tip)
        place = str(self._place + 1) if len(selected) == 1 and self._place >= 0 else "-"
        count = len(self._fids)
        self._position.setText(tr("{place} of {count}").format(place=place, count=count) if count else "")
        widest = tr("{place} of {count}").format(place=count, count=count)
        self._position.setMinimumWidth(self.fontMetrics().horizontalAdvance(widest))  # the arrows stay where they are

    # Widgets

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self._arrange()

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() == QEvent.Type.FontChange:
            self._arrange()

    def minimumSizeHint(self) -> QSize:
        """As narrow as the buttons that judge; the arrows go below them then."""
        margins = self.contentsMargins()
        width = self._judging.minimumSize().width() + margins.left() + margins.right()
        return QSize(width, super().minimumSizeHint().height())

    def _arrange(self) -> None:
        """The sentence beside the buttons where there is room, else above; the arrows below where there is little."""
        buttons = self._judging.sizeHint().width() + self._moving.sizeHint().width() + self._buttons.spacing()
        sentence = _SENTENCE_CHARACTERS * self.fontMetrics().averageCharWidth()
        beside, below = QBoxLayout.Direction.LeftToRight, QBoxLayout.Direction.TopToBottom
        self._rows.setDirection(beside if self.width() >= buttons + sentence else below)
        self._buttons.setDirection(beside if self.width() >= buttons else below)

    def _lay_out(self) -> None:
        words = QHBoxLayout()
        words.addWidget(self._chip)
        words.addWidget(self._sentence, 1)
        self._judging, self._moving = QHBoxLayout(), QHBoxLayout()
        for button in (self._visible, self._invisible, self._next):
            self._judging.addWidget(button)
        self._judging.addStretch(1)
        self._moving.addStretch(1)
        for widget in (self._back, self._position, self._forth):
            self._moving.addWidget(widget)
        self._buttons = QBoxLayout(QBoxLayout.Direction.LeftToRight)
        self._buttons.addLayout(self._judging, 1)
        self._buttons.addLayout(self._moving)
        self._rows = QBoxLayout(QBoxLayout.Direction.TopToBottom, self)
        self._rows.setContentsMargins(0, 0, 0, 0)
        self._rows.addLayout(words, 1)
        self._rows.addLayout(self._buttons)

    def _push_button(self, text: str, icon: str, slot: Callable[..., None], tip: str) -> QPushButton:
        button = QPushButton(text, self)
        if icon:
            button.setIcon(QgsApplication.getThemeIcon(f"/{icon}.svg"))
        button.setToolTip(rich_tip(tip))
        button.setFocusPolicy(Qt.FocusPolicy.TabFocus)  # a click leaves the focus, and Space, where they are
        button.setAutoDefault(False)
        button.clicked.connect(slot)
        return button

    def _arrow(self, direction: Qt.ArrowType, slot: Callable[..., None], tip: str) -> QToolButton:
        button = QToolButton(self)
        button.setArrowType(direction)
        button.setAutoRaise(True)
        button.setAutoRepeat(True)
        button.setToolTip(rich_tip(tip))
        button.setAccessibleName(tip)
        button.setFocusPolicy(Qt.FocusPolicy.TabFocus)
        button.clicked.connect(slot)
        return button

    def _action(self, text: str, key: Qt.Key, slot: Callable[..., None]) -> QAction:
        action = QAction(text, self)
        action.setShortcut(QKeySequence(key))
        action.setShortcutContext(Qt.ShortcutContext.WidgetWithChildrenShortcut)
        action.setAutoRepeat(False)
        action.triggered.connect(slot)
        return action
