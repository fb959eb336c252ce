"""The places of the plugin's own files, and its help in the system's browser."""
from __future__ import annotations

from contextlib import suppress
from functools import cache
from pathlib import Path

from qgis.PyQt.QtCore import QUrl
from qgis.PyQt.QtGui import QDesktopServices

_PLUGIN = Path(__file__).parents[2]
_RESOURCES = _PLUGIN / "resources"


@cache
def plugin_commit() -> str:
    """The commit that the plugin was made of, as its package has it, or that a checkout is at; empty for neither.

    Nothing is run for it: git's own files are read.
    """
    git = _PLUGIN / ".git"
    head = _lines(_PLUGIN / "COMMIT") or _lines(git / "HEAD")
    if not head or not head[0].startswith(_REFERENCE):
        return head[0] if head else ""
    name = head[0][len(_REFERENCE) :]
    packed = (line.split()[0] for line in _lines(git / "packed-refs") if line.endswith(f" {name}"))
    return next(iter([*_lines(git / name), *packed]), "")


_REFERENCE = "ref: "


def _lines(path: Path) -> list[str]:
    """Lines of a text file; none where there is no such file."""
    with suppress(OSError, UnicodeError):
        return path.read_text(encoding="utf-8").splitlines()
    return []


def icon_path(name: str = "seam_inspector") -> str:
    return str(_RESOURCES / "icons" / f"{name}.svg")


def style_path(name: str) -> str:
    return str(_RESOURCES / "styles" / f"{name}.qml")


def reports_path() -> str:
    return str(_RESOURCES / "reports")


def model_paths() -> list[str]:
    return [str(path) for path in sorted((_RESOURCES / "models").glob("*.model3"))]


def help_url(page: str) -> str:
    """The address of a page of the help that comes with the plugin, for a browser without internet."""
    return (_RESOURCES / "help" / f"{page}.html").as_uri()


def translations_path() -> str:
    return str(_PLUGIN / "i18n")


FIRST_PAGE = "first_inspection"  # the page for somebody new


def show_first_page() -> None:
    """Open the page on a first inspection, which leads to all other pages."""
    QDesktopServices.openUrl(QUrl(help_url(FIRST_PAGE)))
