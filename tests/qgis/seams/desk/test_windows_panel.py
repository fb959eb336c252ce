"""The table of windows and the judge bar, on a session without layers."""
from __future__ import annotations

from dataclasses import replace

import pytest
from qgis.PyQt.QtCore import QPoint, Qt
from qgis.PyQt.QtTest import QTest
from qgis.PyQt.QtWidgets import QApplication
from seam_inspector.plugin.imagery.statistics import FIRST
from seam_inspector.plugin.seams.desk.windows.window_columns import COLUMNS
from seam_inspector.plugin.seams.desk.windows.windows_panel import WindowsPanel

from tests.qgis.seams.desk.session_desk import wait_until
from tests.qgis.seams.desk.windows_session import ROWS, Show, WindowsSession, columns_of, filter_to, window
from tests.work import calls_of

ID, VERDICT, LOSS, RATIO, PAPER, CAUSE, SOURCES, OBSERVER = range(8)
ASCENDING, DESCENDING = Qt.SortOrder.AscendingOrder, Qt.SortOrder.DescendingOrder


def many(count: int) -> list:
    return [window(fid, "reduced", (fid / 3000, 0.5, 0.6), sources=2) for fid in range(1, count + 1)]


def cell(panel: WindowsPanel, fid: int, column: int, role: int = Qt.ItemDataRole.DisplayRole) -> object:
    return panel.table.model().index(panel._windows.row_of(fid), column).data(role)


def select_row(panel: WindowsPanel, fid: int, *more: int) -> None:
    """Select rows as the operator does, by click and Ctrl+click."""
    for number, each in enumerate((fid, *more)):
        keys = Qt.KeyboardModifier.ControlModifier if number else Qt.KeyboardModifier.NoModifier
        QTest.mouseClick(panel.table.viewport(), Qt.MouseButton.LeftButton, keys, place_of(panel, each))


def place_of(panel: WindowsPanel, fid: int) -> QPoint:
    return panel.table.visualRect(panel.table.model().index(panel._windows.row_of(fid), 0)).center()


# What the table says


def test_cells(panel: WindowsPanel) -> None:
    texts = [cell(panel, 2, column) for column in range(8)]
    assert texts == ["2", "significant", "44 m²", "0.38", "reduced", "feathering", "2", "visible"]
    assert [cell(panel, 3, column) for column in range(2, len(COLUMNS))] == [""] * (len(COLUMNS) - 2)
    assert cell(panel, 3, VERDICT) == "not inspected"


def test_changed_windows_are_marked(panel: WindowsPanel) -> None:
    assert cell(panel, 12, VERDICT) == "significant, changed"
    assert cell(panel, 12, RATIO, Qt.ItemDataRole.FontRole).italic()  # type: ignore[attr-defined]
    assert "inspect it again" in str(cell(panel, 12, RATIO, Qt.ItemDataRole.ToolTipRole))
    assert cell(panel, 2, RATIO, Qt.ItemDataRole.FontRole) is None


@pytest.mark.parametrize(
    ("column", "order", "fids"),
    [
        (ID, ASCENDING, [1, 2, 3, 4, 10, 12]),
        (ID, DESCENDING, [12, 10, 4, 3, 2, 1]),
        (VERDICT, ASCENDING, [2, 12, 1, 10, 4, 3]),
        (VERDICT, DESCENDING, [4, 10, 1, 12, 2, 3]),
        (LOSS, ASCENDING, [10, 1, 2, 3, 4, 12]),
        (LOSS, DESCENDING, [2, 1, 10, 3, 4, 12]),
        (RATIO, ASCENDING, [2, 12, 1, 10, 3, 4]),
        (RATIO, DESCENDING, [10, 1, 12, 2, 3, 4]),
        (PAPER, ASCENDING, [2, 1, 3, 4, 10, 12]),
        (CAUSE, ASCENDING, [2, 10, 1, 3, 4, 12]),
        (CAUSE, DESCENDING, [10, 2, 1, 3, 4, 12]),
        (SOURCES, ASCENDING, [4, 12, 2, 1, 10, 3]),
        (OBSERVER, ASCENDING, [2, 10, 1, 3, 4, 12]),
        (OBSERVER, DESCENDING, [10, 2, 1, 3, 4, 12]),
    ],
)
def test_sorting_by_number_with_missing_values_last(
    panel: WindowsPanel, column: int, order: Qt.SortOrder, fids: list[int]
) -> None:
    panel.table.sortByColumn(column, order)
    assert panel.ordered_fids() == fids


@pytest.mark.parametrize(
    ("text", "fids"),
    [
        ("1", [1, 10, 12]), ("12", [12]), ("sign", [2, 12]), ("VISIBLE", [2]), ("invis", [10]),
        ("west_12", [4]), ("sign visible", [2]), ("feath", [2]), ("not", [3, 4]), ("xyz", []),
        ("  ", [1, 2, 3, 4, 10, 12]),
    ],
)
def test_filter_by_text(panel: WindowsPanel, text: str, fids: list[int]) -> None:
    assert filter_to(panel, text) == fids


@pytest.mark.parametrize(
    ("choice", "fids"),
    [
        ("significant", [2, 12]), ("reduced", [1]), ("preserved", [10]), ("not comparable", [4]),
        ("not inspected", [3]), ("not judged", [1, 3, 4, 12]), ("changed", [12]), ("all", [1, 2, 3, 4, 10, 12]),
    ],
)
def test_filter_by_verdict(panel: WindowsPanel, choice: str, fids: list[int]) -> None:
    assert filter_to(panel, choice=choice) == fids


