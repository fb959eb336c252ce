"""The algorithms of ground resolution as QGIS runs them: contracts, bad input, chart, report, the real photograph."""
from __future__ import annotations

import math
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from osgeo import gdal
from qgis.core import QgsProcessingProvider, QgsVectorLayer
from seam_inspector.plugin.resolution.measure import bayer

from tests.numbers.resolution.bar_targets import STEP, theoretical_cycle
from tests.numbers.synthetic import orthoimage, write_raster
from tests.qgis.resolution.bar_scenes import COARSEST_CM, BarScene, bar_layer, make_bar_scene
from tests.qgis.runs import Log, Run, assert_refused, run
from tests.qgis.scenes import ORIGIN, PIXEL, layer, line, moved

pytestmark = pytest.mark.usefixtures("provider")

FIELDS = (
    "group direction band grd grd_error bars_found amplitude full_amplitude amplitude_error modulation resolved "
    "spurious observers seen_by shift_px reason"
).split()
TARGET = {"REFERENCE_GROUP": 1, "REFERENCE_GRD": COARSEST_CM, "STEP": STEP**2}


@pytest.fixture(scope="module")
def target(tmp_path_factory: pytest.TempPathFactory, provider: QgsProcessingProvider) -> BarScene:
    return make_bar_scene(tmp_path_factory.mktemp("bars"))


def measure(log: Log | None = None, **parameters: object) -> Run:
    """A run without chart and report, unless they are asked for."""
    return run("measureresolution", log, **{"CHART": None, "REPORT": None, **parameters})


def reasons(scene: BarScene, *lines: object, **parameters: object) -> list[str | None]:
    """The reason of each row of the first band, after a run that has to succeed."""
    made = measure(RASTER=scene.path, GROUPS=lines[0], **{**TARGET, **parameters})
    assert made.complaint is None
    rows = made.rows()
    assert all("Traceback" not in (row["reason"] or "") for row in rows)
    return [row["reason"] for row in rows if row["band"] in (None, "red", "band_1")]


def test_fields_numbers_and_verdicts(target: BarScene) -> None:
    made = measure(RASTER=target.path, GROUPS=target.lines(), **TARGET)
    assert made.complaint is None
    assert made.layer().fields().names() == FIELDS
    rows = made.rows()
    assert len(rows) == 10 * 3
    assert {row["band"] for row in rows} == {"red", "green", "blue"}
    for direction, sigma in (("along", 0.8), ("across", 1.2)):
        limit = theoretical_cycle(sigma) * PIXEL * 100
        finest = max(group for group in range(1, 6) if COARSEST_CM / STEP ** (2 * (group - 1)) >= limit)
        expected = COARSEST_CM / STEP ** (2 * (finest - 1))
        assert made.results[f"GRD_{direction.upper()}"] == pytest.approx(expected)
        for row in rows:
            if row["direction"] == direction:
                assert row["grd"] == pytest.approx(COARSEST_CM / STEP ** (2 * (row["group"] - 1)))
                assert (row["resolved"], row["spurious"]) == (int(row["group"] <= finest), 0)
                assert bool(row["reason"]) == (row["group"] > finest)
    assert made.results["GRD_MEAN"] == pytest.approx(
        math.sqrt(made.results["GRD_ALONG"] * made.results["GRD_ACROSS"])
    )
    coarsest = rows[0]
    assert coarsest["bars_found"] == 3
    assert coarsest["full_amplitude"] == pytest.approx(160, rel=0.06)
    assert abs(coarsest["shift_px"]) < 0.05


def test_lines_in_another_reference_system(target: BarScene) -> None:
    keys = [(1, "along"), (2, "along")]
    shapes = [moved(target.geometry(*key), 4326) for key in keys]
    made = measure(RASTER=target.path, GROUPS=bar_layer(shapes, [1, 2], ["along"] * 2, 4326), **TARGET)
    assert [row["resolved"] for row in made.rows()] == [1] * 6


