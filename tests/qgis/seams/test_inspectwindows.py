"""``seaminspector:inspectwindows`` through QGIS: its contract, its numbers, and what it carries over."""
from __future__ import annotations

import os
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from qgis.core import QgsGeometry, QgsRectangle, QgsWkbTypes

from tests.numbers.synthetic import UTM33, decompose, luminance, read_pixels, write_raster
from tests.qgis.runs import Log, Run, run
from tests.qgis.scenes import BLURRED, SHARP, Scene, layer, luminance_shares, pixel_box, whole, windows

pytestmark = pytest.mark.usefixtures("provider")

INTEGER, REAL, TEXT = "integer", "double", "string"


def inspect(scene: Scene, *boxes: tuple[float, ...], log: Log | None = None, **parameters: Any) -> Run:
    given = {"WINDOWS": windows(*boxes or (SHARP, BLURRED)), "MOSAIC": str(scene.mosaic), "SOURCES": scene.sources}
    outcome = run("inspectwindows", log, **{**given, **parameters})
    assert outcome.complaint is None
    return outcome


def layout(outcome: Run, name: str) -> list[tuple[str, str]]:
    return [(field.name(), field.typeName()) for field in outcome.layer(name).fields()]


# --- the contract ----------------------------------------------------------------------------------------------


FIELDS = {
    "OUTPUT": "window_id:i verdict:t reason:t sources:i ratio_{} background_ratio observer:t composite_ratio_{} "
    "expected_ratio_{} unclear_share cause:t causes:t reference:t paper_verdict:t kept_{} kept_low kept_high "
    "band_width feather_width visibility misfit contrast_1 sharpness_1 added_1 explained loss reason_code:t",
    "CURVES": "window_id:i raster:t role:t band:t component:t level:i relative_variance variance",
    "PAIRS": "window_id:i source:t band:t ratio_{} similarity offset_x offset_y resampled:i gain bias gamma "
    "contrast_{} sharpness_{} clipped colour_shift shift_x shift_y",
    "PROFILES": "window_id:i level:i distance kept low high area mixture",
}


@pytest.mark.parametrize("levels", [1, 3, 5])
def test_fields(scene: Scene, levels: int) -> None:
    outcome = inspect(scene, LEVELS=levels)
    """Fields by name and type; {} is each level in turn."""
    for table, names in FIELDS.items():
        expected = []
        for name in names.split():
            title, _, kind = name.partition(":")
            titles = [title.format(level) for level in range(1, levels + 1)] if "{}" in title else [title]
            expected += [(title, {"i": INTEGER, "t": TEXT}.get(kind, REAL)) for title in titles]
        assert layout(outcome, table) == expected
    assert outcome.layer("OUTPUT").wkbType() == QgsWkbTypes.Type.Polygon
    assert not outcome.layer("CURVES").isSpatial()
    assert not outcome.layer("PAIRS").isSpatial()
    assert not outcome.layer("PROFILES").isSpatial()
    assert outcome.layer("OUTPUT").crs().authid() == f"EPSG:{UTM33}"


def test_results(scene: Scene) -> None:
    outcome = inspect(scene, SHARP, BLURRED, (0, 0, 10, 10), REFERENCE="sources")
    assert outcome.column("verdict") == ["reduced", "significant", "not_comparable"]
    counts = {name: value for name, value in outcome.results.items() if name.endswith("_COUNT")}
    assert counts == {"WINDOW_COUNT": 3, "SIGNIFICANT_COUNT": 1, "NOT_COMPARABLE_COUNT": 1}
    assert outcome.column("sources") == [2, 2, 0]
    reasons = outcome.column("reason")
    assert reasons[:2] == [None, None]
    assert "10 x 10 px" in reasons[2]
    assert outcome.log.infos[-1] == "significant: 1, reduced: 1, preserved: 0, not comparable: 1"


