"""Results of thousands of windows: only some are held in memory; whoever asks for another one gets it all the same."""
from __future__ import annotations

import pytest
from qgis.core import QgsVectorLayer
from seam_inspector.plugin.imagery.grids import PixelWindow
from seam_inspector.plugin.seams.desk.windows import window_results
from seam_inspector.plugin.seams.measure.window.window_result import WindowResult

from tests.qgis.scenes import COLUMNS
from tests.qgis.seams.desk.session_desk import Desk, wait_until

WINDOWS = [PixelWindow(COLUMNS // 2 - 64, 20 * number, 128, 128) for number in range(6)]
HELD = 2


@pytest.fixture
def results(desk: Desk, monkeypatch: pytest.MonkeyPatch) -> dict[int, WindowResult]:
    """Results by feature id, of six windows of which two are held, as they came."""
    monkeypatch.setattr(window_results, "MOST_HELD", HELD)
    desk.set(desk.inputs(reference="sources"))  # of such small windows there is too little ground for the seam's
    found: dict[int, WindowResult] = {}

    def take(fid: int) -> None:
        result = desk.session.result(fid)
        assert result is not None
        found[fid] = result

    desk.session.resultArrived.connect(take)
    for window in WINDOWS:
        desk.add(window)
    desk.session.resultArrived.disconnect(take)
    return found


def held(desk: Desk, results: dict[int, WindowResult]) -> list[int]:
    """Those whose result is still the same object: of the others another one is read."""
    return [fid for fid, result in results.items() if desk.session.result(fid) is result]


def test_what_is_not_held_is_read_again(desk: Desk, results: dict[int, WindowResult]) -> None:
    assert len(results) == len(WINDOWS)
    for fid, result in results.items():
        assert desk.session.result(fid) == result
    assert len(held(desk, results)) <= HELD
    assert len(desk.session.source_uses()) == len(WINDOWS)  # what they say of the sources stays


def test_nothing_is_let_go_that_stands_in_no_file(desk: Desk, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(window_results, "MOST_HELD", HELD)
    layer = QgsVectorLayer("Polygon?crs=EPSG:32633", "in memory", "memory")
    desk.use(layer)
    for window in WINDOWS:
        desk.add(window)
    assert all(desk.session.result(row.fid) is not None for row in desk.session.windows())


def test_undo_and_redo_bring_back_values_of_results_that_are_not_held(
    desk: Desk, results: dict[int, WindowResult]
) -> None:
    row = desk.session.windows()[0]
    desk.session.remove([row.fid])
    assert len(desk.session.windows()) == len(WINDOWS) - 1
    desk.undo()
    wait_until(lambda: any(one.window_id == row.window_id and one.verdict for one in desk.session.windows()))
    back = next(one for one in desk.session.windows() if one.window_id == row.window_id)
    assert back.measured == row.measured
    assert desk.session.result(back.fid) == results[row.fid]
