"""What the session tells from a click to the flag: each change once, in an order that listeners can rely on."""
from __future__ import annotations

from typing import Any

import pytest
from qgis.core import QgsVectorLayer
from seam_inspector.plugin.seams.desk.session import Session
from seam_inspector.plugin.seams.tables import window_layer

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
        calls, self.told = self.told, []
        return [(list(rows.values()), selected) for name, rows, selected in calls if name in names]


@pytest.fixture
def reads(monkeypatch: pytest.MonkeyPatch) -> list[int]:
    """The feature ids of every window that is read from a layer."""
    read, items = window_layer.read_layer, []

    def counted(layer: QgsVectorLayer, fids: Any = None) -> list[Any]:
        rows = read(layer, fids)
        items.extend(row.fid for row in rows)
        return rows

    monkeypatch.setattr(window_layer, "read_layer", counted)
    return items


@pytest.mark.parametrize("clicks", [1, 2])
def test_from_a_click_to_the_flag_each_change_is_read_and_told_once(desk: Desk, reads: list[int], clicks: int) -> None:
    before = [desk.rows()[1].verdict for _ in range(clicks - 1) if desk.add(SHARP_WINDOW)]
    listener = Listener(desk.session)
    reads.clear()
    fid = desk.add(BLURRED_WINDOW)
    settle()
    messages = [(name, list(rows.values()), chosen) for name, rows, chosen in listener.told if name in TOLD[:2]]
    assert messages == [
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


# No matter in which order signals were connected


def test_a_new_project_tells_that_nothing_is_selected_any_more(desk: Desk) -> None:
    desk.session.select([desk.add()])
    listener = Listener(desk.session)
    desk.project.clear()
    assert listener.take("selectionChanged") == [([], [])]
    assert listener.outdated == []
