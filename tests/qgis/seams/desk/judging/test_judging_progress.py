"""How many windows are judged is counted change by change, and is what counting all of them gives."""
from __future__ import annotations

import random
from dataclasses import replace

from seam_inspector.plugin.imagery.statistics import FIRST, SECOND
from seam_inspector.plugin.seams.desk.judging import JudgingProgress, JudgingTally
from seam_inspector.plugin.seams.desk.windows.windows_panel import WindowsPanel
from seam_inspector.plugin.seams.measure.window_records import WindowRecord

from tests.qgis.seams.desk.windows_session import WindowsSession, filter_to, window


def test_the_tally_is_what_counting_all_windows_gives() -> None:
    chance, tally = random.Random(5), JudgingTally()
    rows = [window(fid) for fid in range(1, 40)]
    for step in range(400):
        rows, fid = list(rows), len(rows) + step + 1
        for place in chance.sample(range(len(rows)), chance.randrange(3)):
            rows[place] = replace(
                rows[place],
                verdict=chance.choice(["", "reduced", "not_comparable"]),
                observer=chance.choice(["", "visible", "unsure"]),
                observer_2=chance.choice(["", "invisible"]),
            )
        if step % 20 == 0:
            chance.shuffle(rows)
        if step % 30 == 0:
            rows = [*rows[1:], window(fid, "reduced")]  # as many, and another one among them
        if step % 50 == 0:
            rows.append(window(fid + 1000, "reduced", observer="visible"))
        operator = SECOND if step % 100 > 80 else FIRST
        tally.take(operator, rows)
        words = [(row, getattr(row, operator.observer)) for row in rows]
        left = {row.fid for row, word in words if not word and row.verdict == "reduced"}
        judged = sum(word in ("visible", "invisible") for _, word in words)
        unsure = sum(word == "unsure" for _, word in words)
        assert tally.left == left
        assert tally.progress() == JudgingProgress(len(rows), judged, unsure, len(left))


def test_what_is_shown_is_put_together_anew_only_when_a_window_comes_or_goes(
    session: WindowsSession, panel: WindowsPanel
) -> None:
    before = panel.ordered_fids()
    session.judge([1], "visible")
    assert panel.ordered_fids() is before
    shown = filter_to(panel, "visible")
    assert shown == [1, 2]
    session.change(1, verdict="preserved")
    assert panel.ordered_fids() is shown
    session.judge([1], "invisible")
    assert panel.ordered_fids() == [2]
    session.judge([3], "visible")
    assert panel.ordered_fids() == [2, 3]


def test_a_number_that_is_written_is_found_at_its_row(session: WindowsSession, panel: WindowsPanel) -> None:
    shown = panel.ordered_fids()
    session.change(12, window_id=13)
    assert panel._windows.windows()[len(shown) - 1].window_id == 13
    assert (panel._windows.row_numbered(13), panel._windows.row_numbered(12)) == (len(shown) - 1, -1)
    rows: list[WindowRecord] = session.windows()
    assert [row.window_id for row in panel._windows.windows()] == [row.window_id for row in rows]
