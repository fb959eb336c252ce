"""The table of windows and the judge bar, on a session without layers."""
from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace
from time import process_time

import pytest
from qgis.PyQt.QtCore import QItemSelectionModel, QPoint, Qt
from qgis.PyQt.QtTest import QTest
from qgis.PyQt.QtWidgets import QApplication, QLineEdit, QVBoxLayout, QWidget
from seam_inspector.plugin.seams.desk.windows.judge_bar import JudgeBar
from seam_inspector.plugin.seams.desk.windows.windows_columns import WINDOW_ID
from seam_inspector.plugin.seams.desk.windows.windows_panel import WindowsPanel
from seam_inspector.plugin.toolkit.translation import percent

from tests.qgis.seams.desk.windows_session import WindowsSession, window

ROWS = [
    window(1, "reduced", (0.83, 0.95, 0.99), sources=3, kept=(0.9, 0.95, 1.0)),
    window(
        2, "significant", (0.381234, 0.52, 0.88), "visible", sources=2, composite_ratio=0.6, cause="feathering",
        kept=(0.557, 0.8, 0.97), paper_verdict="reduced",
    ),
    window(3),
    window(4, "not_comparable", reason="No source covers <window> in west_12.tif.", sources=0),
    window(10, "preserved", (1.04, 1.0, None), "invisible", sources=10, cause="none", kept=(1.02,)),
    window(12, "significant", (0.45, 0.7, 0.9), sources=1, stale=True),
]
ID, VERDICT, KEPT, RATIO_1, RATIO_2, RATIO_3, PAPER, CAUSE, SOURCES, OBSERVER, REASON = range(11)
ASCENDING, DESCENDING = Qt.SortOrder.AscendingOrder, Qt.SortOrder.DescendingOrder

Show = Callable[[QWidget], QWidget]


@pytest.fixture
def session() -> WindowsSession:
    return WindowsSession(ROWS)


@pytest.fixture
def show(qgis_app: QApplication) -> Iterator[Show]:
    """Shows a widget until the test is over."""
    shown: list[QWidget] = []

    def show_widget(widget: QWidget) -> QWidget:
        shown.append(widget)
        widget.show()
        QTest.qWait(1)
        return widget

    yield show_widget
    for widget in shown:
        widget.close()
        widget.deleteLater()


@pytest.fixture
def panel(session: WindowsSession, show: Show) -> WindowsPanel:
    panel = WindowsPanel(session)
    panel.resize(600, 300)
    show(panel)
    return panel


def many(count: int) -> list:
    return [window(fid, "reduced", (fid / 3000, 0.5, 0.6), sources=2) for fid in range(1, count + 1)]


def cell(panel: WindowsPanel, fid: int, column: int, role: int = Qt.ItemDataRole.DisplayRole) -> object:
    return panel.table.model().index(panel._shown.row_of(fid), column).data(role)


def filter_to(panel: WindowsPanel, text: str = "", choice: str = "all") -> list[int]:
    panel._search.setText(text)
    panel._verdicts.setCurrentText(choice)
    return panel.ordered_fids()


def select_row(panel: WindowsPanel, fid: int, *more: int) -> None:
    """As the operator does, by click and Ctrl+click."""
    for number, each in enumerate((fid, *more)):
        keys = Qt.KeyboardModifier.ControlModifier if number else Qt.KeyboardModifier.NoModifier
        QTest.mouseClick(panel.table.viewport(), Qt.MouseButton.LeftButton, keys, place_of(panel, each))


def place_of(panel: WindowsPanel, fid: int) -> QPoint:
    return panel.table.visualRect(panel.table.model().index(panel._shown.row_of(fid), 0)).center()


def top_window(panel: WindowsPanel) -> int:
    return panel.ordered_fids()[panel.table.rowAt(0)]


# What the table says


def test_cells(panel: WindowsPanel) -> None:
    texts = [cell(panel, 2, column) for column in range(11)]
    assert texts == ["2", "significant", "56 %", "0.38", "0.52", "0.88", "reduced", "feathering", "2", "visible", ""]
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
        (KEPT, ASCENDING, [2, 1, 10, 3, 4, 12]),
        (KEPT, DESCENDING, [10, 1, 2, 3, 4, 12]),
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


def test_columns_fit_a_narrow_dock_and_a_wide_one(panel: WindowsPanel) -> None:
    font = panel.font()
    font.setPixelSize(12)
    panel.setFont(font)
    panel.resize(412, 300)
    QTest.qWait(1)
    assert panel.table.horizontalScrollBar().maximum() == 0
    assert panel.table.isColumnHidden(REASON)
    assert panel.table.isColumnHidden(RATIO_2)
    assert not panel.table.isColumnHidden(KEPT)
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


