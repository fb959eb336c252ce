"""``seaminspector:predictloss`` through QGIS: its contract, its numbers, and what it does with bad input."""
from __future__ import annotations

import os
import subprocess
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from osgeo import gdal
from qgis.core import (
    QgsExpressionContext,
    QgsExpressionContextUtils,
    QgsProcessingParameterDefinition,
    QgsProject,
    QgsRasterLayer,
    QgsWkbTypes,
)

from tests.numbers.synthetic import UTM33, decompose, luminance, read_pixels, write_raster
from tests.qgis.runs import Log, Run, algorithm, assert_refused, assert_sentence, run
from tests.qgis.scenes import BLURRED, SHARP, Scene, layer, outline, pixel_box, whole, windows

pytestmark = pytest.mark.usefixtures("provider")

INTEGER, REAL, TEXT = "integer", "double", "string"
ALONE = "Only one source covers the window, so nothing will be feathered there."


def predict(scene: Scene, *boxes: tuple[float, ...], log: Log | None = None, **parameters: Any) -> Run:
    given = {"WINDOWS": windows(*boxes or (SHARP, BLURRED)), "SOURCES": scene.sources}
    outcome = run("predictloss", log, **{**given, **parameters})
    assert outcome.complaint is None
    return outcome


def left_of_a_blend(scene: Scene, box: tuple[int, int, int, int], wavelet: str, levels: int) -> list[float]:
    """The detail variance of the 50:50 blend of the scene's sources over the mean of theirs, by PyWavelets."""
    west, east = (luminance(read_pixels(str(path), *box)) for path in (scene.west, scene.east))
    of_blend, *own = (
        np.array([np.sum(part**2) for part in decompose(image, wavelet, levels).details])
        for image in ((west + east) / 2, west, east)
    )
    return [float(one) for one in of_blend / np.mean(own, axis=0)]


@pytest.fixture(scope="module")
def expected(scene: Scene, provider: object) -> list[dict[str, Any]]:
    """What comes out when the sources are given as paths."""
    return predict(scene).rows("PAIRS")


# --- the contract ----------------------------------------------------------------------------------------------


def test_parameters() -> None:
    job = algorithm("predictloss")
    definitions = {one.name(): one for one in job.parameterDefinitions()}
    assert list(definitions) == "WINDOWS SOURCES SOURCE_INDEX WAVELET LEVELS WIDTH RAMP SEAMLINES OUTPUT PAIRS".split()
    optional = {
        name for name, one in definitions.items() if one.flags() & QgsProcessingParameterDefinition.Flag.FlagOptional
    }
    assert optional == {"SOURCES", "SOURCE_INDEX", "WIDTH", "RAMP", "SEAMLINES", "PAIRS"}
    assert definitions["RAMP"].options() == ["linear", "cosine", "gaussian"]
    assert definitions["RAMP"].usesStaticStrings()
    assert {name: definitions[name].defaultValue() for name in ("WAVELET", "LEVELS", "WIDTH", "RAMP")} == {
        "WAVELET": "coif3", "LEVELS": 3, "WIDTH": 0, "RAMP": "cosine"
    }
    for definition in definitions.values():
        assert len(definition.help()) > 20
        assert definition.help() in job.shortHelpString()
    outputs = [one.name() for one in job.outputDefinitions() if one.type() == "outputNumber"]
    assert outputs == ["WINDOW_COUNT", "NOT_COMPARABLE_COUNT"]


@pytest.mark.parametrize("levels", [1, 4])
def test_fields(scene: Scene, levels: int) -> None:
    outcome = predict(scene, LEVELS=levels)

    def fields(name: str) -> list[tuple[str, str]]:
        return [(field.name(), field.typeName()) for field in outcome.layer(name).fields()]

    def by_level(name: str) -> list[tuple[str, str]]:
        return [(f"{name}_{level}", REAL) for level in range(1, levels + 1)]

    assert fields("OUTPUT") == [
        ("window_id", INTEGER),
        ("reason", TEXT),
        ("sources", INTEGER),
        *by_level("expected_ratio"),
        *by_level("window_kept"),
        *by_level("strip_kept"),
    ]
    assert fields("PAIRS") == [
        ("window_id", INTEGER),
        *[(name, TEXT) for name in ("source", "other", "band")],
        *by_level("rho"),
        *by_level("ratio"),
        *by_level("window_kept"),
        *by_level("strip_kept"),
        ("shift_x", REAL),
        ("shift_y", REAL),
        ("resampled", INTEGER),
    ]
    assert outcome.layer().wkbType() == QgsWkbTypes.Type.Polygon
    assert outcome.layer().crs().authid() == f"EPSG:{UTM33}"
    assert not outcome.layer("PAIRS").isSpatial()


