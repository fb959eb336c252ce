"""The dock of bar groups in the real QGIS desktop."""
from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest
from osgeo import gdal

from demo.desktop import play
from tests.desktop.conftest import SCENARIOS, check, say
from tests.numbers.resolution.bar_grounds import GROUNDS, ground_scene
from tests.numbers.resolution.bar_targets import STEP
from tests.numbers.synthetic import write_raster

pytestmark = pytest.mark.slow

PIXEL_CM = 25.0


def test_the_groups_of_a_target_are_drawn_one_after_the_other(tmp_path: Path, screenshots: Path) -> None:
    """Other ground begins right beside the bars; the distance of all lines is the one that theory gives."""
    scene = ground_scene(np.random.default_rng(3), GROUNDS["100 DN"], groups=9, limit=5, sigma=1.0, noise=2.0)
    reference = scene.cycles[0] * PIXEL_CM
    target = write_raster(tmp_path / "target.tif", scene.pixels, gsd=PIXEL_CM / 100)
    transform = gdal.Open(target).GetGeoTransform()
    parameters = {
        "target": target,
        "lines": [
            [gdal.ApplyGeoTransform(transform, *end) for end in (ends[:2], ends[2:])] for ends in scene.lines.values()
        ],
        "reference_cm": reference, "pictures": [1, 7], "screenshots": str(screenshots),
    }
    run = play(SCENARIOS / "bars.py", tmp_path, parameters)
    say("Bar groups", run.seconds, run.report)
    check(run)
    words = run.report["words"]
    assert len(words) == len(scene.lines)
    expected = round(reference, 2) / STEP**scene.expected
    found = float(words[-1].split("along the flight: ")[1].split(" ")[0])
    assert abs(math.log(found / expected, STEP)) < 0.5
    assert "resolved" in words[0]
    assert "the criterion is 50\u00a0%" in words[-1]
