"""The table's model takes over what changed and leaves the other rows alone; it shows what a new one would."""
from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import pytest
from qgis.core import QgsApplication
from seam_inspector.plugin.seams.desk.windows.windows_table import WindowsModel
from seam_inspector.plugin.seams.measure.window_records import WindowRecord

LOSS = 2
ROWS = [
    WindowRecord(number, (0.0, 0.0, 1.0, 1.0), "reduced", fid=100 - number, loss=7 * number % 10)
    for number in range(1, 21)
]
CHANGES: dict[str, Callable[[WindowRecord], WindowRecord]] = {
    "judged": lambda row: replace(row, observer="visible"),
    "stale": lambda row: replace(row, stale=True),
    "moved in the order": lambda row: replace(row, loss=9.5),
    "no place in the order": lambda row: replace(row, loss=None, verdict=""),
    "another number": lambda row: replace(row, window_id=50),
    "read again, the same": replace,
}


@pytest.mark.parametrize("change", CHANGES)
def test_changed_windows_stand_where_a_new_table_has_them(qgis_app: QgsApplication, change: str) -> None:
    model, fresh = WindowsModel(), WindowsModel()
    for item in (model, fresh):
        item.sort(LOSS)
    model.set_windows(ROWS)
    messages: list[tuple[int, int]] = []
    model.dataChanged.connect(lambda first, last, *_: messages.append((first.row(), last.row())))
    rows = [CHANGES[change](row) if row.window_id in (3, 4, 11) else row for row in ROWS]
    model.set_windows(rows)
    fresh.set_windows(rows)
    assert model.windows() == fresh.windows()
    if change in ("judged", "stale"):
        places = [place for place, row in enumerate(model.windows()) if row.window_id in (3, 4, 11)]
        assert messages == [(min(places), max(places))]
    if change == "read again, the same":
        assert messages == []
