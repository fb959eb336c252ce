"""The decision of ``checkradiometry``, and what users give it for that: the range of values, grey areas, seams."""
from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

from tests.numbers.synthetic import ORIGIN, texture, write_raster
from tests.qgis.runs import Log, assert_sentence, run
from tests.qgis.scenes import layer, line, windows

pytestmark = pytest.mark.usefixtures("provider")


def ground(*bands: float, side: int = 384, sigma: float = 32.0) -> np.ndarray:
    """Texture about these levels, with a uniform band of rows for the noise."""
    common = sigma * texture((side, side), 2.0, 1)
    common[300:360] = np.random.default_rng(0).normal(0, 4, (60, side))
    return np.rint(np.array(bands)[:, np.newaxis, np.newaxis] + common).clip(8, 247).astype(np.uint8)


@pytest.fixture(scope="module")
def sheets(tmp_path_factory: pytest.TempPathFactory) -> dict[str, str]:
    folder = tmp_path_factory.mktemp("sheets")
    flat = ground(128, 128, 128, sigma=10)
    return {
        "good": write_raster(folder / "good.tif", ground(128, 128, 128)),
        "soil": write_raster(folder / "soil.tif", ground(140, 128, 117)),
        "flat": write_raster(folder / "flat <b>'&.tif", flat),
        "twelve": write_raster(folder / "twelve.tif", ground(60, 60, 60, sigma=18).astype(np.uint16) * 4),
    }


def decided(rasters: list[str], **parameters: Any) -> tuple[str, str, Log]:
    outcome = run("checkradiometry", RASTERS=rasters, **parameters)
    assert outcome.complaint is None
    return outcome.results["DECISION"], outcome.results["REASONS"], outcome.log


def test_a_good_sheet_is_accepted_and_told_what_was_not_measured(sheets: dict[str, str], tmp_path: Path) -> None:
    report = tmp_path / "r.html"
    word, why, log = decided([sheets["good"], sheets["soil"]], REPORT=str(report))
    assert word == "accepted"
    assert why == "Not measurable and not required: colour balance; in good.tif, soil.tif."
    assert log.infos[-2:] == ["Radiometry: accepted.", why]
    page = report.read_text(encoding="utf-8")
    assert 'class="decision good"' in page
    assert "no grey areas are given" in page


def test_one_bad_sheet_rejects_and_is_named(sheets: dict[str, str], tmp_path: Path) -> None:
    report = tmp_path / "r.html"
    word, why, _ = decided([sheets["good"], sheets["flat"]], REPORT=str(report))
    assert word == "rejected"
    assert "Beyond their limits: flat <b>'&.tif; by contrast (luminosity)." in why
    page = report.read_text(encoding="utf-8")
    assert "<b>'&.tif" not in page
    assert 'class="decision bad"' in page


def test_a_name_that_turns_or_breaks_lines_is_made_plain(tmp_path: Path) -> None:
    turned = write_raster(tmp_path / "flat\u202egnp\nW: made up.tif", ground(128, 128, 128, sigma=10))
    word, why, log = decided([turned])
    assert word == "rejected"
    assert "flat\ufffdgnp W: made up.tif" in why
    assert not any(mark in said for mark in ("\u202e", "\n") for said in (why, *log.infos, *log.warnings))


def test_the_stricter_rules_leave_it_open_without_grey_areas(sheets: dict[str, str]) -> None:
    word, why, _ = decided([sheets["good"]], READY_RULES="jrc_lpis_each_band")
    assert (word, why) == ("undecided", "Required but not measurable: colour balance; in good.tif.")
    grey = windows((0, 0, 100, 100))
    word, why, log = decided([sheets["good"]], READY_RULES="jrc_lpis_each_band", GREY_AREAS=grey)
    assert (word, why) == ("accepted", "All figures are within their limits.")
    assert any("Grey areas: 1, with 10000 px" in said for said in log.infos)


