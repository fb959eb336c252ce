"""How windows are judged, and where one was, remembered in the project."""
from __future__ import annotations

from dataclasses import asdict, dataclass, fields

from qgis.core import QgsProject

from ....toolkit.project_settings import load_settings, save_settings

_KEY = "judging"


@dataclass(frozen=True)
class JudgingSettings:
    """Plain values, as the project keeps them."""

    operator: int = 1
    """1 or 2: who judges."""
    is_blind: bool = False
    """Whether the tool's verdict, and the other operator's, is hidden."""
    order: str = "table"
    """Name of the order of the windows."""
    search: str = ""
    """What the table is filtered by."""
    shown: str = ""
    """Name of the kind of windows that the table shows; empty: all."""
    window: int = 0
    """Number of the window that was looked at last; 0: none."""


def load_judging(project: QgsProject) -> JudgingSettings:
    """The project's; the defaults where it has none, or they are another kind of thing."""
    stored = load_settings(project, _KEY)
    values = {
        one.name: stored[one.name] for one in fields(JudgingSettings) if type(stored.get(one.name)) is type(one.default)
    }
    return JudgingSettings(**values)


def save_judging(project: QgsProject, settings: JudgingSettings) -> None:
    """Write them into the project, which is saved by its user."""
    save_settings(project, _KEY, asdict(settings))
