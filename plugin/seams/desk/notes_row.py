"""What an operator says of a window beside the judgement: how sure, and a remark."""
from __future__ import annotations

from typing import TYPE_CHECKING

from qgis.core import QgsApplication
from qgis.PyQt.QtCore import Qt
from qgis.PyQt.QtGui import QKeyEvent
from qgis.PyQt.QtWidgets import QHBoxLayout, QLabel, QLineEdit, QSpinBox, QToolButton, QWidget

from ...toolkit.desk.widgets import rich_tip
from ...toolkit.translation import filled, tr
from .judging import Judging

if TYPE_CHECKING:
    from .session import Session

_UNSAID = -1  # the spin box's value where no confidence was given
_LONGEST = 254  # letters of a remark, as many as a shapefile holds


class RemarkEdit(QLineEdit):
    """Escape leaves it as it was."""

    def keyPressEvent(self, event: QKeyEvent) -> None:
        if event.key() == Qt.Key.Key_Escape:
            self.undo()
            self.setModified(False)
            self.clearFocus()
        else:
            super().keyPressEvent(event)


class NotesRow(QWidget):
    """A line for the remark below the buttons, shown when it is asked for or there is a remark already."""

    def __init__(self, session: Session, judging: Judging, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._session = session
        self._judging = judging
        self._before: QWidget | None = None  # had the focus
        self.confidence = QSpinBox(parent)
        self.confidence.setRange(_UNSAID, 100)
        self.confidence.setSingleStep(10)
        self.confidence.setSuffix(" %")
        self.confidence.setSpecialValueText("- %")
        self.confidence.setKeyboardTracking(False)
        self.confidence.setFocusPolicy(Qt.FocusPolicy.ClickFocus)
        tip = tr("How sure you are, 0 to 100 %: the keys 1 to 9 set 10 to 90 %, 0 sets 100 %. It can be left out.")
        self.confidence.setToolTip(rich_tip(tip))
        self.confidence.valueChanged.connect(self._write_confidence)
        self.confidence.editingFinished.connect(self._leave)
        self.opener = QToolButton(parent)
        self.opener.setIcon(QgsApplication.getThemeIcon("/mActionAnnotation.svg"))
        self.opener.setAutoRaise(True)
        self.opener.setCheckable(True)
        self.opener.setToolTip(rich_tip(tr("A remark on the window (R); Enter saves it, Esc discards the change.")))
        self.opener.setFocusPolicy(Qt.FocusPolicy.TabFocus)
        self.opener.clicked.connect(self._toggle)
        self.buttons = (self.confidence, self.opener)  # what stands in the row of the judge bar
        self._edit = RemarkEdit(self)
        self._edit.setMaxLength(_LONGEST)
        self._edit.setPlaceholderText(tr("remark"))
        self._edit.setToolTip(self.opener.toolTip())
        self._edit.editingFinished.connect(self._write_remark)
        layout = QHBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        self._label = QLabel(self)
        layout.addWidget(self._label)
        layout.addWidget(self._edit, 1)

    def refresh(self) -> None:
        """Show what is said of the selected windows, where it is the same of all."""
        operator, chosen = self._judging.operator, self._session.selected()
        rows = [row for row in map(self._session.row, chosen) if row is not None]
        sure = {getattr(row, operator.confidence) for row in rows}
        value = next(iter(sure)) if len(sure) == 1 else None
        self.confidence.blockSignals(True)
        self.confidence.setValue(_UNSAID if value is None else value)
        self.confidence.blockSignals(False)
        for widget in self.buttons:
            widget.setEnabled(bool(rows))
        if self._edit.hasFocus():
            return  # the operator is writing
        remarks = {getattr(row, operator.remark) for row in rows}
        remark = next(iter(remarks)) if len(remarks) == 1 else ""
        self._edit.setText(remark)
        of_one = tr("Remark on window {number}:")  # a verdict may have led on from the one that is meant
        self._label.setText(filled(of_one, number=rows[0].window_id) if len(rows) == 1 else tr("Remark:"))
        self._show(bool(remark))

    def begin_remark(self) -> bool:
        """Let the operator write a remark on the selected windows."""
        if not self._session.selected():
            return False
        self._before = self.window().focusWidget()
        self._show(True)
        self._edit.setFocus()
        self._edit.selectAll()
        return True

    def _toggle(self, shown: bool) -> None:
        if not shown or not self.begin_remark():
            self._leave()

    def _show(self, shown: bool) -> None:
        self.setVisible(shown)
        self.opener.setChecked(shown)

    def _write_confidence(self, value: int) -> None:
        self._judging.note(confidence=None if value == _UNSAID else value)

    def _write_remark(self) -> None:
        if self._edit.isModified():
            self._edit.setModified(False)
            self._judging.note(remark=self._edit.text().strip() or None)
        self._leave()

    def _leave(self) -> None:
        """The keys that judge are free again."""
        for widget in (self.confidence, self._edit):
            if widget.hasFocus():
                widget.clearFocus()
        if self._before is not None:
            self._before.setFocus()
            self._before = None
        self.refresh()
