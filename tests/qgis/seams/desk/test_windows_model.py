"""The table's model takes over what changed and leaves the other rows alone; it shows what a new one would."""
from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Any

import pytest
from qgis.core import QgsApplication
from seam_inspector.plugin.seams.desk.windows.windows_model import WindowsModel
from seam_inspector.plugin.seams.measure.window_records import WindowRecord

ROWS = [
    WindowRecord(
        number, (0.0, 0.0, 1.0, 1.0), "reduced", fid=100 - number, kept=((7 * number % 10) / 10,), reference="seam",
        kept_low=0.0, kept_high=0.99,
    )
    for number in range(1, 21)
]
CHANGES: dict[str, Callable[[WindowRecord], WindowRecord]] = {
    "judged": lambda row: replace(row, observer="visible"),
    "judged by two, a column more": lambda row: replace(row, observer_2="visible"),
    "stale": lambda row: replace(row, stale=True),
    "moved in the order": lambda row: replace(row, kept=(0.95,)),
    "no place in the order": lambda row: replace(row, kept=(), verdict=""),
    "another number": lambda row: replace(row, window_id=50),
    "levels": lambda row: replace(row, ratios=(1.0, 1.0, 1.0, 1.0)),
    "read again, the same": replace,
}


@pytest.mark.parametrize("change", CHANGES)
def test_changed_windows_stand_where_a_new_table_has_them(qgis_app: QgsApplication, change: str) -> None:
    model, fresh = WindowsModel(), WindowsModel()
    for item in (model, fresh):
        item.sort([column.name for column in item.columns].index("kept"))
    model.set_windows(ROWS)
    messages: list[tuple[int, int]] = []
    model.dataChanged.connect(lambda first, last, *_: messages.append((first.row(), last.row())))
    rows: list[Any] = [CHANGES[change](row) if row.window_id in (3, 4, 11) else row for row in ROWS]
    model.set_windows(rows)
    fresh.set_windows(rows)
    assert model.windows() == fresh.windows()
    assert model.columns == fresh.columns
    for row in range(model.rowCount()):
        shown = [[item.index(row, column).data() for column in range(item.columnCount())] for item in (model, fresh)]
        assert shown[0] == shown[1]
    if change in ("judged", "stale"):
        places = [place for place, row in enumerate(model.windows()) if row.window_id in (3, 4, 11)]
        assert messages == [(min(places), max(places))]
    if change == "read again, the same":
        assert messages == []
