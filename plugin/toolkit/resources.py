"""The places of the plugin's own files, and its help in the system's browser."""
from __future__ import annotations

from contextlib import suppress
from pathlib import Path

from qgis.PyQt.QtCore import QUrl
from qgis.PyQt.QtGui import QDesktopServices

_PLUGIN = Path(__file__).parents[2]
RESOURCES = _PLUGIN / "resources"
TRANSLATIONS = str(_PLUGIN / "i18n")


def plugin_commit() -> str:
    """The commit that the plugin's package was made of; empty for a checkout, which may be at any."""
    with suppress(FileNotFoundError):
        return (_PLUGIN / "COMMIT").read_text(encoding="utf-8").strip()
    return ""


def icon_path(name: str = "seam_inspector") -> str:
    return str(RESOURCES / "icons" / f"{name}.svg")


def style_path(name: str) -> str:
    return str(RESOURCES / "styles" / f"{name}.qml")


def help_url(page: str) -> str:
    """The address of a page of the help that comes with the plugin, for a browser without internet."""
    return (RESOURCES / "help" / f"{page}.html").as_uri()


FIRST_PAGE = "first_inspection"  # the page for somebody new


def show_first_page() -> None:
    """Open the page on a first inspection, which leads to all other pages."""
    QDesktopServices.openUrl(QUrl(help_url(FIRST_PAGE)))
