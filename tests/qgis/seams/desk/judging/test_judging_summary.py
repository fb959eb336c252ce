"""What is said after the last window, and what leads on from there."""
from __future__ import annotations

from dataclasses import replace

from qgis.PyQt.QtWidgets import QAction
from seam_inspector.plugin.imagery.statistics import SECOND
from seam_inspector.plugin.seams.desk.judge_bar import JudgeBar
from seam_inspector.plugin.seams.desk.judging import Judging
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


def test_after_the_last_window_the_bar_sums_up_and_offers_what_comes_next(
    bar: JudgeBar, session: WindowsSession, judging: Judging
) -> None:
    report = QAction("Report")
    bar.offer_next([report])
    session.put(judged())
    session.select([7])
    assert not any(button.isVisible() for button in bar._steps)
    session.select([])
    assert bar.sentence() == "All windows are judged: 6 visible, 6 invisible, 0 not sure."
    assert [button.text() for button in bar._steps if button.isVisible()] == ["Second operator", "Report"]
    next(button for button in bar._steps if button.text() == "Second operator").click()
    assert (judging.operator, judging.is_blind) == (SECOND, True)
    assert session.selected() == [1]  # the first of his
    session.put([replace(row, observer_2="visible") for row in judged()])
    session.select([])
    assert [button.text() for button in bar._steps if button.isVisible()] == ["Report"]
