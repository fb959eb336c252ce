"""How windows are judged, and where one was, remembered in the project."""
from __future__ import annotations

import json
from dataclasses import asdict, dataclass, fields

from qgis.core import QgsProject

_SCOPE, _KEY = "SeamInspector", "judging"


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
    text, known = project.readEntry(_SCOPE, _KEY)
    try:
        stored = json.loads(text) if known and text else {}
    except ValueError:
        stored = {}
    if not isinstance(stored, dict):
        return JudgingSettings()
    values = {
        one.name: stored[one.name] for one in fields(JudgingSettings) if type(stored.get(one.name)) is type(one.default)
    }
    return JudgingSettings(**values)


def save_judging(project: QgsProject, settings: JudgingSettings) -> None:
    """Write them into the project, which is saved by its user."""
    text = json.dumps(asdict(settings))
    if project.readEntry(_SCOPE, _KEY)[0] != text:
        project.writeEntry(_SCOPE, _KEY, text)
