"""``checknoise`` as QGIS runs it: its contract, its files, and bad input."""
from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest
from matplotlib.image import imread
from osgeo import gdal
from qgis.core import (
    QgsGeometry,
    QgsProcessing,
    QgsProcessingModelAlgorithm,
    QgsProcessingModelChildAlgorithm,
    QgsProcessingModelOutput,
    QgsProcessingModelParameter,
    QgsProcessingParameterMultipleLayers,
    QgsProject,
    QgsRasterLayer,
    QgsRectangle,
)
from qgis.core import QgsProcessingModelChildParameterSource as ChildSource

from tests.numbers.synthetic import decompose, luminance, patchy_texture, read_pixels, texture, write_raster
from tests.qgis.runs import Log, Run, algorithm, assert_refused, assert_sentence, run
from tests.qgis.scenes import Scene, layer, windows

pytestmark = pytest.mark.usefixtures("provider")

SIDE = 512
NUMBERS = {"LOW_COUNT", "UNCERTAIN_COUNT", "MODERATE_COUNT", "STRONG_COUNT"}
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


def test_parameters_and_outputs_are_those_promised() -> None:
    job = algorithm("checknoise")
    names = [definition.name() for definition in job.parameterDefinitions()]
    assert names == (
        "RASTERS SECOND_GROUP GROUP_NAME SECOND_GROUP_NAME WINDOWS GROUP_FIELD WAVELET LEVELS OUTPUT CHART REPORT"
    ).split()
    required = [one.name() for one in job.parameterDefinitions() if not one.flags() & one.Flag.FlagOptional]
    assert required == ["RASTERS", "WAVELET", "LEVELS", "OUTPUT"]
    assert job.parameterDefinition("WAVELET").defaultValue() == "coif3"
    assert job.parameterDefinition("LEVELS").defaultValue() == 3
    assert {one.name() for one in job.outputDefinitions()} == {"OUTPUT", "CHART", "REPORT"} | NUMBERS


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


def test_each_group_counts_its_windows(pictures: dict[str, str]) -> None:
    outcome = run("checknoise", RASTERS=[pictures["clean"]], SECOND_GROUP=[pictures["noisy"]])
    assert counts(outcome) == [1, 0, 0, 1]


def test_windows_are_judged_by_their_noisiest_band(tmp_path: Path) -> None:
    ground = 120 + 25 * patchy_texture((SIDE, SIDE), 2.8, 1)
    pixels = np.stack([ground + np.random.default_rng(seed).normal(0, 6, ground.shape) for seed in range(3)])
    path = write_raster(tmp_path / "rgb.tif", np.rint(pixels).clip(0, 255).astype(np.uint8))
    outcome = run("checknoise", RASTERS=[path])
    words = {row["band"]: row["noise"] for row in outcome.rows()}
    assert words == {"luminance": "moderate", "red": "strong", "green": "strong", "blue": "strong"}
    assert counts(outcome) == [0, 0, 0, 1]


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


def test_windows_are_grouped_by_numbers_and_many_values(pictures: dict[str, str], tmp_path: Path) -> None:
    boxes = [(32 * column, 32 * row, 96, 96) for row in range(4) for column in range(4)]
    drawn = windows(*boxes, scale=("double", [1000.0 * (number % 12) for number in range(16)]))
    outcome = run(
        "checknoise", RASTERS=[pictures["grainy"]], WINDOWS=drawn, GROUP_FIELD="scale", CHART=str(tmp_path / "a.png"),
        REPORT=str(tmp_path / "a.html"), WAVELET="haar",
    )
    assert {row["class"] for row in outcome.rows()} == {str(1000 * number) for number in range(12)}
    page = (tmp_path / "a.html").read_text(encoding="utf-8")
    assert page.index(">2000</td>") < page.index(">11000</td>")  # by size, as numbers are


def test_a_field_without_windows_or_that_they_do_not_have_is_refused(pictures: dict[str, str]) -> None:
    assert_refused("checknoise", "give WINDOWS", RASTERS=[pictures["clean"]], GROUP_FIELD="scale")
    drawn = windows((0, 0, 128, 128))
    assert_refused("checknoise", "scale", RASTERS=[pictures["clean"]], WINDOWS=drawn, GROUP_FIELD="scale")


