"""The results of a layer's windows, kept in a file beside the layer's own: curves, profiles, pictures of the loss."""
from __future__ import annotations

from functools import partial
from pathlib import Path

from qgis.PyQt.QtCore import QObject, pyqtSignal

from ....imagery.record_store import RecordKeeper
from ...measure.window.window_result import WindowResult
from ...measure.window.window_tables import result_of, result_record
from ...measure.window_records import WindowRecord
from ...window_summary import is_same

_KIND = "Seam Inspector: results of windows, "
_VERSION = "3"


class KeptResults(QObject):
    """By the windows' numbers, the last one of each."""

    failed = pyqtSignal(object)
    """Why they can't be kept."""

    def __init__(self, path: Path, parent: QObject) -> None:
        super().__init__(parent)
        self._keeper = RecordKeeper(path, _KIND + _VERSION, self.failed.emit, _KIND)
        self._missing: set[int] = set()

    def keep(self, result: WindowResult) -> None:
        """Written in the background."""
        self._missing.discard(result.window_id)
        self._keeper.save(str(result.window_id), partial(result_record, result))

    def holds(self, window_id: int) -> bool:
        """Whether a result of a window is written by now."""
        return self._keeper.holds(str(window_id))

    def result(self, row: WindowRecord) -> WindowResult | None:
        """What was measured in a window, if its row still says so; None where that is not known and can't be read."""
        found = self.last(row.window_id) if row.verdict else None
        return found if found is not None and _is_of(found, row) else None

    def last(self, window_id: int) -> WindowResult | None:
        """What was last measured in a window, whatever its row says."""
        if window_id in self._missing:
            return None
        record = self._keeper.load(str(window_id))
        found = result_of(record) if record is not None else None
        if found is None:
            self._missing.add(window_id)
        return found

    def flush(self) -> None:
        """Wait until all is written."""
        self._keeper.flush()

    def close(self) -> None:
        """Write what is to be written."""
        self._keeper.close()


def _is_of(result: WindowResult, row: WindowRecord) -> bool:
    """Whether a row has the values of a result; another inspection may have written others into the layer since."""
    profile = result.profile
    return (
        row.window_id == result.window_id
        and row.verdict == result.judgement.verdict.value
        and all(map(is_same, row.ratios, result.judgement.ratios.detail))
        and all(map(is_same, row.kept, profile.kept if profile is not None else row.kept))
    )
