"""What the table shows is put together anew only where it must be."""
from __future__ import annotations

from seam_inspector.plugin.seams.desk.windows.windows_panel import WindowsPanel
from seam_inspector.plugin.seams.measure.window_records import WindowRecord

from tests.qgis.seams.desk.windows_session import WindowsSession, filter_to


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