def test_two_groups_on_the_same_ground_are_compared_window_by_window(pictures: dict[str, str]) -> None:
    drawn = windows((0, 0, 128, 128), (256, 256, 200, 200), window_id=("integer", [11, 12]))
    outcome = run("checknoise", RASTERS=[pictures["clean"]], SECOND_GROUP=[pictures["noisy"]], WINDOWS=drawn, LEVELS=2)
    rows = [row for row in outcome.rows() if row["band"] == "luminance"]
    assert [(row["window_id"], row["group"]) for row in rows] == [(11, 1), (11, 2), (12, 1), (12, 2)]
    assert [row["width"] for row in rows] == [128, 128, 200, 200]
    assert "detail_3" not in rows[0]
    for clean, noisy in (rows[:2], rows[2:]):
        assert noisy["sigma"] > 5 * clean["sigma"]


def test_windows_come_from_any_system(pictures: dict[str, str]) -> None:
    near, far = (
        run("checknoise", RASTERS=[pictures["clean"]], WINDOWS=windows((64, 64, 128, 128), epsg=epsg)).rows()
        for epsg in (32633, 4326)
    )
    assert [abs(a["column"] - b["column"]) <= 8 for a, b in zip(near, far)] == [True] * 4


@pytest.mark.parametrize("ending", ["png", "svg", "pdf"])
def test_chart_and_report(pictures: dict[str, str], tmp_path: Path, ending: str) -> None:
    chart, report = tmp_path / f"noise.{ending}", tmp_path / "noise.html"
    outcome = run(
        "checknoise", RASTERS=[pictures["clean"]], SECOND_GROUP=[pictures["noisy"]], CHART=str(chart),
        REPORT=str(report),
    )
    assert (outcome.results["CHART"], outcome.results["REPORT"]) == (str(chart), str(report))
    if ending == "png":
        picture = imread(chart)
        assert picture.shape[1] == 2000
        assert picture[..., :3].std() > 0.05
    if ending == "svg":
        drawn = chart.read_text(encoding="utf-8")
        said = "relative variance", "clean.tif", "noisy.tif: luminance", "clean.tif"
        for words in said:
            assert words in drawn
    page = report.read_text(encoding="utf-8")
    for words in ("Random noise", "noisy.tif", "strong", "svg+xml", "Pyka 2009"):
        assert words in page


def test_a_bad_raster_is_named_and_the_others_are_measured(pictures: dict[str, str], tmp_path: Path) -> None:
    (tmp_path / "text.tif").write_text("no raster")
    outcome = run("checknoise", RASTERS=["/nowhere/a.tif", str(tmp_path / "text.tif"), pictures["clean"]])
    assert outcome.complaint is None
    assert len(outcome.rows()) == 4
    assert len(outcome.log.warnings) == 3  # two left out, and smaller windows
    assert_sentence(outcome.log.warnings[0], r"a\.tif is left out: .* does not exist")
    assert_sentence(outcome.log.warnings[1], r"text\.tif is left out: .* is not a raster")


@pytest.mark.parametrize(
    ("parameters", "words"),
    [
        ({"RASTERS": []}, "No rasters are given"),
        ({"RASTERS": ["/nowhere/a.tif"]}, "None of the rasters can be used: a.tif is left out"),
        ({"CHART": "noise.jpg"}, "noise.jpg is no PNG, SVG or PDF file"),
        ({"LEVELS": 1}, "1 levels asked for; the noise rule compares levels"),
        ({"WINDOWS": "empty"}, "The window layer is empty"),
        ({"WINDOWS": "elsewhere"}, "Window 1 lies on none of the rasters"),
    ],
)
def test_bad_input_ends_with_a_sentence(pictures: dict[str, str], parameters: dict[str, Any], words: str) -> None:
    layers = {"empty": windows(), "elsewhere": windows((9000, 9000, 200, 200))}
    given = {"RASTERS": [pictures["clean"]], **parameters}
    if "WINDOWS" in given:
        given["WINDOWS"] = layers[given["WINDOWS"]]
    log = Log()
    outcome = run("checknoise", log, **given)
    assert_sentence(outcome.complaint, words)