def test_rows_of_curves_and_pairs(scene: Scene) -> None:
    outcome = inspect(scene, SHARP)
    bands = ["luminance", "red", "green", "blue"]
    components = [("detail", 1), ("detail", 2), ("detail", 3), ("background", 3)]
    rasters = [("mosaic.tif", "mosaic"), ("west.tif", "source"), ("east.tif", "source")]
    rasters.append(("composite", "composite"))
    rows = [(row["raster"], row["role"], row["band"], row["component"], row["level"]) for row in outcome.rows("CURVES")]
    assert rows == [(*raster, band, *component) for raster in rasters for band in bands for component in components]
    pairs = [(row["source"], row["band"]) for row in outcome.rows("PAIRS")]
    assert pairs == [(source, band) for source in ("west.tif", "east.tif", "composite") for band in bands]


# --- the numbers -----------------------------------------------------------------------------------------------


@pytest.mark.parametrize(("wavelet", "levels"), [("coif3", 3), ("haar", 1), ("db4", 5), ("sym8", 2)])
@pytest.mark.parametrize("box", [SHARP, BLURRED, (192, 32, 160, 96)])
def test_curves_are_those_of_pywavelets(
    scene: Scene, wavelet: str, levels: int, box: tuple[int, int, int, int]
) -> None:
    outcome = inspect(scene, box, WAVELET=wavelet, LEVELS=levels)
    assert pixel_box(outcome.features()[0].geometry()) == box
    curves = outcome.rows("CURVES")
    for path in (scene.mosaic, scene.west, scene.east):
        pixels = read_pixels(str(path), *box)
        for name, clip in zip(("luminance", "red", "green", "blue"), (luminance(pixels), *pixels)):
            rows = [row for row in curves if row["raster"] == path.name and row["band"] == name]
            expected = decompose(clip, wavelet, levels)
            shares = [row["relative_variance"] for row in rows]
            np.testing.assert_allclose(shares, expected.shares, rtol=1e-4, atol=0)
            assert np.abs(shares - expected.shares).max() <= 1e-7
            variances = expected.shares * expected.energy / clip.size
            np.testing.assert_allclose([row["variance"] for row in rows], variances, rtol=1e-4)


@pytest.mark.parametrize("box", [SHARP, BLURRED, (192, 32, 160, 96)])
def test_ratios_and_verdicts_follow_from_pywavelets(scene: Scene, box: tuple[int, int, int, int]) -> None:
    outcome = inspect(scene, box, REFERENCE="sources")
    mosaic, *sources = (luminance_shares(path, box) for path in (scene.mosaic, scene.west, scene.east))
    against = np.array([mosaic / source for source in sources])
    (row,) = outcome.rows()
    items = [row[name] for name in ("ratio_1", "ratio_2", "ratio_3", "background_ratio")]
    np.testing.assert_allclose(items, against.max(axis=0), rtol=1e-4)
    largest = against[:, 0].max()
    assert row["verdict"] == ("significant" if largest <= 0.5 else "reduced" if largest < 1 else "preserved")
    pairs = [[row["ratio_1"], row["ratio_2"], row["ratio_3"]] for row in outcome.rows("PAIRS")]
    np.testing.assert_allclose(pairs[0], against[0, :3], rtol=1e-4)
    np.testing.assert_allclose(pairs[4], against[1, :3], rtol=1e-4)


def test_a_geographic_mosaic_is_measured_on_its_own_pixels(scene: Scene, tmp_path: Path) -> None:
    degrees = (19.0, 1.4e-6, 0.0, 50.0, 0.0, -0.9e-6)
    mosaic, source = (
        write_raster(tmp_path / path.name, whole(path), system=4326, geotransform=degrees)
        for path in (scene.mosaic, scene.west)
    )
    column, row, width, height = BLURRED
    left, top = 19 + 1.4e-6 * column, 50 - 0.9e-6 * row
    box = QgsGeometry.fromRect(QgsRectangle(left, top - 0.9e-6 * height, left + 1.4e-6 * width, top))
    outcome = run(
        "inspectwindows", WINDOWS=layer("Polygon", [box], 4326), MOSAIC=mosaic, SOURCES=[source, str(scene.east)]
    )
    assert outcome.layer().crs().authid() == "EPSG:4326"
    resampled = {(row["source"], row["resampled"]) for row in outcome.rows("PAIRS")}
    assert resampled == {("west.tif", 0), ("composite", 0)}
    expected = luminance_shares(mosaic, BLURRED)[0] / luminance_shares(source, BLURRED)[0]
    assert outcome.column("ratio_1") == pytest.approx([expected], rel=1e-4)