def test_ratios_stand_in_the_table_where_a_verdict_is_taken_by_them(
    panel: WindowsPanel, session: WindowsSession
) -> None:
    panel.resize(1200, 400)
    by_seam = [replace(row, reference="seam") for row in ROWS]

    def shown() -> list[str]:
        QApplication.processEvents()
        return columns_of(panel)

    session.put(by_seam)
    wait_until(lambda: "ratio" not in shown(), "for the columns")
    assert shown() == ["window_id", "verdict", "loss", "paper_verdict", "cause", "sources", "observer"]
    session.put([replace(row, verdict="") for row in ROWS])  # placed, and nothing measured
    wait_until(lambda: "ratio" not in shown(), "for the columns")
    session.put([replace(by_seam[0], reference="sources"), *by_seam[1:]])  # of one more, in its place
    wait_until(lambda: shown()[3] == "ratio", "for the column")


@pytest.mark.parametrize("width", [420, 600, 2000])
def test_as_many_columns_are_seen_as_there_is_room_for(
    panel: WindowsPanel, session: WindowsSession, width: int
) -> None:
    session.change(2, observer_2="visible", remark="haze")
    panel.resize(width, 400)
    QApplication.processEvents()
    names = set(columns_of(panel))
    assert names >= {"window_id", "verdict", "loss", "cause", "observer"}
    assert ("remark" in names) == (width == 2000)
    assert panel.table.horizontalScrollBar().maximum() == 0


def test_the_selected_window_stays_in_sight_where_its_verdict_moves_its_row(
    panel: WindowsPanel, session: WindowsSession, show: Show
) -> None:
    show(panel)
    panel.table.sortByColumn(1, Qt.SortOrder.AscendingOrder)
    session.put([window(fid, "reduced", kept=(0.9,)) for fid in range(1, 200)] + [window(200)])
    session.select([200])
    assert panel.table.is_in_sight(199)
    session.change(200, verdict="significant")
    assert panel.table.selected_rows() == [0]
    assert panel.table.is_in_sight(0)
    panel.table.scrollToBottom()
    assert not panel.table.is_in_sight(0)
    panel.show_selected()
    assert panel.table.is_in_sight(0)


# Selection


def test_rows_clicked_are_selected_in_the_session_once(panel: WindowsPanel, session: WindowsSession) -> None:
    select_row(panel, 2)
    assert session.calls == [("select", [2])]
    select_row(panel, 4, 10)
    assert session.calls[1:] == [("select", [4]), ("select", [4, 10])]


def test_selection_of_the_session_is_followed_without_an_echo(panel: WindowsPanel, session: WindowsSession) -> None:
    session.select([1, 10, 12])
    assert panel.table.selected_fids() == [1, 10, 12]
    session.select([])
    assert panel.table.selected_fids() == []
    assert session.calls == [("select", [1, 10, 12]), ("select", [])]


# Changes


@pytest.mark.parametrize(("column", "most"), [(ID, 20_000), (RATIO, 200_000)], ids=["in place", "to be sorted"])
def test_two_thousand_windows_are_followed_at_once(
    panel: WindowsPanel, session: WindowsSession, column: int, most: int
) -> None:
    """The map must not stall: a window that stays where it is costs a few calls for each of the others."""
    panel.table.sortByColumn(column, DESCENDING)
    rows = many(2000)
    session.put(rows)
    filter_to(panel, "reduced")
    session.select(list(range(1, 2000, 20)))
    rows = [replace(row, ratios=(0.2, 0.3, 0.4)) if row.fid == 1000 else row for row in rows]
    assert calls_of(lambda: session.put(rows)) < most


# What the operator asks for


def test_del_removes_the_selected_windows(panel: WindowsPanel, session: WindowsSession) -> None:
    select_row(panel, 2, 4)
    session.calls.clear()
    QTest.keyClick(panel.table, Qt.Key.Key_Delete)
    assert session.calls == [("remove", [2, 4])]
    assert panel.ordered_fids() == [1, 3, 10, 12]
    assert panel.table.selected_fids() == session.selected() == []
    QTest.keyClick(panel.table, Qt.Key.Key_Delete)
    assert session.calls == [("remove", [2, 4])]


@pytest.mark.parametrize("yes", [False, True])
def test_del_asks_before_it_removes_several_judged_windows(session: WindowsSession, show: Show, yes: bool) -> None:
    asked: list[str] = []

    def confirm(_widget: object, question: str) -> bool:
        asked.append(question)
        return yes

    panel = WindowsPanel(session, confirm=confirm)
    show(panel)
    select_row(panel, 2, 4, 10)
    session.calls.clear()
    QTest.keyClick(panel.table, Qt.Key.Key_Delete)
    assert asked == ["Remove 3 windows, 2 of them judged?"]
    assert session.calls == [("remove", [2, 4, 10])] * yes


def test_a_click_and_enter_go_to_a_window(panel: WindowsPanel, session: WindowsSession) -> None:
    zoomed: list[int] = []
    panel.zoomRequested.connect(zoomed.append)
    viewport, none = panel.table.viewport(), Qt.KeyboardModifier.NoModifier
    QTest.mouseClick(viewport, Qt.MouseButton.LeftButton, none, place_of(panel, 10))
    assert zoomed == [10]
    QTest.keyClick(panel.table, Qt.Key.Key_Return)
    assert zoomed == [10, 10]
    QTest.mouseClick(viewport, Qt.MouseButton.LeftButton, Qt.KeyboardModifier.ControlModifier, place_of(panel, 2))
    assert zoomed == [10, 10]
    session.select([12])  # on the map, where it is
    assert zoomed == [10, 10]


def test_who_judges_blind_filters_by_what_he_sees(panel: WindowsPanel) -> None:
    panel.show_for(FIRST, is_blind=True)
    assert filter_to(panel, "significant") == []
    assert filter_to(panel, "visible") == [2]
