"""``seaminspector:predictloss`` through QGIS: its contract, its numbers, and what it does with bad input."""
from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest
from qgis.core import QgsExpressionContext, QgsExpressionContextUtils

from tests.numbers.synthetic import decompose, luminance, read_pixels
from tests.qgis.runs import Log, Run, assert_sentence, run
from tests.qgis.scenes import BLURRED, SHARP, Scene, layer, outline, pixel_box, windows

pytestmark = pytest.mark.usefixtures("provider")


def predict(scene: Scene, *boxes: tuple[float, ...], log: Log | None = None, **parameters: Any) -> Run:
    given = {"WINDOWS": windows(*boxes or (SHARP, BLURRED)), "SOURCES": scene.sources}
    outcome = run("predictloss", log, **{**given, **parameters})
    assert outcome.complaint is None
    return outcome


def left_of_a_blend(scene: Scene, box: tuple[int, int, int, int], wavelet: str, levels: int) -> list[float]:
    """The detail variance of the 50:50 blend of the scene's sources over the mean of theirs, by PyWavelets."""
    west, east = (luminance(read_pixels(str(path), *box)) for path in (scene.west, scene.east))
    of_blend, *of_sources = (
        np.array([np.sum(part**2) for part in decompose(image, wavelet, levels).details])
        for image in ((west + east) / 2, west, east)
    )
    return [float(item) for item in of_blend / np.mean(of_sources, axis=0)]


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
        assert rho == pytest.approx([2 * item - 1 for item in left], rel=1e-3)
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
