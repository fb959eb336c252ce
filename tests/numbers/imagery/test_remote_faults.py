"""Rasters over the network: faults that pass cost nothing but time, those that stay are named."""
from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from osgeo import gdal
from seam_inspector.plugin.imagery import gdal_paths
from seam_inspector.plugin.imagery.errors import RasterError
from seam_inspector.plugin.imagery.grids import PixelWindow
from seam_inspector.plugin.imagery.raster_pool import open_raster, rasters_kept
from seam_inspector.plugin.imagery.rasters import RasterRef

from tests.numbers.imagery.conftest import SIDE, WHOLE, WINDOW, expected, read
from tests.range_server import NONE, Answer, Fault, RangeServer, serving


def first(count: int, fault: Fault, method: str = "") -> Callable[[Answer], Fault]:
    """The fault for so many requests."""
    left = [count]

    def choose(asked: Answer) -> Fault:
        if method not in ("", asked.method) or not left[0]:
            return NONE
        left[0] -= 1
        return fault

    return choose


PASSING = [Fault(status=503), Fault(status=500), Fault(status=429), Fault(dropped=True), Fault(cut_to=0.5)]


@pytest.mark.slow
@pytest.mark.parametrize("fault", PASSING, ids=["503", "500", "429", "dropped", "cut"])
@pytest.mark.parametrize("count", [1, 3])
def test_a_fault_while_reading_that_passes_costs_nothing(
    server: RangeServer, folder: Path, fault: Fault, count: int
) -> None:
    raster = open_raster(RasterRef(server.vsi("cog.tif")))
    server.fault = first(count, fault)
    np.testing.assert_array_equal(raster.read(WINDOW).bands, expected(folder))


@pytest.fixture
def one_second(monkeypatch: pytest.MonkeyPatch) -> None:
    """Without an answer is long enough."""
    monkeypatch.setitem(gdal_paths.SETTINGS, "GDAL_HTTP_LOW_SPEED_TIME", "1")


@pytest.mark.usefixtures("one_second")
def test_no_answer_once_is_asked_again(server: RangeServer, folder: Path) -> None:
    server.fault = first(1, Fault(silent=True), "GET")
    np.testing.assert_array_equal(read(server.vsi("cog.tif")), expected(folder))


@pytest.mark.slow
@pytest.mark.parametrize(
    ("fault", "why"),
    [(Fault(status=404), "HTTP 404"), (Fault(status=403), "HTTP 403"), (Fault(status=503), "HTTP 503"),
     (Fault(status=418), "HTTP 418"), (Fault(dropped=True), "Empty reply from server")],
)  # fmt: skip
@pytest.mark.parametrize("while_reading", [False, True])
@pytest.mark.usefixtures("either_gdal")
def test_a_fault_that_stays_is_named_and_not_asked_for_by_each_block(
    server: RangeServer, fault: Fault, why: str, while_reading: bool
) -> None:
    ref = RasterRef(server.vsi("cog.tif") + "?token=secret")
    if while_reading:
        open_raster(ref)
    server.fault = lambda asked: fault
    with pytest.raises(RasterError) as caught:
        open_raster(ref).read(WINDOW)
    assert str(caught.value).startswith(f"cog.tif can't be read over the network ({why}); check its address, ")
    assert "secret" not in str(caught.value)
    server.forget()
    with pytest.raises(RasterError, match=r"server|network"):
        open_raster(ref).read(WINDOW)
    assert server.answers == []
    server.fault = lambda asked: NONE
    with rasters_kept():  # the end of a run forgets it
        pass
    read(ref.path)


def test_what_is_gone_or_refused_is_asked_for_in_one_attempt(server: RangeServer) -> None:
    with pytest.raises(RasterError):
        read(server.vsi("gone.tif"))
    assert len(server.answers) <= 3  # GDAL's own and ours for the cause


@pytest.mark.slow
@pytest.mark.usefixtures("one_second")
def test_a_silent_server_is_named(server: RangeServer) -> None:
    server.fault = lambda asked: Fault(silent=True)
    with pytest.raises(RasterError, match=r"cog\.tif can't be read over the network \(Operation too slow"):
        read(server.vsi("cog.tif"))
    assert len(server.answers) <= 4, server.answers  # each of them is waited for


LIES = {
    "a byte more": Fault(claimed=1), "a kilobyte more": Fault(claimed=1000), "a petabyte more": Fault(claimed=10**15),
    "no end": Fault(endless=True), "a byte a second": Fault(dripping=1.0),
}  # fmt: skip


@pytest.mark.slow
@pytest.mark.usefixtures("one_second")
@pytest.mark.parametrize("lie", LIES)
def test_a_server_that_lies_costs_no_pixel_and_has_an_end(
    server: RangeServer, folder: Path, lie: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setitem(gdal_paths.SETTINGS, "GDAL_HTTP_TIMEOUT", "2")
    raster = open_raster(RasterRef(server.vsi("cog.tif")))
    server.fault = lambda asked: LIES[lie]
    if LIES[lie].claimed:  # all that is needed comes
        np.testing.assert_array_equal(raster.read(WINDOW).bands, expected(folder))
    else:
        with pytest.raises(RasterError, match=r"cog\.tif"):
            raster.read(WINDOW)


def test_nobody_at_that_address_is_named() -> None:
    with serving(Path()) as gone:
        path = gone.vsi("a.tif")
    with rasters_kept(), pytest.raises(RasterError, match=r"a\.tif can't be read over the network \(.*onnect.*\)"):
        read(path)


def test_a_file_that_is_truncated_there_is_named_and_its_whole_part_can_be_read(server: RangeServer) -> None:
    path = server.vsi("short.tif")
    read(path, PixelWindow(0, 0, 64, 64))
    with pytest.raises(RasterError, match=r"The pixels of short\.tif can't be read; the file may be truncated"):
        read(path, WHOLE)


def test_a_part_of_a_vrt_that_is_gone_is_named_and_costs_its_place_only(
    server: RangeServer, folder: Path, tmp_path: Path
) -> None:
    path = str(tmp_path / "two.vrt")
    gdal.BuildVRT(path, [server.vsi("cog.tif")]).FlushCache()
    text = Path(path).read_text()
    start, end = text.index("<ComplexSource>" if "<ComplexSource>" in text else "<SimpleSource>"), 0
    end = text.index("Source>", text.index("</", text.index("DstRect", start))) + len("Source>")
    part = text[start:end]
    half = SIDE // 2
    parts = [
        part.replace(f'DstRect xOff="0" yOff="0" xSize="{SIDE}"', f'DstRect xOff="{x}" yOff="0" xSize="{half}"')
        .replace(f'SrcRect xOff="0" yOff="0" xSize="{SIDE}"', f'SrcRect xOff="{x}" yOff="0" xSize="{half}"')
        .replace("/cog.tif", name)
        for x, name in ((0, "/cog.tif"), (half, "/gone.tif"))
    ]
    Path(path).write_text(text.replace(part, "".join(parts)))
    left = PixelWindow(0, 0, 300, 300)
    np.testing.assert_array_equal(read(path, left), expected(folder, window=left))
    with pytest.raises(RasterError, match=r"gone\.tif can't be read over the network \(HTTP 404\)"):
        read(path, WHOLE)
    np.testing.assert_array_equal(read(path, left), expected(folder, window=left))
