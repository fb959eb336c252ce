"""The real QGIS desktop on projects of unsuitable, of fitting and of very many layers. Figures: `pytest -s`."""
from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from osgeo import gdal

from demo.desktop import play
from tests.desktop.conftest import SCENARIOS, check, say


@pytest.fixture
def relatives(data_folder: Path, tmp_path: Path) -> Path:
    """All that may lie beside a mosaic in a project and is no source of it."""
    brighton, folder = data_folder / "seams" / "brighton", tmp_path / "relatives"
    if not brighton.is_dir():
        pytest.skip(f"no real data at {brighton}")
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
    shape = source.RasterYSize, source.RasterXSize
    drawn = np.full((3, *shape), 255, np.uint8)
    drawn[:, ::40], drawn[:, :, ::55] = 30, 90
    made = gdal.GetDriverByName("GTiff").Create(
        str(folder / "scanned map.tif"), shape[1], shape[0], 3, options=["COMPRESS=DEFLATE"]
    )
    made.SetGeoTransform(source.GetGeoTransform())
    made.SetProjection(source.GetProjection())
    made.WriteArray(drawn)
    return folder


@pytest.fixture
def stranger(data_folder: Path, tmp_path: Path) -> Path:
    """An image of the same ground that lies 0.2 m off, as of another flight."""
    path = tmp_path / "DJI_0099_ortho.tif"
    made = gdal.Translate(str(path), str(data_folder / "seams" / "brighton" / "DJI_0033_ortho.tif"))
    left, right, _, top, _, down = made.GetGeoTransform()
    made.SetGeoTransform((left + 0.21, right, 0, top + 0.09, 0, down))
    return path


def test_only_sources_become_sources(
    data_folder: Path, relatives: Path, stranger: Path, tmp_path: Path, screenshots: Path
) -> None:
    """In a project full of copies, in one as it should be, and in one of 500 rasters."""
    brighton = data_folder / "seams" / "brighton"
    parameters = {
        "brighton": str(brighton), "relatives": str(relatives), "stranger": str(stranger),
        "screenshots": str(screenshots),
    }  # fmt: skip
    run = play(SCENARIOS / "inputs.py", tmp_path, parameters, seconds=500)  # a machine shared with others
    say("Inputs", run.seconds, run.report)
    check(run)
    report, images = run.report, sorted(path.stem for path in brighton.glob("DJI*.tif"))
    assert report["sources"] == [*images, "sheet"]
    assert sum("Covers the whole mosaic" in reason for reason in report["reasons"]) >= 2
    assert report["suggested"][:3] == ["mosaic_feather0p4m", len(images), "seamlines"]
    assert report["places"]["here"] > 0
    assert report["places"]["elsewhere"] > 0
    assert report["clicked"] not in ("", "not_comparable")
    assert report["with_stranger"] == [*images, "DJI_0099_ortho"]
    assert "DJI_0099_ortho.tif" in report["doubts"]
    assert "none of the" in report["doubts"]
    assert report["many"] == 500