def test_a_distance_has_its_uncertainty_in_table_log_and_report(target: BarScene, tmp_path: Path) -> None:
    log, report = Log(), tmp_path / "report.html"
    made = measure(log, RASTER=target.path, GROUPS=target.lines(), REPORT=str(report), **TARGET)
    grd, error = (made.results[f"GRD_ALONG{name}"] for name in ("", "_ERROR"))
    assert 0 < error < 0.05 * grd
    assert made.results["GRD_MEAN_ERROR"] > 0
    finest = [row for row in made.rows() if row["direction"] == "along" and row["grd"] == pytest.approx(grd)]
    assert max(row["grd_error"] for row in finest) == pytest.approx(error)
    assert all(row["amplitude_error"] > 0 for row in finest)
    words = f"{grd:.2f} ± {error:.2f} cm"
    assert f"along the flight: {words}" in log.infos
    assert words in report.read_text(encoding="utf-8")


def test_several_observers_of_each_line(target: BarScene, tmp_path: Path) -> None:
    """Tables 3A and 3B: a group counts when each of those who judged it tells its bars apart."""
    keys = [(group, "along") for group in (1, 2, 3, 4)]
    lines = layer(
        "LineString", [target.geometry(*key) for key in keys], group=("integer", [1, 2, 3, 4]),
        direction=("string", ["along"] * 4), observer=("string", ["visible", "visible", "visible", "invisible"]),
        observer_2=("string", ["Visible", "visible", "invisible", None]),
        observer_3=("string", [None, "unsure", None, "visible"]),
    )
    report = tmp_path / "report.html"
    made = measure(RASTER=target.path, GROUPS=lines, BAND=1, REPORT=str(report), **TARGET)
    assert made.column("observers") == [2, 2, 2, 2]
    assert made.column("seen_by") == [2, 2, 1, 1]
    assert made.results["SEEN_ALONG"] == pytest.approx(COARSEST_CM / STEP**2)
    assert "SEEN_ACROSS" not in made.results
    page = report.read_text(encoding="utf-8")
    for words in ("observer_2", f"{COARSEST_CM / STEP**4:.2f}", f"{COARSEST_CM / STEP**2:.2f}", "all of them"):
        assert words in page


# bad input: a sentence each, and it costs nothing else


def test_each_bad_line_has_its_reason_and_the_others_are_measured(target: BarScene) -> None:
    good = target.geometry(1)
    cases = [
        (good, 1, "along", None),
        (line((-50, 10), (-10, 10)), 2, "along", "leaves target.tif"),
        (target.geometry(3, half=0.3), 3, "along", "px long, and 3 bars with their gaps need 5 px"),
        (line((10, 3), (40, 3)), 4, "along", "No bars stand out"),
        (target.geometry(1), 1, "along", "Group 1 along is drawn twice"),
        (target.geometry(2), None, "along", "no whole number in its field 'group'"),
        (target.geometry(2), 7, "sideways", "direction is 'sideways'"),
        (None, 8, "along", "one straight line"),
        (line((10, 40), (30, 60), (50, 40)), 9, "along", "one straight line"),
        (line((0, 0), (5000, 0)), 10, "along", "are the most"),
    ]
    shapes, groups, directions, words = zip(*cases)
    result = reasons(target, bar_layer(shapes, groups, directions))
    assert len(result) == len(cases)
    for reason, word in zip(result, words):
        assert (reason is None) == (word is None), reason
        assert word is None or word in str(reason)


@pytest.mark.parametrize("places", [[((-50, 10), (-10, 10))], [((10, 3), (40, 3)), ((60, 3), (90, 3))]])
def test_lines_that_show_nothing_at_all_are_no_success(target: BarScene, places: list[Any]) -> None:
    """Outside the image, or on plain ground: the reason of each line, then one sentence, and no empty result."""
    log, shapes = Log(), [line(*ends) for ends in places]
    lines = bar_layer(shapes, range(1, len(shapes) + 1), ["along"] * len(shapes))
    made = measure(log, RASTER=target.path, GROUPS=lines, **TARGET)
    assert f"None of the {len(shapes)} lines shows bars" in str(made.complaint)
    words = " ".join([*log.infos, *log.warnings])
    assert "leaves target.tif" in words or "No bars stand out" in words


# the real photograph of a USAF-1951 target

