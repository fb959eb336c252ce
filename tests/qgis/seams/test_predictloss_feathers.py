"""``seaminspector:predictloss`` told how wide the feather is: what it says of the window and of the feather's strip."""
from __future__ import annotations

from typing import Any

import pytest

from tests.qgis.runs import Run, run
from tests.qgis.scenes import BLURRED, SHARP, Scene, layer, line, outline, windows

pytestmark = pytest.mark.usefixtures("provider")


def predict(scene: Scene, *boxes: tuple[float, ...], **parameters: Any) -> Run:
    outcome = run("predictloss", WINDOWS=windows(*boxes or (SHARP, BLURRED)), SOURCES=scene.sources, **parameters)
    assert outcome.complaint is None
    return outcome


KEPT = [f"{part}_kept_{level}" for part in ("window", "strip") for level in (1, 2, 3)]


def test_without_a_width_nothing_is_said_of_it(scene: Scene) -> None:
    outcome = predict(scene)
    for name in ("OUTPUT", "PAIRS"):
        assert [row[field] for row in outcome.rows(name) for field in KEPT] == [None] * 12
    given = predict(scene, WIDTH=None, RAMP=None)
    assert given.rows() == outcome.rows()


@pytest.mark.parametrize("ramp", ["linear", "cosine", "gaussian"])
def test_a_wider_feather_leaves_less_in_the_window(scene: Scene, ramp: str) -> None:
    narrow, wide = (predict(scene, WIDTH=width, RAMP=ramp) for width in (1.0, 6.0))
    plain = predict(scene)
    for row, other, without in zip(narrow.rows(), wide.rows(), plain.rows()):
        assert row["expected_ratio_1"] == without["expected_ratio_1"]
        for level in (1, 2, 3):
            assert 1 > row[f"window_kept_{level}"] > other[f"window_kept_{level}"] > 0
            assert other[f"window_kept_{level}"] > other[f"strip_kept_{level}"] > without[f"expected_ratio_{level}"]
    assert [[row[name] for name in KEPT] for row in wide.rows()] == [
        [row[name] for name in KEPT] for row in wide.rows("PAIRS")
    ]  # a single pair


def test_seamlines_say_where_the_feather_runs(scene: Scene) -> None:
    column, row, width, height = SHARP
    down = line((column + width / 2, row - 5), (column + width / 2, row + height + 5))
    seams = layer("LineString", [down])
    given = predict(scene, SHARP, WIDTH=2.0, SEAMLINES=seams)
    assumed = predict(scene, SHARP, WIDTH=2.0)
    assert given.column("window_kept_1") != assumed.column("window_kept_1")
    assert given.column("window_kept_1") == pytest.approx(assumed.column("window_kept_1"), abs=0.05)
    cells = layer("Polygon", [outline((-5, -5, 5 + column + width // 2, 266))])
    same = predict(scene, SHARP, WIDTH=2.0, SEAMLINES=cells)
    assert [same.rows()[0][name] for name in KEPT] == pytest.approx([given.rows()[0][name] for name in KEPT], abs=1e-6)
    moved_away = predict(scene, SHARP, WIDTH=2.0, SEAMLINES=layer("LineString", [line((0, 0), (1, 1))]))
    assert moved_away.column("window_kept_1") == assumed.column("window_kept_1")
    assert [info for info in moved_away.log.infos if "Where no seamline divides a window" in info]
