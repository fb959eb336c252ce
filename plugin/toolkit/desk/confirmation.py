"""Asks before something is done to many things at once."""
from __future__ import annotations

from qgis.PyQt.QtWidgets import QMessageBox, QWidget

from ..translation import tr


def is_confirmed(widget: QWidget, question: str) -> bool:
    """Whether the user says yes; no is what Enter says."""
    yes, no = QMessageBox.StandardButton.Yes, QMessageBox.StandardButton.No
    return bool(QMessageBox.question(widget, tr("Seam Inspector"), question, yes | no, no) == yes)
