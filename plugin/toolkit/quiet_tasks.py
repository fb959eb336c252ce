"""QGIS covers the map with a notice when a task ends that took more than 5 s. Ours tell in the desk what they found."""
from __future__ import annotations

from qgis.core import QgsApplication, QgsSettings

from .version_differences import SILENT_TASK

_SETTING, _SECTION = "minTaskLengthForSystemNotification", QgsSettings.Section.App
_NEVER_S = 10**9


def hush_end() -> None:
    """For a task's ``finished``: QGIS, which hears of its end right after, says nothing. Later ones have a flag for it.

    No task is long enough for a notice until then; at once the user's setting holds again.
    """
    settings = QgsSettings()
    before = settings.value(_SETTING, None, section=_SECTION)
    if SILENT_TASK is not None or before == _NEVER_S:
        return
    heard = QgsApplication.taskManager().statusChanged

    def restore(_task: int, _status: int) -> None:
        heard.disconnect(restore)
        if before is None:
            settings.remove(_SETTING, _SECTION)
        else:
            settings.setValue(_SETTING, before, _SECTION)

    settings.setValue(_SETTING, _NEVER_S, _SECTION)
    heard.connect(restore)