def test_the_table_of_pairs_is_optional(scene: Scene, tmp_path: Path) -> None:
    only = predict(scene, PAIRS=None)
    assert "PAIRS" not in only.results
    assert len(only.features()) == 2
    output, pairs = tmp_path / "o.gpkg", tmp_path / "p.csv"
    predict(scene, OUTPUT=str(output), PAIRS=str(pairs))
    assert output.exists()
    assert pairs.exists()


# --- the numbers -----------------------------------------------------------------------------------------------


@pytest.mark.parametrize(("wavelet", "levels"), [("coif3", 3), ("haar", 1), ("db4", 4)])
def test_ratios_are_those_of_the_blend_by_pywavelets(scene: Scene, wavelet: str, levels: int) -> None:
    outcome = predict(scene, WAVELET=wavelet, LEVELS=levels)
    assert outcome.results["WINDOW_COUNT"] == 2
    assert outcome.results["NOT_COMPARABLE_COUNT"] == 0
    for box, row, pair in zip((SHARP, BLURRED), outcome.rows(), outcome.rows("PAIRS")):
        left = left_of_a_blend(scene, box, wavelet, levels)
        assert [row[f"expected_ratio_{level}"] for level in range(1, levels + 1)] == pytest.approx(left, rel=1e-4)
        assert [pair[f"ratio_{level}"] for level in range(1, levels + 1)] == pytest.approx(left, rel=1e-4)
        rho = [pair[f"rho_{level}"] for level in range(1, levels + 1)]
        assert rho == pytest.approx([2 * one - 1 for one in left], rel=1e-3)
        assert (row["sources"], row["reason"], pair["band"], pair["resampled"]) == (2, None, "luminance", 0)
        assert (pair["source"], pair["other"]) == ("west.tif", "east.tif")
        assert np.hypot(pair["shift_x"], pair["shift_y"]) < 0.05
    assert [pixel_box(feature.geometry()) for feature in outcome.features()] == [SHARP, BLURRED]


def test_it_says_what_an_inspection_of_the_mosaic_would_expect(scene: Scene) -> None:
    drawn = windows(SHARP, BLURRED)
    inspected = run("inspectwindows", WINDOWS=drawn, MOSAIC=str(scene.mosaic), SOURCES=scene.sources)
    for level in (1, 2, 3):
        name = f"expected_ratio_{level}"
        assert predict(scene).column(name) == pytest.approx(inspected.column(name), rel=1e-6)


def test_images_that_lie_apart_lose_more(scene: Scene, tmp_path: Path) -> None:
    moved = write_raster(tmp_path / "moved.tif", np.roll(whole(scene.west), 1, axis=2), nodata=0)
    outcome = predict(scene, SHARP, SOURCES=[*scene.sources, moved])
    pairs = {(row["source"], row["other"]): row for row in outcome.rows("PAIRS")}
    assert len(pairs) == 3
    assert pairs["west.tif", "moved.tif"]["shift_x"] == pytest.approx(1, abs=0.05)
    assert pairs["west.tif", "moved.tif"]["shift_y"] == pytest.approx(0, abs=0.05)
    assert pairs["west.tif", "moved.tif"]["ratio_1"] < pairs["west.tif", "east.tif"]["ratio_1"]
    assert outcome.column("expected_ratio_1") == [min(row["ratio_1"] for row in pairs.values())]


