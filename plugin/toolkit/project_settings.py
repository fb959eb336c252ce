"""Plain values that the plugin keeps in the project, by key."""
from __future__ import annotations

import json
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

from qgis.core import QgsProject

from ..imagery.documents import json_document

_SCOPE = "SeamInspector"


def load_settings(project: QgsProject, key: str) -> dict[str, Any]:
    """The values that the project keeps under a key; empty where it keeps none, or none that can be understood."""
    text, known = project.readEntry(_SCOPE, key)
    try:
        stored = json_document(text) if known and text else {}
    except ValueError:
        return {}
    return stored if isinstance(stored, dict) else {}


def save_settings(project: QgsProject, key: str, values: dict[str, Any]) -> None:
    """Write them into the project, which is saved by its user; the same again is no change."""
    text = json.dumps(values)
    if project.readEntry(_SCOPE, key)[0] != text:
        project.writeEntry(_SCOPE, key, text)


@contextmanager
def unmodified(project: QgsProject) -> Iterator[None]:
    """Keep what is written here from counting as a change: nobody is asked to save a project for that alone."""
    is_modified = project.isDirty()
    try:
        yield
    finally:
        if not is_modified:
            project.setDirty(False)