# --- windows ---------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("epsg", [4326, 3857, 2180, UTM33])
def test_windows_in_any_reference_system(scene: Scene, epsg: int) -> None:
    outcome = inspect(scene, WINDOWS=windows((64, 64, 128, 128), epsg=epsg))
    assert outcome.layer().crs().authid() == f"EPSG:{UTM33}"
    # What a system that is turned against the mosaic's adds to the bounding box is trimmed to a multiple of 8.
    column, row, width, height = pixel_box(outcome.features()[0].geometry())
    assert width % 8 == height % 8 == 0
    np.testing.assert_allclose((column + width / 2, row + height / 2), (128, 128), atol=1)
    np.testing.assert_allclose((width, height), (128, 128), atol=16)


@pytest.mark.parametrize(
    ("drawn", "measured"),
    [
        ((10.3, 20.4, 128.2, 129.2), (10, 21, 128, 128)),
        ((100, 100, 67, 78), (101, 103, 64, 72)),
        ((-20, -30, 148, 158), (0, 0, 128, 128)),
        ((440, 0, 500, 500), (440, 0, 72, 256)),
    ],
)
def test_windows_are_measured_on_whole_pixels(
    scene: Scene, drawn: tuple[float, ...], measured: tuple[float, ...]
) -> None:
    outcome = inspect(scene, drawn)
    assert pixel_box(outcome.features()[0].geometry()) == measured


def test_the_observers_word_and_the_numbers_are_carried_over(scene: Scene) -> None:
    words = ["visible", None, "invisible", ""]
    drawn = windows(*[SHARP] * 4, window_id=("integer", [7, 0, -2, 12]), observer=("string", words))
    outcome = inspect(scene, WINDOWS=drawn)
    assert outcome.column("observer") == ["visible", None, "invisible", None]
    assert outcome.column("window_id") == [7, 0, -2, 12]
    assert not outcome.log.warnings


# --- cancellation ----------------------------------------------------------------------------------------------


class CancelledAfter(Log):
    """Cancels when so many windows are done; counts them by the progress that is shown."""

    def __init__(self, count: int, of: int) -> None:
        super().__init__()
        self.seen: list[float] = []
        self._limit = 100 * count / of - 1e-6
        self.progressChanged.connect(self._look)

    def _look(self, progress: float) -> None:
        self.seen.append(progress)
        if progress >= self._limit:
            self.cancel()


@pytest.mark.parametrize("count", [1, 5])
def test_what_was_measured_before_a_cancellation_stays(scene: Scene, tmp_path: Path, count: int) -> None:
    log, of = CancelledAfter(count, of=60), [(7 * index, 0, 64, 64) for index in range(60)]
    outcome = inspect(scene, *of, log=log, OUTPUT=str(tmp_path / "o.gpkg"), REFERENCE="sources")
    measured = outcome.column("window_id")
    assert measured[:count] == list(range(1, count + 1))
    assert measured == sorted(measured)
    assert len(measured) <= count + 4 * (os.cpu_count() or 1)  # those that were under way may be there too
    assert len(measured) < 60
    assert outcome.results["WINDOW_COUNT"] == len(measured)
    assert list(dict.fromkeys(outcome.column("window_id", "CURVES"))) == measured
    assert set(outcome.column("verdict")) == {"reduced"}
