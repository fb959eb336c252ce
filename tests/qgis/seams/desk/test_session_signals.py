"""What the session tells from a click to the flag: each change once, in an order that listeners can rely on."""
from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from qgis.core import QgsVectorLayer
from qgis.PyQt.QtCore import QObject
from seam_inspector.plugin.seams.desk.inputs.block_cache import BlockCache
from seam_inspector.plugin.seams.desk.inputs.project_inputs import InputsWatch
from seam_inspector.plugin.seams.desk.judge_bar import JudgeBar
from seam_inspector.plugin.seams.desk.judging import Judging
from seam_inspector.plugin.seams.desk.session import Session
from seam_inspector.plugin.seams.desk.windows.new_windows import NewWindows
from seam_inspector.plugin.seams.desk.windows.window_results import WindowResults
from seam_inspector.plugin.seams.desk.windows.window_steps import WindowSteps
from seam_inspector.plugin.seams.desk.windows.window_watch import WindowWatch
from seam_inspector.plugin.seams.tables import window_file, window_layer
from seam_inspector.plugin.toolkit.background_tasks import BackgroundTasks

from tests.numbers.synthetic import UTM33, wkt
from tests.qgis.conftest import wait_for_tasks
from tests.qgis.scenes import BLURRED, SHARP, Scene, outline, windows
from tests.qgis.seams.desk.session_desk import BLURRED_WINDOW, SHARP_WINDOW, Desk, settle

TOLD = ("windowsChanged", "selectionChanged", "inputsChanged", "progressChanged", "resultArrived")


class Listener:
    """What a session tells, and what a listener who asks at once is told of it."""

    def __init__(self, session: Session) -> None:
        self._session = session
        self.told: list[tuple[str, dict[int, str], list[int]]] = []
        self.outdated: list[str] = []
        for name in TOLD:
            getattr(session, name).connect(lambda *values, name=name: self._hear(name, values))

    def _hear(self, name: str, values: tuple[int, ...]) -> None:
        session = self._session
        rows = {row.fid: row.verdict for row in session.windows()}
        self.told.append((name, rows, session.selected()))
        if not set(session.selected()) <= set(rows):
            self.outdated.append(f"{name}: windows are selected that are not there")
        if name == "progressChanged" and values == (0, 0) and any(map(session.is_pending, rows)):
            self.outdated.append("all is done, but not written")
        if name == "resultArrived" and session.result(values[0]) is None:
            self.outdated.append("a result is told that is not there")

    def take(self, *names: str) -> list[tuple[list[str], list[int]]]:
        """The verdicts and the selection at each of these signals so far, which are forgotten."""
        settle()
        told, self.told = self.told, []
        return [(list(rows.values()), selected) for name, rows, selected in told if name in names]


@pytest.fixture
def reads(monkeypatch: pytest.MonkeyPatch) -> list[int]:
    """The feature ids of every window that is read from a layer."""
    read, found = window_layer.read_layer, []

    def counted(layer: QgsVectorLayer, fids: Any = None) -> list[Any]:
        rows = read(layer, fids)
        found.extend(row.fid for row in rows)
        return rows

    monkeypatch.setattr(window_layer, "read_layer", counted)
    return found


@pytest.mark.parametrize("clicks", [1, 2])
def test_from_a_click_to_the_flag_each_change_is_read_and_told_once(desk: Desk, reads: list[int], clicks: int) -> None:
    before = [desk.rows()[1].verdict for _ in range(clicks - 1) if desk.add(SHARP_WINDOW)]
    listener = Listener(desk.session)
    reads.clear()
    fid = desk.add(BLURRED_WINDOW)
    settle()
    told = [(name, list(rows.values()), chosen) for name, rows, chosen in listener.told if name in TOLD[:2]]
    assert told == [
        ("windowsChanged", [*before, ""], [fid]),
        ("selectionChanged", [*before, ""], [fid]),
        ("windowsChanged", [*before, "significant"], [fid]),
    ]
    assert reads == [fid, fid]  # once when it is drawn, once when its result is written


def test_edits_of_many_windows_are_told_once(desk: Desk, reads: list[int]) -> None:
    fids = [desk.add(SHARP_WINDOW), desk.add(BLURRED_WINDOW)]
    desk.session.select(fids)
    settle()
    listener = Listener(desk.session)
    for change, selected in (
        (lambda: desk.session.judge(fids, "visible"), fids),
        (lambda: desk.session.remove(fids), []),
        (desk.undo, fids),
    ):
        reads.clear()
        change()
        assert len(listener.take("windowsChanged")) == 1
        assert len(reads) == len(set(reads))
        assert set(desk.session.selected()) <= set(selected)
    assert not listener.outdated


def test_a_selection_is_told_at_once_and_only_when_it_is_another(desk: Desk) -> None:
    fid = desk.add()
    listener = Listener(desk.session)
    desk.session.select([])
    assert [selected for name, _, selected in listener.told if name == "selectionChanged"] == [[]]
    desk.session.select([])
    desk.layer().selectByIds([])
    assert listener.take("selectionChanged") == [(["significant"], [])]
    desk.layer().selectByIds([fid])
    assert listener.take("selectionChanged", "windowsChanged") == [(["significant"], [fid])]


def test_nothing_is_told_of_a_layer_without_windows(desk: Desk) -> None:
    listener = Listener(desk.session)
    empty = desk.use(windows())
    assert listener.take("windowsChanged", "selectionChanged") == []
    other = desk.use(windows(SHARP))
    assert set(map(str, listener.take("windowsChanged"))) == {str(([""], []))}
    other.selectByIds([1])
    desk.use(windows(BLURRED))
    listener.take()
    assert desk.session.selected() == []
    desk.session.set_inputs(desk.inputs(windows=empty.id()))
    assert listener.take("windowsChanged") == [([], [])]


