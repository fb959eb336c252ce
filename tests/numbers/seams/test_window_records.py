"""What a window's record says of itself."""
from __future__ import annotations

import pytest
from seam_inspector.plugin.imagery.statistics import INVISIBLE, UNSURE, VISIBLE
from seam_inspector.plugin.seams.measure.window_records import WindowRecord


@pytest.mark.parametrize(
    ("observer", "is_judged"), [(VISIBLE, True), (INVISIBLE, True), (UNSURE, False), ("", False), ("maybe", False)]
)
def test_who_is_not_sure_did_not_judge(observer: str, is_judged: bool) -> None:
    assert WindowRecord(1, (0.0, 0.0, 1.0, 1.0), observer=observer).is_judged is is_judged


@pytest.mark.parametrize(
    ("verdict", "explained", "is_compared"),
    [("", None, False), ("", 0.5, False), ("preserved", None, True), ("not_comparable", None, False),
     ("not_comparable", 0.01, True)],
)  # fmt: skip
def test_a_source_took_part_where_some_of_the_window_is_explained(
    verdict: str, explained: float | None, is_compared: bool
) -> None:
    assert WindowRecord(1, (0.0, 0.0, 1.0, 1.0), verdict=verdict, explained=explained).is_compared is is_compared
