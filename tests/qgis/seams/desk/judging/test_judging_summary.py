"""What is said after the last window, and what leads on from there."""
from __future__ import annotations

from dataclasses import replace

import pytest
from qgis.PyQt.QtWidgets import QAction
from seam_inspector.plugin.imagery.statistics import FIRST, SECOND
from seam_inspector.plugin.seams.desk.judge_bar import JudgeBar, counts_words, tool_words
from seam_inspector.plugin.seams.desk.judging import Judging
from seam_inspector.plugin.seams.desk.windows.filter_boxes import least_sure_first
from seam_inspector.plugin.seams.measure.window_records import WindowRecord

from tests.qgis.seams.desk.windows_session import WindowsSession, window

KEPT = (0.4, 0.45, 0.5, 0.55, 0.6, 0.62, 0.75, 0.8, 0.85, 0.9, 0.95, 0.99)


def judged() -> list[WindowRecord]:
    """Six where a loss was seen and six where none was, far from each other."""
    return [
        replace(
            window(fid, "significant" if kept < 0.58 else "reduced", kept=(kept,)),
            extent=(1000.0 * fid, 0.0, 1000.0 * fid + 10, 10.0), observer="visible" if kept < 0.7 else "invisible",
        )
        for fid, kept in enumerate(KEPT, 1)
    ]  # fmt: skip


def test_own_words_are_counted_and_held_against_the_tool_s() -> None:
    rows = [*judged(), replace(window(20, "preserved"), observer="unsure")]
    assert counts_words(rows, FIRST) == "All windows are judged: 6 visible, 6 invisible, 1 not sure."
    assert tool_words(rows, FIRST) == (
        "The tool agrees on 10 of 12. Called significant and not seen: 0; seen and not called so: 2."
    )
    assert tool_words(rows, SECOND) == ""


def test_after_the_last_window_the_bar_sums_up_and_offers_what_comes_next(
    bar: JudgeBar, session: WindowsSession, judging: Judging
) -> None:
    report = QAction("Report")
    bar.offer_next([report])
    session.put(judged())
    session.select([7])
    assert not any(button.isVisible() for button in bar._steps)
    session.select([])
    assert bar.sentence().startswith("All windows are judged: 6 visible, 6 invisible, 0 not sure. The tool agrees on")
    assert [button.text() for button in bar._steps if button.isVisible()] == ["Second operator", "Report"]
    next(button for button in bar._steps if button.text() == "Second operator").click()
    assert (judging.operator, judging.is_blind) == (SECOND, True)
    assert session.selected() == [1]  # the first of his
    session.put([replace(row, observer_2="visible") for row in judged()])
    session.select([])
    assert "tool" not in bar.sentence()
    assert [button.text() for button in bar._steps if button.isVisible()] == ["Report"]


@pytest.mark.parametrize(("rows", "order"), [
    (((1, 0.5, 0.05), (2, 0.72, 0.05), (3, 0.6, 0.2)), [2, 3, 1]),
    (((1, 0.9, 0.4), (2, 0.7, 0.01), (3, 0.99, 0.01)), [2, 1, 3]),
])  # fmt: skip
def test_least_sure_is_where_the_limit_lies_deepest_in_the_interval(
    rows: tuple[tuple[int, float, float], ...], order: list[int]
) -> None:
    records = [
        replace(window(fid, "reduced", kept=(kept,)), kept_low=kept - half, kept_high=kept + half)
        for fid, kept, half in rows
    ]  # fmt: skip
    ordered = sorted(records, key=lambda row: least_sure_first(row, 0.7) or 0.0)
    assert [row.window_id for row in ordered] == order
    assert least_sure_first(window(9, "not_comparable"), 0.7) is None