def test_equal_ids_of_another_layer_are_another_selection(desk: Desk) -> None:
    first, second = desk.use(windows(SHARP)), desk.use(windows(BLURRED))
    for layer in (first, second):
        layer.selectByIds([1])
    desk.set(desk.inputs(windows=first.id()))
    settle()
    listener = Listener(desk.session)
    desk.set(desk.inputs(windows=second.id()))
    assert listener.take("selectionChanged") == [([""], [1])]


def test_keys_that_come_before_the_selection_is_told_are_not_lost(desk: Desk) -> None:
    desk.use(windows(SHARP, BLURRED, (64, 64, 64, 64)))
    desk.session.inspect_pending()
    desk.wait()
    desk.session.select([1])
    judging = Judging(desk.session)
    judging.judge("visible")
    judging.judge("invisible")
    judging.close()
    assert desk.session.selected() == [3]
    assert [row.observer for row in desk.session.windows()] == ["visible", "invisible", ""]


# No matter in which order signals were connected


class ReorderedSignal:
    """Stands for a pyqtSignal: its slots are called in the order in which they were connected, or the other way."""

    def __init__(self, turned: bool) -> None:
        self._turned = turned
        self._slots: dict[int, list[Any]] = {}

    def __get__(self, sender: QObject | None, _kind: type) -> Any:
        return self if sender is None else _BoundSignal(self._slots.setdefault(id(sender), []), self._turned, sender)


class _BoundSignal:
    def __init__(self, slots: list[Any], turned: bool, sender: QObject) -> None:
        self._slots, self._turned, self._sender = slots, turned, sender

    def connect(self, slot: Any) -> None:
        self._slots.append(slot)

    def disconnect(self, slot: Any) -> None:
        self._slots.remove(slot)

    def emit(self, *values: object) -> None:
        if not self._sender.signalsBlocked():
            for slot in self._slots[:: -1 if self._turned else 1]:
                (slot if callable(slot) else slot.emit)(*values)

    __call__ = emit


SIGNALS: dict[type, tuple[str, ...]] = {
    Session: ("inputsChanged", "windowsChanged", "selectionChanged", "resultArrived",
              "curvesArrived", "progressChanged", "messageRaised"),
    WindowWatch: ("windowsChanged", "selectionChanged", "replaced", "rolledBack"),
    WindowSteps: ("failed", "stepped"),
    WindowResults: ("arrived", "curvesArrived", "failed", "progressChanged"),
    NewWindows: ("layerMade", "drawn", "scanned", "told"),
    BlockCache: ("opened",),
    InputsWatch: ("layersChanged", "seamlinesEdited"),
    BackgroundTasks: ("progressChanged", "failed", "ended"),
}  # fmt: skip


@pytest.fixture(params=[False, True], ids=["as connected", "the other way"])
def reordered(
    request: Any, monkeypatch: pytest.MonkeyPatch, scene: Scene, project: Any, tmp_path: Path
) -> Iterator[Desk]:
    """A desk whose own signals reach their slots in one order or the other."""
    for kind, names in SIGNALS.items():
        for name in names:
            monkeypatch.setattr(kind, name, ReorderedSignal(request.param))
    made = Desk(scene, tmp_path)
    made.set(made.inputs())
    yield made
    made.session.close()
    wait_for_tasks()
    project.clear()


def test_no_behaviour_hangs_on_the_order_of_connections(reordered: Desk) -> None:
    desk = reordered
    listener, judging = Listener(desk.session), Judging(desk.session)
    bar = JudgeBar(desk.session, judging)
    fid = desk.add(BLURRED_WINDOW)
    assert listener.take("windowsChanged", "selectionChanged") == [
        ([""], [fid]), ([""], [fid]), (["significant"], [fid])
    ]  # fmt: skip
    assert bar.sentence().startswith("Significant loss.")
    desk.move(fid, outline(SHARP))
    assert set(map(str, listener.take("windowsChanged"))) == {str((["significant"], [fid]))}
    assert bar.sentence().endswith("Changed since: inspect it again.")
    desk.session.inspect_pending()
    desk.wait()
    assert listener.take("windowsChanged") == [(["preserved"], [fid])]
    desk.session.judge([fid], "visible")
    desk.undo()
    desk.undo()
    assert [(row.verdict, row.stale) for row in desk.session.windows()] == [("significant", True)]
    listener.take()
    desk.session.remove([fid])
    assert listener.take("windowsChanged", "selectionChanged") == [([], []), ([], [])]
    assert listener.outdated == []
    assert desk.messages == []


def test_another_data_source_is_taken_in_any_order(reordered: Desk, tmp_path: Path) -> None:
    desk = reordered
    desk.add(BLURRED_WINDOW)
    path = window_file.write_window_file(wkt(UTM33), tmp_path, window_file.window_fields(3))
    listener = Listener(desk.session)
    desk.layer().setDataSource(f"{path}|layername=windows", "other", "ogr")
    assert listener.take("windowsChanged") == [([], [])]
    assert desk.session.windows() == []
    assert listener.outdated == []


def test_a_new_project_tells_that_nothing_is_selected_any_more(desk: Desk) -> None:
    desk.session.select([desk.add()])
    listener = Listener(desk.session)
    desk.project.clear()
    assert listener.take("selectionChanged") == [([], [])]
    assert listener.outdated == []
