"""A raster of very many bands, as an imaging spectrometer has."""
from __future__ import annotations

import warnings
from pathlib import Path

import pytest
from osgeo import gdal

from tests.qgis.resolution.bar_scenes import make_bar_scene
from tests.qgis.runs import run


@pytest.mark.usefixtures("provider")
def test_a_chart_of_300_bands_keeps_room_for_its_profiles(tmp_path: Path) -> None:
    """Matplotlib warns where a legend leaves none."""
    bars, path = make_bar_scene(tmp_path, bands=1), str(tmp_path / "many.vrt")
    gdal.Translate(path, str(bars.path), bandList=[1] * 300, format="VRT").FlushCache()
    with warnings.catch_warnings():
        warnings.simplefilter("error", UserWarning)
        made = run("measureresolution", RASTER=path, GROUPS=bars.lines([(2, "across")]), CHART=str(tmp_path / "c.png"))
    assert made.complaint is None
    assert (tmp_path / "c.png").stat().st_size > 0