def test_as_many_ratios_as_levels(panel: WindowsPanel, session: WindowsSession) -> None:
    panel.table.sortByColumn(RATIO_3, ASCENDING)
    session.put([replace(row, ratios=row.ratios[:2]) for row in ROWS])
    titles = [column.title() for column in panel._windows.columns]
    assert titles == ["id", "verdict", "kept", "ratio 1", "2", "paper", "cause", "sources", "observer", "reason"]
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
    assert panel.table.is_in_sight(panel._shown.row_of(501))


def test_selected_window_comes_into_sight(panel: WindowsPanel, session: WindowsSession) -> None:
    session.put(many(500))
    session.select([300])
    assert panel.table.is_in_sight(panel._shown.row_of(300))


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
    session.put([row for row in session.rows if row.fid not in (3, 4)])
    session.put([*session.rows, window(20)])
    assert heard == ["rowsRemoved", "rowsInserted"]


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


@pytest.mark.parametrize("column", [ID, RATIO_1])
def test_two_thousand_windows_are_followed_at_once(
    panel: WindowsPanel, session: WindowsSession, column: int
) -> None:
    panel.table.sortByColumn(column, DESCENDING)
    rows = many(2000)
    session.put(rows)
    filter_to(panel, "reduced")
    session.select(list(range(1, 2000, 20)))
    durations = []
    for fid in range(1000, 1007):
        rows = [replace(row, ratios=(0.2, 0.3, 0.4)) if row.fid == fid else row for row in rows]
        started = process_time()
        session.put(rows)
        durations.append(process_time() - started)
    assert min(durations) < 0.05  # seconds: the map must not stall longer


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


def test_double_click_and_enter_zoom(panel: WindowsPanel) -> None:
    zoomed: list[int] = []
    panel.zoomRequested.connect(zoomed.append)
    place = place_of(panel, 10)
    viewport = panel.table.viewport()
    QTest.mouseClick(viewport, Qt.MouseButton.LeftButton, Qt.KeyboardModifier.NoModifier, place)
    QTest.mouseDClick(viewport, Qt.MouseButton.LeftButton, Qt.KeyboardModifier.NoModifier, place)
    assert zoomed == [10]
    QTest.keyClick(panel.table, Qt.Key.Key_Return)
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
    assert session.calls == [
        ("inspect", [1, 12]),
        *(("judge", [1, 12], word) for word in ("visible", "invisible", "")),
        ("remove", [1, 12]),
    ]


# The judge bar


@pytest.fixture
def bar(session: WindowsSession, panel: WindowsPanel, show: Show) -> JudgeBar:
    bar = JudgeBar(session, order=panel.ordered_fids)
    panel.orderChanged.connect(bar.refresh)
    show(bar)
    return bar


@pytest.mark.parametrize(
    ("fids", "sentence"),
    [
        ([], "Select a window to judge it."),
        ([1], "Reduced. Beside the seam 10.0 % of the finest detail is lost (5.0 to 15 %)."),
        (
            [2],
            "Significant loss. Beside the seam 44 % of the finest detail is lost (39 to 49 %). Images are feathered.",
        ),
        ([3], "Not inspected yet."),
        ([4], "No source covers <window> in west_12.tif."),
        (
            [10],
            "Preserved. Along the seam as much of the finest detail is left as around it (102 %, 97 to 107 %).",
        ),
        ([12], "Significant loss. Detail at level 1 is 45 % of the source's. Changed since: inspect it again."),
        ([1, 2, 12], "3 windows selected: 2 significant, 1 reduced, 1 changed since."),
    ],
)
def test_sentence(bar: JudgeBar, session: WindowsSession, fids: list[int], sentence: str) -> None:
    session.select(fids)
    assert bar.sentence() == sentence


@pytest.mark.parametrize(
    ("ratio", "text"), [(0.38, "38"), (0.9996, "99.9"), (1.0, "100"), (1.004, "100.4"), (0.052, "5.2"), (2.5, "250"),
     (0.0, "0"), (0.0006, "0.1"), (0.0003, "0.03"), (0.00001, "0.001"), (1e-9, "0.001")]
)
def test_percent_never_hides_on_which_side_of_one_a_ratio_is(qgis_app: QApplication, ratio: float, text: str) -> None:
    assert percent(ratio) == text


def test_buttons_show_and_write_the_judgement(bar: JudgeBar, session: WindowsSession) -> None:
    session.select([2])
    assert (bar._visible.isChecked(), bar._invisible.isChecked()) == (True, False)
    bar._invisible.click()
    assert session.row(2).observer == "invisible"  # type: ignore[union-attr]
    assert (bar._visible.isChecked(), bar._invisible.isChecked()) == (False, True)
    bar._invisible.click()
    assert session.row(2).observer == ""  # type: ignore[union-attr]
    session.select([2, 10])
    assert (bar._visible.isChecked(), bar._invisible.isChecked()) == (False, False)
    bar._visible.click()
    assert {row.fid: row.observer for row in session.rows if row.observer} == {2: "visible", 10: "visible"}
    session.select([])
    assert not bar._visible.isEnabled()
    assert not bar._invisible.isEnabled()


