"""Says what was found in the selected window, takes the operator's judgement, and goes on to the next one."""
from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import partial
from html import escape
from operator import attrgetter
from typing import TYPE_CHECKING

from qgis.core import QgsApplication
from qgis.PyQt.QtCore import Qt
from qgis.PyQt.QtWidgets import (
    QComboBox,
    QHBoxLayout,
    QInputDialog,
    QLabel,
    QPushButton,
    QToolButton,
    QVBoxLayout,
    QWhatsThis,
    QWidget,
)

from ...imagery.statistics import INVISIBLE, UNSURE, VISIBLE
from ...toolkit.desk.widgets import ClippedLabel, rich_tip
from ...toolkit.translation import filled, tr
from ..window_summary import window_sentence, window_why
from .judging import Judging, JudgingProgress
from .windows.window_columns import verdict_chip, window_tip

if TYPE_CHECKING:
    from ..measure.window_records import WindowRecord
    from .map.window_tool import ClickedPieces
    from .session import Session


_LINES = 2, 8  # of the sentence
_LONGEST = 254  # letters of a remark, as many as a shapefile holds


class JudgeBar(QWidget):
    """Sentence, judgement, progress."""

    def __init__(self, session: Session, judging: Judging, pieces: ClickedPieces) -> None:
        """``pieces``: of the last scan's seams, of which a clicked one is told, and a window offered there."""
        super().__init__()
        self._session, self._judging = session, judging
        self._asked = 0
        self._chip = QLabel(self)
        self._sentence = ClippedLabel(_LINES[0], self, _LINES[1])
        self._why = QToolButton(self)
        self._why.setText(tr("Why?"))
        self._why.setAutoRaise(True)
        self._why.setFocusPolicy(Qt.FocusPolicy.TabFocus)
        self._why.setToolTip(rich_tip(tr("What the sentence is based on: intervals, what an eye sees, all causes with "
                                         "their figures, the paper's rule.")))
        self._why.clicked.connect(lambda *_: QWhatsThis.showText(  # stays until the next click
            self._why.mapToGlobal(self._why.rect().bottomLeft()), self.why(), self
        ))
        self._here = self._push_button(
            tr("Judge here"), "", pieces.judge,
            tr("Goes to the window on this piece of seam, or makes one, and inspects it."),
        )  # fmt: skip
        self._visible = self._judging_button(
            tr("Visible (V)"), "mActionShowAllLayers", VISIBLE,
            tr("The loss of detail can be seen at 2x magnification."),
        )  # fmt: skip
        self._invisible = self._judging_button(
            tr("Invisible (I)"), "mActionHideAllLayers", INVISIBLE,
            tr("The loss of detail can't be seen at 2x magnification."),
        )  # fmt: skip
        self._unsure = self._judging_button(
            tr("Not sure (U)"), "", UNSURE, tr("You can't tell. The window counts as not judged in all results.")
        )
        self._next = self._push_button(
            tr("Next (N)"), "", judging.go_on,
            tr("Goes on without judging: to the next compared window that is not judged yet, or the next one (N)."),
        )  # fmt: skip
        self.remark, self.operators = self._remark_button(), self._choice()
        self._progress = ClippedLabel(1, self)
        self._lay_out()
        session.windowsChanged.connect(self.refresh)
        session.selectionChanged.connect(self.refresh)
        session.progressChanged.connect(self._follow_progress)
        judging.changed.connect(self.refresh)
        pieces.changed.connect(self.refresh)
        self.refresh()

    def key_actions(self) -> dict[str, Callable[[], bool]]:
        """What each key does, by its name; it says by False that it has nothing to do.

        They set a judgement and never toggle it.
        """
        judging = self._judging
        return {
            **{word: partial(judging.judge, word) for word in (VISIBLE, INVISIBLE, UNSURE)},
            "next": judging.go_on,
            "before": partial(judging.step, -1),
            "take back": judging.take_back,
            "remark": lambda: self.ask_remark(judging.just_judged()),
            **{f"sure {percent}": partial(judging.say_sure, percent) for percent in range(10, 101, 10)},
        }

    def sentence(self) -> str:
        """What is said about the selected windows."""
        return self._sentence.text()

    def why(self) -> str:
        """What the sentence rests on, as rich text."""
        return self._sentence.toolTip()

    def refresh(self) -> None:
        """Show the selected windows' state, and where they stand among the others."""
        judging = self._judging
        self.operators.setCurrentIndex(2 * (judging.settings.operator == 2) + judging.is_blind)
        judging.follow()
        chosen = [row for row in map(self._session.row, self._session.selected()) if row is not None]
        selected, progress = sorted(chosen, key=attrgetter("window_id")), judging.progress()
        self._say(selected, progress)
        words = progress.words()
        if (sure := judging.just_sure) is not None:  # a digit that did not go to the selected window
            words = filled(tr("Window {number}: {percent} % sure"), number=sure[0], percent=sure[1])
        self._progress.setText(words, rich_tip(words, *filter(None, [progress.rest()])))
        remark = self._remark(selected)
        self.remark.setChecked(bool(remark))
        tip = tr("A remark on the window (R); Enter saves it, Esc discards the change.")
        self.remark.setToolTip(rich_tip(tip, *([escape(remark)] if remark else [])))
        self.remark.setEnabled(bool(selected))
        for button, word in ((self._visible, VISIBLE), (self._invisible, INVISIBLE), (self._unsure, UNSURE)):
            button.setEnabled(bool(selected))
            button.setChecked(bool(selected) and all(judging.word(row) == word for row in selected))
        self._next.setEnabled(judging.can_go_on())

    def _follow_progress(self, _done: int, asked: int) -> None:
        """Windows are being inspected that were not before, or none any more."""
        if asked != self._asked:
            self._asked = asked
            self.refresh()

    def _clicked(self, word: str, checked: bool) -> None:
        """A second click on the same button takes the word back."""
        if checked:
            self._judging.judge(word)
        else:
            self._judging.take_back()
        self.refresh()  # the buttons show what was written, also when nothing could be

    def _say(self, selected: Sequence[WindowRecord], progress: JudgingProgress) -> None:
        tip, shows_chip, piece = "", False, self._session.piece
        if selected and self._judging.is_blind:
            numbers = ", ".join(str(row.window_id) for row in selected[:9])
            sentence = filled(tr("Window {numbers}. Results are hidden."), numbers=numbers)
        elif len(selected) == 1:
            row, shows_chip = selected[0], True
            if self._session.is_pending(row.fid):
                sentence = tr("Measuring ...")
            else:
                result = self._session.result(row.fid)
                sentence, tip = window_sentence(row, result), window_tip(row, result) if window_why(row, result) else ""
            side = self.fontMetrics().ascent()
            self._chip.setPixmap(verdict_chip(row.verdict).pixmap(side, side))
        elif selected:
            sentence = filled(tr("{count} windows selected."), count=len(selected))
        elif piece is not None:
            grid = self._session.mosaic_grid()
            pixel_m = None if grid is None else grid.ground_sample_distance
            finding = window_sentence(piece.record, pixel_m=pixel_m)
            sentence = filled(tr("By the scan, this piece of seam: {finding}"), finding=finding)
        elif self._judging.is_walked():
            sentence = tr("No window at the worst places is left to judge.")
        elif progress.is_done:
            sentence = tr("No window is left to judge.")
        else:
            sentence = tr("Select a window to judge it.") if progress.count else ""
        self._chip.setVisible(shows_chip)
        self._why.setVisible(bool(tip))
        self._here.setVisible(piece is not None and not selected)
        self._sentence.setText(sentence, tip)

    # What an operator says of a window beside the judgement

    def _remark(self, selected: Sequence[WindowRecord]) -> str:
        """What the operator remarked, where it is the same of all."""
        remarks = {getattr(row, self._judging.operator.remark) for row in selected}
        return str(remarks.pop()) if len(remarks) == 1 else ""

    def ask_remark(self, judged: WindowRecord | None = None) -> bool:
        """Let the operator write a remark on the window just judged, or the selected ones. Whether there are any."""
        chosen = map(self._session.row, self._session.selected())
        rows = [row for row in chosen if row is not None] if judged is None else [judged]
        if rows:
            self.question = QInputDialog(self)
            self.question.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
            self.question.setWindowTitle(tr("Seam Inspector"))
            words = tr("Remark on window {number}:") if len(rows) == 1 else tr("Remark:")
            self.question.setLabelText(filled(words, number=rows[0].window_id))
            self.question.setTextValue(self._remark(rows))
            self.question.textValueSelected.connect(
                lambda text: self._judging.note(judged, remark=text.strip()[:_LONGEST] or None)
            )
            self.question.open()
        self.refresh()  # a click has checked the button
        return bool(rows)

    def _choose_operator(self, place: int) -> None:
        operator, is_blind = divmod(place, 2)
        self._judging.change(operator=operator + 1, is_blind=bool(is_blind))

    # Widgets

    def _remark_button(self) -> QToolButton:
        button = QToolButton(self)
        button.setIcon(QgsApplication.getThemeIcon("/mActionAnnotation.svg"))
        button.setAutoRaise(True)
        button.setCheckable(True)
        button.setFocusPolicy(Qt.FocusPolicy.TabFocus)
        button.clicked.connect(lambda *_: self.ask_remark())
        return button

    def _choice(self) -> QComboBox:
        """The choice who judges, and whether blind."""
        box, blind = QComboBox(self), tr(
            "Hides the tool's results and the other operator's verdicts in the table, in words, charts and on the map.")
        box.setToolTip(rich_tip(tr("Choose the operator, and judge blind.")))
        for word, tip in (
            (tr("1st"), tr("Verdicts go to the field 'observer'.")),
            (tr("2nd"), tr("Verdicts go to the field 'observer_2', beside the first operator's.")),
        ):
            for text, more in ((word, ""), (filled(tr("{operator}, blind"), operator=word), blind)):
                box.addItem(text)
                box.setItemData(box.count() - 1, f"{tip} {more}".rstrip(), Qt.ItemDataRole.ToolTipRole)
        box.activated.connect(self._choose_operator)
        return box

    def _lay_out(self) -> None:
        words = QHBoxLayout()
        words.addWidget(self._chip)
        words.addWidget(self._sentence, 1)
        words.addWidget(self._why)
        words.addWidget(self._here)
        judging, moving = QHBoxLayout(), QHBoxLayout()
        for button in (self._visible, self._invisible, self._unsure, self._next):
            judging.addWidget(button)
        judging.addStretch()
        moving.addWidget(self._progress, 1)
        for widget in (self.remark, self.operators):
            moving.addWidget(widget)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        for row in (words, judging, moving):
            layout.addLayout(row)

    def _judging_button(self, text: str, icon: str, word: str, tip: str) -> QPushButton:
        more = tr("Then goes to the next window. Click again to undo it.")
        seamlines = tr("The key S hides the seamlines and a scan's layers, and shows them again.")
        button = self._push_button(text, icon, partial(self._clicked, word), f"{tip} {more} {seamlines}")
        button.setCheckable(True)
        return button

    def _push_button(self, text: str, icon: str, slot: Callable[..., object], tip: str) -> QPushButton:
        button = QPushButton(text, self)
        if icon:
            button.setIcon(QgsApplication.getThemeIcon(f"/{icon}.svg"))
        button.setToolTip(rich_tip(tip))
        button.setFocusPolicy(Qt.FocusPolicy.TabFocus)  # a click leaves the focus, and Space, where they are
        button.setAutoDefault(False)
        button.clicked.connect(slot if isinstance(slot, partial) else lambda *_: slot())
        return button
