"""What makes a scan start anew, and what does not."""
from __future__ import annotations

from contextlib import suppress
from pathlib import Path

import pytest
from osgeo import gdal
from seam_inspector.plugin.imagery.atomic_files import drop_unfinished, replacing
from seam_inspector.plugin.imagery.open_raster import describe
from seam_inspector.plugin.imagery.rasters import RasterRef
from seam_inspector.plugin.seams.measure.scan.block_runs import ScanInputs

from tests.numbers.synthetic import orthoimage, write_raster


@pytest.fixture
def mosaic(tmp_path: Path) -> Path:
    return Path(write_raster(tmp_path / "mosaic.tif", orthoimage((64, 64))))


def fingerprint_of(mosaic: Path) -> str:
    return ScanInputs(describe(RasterRef(str(mosaic))), []).fingerprint(None)


def test_statistics_that_are_written_beside_a_mosaic_change_nothing(mosaic: Path) -> None:
    """QGIS writes them when it first shows a raster, in the middle of a scan perhaps."""
    before = fingerprint_of(mosaic)
    dataset = gdal.Open(str(mosaic))
    dataset.GetRasterBand(1).ComputeStatistics(False)
    dataset.GetRasterBand(2).GetDefaultHistogram(force=True)
    del dataset
    assert "STATISTICS_MEAN" in mosaic.with_name("mosaic.tif.aux.xml").read_text(encoding="utf-8")
    assert fingerprint_of(mosaic) == before


@pytest.mark.parametrize("written", [[], [""], ["", ".aux.xml"]], ids=len)
@pytest.mark.parametrize("name", ["loss.tif", f"{'n' * 240}.tif"], ids=len)
def test_what_a_killed_scan_left_goes_and_nothing_else(tmp_path: Path, name: str, written: list[str]) -> None:
    """At whatever moment it was killed: before the first file, or after the last was moved to its place."""
    with suppress(FileNotFoundError), replacing(tmp_path / name) as killed, replacing(tmp_path / "else.tif") as other:
        for ending in written:
            killed.with_name(f"{name}{ending}").write_bytes(b"half")
        drop_unfinished(tmp_path / name)
        assert list(tmp_path.iterdir()) == [other.parent]
