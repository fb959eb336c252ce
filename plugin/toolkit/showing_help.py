"""The help that comes with the plugin, in the system's browser."""
from __future__ import annotations

from qgis.PyQt.QtCore import QUrl
from qgis.PyQt.QtGui import QDesktopServices

from .resources import help_url

FIRST_PAGE = "first_inspection"
"""Where somebody new begins."""


def show_first_page() -> None:
    """How a first inspection goes; the way to all other pages."""
    QDesktopServices.openUrl(QUrl(help_url(FIRST_PAGE)))
