"""The table of windows and the judge bar, on a session without layers."""
from __future__ import annotations

from dataclasses import replace

import pytest
from qgis.PyQt.QtCore import QPoint, Qt
from qgis.PyQt.QtTest import QTest
from qgis.PyQt.QtWidgets import QApplication, QStyleOptionViewItem
from seam_inspector.plugin.seams.desk.windows.window_columns import WINDOW_ID
from seam_inspector.plugin.seams.desk.windows.windows_panel import WindowsPanel

from tests.qgis.seams.desk.windows_session import ROWS, Show, WindowsSession, filter_to, window
from tests.work import calls_of

ID, VERDICT, LOSS, RATIO_1, RATIO_2, RATIO_3, PAPER, CAUSE, SOURCES, OBSERVER, REASON = range(11)
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


def top_window(panel: WindowsPanel) -> int:
    return panel.ordered_fids()[panel.table.rowAt(0)]


# What the table says


def test_cells(panel: WindowsPanel) -> None:
    texts = [cell(panel, 2, column) for column in range(11)]
    assert texts == ["2", "significant", "44 m²", "0.38", "0.52", "0.88", "reduced", "feathering", "2", "visible", ""]
    assert "0.3812" in str(cell(panel, 2, RATIO_1, Qt.ItemDataRole.ToolTipRole))
    assert [cell(panel, 3, column) for column in range(2, 10)] == [""] * 8
    assert cell(panel, 3, VERDICT) == "not inspected"


def test_reason_is_the_tooltip_of_a_row_that_is_not_comparable(panel: WindowsPanel) -> None:
    for column in range(11):
        assert "No source covers &lt;window&gt;" in str(cell(panel, 4, column, Qt.ItemDataRole.ToolTipRole))


def test_changed_windows_are_marked(panel: WindowsPanel) -> None:
    assert cell(panel, 12, VERDICT) == "significant, changed"
    assert cell(panel, 12, RATIO_1, Qt.ItemDataRole.FontRole).italic()  # type: ignore[attr-defined]
    assert "inspect it again" in str(cell(panel, 12, RATIO_1, Qt.ItemDataRole.ToolTipRole))
    assert cell(panel, 2, RATIO_1, Qt.ItemDataRole.FontRole) is None


