"""The real QGIS desktop on eight real orthoimages. Figures are printed: `pytest -s`."""
from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from osgeo import gdal

from tests.desktop.conftest import assert_no_stall, played

pytestmark = pytest.mark.release


def test_windows_are_judged_by_one_key_each(brighton: Path, tmp_path: Path, screenshots: Path) -> None:
    """Worst first, the map following; a second operator judges blind."""
    parameters = {"brighton": brighton, "screenshots": screenshots}
    report = played("real_judging", tmp_path, parameters, seconds=400).report
    assert report["placed"] > 30
    assert report["said_over_the_map"] == 0
    assert report["wrong"] == []
    assert report["worst_first"]
    assert report["second"] == 20
    assert report["blind_columns"] == ["id", "observer 2"]
    assert report["disagreements"] > 0
    assert_no_stall(report, ("inspect", "judge"))


@pytest.fixture
def relatives(brighton: Path, tmp_path: Path) -> Path:
    """All that may lie beside a mosaic in a project and is no source of it."""
    folder = tmp_path / "relatives"
    folder.mkdir()
    mosaic, image = str(brighton / "mosaic_feather0p4m.tif"), str(brighton / "DJI_0027_ortho.tif")
    gdal.Translate(str(folder / "half.tif"), mosaic, widthPct=50, heightPct=50, resampleAlg="average")
    gdal.Warp(str(folder / "rgba.tif"), mosaic, dstAlpha=True)
    gdal.Translate(str(folder / "16bit.tif"), mosaic, outputType=gdal.GDT_UInt16, scaleParams=[[0, 255, 0, 65535]])
    gdal.Warp(str(folder / "degrees.tif"), mosaic, dstSRS="EPSG:4326", resampleAlg="cubic")
    gdal.Translate(str(folder / "sheet.tif"), mosaic, srcWin=[800, 700, 1500, 1500])
    gdal.Warp(str(folder / "image in degrees.tif"), image, dstSRS="EPSG:4326")
    gdal.BuildVRT(str(folder / "linked.vrt"), [mosaic])
    gdal.BuildVRT(str(folder / "block.vrt"), sorted(map(str, brighton.glob("DJI*.tif"))))
    source = gdal.Open(mosaic)
    drawn = np.full((3, source.RasterYSize, source.RasterXSize), 255, np.uint8)
    drawn[:, ::40], drawn[:, :, ::55] = 30, 90
    scanned = gdal.GetDriverByName("GTiff").CreateCopy(str(folder / "scanned map.tif"), source)
    scanned.WriteArray(drawn)
    return folder


@pytest.fixture
def stranger(brighton: Path, tmp_path: Path) -> Path:
    """An image of the same ground that lies 0.2 m off, as of another flight."""
    path = tmp_path / "DJI_0099_ortho.tif"
    image = gdal.Translate(str(path), str(brighton / "DJI_0033_ortho.tif"))
    left, right, _, top, _, down = image.GetGeoTransform()
    image.SetGeoTransform((left + 0.21, right, 0, top + 0.09, 0, down))
    return path


def test_only_sources_become_sources(
    brighton: Path, relatives: Path, stranger: Path, tmp_path: Path, screenshots: Path
) -> None:
    """In a project full of copies, in one with a stranger, and in one of 500 rasters."""
    parameters = {"brighton": brighton, "relatives": relatives, "stranger": stranger, "screenshots": screenshots}
    report = played("inputs", tmp_path, parameters, seconds=500).report
    images = sorted(path.stem for path in brighton.glob("DJI*.tif"))
    assert report["sources"] == [*images, "sheet"]
    assert report["with_stranger"] == [*images, "DJI_0099_ortho"]
    assert report["many"] == 500
