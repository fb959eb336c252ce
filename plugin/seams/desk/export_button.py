"""The button of a chart that saves and copies it, as a picture or as a table."""
from __future__ import annotations

from collections.abc import Callable, Iterable
from pathlib import Path

from qgis.core import Qgis, QgsApplication
from qgis.PyQt.QtCore import pyqtSignal
from qgis.PyQt.QtWidgets import QFileDialog, QMenu, QToolButton, QWidget

from ...toolkit.translation import filled


class ExportButton(QToolButton):
    """Opens a menu of formats; those who make it say what is written."""

    told = pyqtSignal(str, int)  # sentence, Qgis.MessageLevel as int

    def __init__(self, tip: str, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._folder = Path.home()
        self.setIcon(QgsApplication.getThemeIcon("/mActionSharingExport.svg"))
        self.setToolTip(tip)
        self.setPopupMode(QToolButton.ToolButtonPopupMode.InstantPopup)
        self.setAutoRaise(True)
        self.setEnabled(False)

    def _offer_formats(self, formats: Iterable[tuple[str, str, str, Callable[[], None]]]) -> None:
        """Icon, words, tooltip and slot of each."""
        menu = QMenu(self)
        menu.setToolTipsVisible(True)
        for icon, text, tip, slot in formats:
            action = menu.addAction(QgsApplication.getThemeIcon(f"/{icon}.svg"), text)
            action.setToolTip(tip)
            action.triggered.connect(slot)
        self.setMenu(menu)

    def _ask(self, title: str, name: str, ending: str, kind: str) -> Path | None:
        """Where to save; None where the user thought better of it. The folder is suggested again the next time."""
        suggested = self._folder / f"{name}.{ending}"
        chosen, _ = QFileDialog.getSaveFileName(self, title, str(suggested), f"{kind} (*.{ending})")
        if not chosen:
            return None
        path = Path(chosen) if chosen.lower().endswith(f".{ending}") else Path(f"{chosen}.{ending}")
        self._folder = path.parent
        return path

    def _write(self, write: Callable[[Path], None], path: Path, saved: str, not_saved: str) -> None:
        """Save, and tell it: ``saved`` has a place for the path, ``not_saved`` for the error, too."""
        try:
            write(path)
        except OSError as error:
            said, level = filled(not_saved, path=path, error=error.strerror or error), Qgis.MessageLevel.Warning
        else:
            said, level = filled(saved, path=path), Qgis.MessageLevel.Success
        self.told.emit(said, int(level))
