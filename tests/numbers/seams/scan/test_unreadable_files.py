"""Files that can't be read make no scan of 0 m: an error where nothing could be, else it is told and counted."""
from __future__ import annotations

import os
import warnings
from concurrent.futures import Executor, Future
from pathlib import Path
from typing import Any, Callable

import numpy as np
import pytest
from osgeo import gdal
from seam_inspector import SeamInspectorError, SeamInspectorWarning, limit_rules, open_block, scan
from seam_inspector.plugin.acceptance.measure.deciding import decide
from seam_inspector.plugin.acceptance.measure.delivered_rows import make_delivery
from seam_inspector.plugin.imagery.rasters import RasterRef
from seam_inspector.plugin.seams.measure.blocks.block_grid import BLOCK_PX
from seam_inspector.plugin.seams.measure.window.inspection import Block

from tests.numbers.synthetic import orthoimage, write_raster

ROWS, COLUMNS = 384, 2400  # two blocks
TILED = ["TILED=YES", "BLOCKXSIZE=256", "BLOCKYSIZE=256", "COMPRESS=DEFLATE"]


@pytest.fixture(scope="module")
def whole(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A mosaic cut hard out of two images along a line that runs across it."""
    folder = tmp_path_factory.mktemp("whole")
    north, south = (np.tile(orthoimage((ROWS, COLUMNS // 4), 1, seed), (1, 1, 4)) for seed in (1, 2))
    mosaic = np.where(np.arange(ROWS)[:, np.newaxis] < ROWS / 2, north, south)
    for name, pixels in (("mosaic", mosaic), ("north", north), ("south", south)):
        write_raster(folder / f"{name}.tif", pixels, options=TILED)
    (folder / "seam.geojson").write_text(
        '{"type": "FeatureCollection", "crs": {"type": "name", "properties": {"name": "EPSG:32633"}}, "features": ['
        '{"type": "Feature", "properties": {}, "geometry": {"type": "LineString", "coordinates": '
        "[[500000, 4999980.8], [500240, 4999980.8]]}}]}"
    )
    return folder


@pytest.fixture
def files(whole: Path, tmp_path: Path) -> Path:
    for path in whole.iterdir():
        (tmp_path / path.name).write_bytes(path.read_bytes())
    return tmp_path


def block_of(folder: Path) -> Block:
    return open_block(folder / "mosaic.tif", [folder / "north.tif", folder / "south.tif"])


def spoiled(path: Path, columns: int) -> None:
    """So many columns of its tiles are damaged, though it opens."""
    dataset = gdal.Open(str(path))
    band, held = dataset.GetRasterBand(1), bytearray(path.read_bytes())
    for column in range(columns):
        for row in range(-(-dataset.RasterYSize // 256)):
            offset = int(band.GetMetadataItem(f"BLOCK_OFFSET_{column}_{row}", "TIFF"))
            held[offset : offset + 40] = bytes(40)
    del band, dataset
    path.write_bytes(held)


@pytest.mark.parametrize("seamlines", ["", "seam.geojson"])
def test_a_mosaic_without_readable_pixels_is_an_error(files: Path, seamlines: str) -> None:
    block = block_of(files)
    spoiled(files / "mosaic.tif", -(-COLUMNS // 256))
    with pytest.raises(SeamInspectorError, match=r"Nothing of the mosaic mosaic\.tif could be read"):
        scan(block, seamlines=seamlines and files / seamlines)


def test_nor_is_one_that_is_gone_scanned_along_its_seamlines_alone(files: Path) -> None:
    block = open_block(files / "mosaic.tif")
    (files / "mosaic.tif").unlink()
    with pytest.raises(SeamInspectorError, match=r"Nothing of the mosaic mosaic\.tif could be read"):
        scan(block, seamlines=files / "seam.geojson")


def test_orthoimages_that_are_all_gone_are_an_error(files: Path) -> None:
    block = block_of(files)
    for name in ("north.tif", "south.tif"):
        (files / name).unlink()
    with pytest.raises(SeamInspectorError, match=r"No orthoimage could be read.*north\.tif does not exist"):
        scan(block)
    with pytest.warns(SeamInspectorWarning), pytest.raises(SeamInspectorError, match="None of the orthoimages can"):
        block_of(files)


class Elsewhere(Executor):
    """A worker that has another working folder and does not see some files."""

    def __init__(self, *unseen: Path) -> None:
        self._unseen = unseen

    def submit(self, work: Callable[..., Any], /, *given: Any, **named: Any) -> Future[Any]:
        done: Future[Any] = Future()
        before = os.getcwd()
        for path in self._unseen:
            path.rename(path.with_suffix(".unseen"))
        os.chdir("/")
        try:
            done.set_result(work(*given, **named))
        except Exception as error:
            done.set_exception(error)
        finally:
            os.chdir(before)
            for path in self._unseen:
                path.with_suffix(".unseen").rename(path)
        return done


@pytest.mark.parametrize(
    ("unseen", "said"), [(["mosaic"], "Nothing of the mosaic"), (["north", "south"], "No orthoimage could be read")]
)
def test_files_that_no_worker_sees_are_an_error(files: Path, unseen: list[str], said: str) -> None:
    with pytest.raises(SeamInspectorError, match=said):
        scan(block_of(files), executor=Elsewhere(*(files / f"{name}.tif" for name in unseen)))


@pytest.mark.slow
def test_relative_paths_are_found_from_another_folder(files: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(files)
    block = open_block("mosaic.tif", ["north.tif", "south.tif"])
    assert RasterRef("mosaic.tif", parts=("north.tif",)).paths == (str(files / "mosaic.tif"), str(files / "north.tif"))
    assert RasterRef("/vsicurl/none").path == "/vsicurl/none"
    result = scan(block, executor=Elsewhere())
    assert result.seam_metres == pytest.approx(COLUMNS / 10, rel=0.02)


@pytest.mark.slow
def test_what_can_not_be_read_is_told_and_not_called_unexplained(files: Path) -> None:
    """The first of its two blocks."""
    spoiled(files / "mosaic.tif", 2)
    result = scan(block_of(files))
    notices = [str(notice) for notice in result.notices]
    assert any("mosaic.tif is damaged" in text or "pixels of mosaic.tif can't be read" in text for text in notices)
    assert any("of the mosaic could not be read, for example around" in text for text in notices)
    assert float(result.told["unread"]) == pytest.approx(BLOCK_PX / COLUMNS, abs=0.01)
    x, y = map(float, result.told["unread_at"].split())
    assert 500000 < x < 500000 + BLOCK_PX / 10
    assert 4999961 < y < 5000000
    assert result.told["unexplained"] == "0.0000"
    along = scan(block_of(files), seamlines=files / "seam.geojson")
    assert float(along.told["unread"]) > 0
    alone = scan(open_block(files / "mosaic.tif"), seamlines=files / "seam.geojson")
    assert float(alone.told["unread"]) > 0


@pytest.mark.slow
def test_all_that_was_read_is_not_told(files: Path) -> None:
    assert "unread" not in scan(block_of(files)).told


def test_a_sheet_of_which_nothing_is_known_leaves_the_decision_open(files: Path) -> None:
    """Its scan failed, or measured nothing."""
    good = [
        {"seam_id": 1, "station": 10.0 * place, "length": 10.0, "kept_1": 0.97, "kept_low": 0.93, "kept_high": 1.02,
         "verdict": "preserved", "geometry": f"LINESTRING ({10 * place} 0, {10 * place + 10} 0)"}
        for place in range(60)
    ]
    unmeasured = [{**row, "kept_1": None, "verdict": "not_comparable", "geometry": row["geometry"].replace(" 0", " 99")}
                  for row in good[:5]]
    rules = limit_rules()
    assert decide(make_delivery({"good": good}, ""), rules).accepted
    for rows in ([], unmeasured):
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", SeamInspectorWarning)
            decision = decide(make_delivery({"good": good, "broken": rows}, ""), rules)
        assert decision.accepted is None
        assert "sheets of which nothing was measured: 1 (broken)" in str(decision.sentences[0])
