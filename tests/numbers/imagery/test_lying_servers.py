"""Web servers that promise bytes that never come, or send without an end: one sentence, and whoever cancels is free."""
from __future__ import annotations

import threading
import time
from pathlib import Path

import numpy as np
import pytest
from seam_inspector.plugin.imagery import remote_files
from seam_inspector.plugin.imagery.errors import CancelledError, RasterError
from seam_inspector.plugin.imagery.open_raster import OpenRaster
from seam_inspector.plugin.imagery.raster_pool import ReadingLanes, open_raster
from seam_inspector.plugin.imagery.rasters import RasterRef
from seam_inspector.plugin.imagery.remote_files import heeding, wait_for_left_alone

from tests.numbers.imagery.conftest import WINDOW, expected
from tests.range_server import Fault, RangeServer

pytestmark = [pytest.mark.slow, pytest.mark.usefixtures("one_second")]

LIES = {
    "a byte more": Fault(claimed=1), "a kilobyte more": Fault(claimed=1000), "a petabyte more": Fault(claimed=10**15),
    "no end": Fault(endless=True), "a byte a second": Fault(dripping=1.0),
}  # fmt: skip
SOON_S = 2.0


@pytest.fixture
def one_second(monkeypatch: pytest.MonkeyPatch) -> None:
    """Without an answer is long enough, and two for one."""
    monkeypatch.setitem(remote_files.SETTINGS, "GDAL_HTTP_LOW_SPEED_TIME", "1")
    monkeypatch.setitem(remote_files.SETTINGS, "GDAL_HTTP_TIMEOUT", "2")
    monkeypatch.setattr(remote_files, "PATIENCE_S", 1.0)
    monkeypatch.setattr(remote_files, "DELAYS_S", (0.1,))


@pytest.mark.parametrize("lie", LIES)
def test_a_server_that_lies_costs_no_pixel_and_has_an_end(server: RangeServer, folder: Path, lie: str) -> None:
    raster = open_raster(RasterRef(server.vsi("cog.tif")))
    server.fault = lambda asked: LIES[lie]
    if LIES[lie].claimed:  # all that is needed comes
        np.testing.assert_array_equal(raster.read(WINDOW).bands, expected(folder))
    else:
        with pytest.raises(RasterError, match=r"cog\.tif"):
            raster.read(WINDOW)


class Cancelling:
    """Says so after half a second."""

    def __init__(self) -> None:
        self.since = time.monotonic() + 0.5

    def __call__(self) -> bool:
        return time.monotonic() > self.since


@pytest.mark.parametrize("lie", LIES)
@pytest.mark.parametrize("way", ["alone", "kept", "by others"])
def test_who_cancels_is_free(server: RangeServer, lie: str, way: str, monkeypatch: pytest.MonkeyPatch) -> None:
    for name in ("GDAL_HTTP_LOW_SPEED_TIME", "GDAL_HTTP_TIMEOUT"):
        monkeypatch.setitem(remote_files.SETTINGS, name, "10")
    ref = RasterRef(server.vsi("cog.tif"))
    lanes = ReadingLanes(1)
    raster = OpenRaster(ref) if way == "alone" else open_raster(ref) if way == "kept" else None
    if raster is None:
        lanes([(ref, lambda one: one.columns)])
    server.fault = lambda asked: LIES[lie]
    cancelled = Cancelling()
    with heeding(cancelled), pytest.raises((CancelledError, RasterError)):  # GDAL refuses some answers at once
        raster.read(WINDOW) if raster else lanes([(ref, lambda one: one.read(WINDOW))])
    assert time.monotonic() < cancelled.since + SOON_S
    server.closing.set()
    lanes.close()
    wait_for_left_alone()


def test_threads_that_are_left_alone_end(server: RangeServer) -> None:
    raster = OpenRaster(RasterRef(server.vsi("cog.tif")))
    server.fault = lambda asked: Fault(silent=True)
    with heeding(Cancelling()), pytest.raises(CancelledError):
        raster.read(WINDOW)
    assert any(one.name.startswith("seam-inspector-network") for one in threading.enumerate())
    wait_for_left_alone()  # GDAL's own limit, a second here
    last = time.monotonic() + 5
    while any(one.name.startswith("seam-inspector-network") for one in threading.enumerate()):
        assert time.monotonic() < last
        time.sleep(0.05)
