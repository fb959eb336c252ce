"""``seaminspector:predictloss`` through QGIS: its contract, its numbers, and what it does with bad input."""
from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest
from qgis.core import (
    QgsExpressionContext,
    QgsExpressionContextUtils,
)

from tests.numbers.synthetic import decompose, luminance, read_pixels, write_raster
from tests.qgis.runs import Log, Run, assert_sentence, run
from tests.qgis.scenes import BLURRED, SHARP, Scene, layer, outline, pixel_box, whole, windows

pytestmark = pytest.mark.usefixtures("provider")

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


# --- cancellation ----------------------------------------------------------------------------------------------
