"""Charts of noise and radiometry: what is drawn, on any axes and in any style."""
from __future__ import annotations

from pathlib import Path

import pytest
from osgeo import gdal
from qgis.core import QgsApplication
from seam_inspector.plugin.imagery.grids import PixelWindow
from seam_inspector.plugin.imagery.open_raster import describe
from seam_inspector.plugin.imagery.rasters import RasterRef
from seam_inspector.plugin.noise.charts import MAX_LEGEND, draw_noise, noise_figure
from seam_inspector.plugin.noise.measure.band_noise import noisiest_band
from seam_inspector.plugin.noise.measure.group_noise import ClipNoise
from seam_inspector.plugin.noise.measure.noise_plan import GroupedImage, NoiseRequest, Part
from seam_inspector.plugin.radiometry.report import balance_figure, histogram_figure
from seam_inspector.plugin.toolkit.charts.figure_files import new_figure, save_figure

from tests.numbers.noise.measuring import measured
from tests.numbers.radiometry.judging import checked
from tests.numbers.synthetic import decompose, read_pixels
from tests.qgis.scenes import Scene

pytestmark = pytest.mark.usefixtures("qgis_app")


def noise_of(path: Path, window: PixelWindow) -> ClipNoise:
    """What is measured in one window of an image."""
    part = Part(GroupedImage(describe(RasterRef(str(path))), 1), window)
    return measured([NoiseRequest(1, (part,))])[0]


def test_one_window_of_one_raster_is_measured_and_drawn(scene: Scene, qgis_app: QgsApplication) -> None:
    result = noise_of(scene.west, PixelWindow(64, 0, 128, 128))
    pixels = read_pixels(str(scene.west), 64, 0, 128, 128)
    assert result.bands["blue"].curve.detail == pytest.approx(decompose(pixels[2]).shares[:3], abs=1e-6)
    axes = new_figure(4, 3).subplots()
    draw_noise(axes, result.bands)
    lines = {line.get_label(): line for line in axes.get_lines()}
    for name, noise in result.bands.items():
        assert tuple(lines[name].get_ydata()) == noise.curve.detail
        assert list(lines[name].get_xdata()) == [1, 2, 3]
    widths = {name: line.get_linewidth() for name, line in lines.items() if name in result.bands}
    assert max(widths, key=lambda name: widths[name]) == noisiest_band(result.bands)


def test_histograms_hold_every_pixel(scene: Scene) -> None:
    result = checked(str(scene.west))
    figure = histogram_figure(result)
    assert figure is not None
    curves = {line.get_label(): line for line in figure.axes[0].get_lines()}
    assert curves
    for curve in curves.values():
        assert sum(curve.get_ydata()) == pytest.approx(100)
    assert balance_figure([result, result]) is None  # there are no seams


@pytest.mark.filterwarnings("error")
def test_very_many_bands_leave_the_chart_its_room(scene: Scene, tmp_path: Path) -> None:
    path = tmp_path / "bands.tif"
    gdal.Translate(str(path), str(scene.west), bandList=[1] * 90, srcWin=[0, 0, 256, 256])
    figure = noise_figure([noise_of(path, PixelWindow(64, 0, 128, 128))])
    assert figure is not None
    save_figure(figure, tmp_path / "chart.png")
    assert len(figure.axes[-1].get_legend().get_texts()) == MAX_LEGEND