def test_a_guessed_range_accepts_nothing(sheets: dict[str, str], tmp_path: Path) -> None:
    report = tmp_path / "r.html"
    word, why, log = decided([sheets["twelve"]], REPORT=str(report))
    page = report.read_text(encoding="utf-8")
    assert page.count("The largest value of all such images") == 2  # the notice, and once for all that it concerns
    assert word == "undecided"
    assert "Required but not measurable: clipped at the bright end (luminosity), histogram peak" in why
    (said,) = log.warnings
    assert_sentence(said, "twelve.tif: what depends on the range of values is not judged: the files do not say")
    assert decided([sheets["twelve"]], VALUE_RANGE="0,4095")[0] == "rejected"
    assert decided([sheets["twelve"]], VALUE_RANGE=[0, 480])[0] == "accepted"
    for nothing in ("None,None", "nan,nan", "", None, [float("nan"), float("nan")]):  # what forms and scripts say
        assert decided([sheets["good"]], VALUE_RANGE=nothing)[0] == "accepted"


def test_grey_areas_tell_a_cast(sheets: dict[str, str]) -> None:
    grey = windows((10, 10, 80, 80), (200, 20, 90, 60), epsg=4326)
    outcome = run("checkradiometry", RASTERS=[sheets["soil"]], GREY_AREAS=grey)
    (row,) = [row for row in outcome.rows() if row["check"] == "colour_balance"]
    assert row["value"] == pytest.approx(23 / 255, abs=0.002)
    assert (row["passed"], row["decision"]) == (0, "rejected")
    assert row["place"].startswith("grey area ")
    assert ORIGIN[0] < row["x"] < ORIGIN[0] + 38.4
    assert outcome.results["DECISION"] == "rejected"


def test_what_may_be_grey_can_be_looked_at_and_given(sheets: dict[str, str]) -> None:
    first = run("checkradiometry", RASTERS=[sheets["soil"]], MAYBE_GREY="memory:")
    result = first.features("MAYBE_GREY")
    assert len(result) > 8
    assert {feature["raster"] for feature in result} == {"soil.tif"}
    assert all(0 < feature["difference"] <= 0.1 for feature in result)
    assert result[0].geometry().area() == pytest.approx(1.6 * 1.6, rel=1e-6)
    again = run("checkradiometry", RASTERS=[sheets["soil"]], GREY_AREAS=first.layer("MAYBE_GREY"))
    (row,) = [row for row in again.rows() if row["check"] == "colour_balance"]
    assert row["value"] == pytest.approx(23 / 255, abs=0.01)


@pytest.mark.parametrize("kind", ["LineString", "Polygon"])
def test_the_worst_seam_is_named_with_its_features_and_its_place(tmp_path: Path, kind: str) -> None:
    pixels = np.full((3, 256, 512), 100, np.uint8)
    pixels[:, :, 150:], pixels[:, :, 350:] = 110, 170
    path = write_raster(tmp_path / "steps.tif", pixels)
    if kind == "LineString":
        seams, features = layer("LineString", [line((150, 0), (150, 256)), line((350, 0), (350, 256))]), ["2"]
    else:
        seams, features = windows((0, 0, 150, 256), (150, 0, 200, 256), (350, 0, 162, 256)), ["2", "3"]
    report = tmp_path / "r.html"
    outcome = run("checkradiometry", RASTERS=[path], SEAMLINES=seams, REPORT=str(report))
    (row,) = [row for row in outcome.rows() if (row["check"], row["band"]) == ("seam_step", "red")]
    assert row["value"] == pytest.approx(60 / 170)
    assert row["place"].endswith(f" (feature {', '.join(features)} of made)")
    assert row["x"] == pytest.approx(ORIGIN[0] + 35.0, abs=0.2)
    (said,) = [said for said in outcome.log.infos if "The largest step of tone" in said]
    assert said.startswith("steps.tif: The largest step of tone is 35.29")
    assert row["place"] in said
    page = report.read_text(encoding="utf-8")
    assert said.partition(": ")[2] in page
    assert f">{row['place']}</td>" in page
