"""Whether the keyboard is free for single keys that mean something in the desk."""
from __future__ import annotations

from qgis.PyQt.QtWidgets import QAbstractSpinBox, QApplication, QComboBox, QLineEdit, QPlainTextEdit, QTextEdit

_TEXT_FIELDS = (QLineEdit, QTextEdit, QPlainTextEdit, QAbstractSpinBox)


def is_keyboard_free() -> bool:
    """Whether nobody is typing, and no menu or dialog waits for an answer."""
    if QApplication.activeModalWidget() is not None or QApplication.activePopupWidget() is not None:
        return False
    focus = QApplication.focusWidget()
    if focus is None:
        return True
    typing = isinstance(focus, _TEXT_FIELDS) or focus.inherits("QsciScintilla")
    return not typing and not (isinstance(focus, QComboBox) and focus.isEditable())