def test_a_judgement_that_was_not_written_is_not_shown(
    bar: JudgeBar, session: WindowsSession, monkeypatch: pytest.MonkeyPatch
) -> None:
    session.select([1])
    monkeypatch.setattr(session, "judge", lambda fids, observer: None)  # the layer is read-only
    bar._visible.click()
    assert not bar._visible.isChecked()


def test_next_goes_to_compared_windows_not_judged_and_begins_again(
    bar: JudgeBar, panel: WindowsPanel, session: WindowsSession
) -> None:
    bar.select_next()
    assert session.selected() == [1]
    bar.select_next()
    assert session.selected() == [12]
    bar.select_next()
    assert session.selected() == [1]
    panel.table.sortByColumn(VERDICT, ASCENDING)
    session.select([2])
    bar.select_next()
    assert session.selected() == [12]
    session.judge([1, 12], "visible")
    assert not bar._next.isEnabled()
    bar.select_next()
    assert session.selected() == [12]


def test_next_goes_on_where_a_judged_window_left_the_filter(
    bar: JudgeBar, panel: WindowsPanel, session: WindowsSession
) -> None:
    session.put([window(fid, "reduced", (0.9, 1, 1)) for fid in range(1, 6)])
    filter_to(panel, choice="not judged")
    session.select([3])
    bar.judge_visible()
    assert panel.ordered_fids() == [1, 2, 4, 5]
    assert session.selected() == [3]  # still there to be judged otherwise
    bar.select_next()
    assert session.selected() == [4]


def test_steps_and_position(bar: JudgeBar, panel: WindowsPanel, session: WindowsSession) -> None:
    session.select([2])
    assert bar._position.text() == "2 of 6"
    bar._forth.click()
    assert session.selected() == [3]
    bar._back.click()
    bar._back.click()
    assert session.selected() == [1]
    assert not bar._back.isEnabled()
    panel.table.sortByColumn(ID, DESCENDING)
    assert bar._position.text() == "6 of 6"
    assert not bar._forth.isEnabled()
    filter_to(panel, choice="preserved")
    assert bar._position.text() == "- of 1"


def test_without_an_order_it_is_the_layer_s(session: WindowsSession, show: Show) -> None:
    session.rows.reverse()
    bar = show(JudgeBar(session))
    session.select([12])
    assert bar._position.text() == "1 of 6"  # type: ignore[attr-defined]


def test_keys_work_in_the_dock_but_not_in_text_fields(
    bar: JudgeBar, panel: WindowsPanel, session: WindowsSession, show: Show
) -> None:
    dock, line = QWidget(), QLineEdit()
    layout = QVBoxLayout(dock)
    for widget in (line, panel, bar):
        layout.addWidget(widget)
    dock.addActions(bar.actions_for_dock())
    show(dock)
    dock.activateWindow()
    QTest.qWaitForWindowActive(dock)
    session.select([1])
    session.calls.clear()
    line.setFocus()
    QTest.keyClicks(line, "vin")
    assert line.text() == "vin"
    assert session.calls == []
    panel.table.setFocus()
    QTest.keyClick(panel.table, Qt.Key.Key_V)
    QTest.keyClick(panel.table, Qt.Key.Key_V)  # twice does no harm
    QTest.keyClick(panel.table, Qt.Key.Key_N)
    QTest.keyClick(panel.table, Qt.Key.Key_I)
    assert session.calls == [
        ("judge", [1], "visible"), ("judge", [1], "visible"), ("select", [12]), ("judge", [12], "invisible")
    ]


@pytest.mark.parametrize("width", [412, 1200])
def test_the_bar_is_as_narrow_as_the_dock(bar: JudgeBar, session: WindowsSession, width: int) -> None:
    font = bar.font()
    font.setPixelSize(12)
    bar.setFont(font)
    session.select([4])
    bar.resize(width, 100)
    QTest.qWait(1)
    assert bar.minimumSizeHint().width() <= 412
    beside = bar._sentence.geometry().bottom() >= bar._visible.geometry().top()
    assert beside == (width == 1200)


def test_every_control_has_a_tooltip(bar: JudgeBar, panel: WindowsPanel) -> None:
    session_free = (bar._visible, bar._invisible, bar._next, bar._back, bar._forth, bar._position)
    for widget in (*session_free, panel._search, panel._verdicts, panel._count, panel.table):
        assert widget.toolTip()


def test_the_session_outlives_its_widgets(session: WindowsSession, qgis_app: QApplication) -> None:
    panel = WindowsPanel(session)
    bar = JudgeBar(session, panel, panel.ordered_fids)
    panel.orderChanged.connect(bar.refresh)
    panel.table.selectionModel().select(
        panel.table.rows_selection([0]), QItemSelectionModel.SelectionFlag.ClearAndSelect
    )
    panel.deleteLater()
    QTest.qWait(1)
    session.put(many(3))
    session.select([2])