def test_the_style_tells_what_is_foretold(scene: Scene, repository: Path, tmp_path: Path) -> None:
    drawn = windows(SHARP, (0, 0, 10, 10))
    outcome = predict(scene, WINDOWS=drawn, OUTPUT=str(tmp_path / "o.gpkg"))
    loaded = outcome.layer()
    message, worked = loaded.loadNamedStyle(str(repository / "resources" / "styles" / "predicted_windows.qml"))
    assert worked, message
    rules = loaded.renderer().rootRule().children()
    assert [rule.filter() is not None and bool(rule.label()) for rule in rules] == [True] * 4
    for feature in loaded.getFeatures():
        context = QgsExpressionContext(QgsExpressionContextUtils.globalProjectLayerScopes(loaded))
        context.setFeature(feature)
        assert sum(bool(rule.filter().evaluate(context)) for rule in rules) == 1  # each window is drawn once
    assert loaded.labelsEnabled()


# --- windows ---------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("epsg", [4326, 3857, 2180])
def test_windows_in_any_reference_system(scene: Scene, epsg: int) -> None:
    outcome = predict(scene, WINDOWS=windows((64, 64, 128, 128), epsg=epsg))
    assert outcome.layer().crs().authid() == f"EPSG:{UTM33}"
    column, row, width, height = pixel_box(outcome.features()[0].geometry())
    np.testing.assert_allclose((column + width / 2, row + height / 2), (128, 128), atol=1)
    np.testing.assert_allclose((width, height), (128, 128), atol=16)
    assert outcome.column("sources") == [2]


def test_numbers_are_kept_and_bad_windows_say_why(scene: Scene) -> None:
    drawn = layer(
        "Polygon",
        [outline(SHARP), None, outline((0, 0, 10, 10)), outline((900, 0, 128, 128)), outline(BLURRED)],
        window_id=("integer", [9, 4, 2, 7, 1]),
    )
    outcome = predict(scene, WINDOWS=drawn)
    assert outcome.column("window_id") == [9, 4, 2, 7, 1]
    assert list(dict.fromkeys(outcome.column("window_id", "PAIRS"))) == [9, 1]
    reasons = outcome.column("reason")
    assert reasons[0] is reasons[4] is None
    assert_sentence(reasons[1], "no outline")
    assert_sentence(reasons[2], "10 x 10 px")
    assert_sentence(reasons[3], "No source covers the window")
    assert outcome.results["WINDOW_COUNT"] == 5
    assert outcome.results["NOT_COMPARABLE_COUNT"] == 3
    assert [info for info in outcome.log.infos if info.startswith("Window 7: No source covers")]


# --- sources ---------------------------------------------------------------------------------------------------


def test_one_source_has_nothing_to_be_feathered_with(scene: Scene) -> None:
    outcome = predict(scene, SOURCES=[str(scene.west)])
    assert outcome.column("reason") == [ALONE, ALONE]
    assert outcome.column("sources") == [1, 1]
    assert outcome.column("expected_ratio_1") == [None, None]
    assert outcome.rows("PAIRS") == []
    assert outcome.results["NOT_COMPARABLE_COUNT"] == 2
    assert [pixel_box(feature.geometry()) for feature in outcome.features()] == [SHARP, BLURRED]


def test_sources_as_layers_ids_and_paths(scene: Scene, project: QgsProject, expected: list[dict[str, Any]]) -> None:
    west, east = (QgsRasterLayer(path, "any name") for path in scene.sources)
    project.addMapLayers([west, east])
    assert predict(scene, SOURCES=[west, east]).rows("PAIRS") == expected
    assert predict(scene, SOURCES=[west.id(), str(scene.east), west]).rows("PAIRS") == expected


def test_an_index_by_gdaltindex(scene: Scene, expected: list[dict[str, Any]], tmp_path: Path) -> None:
    for path in (scene.west, scene.east):
        os.link(path, tmp_path / path.name)
    subprocess.run(["gdaltindex", "index.shp", "west.tif", "east.tif"], cwd=tmp_path, check=True, capture_output=True)
    index = str(tmp_path / "index.shp")
    outcome = predict(scene, SOURCES=None, SOURCE_INDEX=index)
    assert outcome.rows("PAIRS") == expected
    assert [pixel_box(feature.geometry()) for feature in outcome.features()] == [SHARP, BLURRED]
    beside = predict(scene, SOURCES=[str(tmp_path / "west.tif")], SOURCE_INDEX=index)
    assert beside.rows("PAIRS") == expected


