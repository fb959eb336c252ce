"""The window under the mouse: live curves, measured ahead where the mouse rests, files let go."""
from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest
from seam_inspector.plugin.imagery.grids import PixelWindow
from seam_inspector.plugin.seams.desk.charts.curves_tab import CurvesAndProfile
from seam_inspector.plugin.seams.measure.window import measured_window

from tests.numbers.synthetic import write_raster
from tests.qgis.scenes import BLURRED, whole
from tests.qgis.seams.desk.session_desk import BLURRED_WINDOW, Desk, settle, wait_until

ACROSS = PixelWindow(BLURRED[0] + 8, BLURRED[1] + 8, 64, 64)


def test_curves_follow_the_mouse_and_end_with_it(desk: Desk) -> None:
    session, emitted = desk.session, []
    session.liveChanged.connect(lambda: emitted.append(session.live))
    assert session.live is None
    for window in (BLURRED_WINDOW, ACROSS):
        session.hover(window, is_live=True)
        wait_until(lambda window=window: session.live is not None and session.live.window == window)
    clips = session.live.clips.clips
    assert [clip.raster for clip in clips] == ["mosaic.tif", "west.tif", "east.tif"]
    assert [list(clip.curves) for clip in clips] == [["luminance"]] * 3
    session.leave()
    assert session.live is None
    assert emitted[-1] is None
    count = len(emitted)
    settle(0.3)
    assert len(emitted) == count
    assert session.windows() == []
    assert desk.messages == []


def test_a_click_where_the_mouse_rested_reads_nothing_again(desk: Desk, monkeypatch: pytest.MonkeyPatch) -> None:
    measured: list[PixelWindow] = []
    measure = measured_window.measure_window

    def counted(request: Any, *others: Any) -> Any:
        measured.append(request.window)
        return measure(request, *others)

    monkeypatch.setattr(measured_window, "measure_window", counted)
    session = desk.session
    session.hover(BLURRED_WINDOW, is_live=False)
    wait_until(lambda: measured == [BLURRED_WINDOW])
    assert session.live is None
    session.leave()
    session.add_window(BLURRED_WINDOW)
    desk.wait()
    assert measured == [BLURRED_WINDOW]
    assert desk.rows()[1].verdict == "significant"
    session.add_window(ACROSS)
    desk.wait()
    assert measured == [BLURRED_WINDOW, ACROSS]


@pytest.mark.parametrize("is_live", [True, False])
def test_where_the_mouse_rests_it_is_known_whether_anything_can_be_compared(
    desk: Desk, tmp_path: Path, is_live: bool
) -> None:
    pixels = whole(Path(desk.mosaic.source()))
    pixels[..., :70, :] = 0
    desk.mosaic = desk.raster(Path(write_raster(tmp_path / "holed.tif", pixels, nodata=0)))
    desk.set(desk.inputs())
    session, emitted, holed = desk.session, [], PixelWindow(0, 0, 128, 128)
    session.liveChanged.connect(lambda: emitted.append(session.is_useless(holed)))
    session.liveChanged.connect(lambda: session.hover(holed, is_live))  # as the tool does
    session.hover(holed, is_live)
    wait_until(lambda: session.is_useless(holed))
    settle(0.3)
    assert emitted.count(True) == 1
    session.liveChanged.disconnect()
    session.hover(PixelWindow(320, 72, 128, 128), is_live)
    wait_until(lambda: not session.is_useless(holed))
    assert not session.is_useless(PixelWindow(320, 72, 128, 128))


def test_the_charts_show_what_is_live_then_the_selected_window_again(desk: Desk) -> None:
    session, panel = desk.session, CurvesAndProfile(desk.session)
    panel.resize(400, 700)
    panel.show()
    fid = desk.add(BLURRED_WINDOW)
    wait_until(lambda: panel.curves.shown == [session.result(fid)])
    idle = panel.curves._status.text()
    session.hover(ACROSS, is_live=True)
    wait_until(lambda: session.live is not None and panel.curves.shown == [session.live.clips])
    assert panel.curves._status.text() == "Live: 64 x 64 px"
    assert not panel.curves._save.isEnabled()
    session.leave()
    wait_until(lambda: panel.curves.shown == [session.result(fid)])
    assert panel.curves._status.text() == idle
    assert panel.profile.chart.isEnabled()
    panel.close()