USAF = {
    "across": {
        1: (195, 206, 255, 206), 2: (115, 10, 168, 10), 3: (108, 64, 157, 64), 4: (103, 120, 148, 120),
        5: (98, 170, 140, 170), 6: (94, 215, 132, 215), 8: (257, 30, 284, 30), 9: (261, 61, 287, 61),
        10: (266, 89, 289, 89), 11: (270, 113, 291, 113), 12: (274, 136, 293, 136), 13: (211.5, 128, 230.5, 128),
        14: (192.5, 77, 208.5, 77), 15: (191.5, 93, 206, 93), 16: (191, 106.5, 203, 106.5),
        17: (189.8, 119.5, 200.5, 119.5), 18: (188.7, 131, 199, 131),
    },
    "along": {
        1: (284, 178, 284, 234), 3: (84, 41, 84, 88), 4: (82, 99, 82, 141), 5: (81, 151, 81, 190),
        6: (79, 199, 79, 232), 8: (297, 17, 297, 43), 9: (298, 49, 298, 73), 10: (299, 78, 299, 99),
        11: (300, 103.5, 300, 123), 12: (301, 126.5, 301, 145), 13: (237, 119.5, 237, 137), 14: (187, 69, 187, 85),
        15: (187, 85.5, 187, 100), 16: (186.5, 100.5, 186.5, 113), 17: (186, 113.5, 186, 125.5),
        18: (185.5, 126, 185.5, 136.5),
    },
}
"""Columns and rows of lines across its elements, numbered on from group to group: 6 x group + element."""


def test_the_photograph_of_usaf_1951(data_folder: Path, provider: QgsProcessingProvider, tmp_path: Path) -> None:
    """Bars that both the eye and the numbers tell apart, and the steps of the target between them."""
    photo = data_folder / "bars" / "usaf1951" / "3.npy"
    path = write_raster(tmp_path / "usaf.tif", np.load(photo), gsd=PIXEL, origin=ORIGIN)
    keys = [(number, direction) for direction, lines in USAF.items() for number in lines]
    shapes = [
        line(*((column + 0.5, row + 0.5) for column, row in (ends[:2], ends[2:])))
        for ends in (USAF[direction][number] for number, direction in keys)
    ]
    log = Log()
    made = measure(
        log, RASTER=path, GROUPS=bar_layer(shapes, *zip(*keys)), WIDTH=2, REFERENCE_GROUP=1,
        REFERENCE_GRD=17.5 * PIXEL * 100,
    )
    assert made.complaint is None
    (warning,) = log.warnings  # no other one: the spacings of its bars are those of its steps
    assert "differ by a factor of 2.2 and the method asks for 5" in warning
    resolved = {(row["group"], row["direction"]) for row in made.rows() if row["resolved"]}
    assert resolved == {key for key in keys if key[0] <= (9 if key[1] == "across" else 11)}
    assert not any(row["spurious"] for row in made.rows())
    assert made.results["GRD_ACROSS"] == pytest.approx(17.5 * PIXEL * 100 / STEP**8)
    assert made.results["GRD_ALONG"] == pytest.approx(17.5 * PIXEL * 100 / STEP**10)


def table(rows: Sequence[tuple[Any, ...]], **fields: str) -> QgsVectorLayer:
    """A table with columns of such types, or ``height`` and ``grd``."""
    kinds = fields or {"height": "double", "grd": "double"}
    columns = {name: (kind, [row[place] for row in rows]) for place, (name, kind) in enumerate(kinds.items())}
    return layer("NoGeometry", [None] * len(rows), **columns)


def test_the_papers_example(provider: QgsProcessingProvider) -> None:
    log = Log()
    made = run("minimumheight", log, OBSERVATIONS=table([(3000.0, 33.67)]), REFERENCE_HEIGHT=2704)
    (row,) = made.rows()
    assert row["count"] == 1
    assert row["mean"] == pytest.approx(2673.0, abs=0.05)
    assert row["spread"] is None
    assert row["tolerance"] == pytest.approx(-1.15, abs=0.01)
    assert any("the Open Skies treaty asks for 5" in warning for warning in log.warnings)
    assert "treaty" in row["notice"]