@pytest.mark.parametrize(
    ("column", "order", "fids"),
    [
        (ID, ASCENDING, [1, 2, 3, 4, 10, 12]),
        (ID, DESCENDING, [12, 10, 4, 3, 2, 1]),
        (VERDICT, ASCENDING, [2, 12, 1, 10, 4, 3]),
        (VERDICT, DESCENDING, [4, 10, 1, 2, 12, 3]),
        (LOSS, ASCENDING, [10, 1, 2, 3, 4, 12]),
        (LOSS, DESCENDING, [2, 1, 10, 3, 4, 12]),
        (RATIO_1, ASCENDING, [2, 12, 1, 10, 3, 4]),
        (RATIO_1, DESCENDING, [10, 1, 12, 2, 3, 4]),
        (PAPER, ASCENDING, [2, 1, 3, 4, 10, 12]),
        (RATIO_3, DESCENDING, [1, 12, 2, 3, 4, 10]),
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


def test_hints_when_there_is_nothing_to_show(panel: WindowsPanel, session: WindowsSession) -> None:
    filter_to(panel, "xyz")
    assert panel.table.hint == "No window matches the filter."
    session.put([])
    assert panel.table.hint == "Draw a window on the map, or place windows along the seamlines."
    assert not panel.grab().isNull()


def test_columns_fit_a_narrow_dock_and_a_wide_one(panel: WindowsPanel, session: WindowsSession) -> None:
    session.change(12, stale=False)
    font = panel.font()
    font.setPixelSize(12)
    panel.setFont(font)
    panel.resize(412, 300)
    QTest.qWait(1)
    assert panel.table.horizontalScrollBar().maximum() == 0
    assert panel.table.isColumnHidden(REASON)
    assert panel.table.isColumnHidden(RATIO_2)
    assert not panel.table.isColumnHidden(LOSS)
    assert not panel.table.isColumnHidden(OBSERVER)
    panel.resize(480, 300)
    QTest.qWait(1)
    assert panel.table.horizontalScrollBar().maximum() == 0
    assert panel.table.isColumnHidden(RATIO_2)
    assert not panel.table.isColumnHidden(CAUSE)
    panel.resize(800, 300)
    QTest.qWait(1)
    assert panel.table.horizontalScrollBar().maximum() == 0
    assert panel.table.isColumnHidden(REASON)
    assert not panel.table.isColumnHidden(RATIO_2)
    assert not panel.table.isColumnHidden(CAUSE)
    panel.resize(1300, 300)
    QTest.qWait(1)
    assert panel.table.horizontalScrollBar().maximum() == 0
    assert not panel.table.isColumnHidden(REASON)


def test_ratios_stand_in_the_table_where_a_verdict_is_taken_by_them(
    panel: WindowsPanel, session: WindowsSession
) -> None:
    panel.resize(1200, 400)
    by_seam = [replace(row, reference="seam") for row in ROWS]

    def shown() -> list[str]:
        QApplication.processEvents()
        return [column.field for column in panel.table.visible_columns()]

    session.put(by_seam)
    assert shown()[:3] == ["window_id", "verdict", "loss"]
    assert not [field for field in shown() if field.startswith("ratio")]
    assert "ratio_1" in [column.field for column in panel._windows.columns]  # to be chosen
    session.put([replace(row, verdict="") for row in ROWS])  # placed, and nothing measured
    assert "ratio_1" not in shown()
    session.put([replace(by_seam[0], reference="sources"), *by_seam[1:]])  # of one more, in its place
    assert "ratio_1" in shown()


def test_a_loss_is_never_cut(panel: WindowsPanel, session: WindowsSession) -> None:
    font = panel.font()
    font.setPixelSize(12)
    panel.setFont(font)
    for width in (412, 480, 640):
        panel.resize(width, 300)
        session.change(2, loss=43.9)
        QTest.qWait(1)
        session.change(2, loss=10_485.8)
        assert cell(panel, 2, LOSS) == "10,486 m²"
        assert panel.table.columnWidth(LOSS) >= panel.table.sizeHintForColumn(LOSS), width
        assert panel.table.horizontalScrollBar().maximum() == 0


def test_the_first_click_on_the_loss_shows_the_worst_first(panel: WindowsPanel) -> None:
    header = panel.table.horizontalHeader()
    place = QPoint(header.sectionViewportPosition(LOSS) + header.sectionSize(LOSS) // 2, header.height() // 2)
    QTest.mouseClick(header.viewport(), Qt.MouseButton.LeftButton, pos=place)
    assert panel.ordered_fids() == [2, 1, 10, 3, 4, 12]


def test_as_many_ratios_as_levels(panel: WindowsPanel, session: WindowsSession) -> None:
    panel.table.sortByColumn(RATIO_3, ASCENDING)
    session.put([replace(row, ratios=row.ratios[:2]) for row in ROWS])
    titles = [column.title() for column in panel._windows.columns]
    assert titles[:10] == ["id", "verdict", "loss", "ratio 1", "2", "paper", "cause", "sources", "observer", "reason"]
    assert panel._windows.sorted_by == WINDOW_ID
    assert panel.table.horizontalHeader().sortIndicatorSection() == ID


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


def test_selection_survives_changes_sorting_and_filters(panel: WindowsPanel, session: WindowsSession) -> None:
    session.select([2, 10])
    session.calls.clear()
    session.change(2, verdict="reduced", ratios=(0.9, 0.9, 0.9))
    panel.table.sortByColumn(RATIO_1, DESCENDING)
    assert panel.table.selected_fids() == [10, 2]
    assert filter_to(panel, choice="preserved") == [10]
    assert panel.table.selected_fids() == [10]
    filter_to(panel)
    session.put([row for row in session.rows if row.fid != 3])
    assert panel.table.selected_fids() == [10, 2]
    assert session.selected() == [2, 10]
    assert session.calls == []


def test_new_window_selected_before_it_was_told_comes_into_sight(
    panel: WindowsPanel, session: WindowsSession
) -> None:
    session.put(many(500))
    session.select([501])  # the layer tells its selection before the session tells the rows
    session.put([*many(500), window(501)])
    assert panel.table.selected_fids() == [501]
    assert panel.table.is_in_sight(panel._windows.row_of(501))


def test_selected_window_comes_into_sight(panel: WindowsPanel, session: WindowsSession) -> None:
    session.put(many(500))
    session.select([300])
    assert panel.table.is_in_sight(panel._windows.row_of(300))


# Changes


def test_a_changed_value_resets_nothing(panel: WindowsPanel, session: WindowsSession) -> None:
    model, heard = panel._windows, []
    for name in ("modelReset", "layoutChanged", "rowsInserted", "rowsRemoved"):
        getattr(model, name).connect(lambda *_, name=name: heard.append(name))
    changed = []
    model.dataChanged.connect(lambda first, last, *_: changed.append((first.row(), last.row())))
    session.change(2, observer="invisible")
    assert (heard, changed) == ([], [(1, 1)])
    session.put(session.rows)
    assert (heard, changed) == ([], [(1, 1)])


def test_changes_at_once_end_in_the_session_s_windows(panel: WindowsPanel, session: WindowsSession) -> None:
    panel.table.sortByColumn(RATIO_1, ASCENDING)
    rows = many(300)
    session.put(rows)
    rows = [replace(row, ratios=(1 - row.ratios[0], 0.1, 0.2)) for row in rows if row.fid % 50]  # type: ignore[operator]
    rows += [window(400), window(401, "reduced", (0.9505, 1.0, 1.0))]
    session.put(rows)
    known = [row for row in rows if row.ratios[0] is not None]
    expected = [row.fid for row in sorted(known, key=lambda row: row.ratios[0])] + [400]  # type: ignore[arg-type, return-value]
    assert panel.ordered_fids() == expected
    session.put([row for row in rows if row.fid % 2])
    assert panel.ordered_fids() == [fid for fid in expected if fid % 2]


def test_scroll_position_is_kept(panel: WindowsPanel, session: WindowsSession) -> None:
    session.put(many(500))
    panel.table.sortByColumn(RATIO_1, DESCENDING)
    QTest.qWait(1)
    panel.table.verticalScrollBar().setValue(200)
    top = top_window(panel)
    session.change(top - 3, observer="visible")
    assert panel.table.verticalScrollBar().value() == 200
    session.put([*session.rows, *(window(fid, "preserved", (2.0, 1, 1)) for fid in range(600, 620))])
    assert top_window(panel) == top
    session.put([row for row in session.rows if row.fid % 2 == top % 2])  # in more places than are told one by one
    assert top_window(panel) == top


def test_saving_gives_other_feature_ids_and_moves_nothing(panel: WindowsPanel, session: WindowsSession) -> None:
    session.put([replace(row, fid=-row.fid) for row in many(500)])
    session.select([-400])
    QTest.qWait(1)
    panel.table.verticalScrollBar().setValue(200)
    session.chosen = [400]
    session.put(many(500))
    session.selectionChanged.emit()
    assert panel.table.selected_fids() == [400]
    assert panel.table.verticalScrollBar().value() == 200


@pytest.mark.parametrize(("column", "most"), [(ID, 4_000), (RATIO_1, 200_000)], ids=["in place", "to be sorted"])
def test_two_thousand_windows_are_followed_at_once(
    panel: WindowsPanel, session: WindowsSession, column: int, most: int
) -> None:
    """The map must not stall: a window that stays where it is costs two calls for each of the others at most."""
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


def test_del_in_the_filter_line_removes_letters_only(panel: WindowsPanel, session: WindowsSession) -> None:
    select_row(panel, 2)
    panel._search.setText("2")
    panel._search.setCursorPosition(0)
    session.calls.clear()
    QTest.keyClick(panel._search, Qt.Key.Key_Delete)
    assert panel._search.text() == ""
    assert session.calls == []


def test_del_leaves_windows_that_the_filter_hides(panel: WindowsPanel, session: WindowsSession) -> None:
    session.select([2, 10])
    filter_to(panel, choice="significant")
    session.calls.clear()
    QTest.keyClick(panel.table, Qt.Key.Key_Delete)
    assert session.calls == [("remove", [2])]


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


def test_context_menu(panel: WindowsPanel, session: WindowsSession) -> None:
    session.select([1, 12])
    session.calls.clear()
    zoomed: list[int] = []
    panel.zoomRequested.connect(zoomed.append)
    for action in panel._menu.actions():
        if not action.isSeparator():
            assert action.toolTip()
            action.trigger()
    assert zoomed == [1]
    assert session.calls == [("inspect", [1, 12]), ("remove", [1, 12])]


# Filter by numbers


@pytest.mark.parametrize(
    ("text", "fids"),
    [
        ("kept < 0.7", [2]), ("visibility > 1", [2]), ("kept<0.95 and cause = 'feathering'", [2]), ("kept_1 > 1", [10]),
        ("ratio_2 >= 0.7", [1, 10, 12]), ("verdict = 'significant' or id = 1", [1, 2, 12]),
        ("Sources > 2", [1, 10]), ("cause is null", [1, 3, 4, 12]), ("observer <> 'invisible'", [2]),
        ("reason like '%west%'", [4]), ("ratio / composite_ratio < 0.7", [2]), ("100 * kept < 70", [2]),
        ("round(kept, 1) > 0.95", [10]),
    ],
)
def test_filter_by_an_expression(panel: WindowsPanel, text: str, fids: list[int]) -> None:
    assert filter_to(panel, text) == fids
    assert panel._problem.isHidden()


@pytest.mark.parametrize(
    ("text", "said"),
    [("kept <", "not understood"), ("sharp < 0.7", "'sharp'"), ("kept < )", "not under"), ("abs(1, 2) > 1", "under"),
     ("kept < 0,7", "not understood"), ("$area > 10", "can't use geometry"),
     ("geom_to_wkt($geometry) <> ''", "can't use geometry"), ("cause = feathering", "'feathering'")],
)
def test_a_wrong_expression_gets_a_sentence_and_leaves_no_window_out(
    panel: WindowsPanel, text: str, said: str
) -> None:
    filter_to(panel, "kept < 0.7")
    assert filter_to(panel, text) == [1, 2, 3, 4, 10, 12]
    assert said in panel._problem.text()
    assert not panel._problem.isHidden()
    assert filter_to(panel, "") == [1, 2, 3, 4, 10, 12]
    assert panel._problem.isHidden()


def test_an_expression_follows_the_windows(panel: WindowsPanel, session: WindowsSession) -> None:
    filter_to(panel, "kept < 0.7")
    session.change(1, kept=(0.3,))
    assert panel.ordered_fids() == [1, 2]
    session.change(2, kept=(0.8,))
    assert panel.ordered_fids() == [1]


def test_two_thousand_windows_are_filtered_by_numbers_at_once(panel: WindowsPanel, session: WindowsSession) -> None:
    session.put(many(2000))
    assert calls_of(lambda: filter_to(panel, "ratio < 0.5")) < 100_000
    assert len(panel.ordered_fids()) == 1499


# Columns


def titles(panel: WindowsPanel) -> list[str]:
    return [column.title() for column in panel.table.visible_columns()]


def choose_column(panel: WindowsPanel, title: str) -> None:
    menu = panel.table.columns_menu()
    next(action for action in menu.actions() if action.text() == title).trigger()


def test_columns_are_chosen_and_kept(
    panel: WindowsPanel, session: WindowsSession, show: Show, own_settings: None
) -> None:
    before = titles(panel)
    choose_column(panel, "band width")
    choose_column(panel, "visibility")
    choose_column(panel, "verdict")
    assert titles(panel) == [*(title for title in before if title != "verdict"), "band width", "visibility"]
    other = WindowsPanel(session)
    show(other)
    assert titles(other) == titles(panel)
    choose_column(other, "As there is room")
    other.resize(panel.size())
    QTest.qWait(1)
    assert titles(other) == before


def test_what_operators_say_has_columns_once_it_is_used(panel: WindowsPanel, session: WindowsSession) -> None:
    panel.resize(1900, 300)
    QTest.qWait(1)
    assert "sure" not in titles(panel)
    session.change(2, confidence=70, remark="by the kerb")
    assert [title for title in titles(panel) if title != "reason"][-3:] == ["observer", "sure", "remark"]
    session.change(2, observer_2="unsure")
    assert "observer 2" in titles(panel)
    assert filter_to(panel, "confidence > 50") == [2]


@pytest.mark.parametrize("said", [{}, {"observer_2": "unsure", "confidence": 70, "remark": "by the kerb"}])
def test_verdicts_are_not_cut_at_the_usual_width(
    panel: WindowsPanel, session: WindowsSession, said: dict[str, object]
) -> None:
    session.change(2, **said)
    font = panel.font()
    font.setPixelSize(12)
    panel.setFont(font)
    panel.resize(412, 300)
    QTest.qWait(1)
    delegate, option = panel.table.itemDelegate(), QStyleOptionViewItem()
    option.initFrom(panel.table)
    option.font = panel.table.font()
    for fid in panel.ordered_fids():
        index = panel.table.model().index(panel._windows.row_of(fid), VERDICT)
        assert delegate.sizeHint(option, index).width() <= panel.table.columnWidth(VERDICT)
    assert panel.table.horizontalScrollBar().maximum() == 0


# Rows as text


def test_selected_rows_are_copied_with_their_headings(panel: WindowsPanel) -> None:
    panel.resize(420, 300)
    select_row(panel, 2, 4)
    QTest.keyClick(panel.table, Qt.Key.Key_C, Qt.KeyboardModifier.ControlModifier)
    lines = [line.split("\t") for line in QApplication.clipboard().text().split("\n")]
    assert lines[0] == titles(panel)
    assert [line[:3] for line in lines[1:]] == [["2", "significant", "44 m²"], ["4", "not comparable", ""]]
