"""Stand-in for ``qgis.PyQt.QtWidgets`` of QGIS 4, which brings back three classes that moved (not QUndoStack)."""
from PyQt6.QtGui import QAction as QAction
from PyQt6.QtGui import QActionGroup as QActionGroup
from PyQt6.QtGui import QShortcut as QShortcut
from PyQt6.QtWidgets import *  # noqa: F403
