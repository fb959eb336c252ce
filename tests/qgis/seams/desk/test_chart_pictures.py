"""Curves that leave the desk name every raster, whatever it is called."""
from __future__ import annotations

import pytest
from seam_inspector.plugin.seams.charts.chart_curves import Chart, ChartCurve
from seam_inspector.plugin.seams.desk.charts.chart_pictures import CurvesPicture
from seam_inspector.plugin.toolkit.charts.chart_painter import chart_svg

NAMES = ("_mosaic.tif", "__a$b$.tif", "<b>c</b>.tif", "\u202egnp.tif", "_.tif")


@pytest.mark.usefixtures("qgis_app")
@pytest.mark.filterwarnings("error")
def test_the_legend_has_an_entry_for_each_name() -> None:
    curves = tuple(ChartCurve(name, not place, (0.5, 0.3, 0.1), 0.1) for place, name in enumerate(NAMES))
    picture = CurvesPicture(Chart(curves, 0.7), "Window 1")
    shown = [name for name, *_ in picture.entries]
    assert shown[: len(NAMES)] == [name.replace("\u202e", "\ufffd") for name in NAMES]
    assert len(shown) == len(NAMES) + 1  # and the limit
    svg = chart_svg(picture.paint, 700, 420)
    assert svg.count("&lt;b&gt;c&lt;/b&gt;.tif") == svg.count("Window 1") == svg.count("significant loss below") == 1
