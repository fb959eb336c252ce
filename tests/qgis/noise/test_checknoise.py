"""``checknoise`` as QGIS runs it: its contract, its files, bad input, and the charts of noise and radiometry."""
from __future__ import annotations

from pathlib import Path

import numpy as np
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
from tests.numbers.synthetic import decompose, luminance, patchy_texture, read_pixels, write_raster
from tests.qgis.runs import Run, assert_sentence, run
from tests.qgis.scenes import Scene, windows

pytestmark = pytest.mark.usefixtures("provider")

SIDE = 512
FIELDS = (
    "raster group window_id band detail_1 detail_2 detail_3 background kurtosis_1 kurtosis_2 kurtosis_3 sigma noise"
).split()


@pytest.fixture(scope="module")
def pictures(tmp_path_factory: pytest.TempPathFactory) -> dict[str, str]:
    """Pictures of one ground, clean and with noise."""
    folder, random = tmp_path_factory.mktemp("pictures"), np.random.default_rng(0)
    ground = np.stack([120 + 25 * patchy_texture((SIDE, SIDE), 2.7, 1 + band // 9) for band in range(3)])
    made = {}
    for name, sigma in (("clean", 0.3), ("grainy", 5.0), ("noisy", 15.0)):
        pixels = np.rint(ground + random.normal(0, sigma, ground.shape)).clip(1, 255).astype(np.uint8)
        made[name] = write_raster(folder / f"{name}.tif", pixels, nodata=0)
    return made


def test_the_table_holds_the_figures_of_every_band(pictures: dict[str, str]) -> None:
    outcome = run("checknoise", RASTERS=[pictures["clean"]])
    rows = outcome.rows()
    assert list(rows[0])[: len(FIELDS)] == FIELDS
    assert [row["band"] for row in rows] == ["luminance", "red", "green", "blue"]
    assert outcome.layer().wkbType() == 100  # a table
    pixels = read_pixels(pictures["clean"], 0, 0, SIDE, SIDE)
    for row, band in zip(rows, [luminance(pixels), *pixels]):
        assert (row["raster"], row["group"], row["window_id"]) == ("clean.tif", 1, 1)
        shares = [row["detail_1"], row["detail_2"], row["detail_3"], row["background"]]
        assert shares == pytest.approx(decompose(band).shares, abs=1e-6)
        assert (row["column"], row["row"], row["width"], row["height"]) == (0, 0, SIDE, SIDE)
        assert row["pixel_size"] == pytest.approx(0.1 / 0.9996)  # amid a zone of UTM


def counts(outcome: Run) -> list[int]:
    return [outcome.results[f"{word}_COUNT"] for word in ("LOW", "UNCERTAIN", "MODERATE", "STRONG")]


def test_ground_that_three_images_show_counts_once_with_the_strongest_verdict(pictures: dict[str, str]) -> None:
    outcome = run("checknoise", RASTERS=list(pictures.values()))
    words = {row["raster"]: row["noise"] for row in outcome.rows() if row["band"] == "red"}
    assert words == {"clean.tif": "low", "grainy.tif": "moderate", "noisy.tif": "strong"}
    assert {row["window_id"] for row in outcome.rows()} == {1}
    assert counts(outcome) == [0, 0, 0, 1]
    assert counts(run("checknoise", RASTERS=[pictures["clean"]] * 3)) == [1, 0, 0, 0]
    drawn = windows((0, 0, 256, 256), (256, 256, 256, 256))
    assert sum(counts(run("checknoise", RASTERS=list(pictures.values()), WINDOWS=drawn))) == 2


# --- groups ----------------------------------------------------------------------------------------------------


def test_groups_have_names(pictures: dict[str, str], tmp_path: Path) -> None:
    chart, report = tmp_path / "noise.svg", tmp_path / "noise.html"
    outcome = run(
        "checknoise", RASTERS=[pictures["clean"], pictures["grainy"]], SECOND_GROUP=[pictures["noisy"]],
        GROUP_NAME="DMC <8 bit> & $x$", CHART=str(chart), REPORT=str(report),
    )
    assert {row["group_name"] for row in outcome.rows()} == {"DMC <8 bit> & $x$", "noisy.tif"}
    drawn = chart.read_text(encoding="utf-8").replace("&gt;", ">")
    assert "DMC &lt;8 bit> &amp; $x$" in drawn
    page = report.read_text(encoding="utf-8")
    assert "DMC &lt;8 bit&gt; &amp; $x$" in page
    assert "DMC <8 bit>" not in page


def test_windows_are_grouped_by_a_field(pictures: dict[str, str], tmp_path: Path) -> None:
    chart, report = tmp_path / "noise.svg", tmp_path / "noise.html"
    drawn = windows(
        (0, 0, 192, 192), (192, 0, 192, 192), (0, 192, 192, 192), (256, 256, 192, 192),
        land_use=("string", ["forest", "field", "forest", None]),
    )
    outcome = run(
        "checknoise", RASTERS=[pictures["clean"]], SECOND_GROUP=[pictures["noisy"]], WINDOWS=drawn,
        GROUP_FIELD="land_use", CHART=str(chart), REPORT=str(report),
    )
    classes = {(row["window_id"], row["class"] or None) for row in outcome.rows()}
    assert classes == {(1, "forest"), (2, "field"), (3, "forest"), (4, None)}
    words = chart.read_text(encoding="utf-8")
    titles = "land_use: forest", "land_use: field", "land_use: no value"
    for title in (*titles, "clean.tif: mean and range of 2 windows"):
        assert title in words
    page = report.read_text(encoding="utf-8")
    assert "Groups" in page
    assert page.index(">field</td>") < page.index(">forest</td>") < page.index(">no value</td>")


def test_two_groups_on_the_same_ground_are_compared_window_by_window(pictures: dict[str, str]) -> None:
    drawn = windows((0, 0, 128, 128), (256, 256, 200, 200), window_id=("integer", [11, 12]))
    outcome = run("checknoise", RASTERS=[pictures["clean"]], SECOND_GROUP=[pictures["noisy"]], WINDOWS=drawn, LEVELS=2)
    rows = [row for row in outcome.rows() if row["band"] == "luminance"]
    assert [(row["window_id"], row["group"]) for row in rows] == [(11, 1), (11, 2), (12, 1), (12, 2)]
    assert [row["width"] for row in rows] == [128, 128, 200, 200]
    assert "detail_3" not in rows[0]
    for clean, noisy in (rows[:2], rows[2:]):
        assert noisy["sigma"] > 5 * clean["sigma"]


def test_a_bad_raster_is_named_and_the_others_are_measured(pictures: dict[str, str], tmp_path: Path) -> None:
    (tmp_path / "text.tif").write_text("no raster")
    outcome = run("checknoise", RASTERS=["/nowhere/a.tif", str(tmp_path / "text.tif"), pictures["clean"]])
    assert outcome.complaint is None
    assert len(outcome.rows()) == 4
    assert len(outcome.log.warnings) == 3  # two left out, and smaller windows
    assert_sentence(outcome.log.warnings[0], r"a\.tif is left out: .* does not exist")
    assert_sentence(outcome.log.warnings[1], r"text\.tif is left out: .* is not a raster")


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