def test_each_sensor_has_its_reference() -> None:
    rows = [("DMC", 3000.0, 30.0), ("RC20", 2000.0, 30.0)]
    observations = table(rows, sensor="string", height="double", grd="double")
    made = run("minimumheight", OBSERVATIONS=observations, REFERENCE_HEIGHT="DMC 2500; RC20 1600")
    assert made.column("tolerance") == [20, 25]
    assert_refused("minimumheight", "for RMK, but", OBSERVATIONS=observations, REFERENCE_HEIGHT="RMK 2000")


def test_groups_and_passes() -> None:
    rows = [("DMC", "PAN", "along", 3000, 30.0 + number) for number in range(5)] + [("DMC", "RGB", "along", 2500, 60.0)]
    observations = table(rows, sensor="string", image_type="string", direction="string", height="integer", grd="double")
    made = run("minimumheight", OBSERVATIONS=observations)
    assert made.layer().fields().names() == (
        "sensor image_type direction count mean spread observers observer_spread reference tolerance notice".split()
    )
    pan, rgb = made.rows()
    heights = [3000 * 30 / (30 + number) for number in range(5)]
    assert (pan["count"], rgb["count"]) == (5, 1)
    assert pan["mean"] == pytest.approx(np.mean(heights))
    assert pan["spread"] == pytest.approx(np.std(heights, ddof=1))
    assert pan["notice"] is None
    assert pan["tolerance"] is None
    assert rgb["mean"] == pytest.approx(1250)
    assert made.column("h_min", "HEIGHTS") == pytest.approx([*heights, 1250])
    assert made.results["GROUP_COUNT"] == 2


def test_bad_rows_are_told_and_cost_nothing_else() -> None:
    log = Log()
    made = run("minimumheight", log, OBSERVATIONS=table([(3000.0, 30.0), (None, 30.0), (3000.0, -1.0)]))
    assert made.column("count") == [1]
    assert [warning for warning in log.warnings if "Row 2 is left out: 'height' or 'grd' holds no number" in warning]
    assert [warning for warning in log.warnings if "Row 3 is left out" in warning and "positive" in warning]


def test_a_table_without_its_fields_or_rows() -> None:
    made = run("minimumheight", OBSERVATIONS=table([(3000.0,)], height="double"))
    assert "no field 'grd'" in str(made.complaint)
    assert "No row has a height" in str(run("minimumheight", OBSERVATIONS=table([])).complaint)


@pytest.mark.parametrize("demosaic", ["bilinear", "malvar", "edge_aware"])
@pytest.mark.parametrize("pattern", ["RGGB", "GBRG"])
def test_a_simulated_bayer_image(tmp_path: Path, pattern: str, demosaic: str) -> None:
    scene = orthoimage((40, 50))
    path = write_raster(tmp_path / "scene.tif", scene)
    made = run(
        "simulatebayer", RASTER=path, PATTERN=pattern, DEMOSAIC=demosaic, OUTPUT=str(tmp_path / f"{demosaic}.tif")
    )
    assert made.complaint is None
    seen = gdal.Open(made.results["OUTPUT"])
    assert seen.GetGeoTransform() == gdal.Open(path).GetGeoTransform()
    assert "UTM zone 33N" in seen.GetProjection()
    assert [seen.GetRasterBand(band).GetColorInterpretation() for band in (1, 2, 3)] == [
        gdal.GCI_RedBand, gdal.GCI_GreenBand, gdal.GCI_BlueBand
    ]
    assert np.array_equal(seen.ReadAsArray(), bayer.simulated(scene, pattern, demosaic))


def test_what_can_not_be_simulated_is_told(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    path = write_raster(tmp_path / "two.tif", orthoimage((30, 30))[:2])
    assert "no red, green and blue" in str(run("simulatebayer", RASTER=path).complaint)
    floats = write_raster(tmp_path / "floats.tif", orthoimage((30, 30), dtype=np.float32))
    assert "choose malvar or bilinear" in str(run("simulatebayer", RASTER=floats, DEMOSAIC="edge_aware").complaint)
    lost = run("simulatebayer", RASTER=floats, OUTPUT="/nowhere/there/seen.tif")
    assert "can't be written" in str(lost.complaint)
    monkeypatch.setattr(bayer, "find_spec", lambda name: None)
    assert_refused("simulatebayer", "needs OpenCV", RASTER=path, DEMOSAIC="edge_aware")
    assert_refused("simulatebayer", "does not exist", RASTER="/nowhere/scene.tif")