def test_sources_in_other_systems_are_resampled(scene: Scene, tmp_path: Path) -> None:
    other = str(tmp_path / "utm34.tif")
    gdal.Warp(other, str(scene.east), dstSRS="EPSG:32634", dstNodata=0, resampleAlg="cubic")
    outcome = predict(scene, (192, 64, 128, 128), SOURCES=[str(scene.west), other])
    assert outcome.column("resampled", "PAIRS") == [1]
    assert outcome.layer().crs().authid() == f"EPSG:{UTM33}"
    turned = predict(scene, (192, 64, 128, 128), SOURCES=[other, str(scene.west)])
    assert turned.layer().crs().authid() == "EPSG:32634"  # that of the first source
    assert turned.column("resampled", "PAIRS") == [1]


def test_bad_rasters_are_named_once_and_cost_nothing(
    scene: Scene, tmp_path: Path, expected: list[dict[str, Any]]
) -> None:
    (tmp_path / "text.tif").write_text("no raster")
    grey = write_raster(tmp_path / "grey.tif", whole(scene.west)[0])
    lost = [str(tmp_path / "text.tif"), "/nowhere/lost.tif"]
    outcome = predict(scene, SOURCES=[grey, *lost, *scene.sources])
    assert outcome.rows("PAIRS") == expected
    assert len(outcome.log.warnings) == 3
    for warning, words in zip(outcome.log.warnings, ("text.tif is left", "lost.tif is left", "grey.tif has no")):
        assert_sentence(warning, words)
    index = layer("Polygon", [outline((-5, -5, 522, 266))] * 4, location=("string", [*lost, *scene.sources]))
    indexed = predict(scene, SOURCES=None, SOURCE_INDEX=index)
    assert indexed.rows("PAIRS") == expected
    assert len(indexed.log.warnings) == 2  # of two windows


def test_only_bad_rasters(scene: Scene) -> None:
    outcome = predict(scene, SOURCES=["/nowhere/a.tif", "/nowhere/b.tif"])
    assert all("No source covers" in reason for reason in outcome.column("reason"))
    assert len(outcome.log.warnings) == 2


def test_what_is_refused(scene: Scene) -> None:
    drawn = windows(SHARP)
    assert_refused("predictloss", "No sources are given", WINDOWS=drawn)
    assert_refused("predictloss", "No sources are given", WINDOWS=drawn, SOURCES=[])
    assert_refused("predictloss", "The window layer is empty", WINDOWS=windows(), SOURCES=scene.sources)
    assert_refused(
        "predictloss", "no field 'location'", WINDOWS=drawn, SOURCE_INDEX=layer("Polygon", [outline(SHARP)])
    )


# --- cancellation ----------------------------------------------------------------------------------------------


class CancelledAfter(Log):
    """Cancels as soon as a share of the windows is done."""

    def __init__(self, percent: float) -> None:
        super().__init__()
        self.progressChanged.connect(lambda progress: self.cancel() if progress >= percent else None)


def test_what_was_foretold_before_a_cancellation_stays(scene: Scene, tmp_path: Path) -> None:
    boxes = [(7 * index, 0, 64, 64) for index in range(60)]
    outcome = predict(scene, *boxes, log=CancelledAfter(5), OUTPUT=str(tmp_path / "o.gpkg"))
    numbers = outcome.column("window_id")
    assert numbers[:3] == [1, 2, 3]
    assert numbers == sorted(set(numbers))  # of those that were under way then, the ones that were ready
    assert 3 <= len(numbers) <= 3 + 4 * (os.cpu_count() or 1)
    assert outcome.results["WINDOW_COUNT"] == len(numbers)
    assert outcome.column("window_id", "PAIRS") == numbers


def test_a_run_cancelled_before_it_began_leaves_an_empty_layer(scene: Scene) -> None:
    log = Log()
    log.cancel()
    outcome = predict(scene, log=log)
    assert outcome.rows() == []
    assert outcome.results["WINDOW_COUNT"] == 0