def test_a_window_that_can_not_be_measured_has_a_row_with_its_reason(scene: Scene, tmp_path: Path) -> None:
    pixels = read_pixels(str(scene.west), 0, 0, 512, 256)
    pixels[:, :128, :128] = 0
    pixels[:, 128:, :128] = 77
    path = write_raster(tmp_path / "holes.tif", pixels, nodata=0)
    drawn = windows((0, 0, 128, 128), (0, 128, 128, 128), (300, 64, 99, 99))
    outcome = run("checknoise", RASTERS=[path], WINDOWS=drawn)
    first, *flat = outcome.rows()[:5]
    assert (first["noise"], first["band"], first["detail_1"]) == ("not measurable", None, None)
    assert "100.00\u00a0% of the pixels of holes.tif are invalid" in first["reason"]
    assert {row["noise"] for row in flat} == {"not measurable"}
    assert {row["sigma"] for row in flat} == {None}
    assert "holes.tif has no variance in luminance here" in flat[0]["reason"]
    assert outcome.rows()[-1]["noise"] in ("low", "moderate", "strong")
    assert sum(outcome.results[name] for name in NUMBERS) == 1


def test_a_folder_that_is_not_there_costs_only_the_chart(pictures: dict[str, str]) -> None:
    outcome = run("checknoise", RASTERS=[pictures["clean"]], CHART="/nowhere/chart.png", REPORT="/nowhere/report.html")
    assert outcome.complaint is None
    assert len(outcome.rows()) == 4
    assert "CHART" not in outcome.results
    for said in outcome.log.errors:
        assert_sentence(said, "can't be written")


def test_layers_of_the_project_are_taken(pictures: dict[str, str], project: QgsProject) -> None:
    shown = QgsRasterLayer(pictures["clean"], "a name")
    project.addMapLayer(shown)
    for given in (shown, shown.id(), pictures["clean"]):
        assert run("checknoise", RASTERS=[given]).rows()[0]["raster"] == "clean.tif"


def test_windows_on_a_photograph_are_where_qgis_shows_them(tmp_path: Path) -> None:
    pixels = np.rint(120 + 30 * texture((256, 256), 2.0, 1)).clip(0, 255).astype(np.uint8)
    photo = str(tmp_path / "photo.jpg")
    gdal.Translate(photo, write_raster(tmp_path / "on_the_map.tif", pixels), format="JPEG")
    Path(photo + ".aux.xml").unlink(missing_ok=True)
    extent = QgsRasterLayer(photo, "photo").extent()
    assert (extent.xMinimum(), extent.yMaximum(), extent.width(), extent.height()) == (0, 0, 256, 256)
    drawn = layer("Polygon", [QgsGeometry.fromRect(QgsRectangle(64, -192, 192, -64))], None)
    row = run("checknoise", RASTERS=[photo], WINDOWS=drawn).rows()[0]
    assert (row["column"], row["row"], row["width"], row["height"], row["pixel_size"]) == (64, 64, 128, 128, None)
    expected = decompose(read_pixels(photo, 64, 64, 128, 128)[0]).shares
    assert row["detail_1"] == pytest.approx(expected[0], abs=1e-6)


def test_it_stops_when_cancelled(pictures: dict[str, str]) -> None:
    log = Log()
    log.cancel()
    outcome = run("checknoise", log, RASTERS=list(pictures.values()))
    assert outcome.complaint is None
    assert outcome.rows() == []


def test_it_works_in_a_model(pictures: dict[str, str]) -> None:
    model = QgsProcessingModelAlgorithm("noise", "tests")
    rasters = QgsProcessingParameterMultipleLayers("rasters", "rasters", QgsProcessing.SourceType.TypeRaster)
    model.addModelParameter(rasters, QgsProcessingModelParameter("rasters"))
    child = QgsProcessingModelChildAlgorithm("seaminspector:checknoise")
    child.setChildId("noise")
    child.addParameterSources("RASTERS", [ChildSource.fromModelParameter("rasters")])
    for setting, value in (("WAVELET", "db4"), ("LEVELS", 3)):
        child.addParameterSources(setting, [ChildSource.fromStaticValue(value)])
    output = QgsProcessingModelOutput("table", "table")
    output.setChildId("noise")
    output.setChildOutputName("OUTPUT")
    child.setModelOutputs({"table": output})
    model.addChildAlgorithm(child)
    assert model.validate() == (True, [])
    outcome = run(model, rasters=[pictures["clean"], pictures["noisy"]])
    assert outcome.complaint is None
    (name,) = (key for key in outcome.results if key.endswith("table"))
    assert len(outcome.rows(name)) == 8
