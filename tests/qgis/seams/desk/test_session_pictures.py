"""The pictures of a session: read in the background, kept for a while, dropped when they are of something else."""
from __future__ import annotations

import time
from collections.abc import Callable
from dataclasses import replace

import numpy as np
import pytest
from seam_inspector.plugin.imagery.grids import PixelWindow
from seam_inspector.plugin.seams import jobs
from seam_inspector.plugin.seams.clip_pictures import PictureRequest, WindowPictureSet, make_pictures
from seam_inspector.plugin.seams.desk.images import window_pictures

from tests.qgis.scenes import outline, windows
from tests.qgis.seams.desk.session_desk import SHARP_WINDOW, Desk, wait_for_tasks, wait_until


def test_pictures_arrive_and_are_dropped_when_the_window_moves(desk: Desk) -> None:
    fid = desk.add()
    arrived: list[int] = []
    desk.session.picturesArrived.connect(arrived.append)
    assert desk.session.pictures(fid) is None
    wait_until(lambda: arrived == [fid])
    pictures = desk.session.pictures(fid)
    assert pictures is not None
    assert [(picture.raster, picture.is_mosaic) for picture in pictures] == [
        ("mosaic.tif", True), ("west.tif", False), ("east.tif", False),
    ]  # fmt: skip
    desk.layer().changeGeometry(fid, outline((200, 64, 64, 128)))
    assert desk.session.pictures(fid) is None
    wait_until(lambda: len(arrived) == 2)
    assert desk.session.pictures(fid)[0].pixels.shape == (384, 384, 3)  # type: ignore[index]
    assert desk.session.pictures(fid)[0].inside == PixelWindow(160, 128, 64, 128)  # type: ignore[index]
    desk.session.set_inputs(replace(desk.session.inputs, sources=desk.session.inputs.sources[:1]))
    assert desk.session.pictures(fid) is None
    wait_until(lambda: len(arrived) == 3)
    assert len(desk.session.pictures(fid) or ()) == 2


def test_pictures_of_the_window_asked_for_last_arrive(desk: Desk) -> None:
    fids = [desk.add(), desk.add(SHARP_WINDOW)]
    arrived: list[int] = []
    desk.session.picturesArrived.connect(arrived.append)
    for fid in (*fids, *fids, *fids):
        assert desk.session.pictures(fid) is None
    wait_until(lambda: fids[1] in arrived)
    assert len(desk.session.pictures(fids[1]) or ()) == 3
    wait_for_tasks()
    assert desk.session.pictures(fids[1])


def test_pictures_that_were_cancelled_midway_are_not_taken_for_none(
    desk: Desk, monkeypatch: pytest.MonkeyPatch
) -> None:
    fids = [desk.add(), desk.add(SHARP_WINDOW)]
    waiting: list[int] = []

    def slow(request: PictureRequest, cancelled: Callable[[], bool]) -> WindowPictureSet:
        waiting.append(request.window.window_id)
        while len(waiting) == 1 and not cancelled():
            time.sleep(0.001)
        return make_pictures(request, cancelled)

    monkeypatch.setattr(jobs, "make_pictures", slow)
    counts: list[int] = []
    desk.session.picturesArrived.connect(lambda fid: counts.append(len(desk.session.pictures(fid) or ())))
    assert desk.session.pictures(fids[0]) is None
    wait_until(lambda: waiting)
    assert desk.session.pictures(fids[1]) is None
    assert desk.session.pictures(fids[0]) is None
    wait_for_tasks()
    assert set(counts) == {3}


def test_pictures_that_cant_be_read_are_none(desk: Desk) -> None:
    desk.use(windows((-400, -400, 64, 64)))
    arrived: list[int] = []
    desk.session.picturesArrived.connect(arrived.append)
    assert desk.session.pictures(1) is None
    wait_until(lambda: arrived == [1])
    assert desk.session.pictures(1) == ()


def test_the_composite_of_a_window(desk: Desk) -> None:
    """Between the sharp half and the blurred one: it is sharp in both, and in the mosaic's tones."""
    fid = desk.add(PixelWindow(192, 64, 128, 128))
    wait_until(lambda: desk.session.pictures(fid))
    wait_until(lambda: desk.session.composite(fid) is not None)
    mosaic = desk.session.pictures(fid)[0]  # type: ignore[index]
    (composite,) = desk.session.composite(fid) or ()
    assert composite.is_composite
    assert composite.inside == mosaic.inside == PixelWindow(128, 128, 128, 128)
    around = np.ones(mosaic.pixels.shape[:2], bool)
    around[128:256, 128:256] = False
    assert np.array_equal(composite.pixels[around], mosaic.pixels[around])
    grey = [one.pixels[128:256, 192:256].astype(float).mean(axis=2) for one in (mosaic, composite)]
    assert abs(grey[0].mean() - grey[1].mean()) < 3
    assert np.diff(grey[1]).std() > 1.2 * np.diff(grey[0]).std()


def test_another_stretch_makes_other_pictures(desk: Desk) -> None:
    fid = desk.add()
    wait_until(lambda: desk.session.pictures(fid))
    delivered = desk.session.pictures(fid)
    desk.session.set_inputs(replace(desk.session.inputs, stretch="common"))
    assert desk.session.pictures(fid) is None
    wait_until(lambda: desk.session.pictures(fid))
    common = desk.session.pictures(fid)
    assert common[0].pixels.std() > delivered[0].pixels.std()  # type: ignore[index]
    assert not desk.session.row(fid).stale  # type: ignore[union-attr]
    desk.session.set_inputs(replace(desk.session.inputs, stretch="delivered"))
    assert desk.session.pictures(fid) is delivered


def test_as_many_pictures_are_kept_as_there_is_room_for(desk: Desk, monkeypatch: pytest.MonkeyPatch) -> None:
    drawn = windows(*((64 * number, 0, 64, 64) for number in range(6)))
    desk.use(drawn)

    def kept() -> list[bool]:
        for fid in range(1, 7):
            wait_until(lambda fid=fid: desk.session.pictures(fid))  # type: ignore[misc]
        wait_for_tasks()
        return [_is_kept(desk, fid) for fid in range(1, 7)]

    assert kept() == [True] * 6
    of_one = 3 * (384 * 384 + 192 * 192) * 3
    monkeypatch.setattr(window_pictures, "_MOST_BYTES", 2 * of_one)
    desk.session.set_inputs(replace(desk.session.inputs, wavelet="db4"))
    assert kept() == [False] * 4 + [True] * 2
    monkeypatch.setattr(window_pictures, "_MOST_BYTES", 1)  # the one that is shown is kept whatever its size
    desk.session.set_inputs(replace(desk.session.inputs, wavelet="db3"))
    assert kept() == [False] * 5 + [True]


def _is_kept(desk: Desk, fid: int) -> bool:
    row = desk.session.row(fid)
    assert row is not None
    return desk.session._pictures._key(row) in desk.session._pictures._kept
