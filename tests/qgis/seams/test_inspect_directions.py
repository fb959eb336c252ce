"""``seaminspector:inspectwindows`` asked for the detail by direction: what the table of curves holds then."""
from __future__ import annotations

import numpy as np
import pytest

from tests.numbers.synthetic import luminance, read_pixels, wavedec, without_mean
from tests.qgis.runs import run
from tests.qgis.scenes import SHARP, Scene, windows

pytestmark = pytest.mark.usefixtures("provider")

LEVELS = 3


def rows(scene: Scene, **parameters: object) -> dict[tuple[object, ...], dict[str, float]]:
    """The rows of CURVES by what they are of, in their order."""
    outcome = run(
        "inspectwindows", WINDOWS=windows(SHARP), MOSAIC=str(scene.mosaic), SOURCES=scene.sources, **parameters
    )
    assert outcome.complaint is None
    keys = ("raster", "band", "component", "level")
    return {tuple(row[key] for key in keys): row for row in outcome.rows("CURVES")}


def test_without_being_asked_the_curves_are_as_they_were(scene: Scene) -> None:
    plain = rows(scene)
    assert {component for _, _, component, _ in plain} == {"detail", "background"}
    asked = rows(scene, DIRECTIONS=True)
    assert {key: asked[key] for key in plain} == plain


def test_the_curves_hold_the_directions_of_pywavelets(scene: Scene) -> None:
    result = rows(scene, DIRECTIONS=True)
    paths = {"mosaic.tif": scene.mosaic, "west.tif": scene.west, "east.tif": scene.east}
    directional = {key: row for key, row in result.items() if key[2] in ("LH", "HL", "HH")}
    assert len(directional) == len(paths) * 4 * LEVELS * 3
    for name, path in paths.items():
        pixels = read_pixels(str(path), *SHARP)
        for band, plane in zip(("luminance", "red", "green", "blue"), (luminance(pixels), *pixels)):
            variance = np.mean(without_mean(plane) ** 2)
            for level, parts in enumerate(wavedec(plane, "coif3", LEVELS)[:0:-1], 1):  # from the finest on
                for component, part in zip(("LH", "HL", "HH"), parts):
                    row = result[name, band, component, level]
                    assert row["variance"] == pytest.approx(np.sum(part**2) / plane.size, rel=1e-4)
                    assert row["relative_variance"] == pytest.approx(np.sum(part**2) / plane.size / variance, rel=1e-4)
                three = [result[name, band, component, level]["relative_variance"] for component in ("LH", "HL", "HH")]
                assert sum(three) == pytest.approx(result[name, band, "detail", level]["relative_variance"], rel=1e-4)
