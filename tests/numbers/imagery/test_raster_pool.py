"""Rasters stay open from one read to the next, few of them, and none that is broken or out of date."""
from __future__ import annotations

import os
import threading
from pathlib import Path

import numpy as np
import pytest
from seam_inspector.plugin.imagery.errors import RasterError
from seam_inspector.plugin.imagery.grids import PixelWindow
from seam_inspector.plugin.imagery.raster_pool import KEPT_OPEN, open_raster, rasters_kept
from seam_inspector.plugin.imagery.rasters import RasterRef

from tests.numbers.conftest import MakeRaster
from tests.numbers.synthetic import orthoimage

WINDOW = PixelWindow(0, 0, 64, 64)


def open_files(folder: Path) -> list[str]:
    """The files of a folder that this process has open, by the system's word."""
    handles = Path("/proc/self/fd")
    if not handles.is_dir():
        pytest.skip("this system does not tell which files are open")
    paths = [os.readlink(handle) for handle in handles.iterdir() if handle.is_symlink()]
    return sorted(path for path in paths if path.startswith(str(folder)))


def test_a_raster_is_opened_once_and_closed_with_the_run(make_raster: MakeRaster, tmp_path: Path) -> None:
    ref = RasterRef(make_raster("a.tif", orthoimage((64, 64))))
    with rasters_kept():
        first = open_raster(ref)
        assert open_raster(RasterRef(ref.path)) is first
        del first
        assert open_files(tmp_path) == [ref.path]
    assert open_files(tmp_path) == []


def test_few_stay_open_those_used_last(make_raster: MakeRaster, tmp_path: Path) -> None:
    refs = [RasterRef(make_raster(f"{n:02}.tif", orthoimage((64, 64)))) for n in range(KEPT_OPEN + 4)]
    with rasters_kept():
        for ref in refs:
            open_raster(ref).read(WINDOW)
            open_raster(refs[0]).read(WINDOW)
        assert open_files(tmp_path) == [ref.path for ref in (refs[0], *refs[-KEPT_OPEN + 1:])]


def test_each_thread_has_its_own_and_the_end_of_the_run_closes_all(make_raster: MakeRaster, tmp_path: Path) -> None:
    ref = RasterRef(make_raster("a.tif", orthoimage((64, 64))))
    opened, go_on = threading.Barrier(3), threading.Event()
    ids: list[int] = []

    def work() -> None:
        ids.append(id(open_raster(ref)))
        opened.wait(10)
        go_on.wait(10)

    threads = [threading.Thread(target=work) for _ in range(2)]
    with rasters_kept():
        for thread in threads:
            thread.start()
        opened.wait(10)
        assert open_files(tmp_path) == [ref.path] * 2
    assert open_files(tmp_path) == []  # though the threads live on, as the ones of a cluster's worker do
    go_on.set()
    for thread in threads:
        thread.join(10)
    assert len(set(ids)) == 2


def test_a_file_that_was_replaced_is_opened_anew(make_raster: MakeRaster) -> None:
    ref = RasterRef(make_raster("a.tif", orthoimage((64, 64), seed=1)))
    newer = orthoimage((64, 64), seed=2)
    with rasters_kept():
        open_raster(ref).read(WINDOW)
        os.replace(make_raster("b.tif", newer), ref.path)
        np.testing.assert_array_equal(open_raster(ref).read(WINDOW).bands, newer)


def test_one_that_can_not_be_read_is_not_kept(make_raster: MakeRaster, tmp_path: Path) -> None:
    path = make_raster("a.tif", orthoimage((512, 512)))
    size = os.path.getsize(path)
    with open(path, "r+b") as file:
        file.truncate(size // 2)
    with rasters_kept():
        raster = open_raster(RasterRef(path))
        raster.read(WINDOW)
        with pytest.raises(RasterError, match=r"a\.tif can't be read"):
            raster.read(PixelWindow(0, 0, 512, 512))
        assert open_raster(RasterRef(path)) is not raster
