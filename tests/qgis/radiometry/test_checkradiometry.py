"""``checkradiometry`` as QGIS runs it: contract, report, bad input, the decision and what users give it for that."""
from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from tests.numbers.synthetic import ORIGIN, read_pixels, texture, write_raster
from tests.qgis.runs import Log, assert_sentence, run
from tests.qgis.scenes import layer, line, windows

pytestmark = pytest.mark.usefixtures("provider")

CHECKS = ["clipped_low", "clipped_high", "peak", "contrast", "signal_to_noise", "colour_balance"]
FIELDS = "raster window_id band check value limit passed source reason".split()
SEAM = ((256, 0), (256, 256))


@pytest.fixture(scope="module")
def mosaics(tmp_path_factory: pytest.TempPathFactory) -> list[str]:
    """A mosaic with a step of 20 DN at column 256, and one where it was balanced, at the cost of contrast."""
    folder, random = tmp_path_factory.mktemp("mosaics"), np.random.default_rng(0)
    columns = np.broadcast_to(np.arange(512) + 0.5, (3, 256, 512))
    made = []
    for name, step, contrast in (("cut", 20, 30), ("balanced", 0, 20)):
        pixels = 110 + step * (columns > 256) + random.normal(0, contrast, (1, 256, 512))
        made.append(write_raster(folder / f"{name}.tif", np.rint(pixels).clip(1, 255).astype(np.uint8), nodata=0))
    return made


def figures(rows: list[dict[str, Any]], raster: str) -> dict[tuple[str, str], Any]:
    return {(row["check"], row["band"]): row["value"] for row in rows if row["raster"] == raster}


def test_the_table_has_a_row_for_every_figure(mosaics: list[str]) -> None:
    outcome = run("checkradiometry", RASTERS=mosaics, READY_RULES="jrc_lpis_each_band")
    rows = outcome.rows()
    assert list(rows[0])[: len(FIELDS)] == FIELDS
    assert outcome.layer().wkbType() == 100  # a table
    assert list(dict.fromkeys(row["check"] for row in rows)) == CHECKS
    assert len(rows) == 2 * (5 * 3 + 1)
    pixels = read_pixels(mosaics[0], 0, 0, 512, 256)
    result = figures(rows, "cut.tif")
    assert result["contrast", "green"] == pytest.approx(pixels[1].std() / 255)
    assert result["clipped_low", "red"] == pytest.approx((pixels[0] <= 4).mean())
    for row in rows:
        if row["check"] == "colour_balance":  # nobody said what is grey
            assert (row["value"], row["passed"], row["decision"]) == (None, None, "rejected")
            continue
        inside = (row["least"] is None or row["value"] >= row["least"]) and (
            row["most"] is None or row["value"] <= row["most"]
        )
        assert row["passed"] == int(inside)
        assert row["source"].startswith("JRC")
        assert row["limit"]
    assert outcome.results["PASSED_COUNT"] + outcome.results["FAILED_COUNT"] == len(rows) - 2
    assert outcome.results["NOT_MEASURABLE_COUNT"] == 2


def test_the_ready_rules_judge_luminosity(mosaics: list[str]) -> None:
    outcome = run("checkradiometry", RASTERS=mosaics)
    bands = {row["check"]: [] for row in outcome.rows()}
    for row in outcome.rows():
        if row["raster"] == "cut.tif":
            bands[row["check"]].append(row["band"])
    assert [bands[check] for check in CHECKS] == [["luminosity"]] * 4 + [["red", "green", "blue"], ["all"]]
    red, green, blue = read_pixels(mosaics[0], 0, 0, 512, 256).astype(float)
    mixed = 0.299 * red + 0.587 * green + 0.114 * blue
    result = figures(outcome.rows(), "cut.tif")
    assert result["contrast", "luminosity"] == pytest.approx(mixed.std() / 255, rel=1e-4)


def test_unity_and_contrast_stand_beside_each_other(mosaics: list[str], tmp_path: Path) -> None:
    report = tmp_path / "r.html"
    seams = layer("LineString", [line(*SEAM)])
    outcome = run("checkradiometry", RASTERS=mosaics, SEAMLINES=seams, REPORT=str(report))
    rows = outcome.rows()
    cut, balanced = (figures(rows, f"{name}.tif") for name in ("cut", "balanced"))
    largest = read_pixels(mosaics[0], 0, 0, 512, 256).max()
    assert cut["seam_step", "red"] == pytest.approx(20 / largest, abs=0.02)
    assert balanced["seam_step", "red"] < 0.02
    assert balanced["seam_contrast", "red"] < 0.75 * cut["seam_contrast", "red"]
    page = report.read_text(encoding="utf-8")
    for words in ("Tonal unity and contrast", "cut.tif", "balanced.tif", "JRC orthoimage specification", "svg+xml"):
        assert words in page
    (state,) = {(row["passed"], row["reason"]) for row in rows if row["check"] == "seam_step"}
    assert state == (None, "The rules set no limit; give one in the rules file.")


def test_own_rules(mosaics: list[str], tmp_path: Path) -> None:
    rules = tmp_path / "own.json"
    rules.write_text(json.dumps({"name": "ours", "rules": [
        {"check": "seam_step", "most": 0.05, "source": "contract 12"},
        {"check": "signal_to_noise", "least": 2.5, "source": "contract 13"},
    ]}))
    outcome = run(
        "checkradiometry", RASTERS=mosaics, RULES=str(rules), SEAMLINES=layer("LineString", [line(*SEAM)])
    )
    passed = {(row["raster"], row["check"]): row["passed"] for row in outcome.rows()}
    assert passed["cut.tif", "seam_step"] == 0
    assert passed["balanced.tif", "seam_step"] == 1
    assert passed["cut.tif", "signal_to_noise"] == 1
    assert {row["source"] for row in outcome.rows()} == {"contract 12", "contract 13"}


def test_a_bad_raster_is_named_and_the_others_are_checked(mosaics: list[str], tmp_path: Path) -> None:
    cut = Path(mosaics[0]).read_bytes()
    (tmp_path / "short.tif").write_bytes(cut[: len(cut) // 2])
    report = tmp_path / "r.html"
    outcome = run(
        "checkradiometry", RASTERS=["/nowhere/a.tif", str(tmp_path / "short.tif"), mosaics[1]], REPORT=str(report)
    )
    assert outcome.complaint is None
    assert {row["raster"] for row in outcome.rows()} == {"balanced.tif"}
    assert len(outcome.log.warnings) == 2
    assert_sentence(outcome.log.warnings[0], "does not exist")
    assert_sentence(outcome.log.warnings[1], r"short\.tif is left out")
    assert "short.tif is left out" in report.read_text(encoding="utf-8")


def test_what_measured_nothing_leaves_no_file_and_an_older_one_as_it_was(mosaics: list[str], tmp_path: Path) -> None:
    """A table of nothing but its names of columns looks like a result."""
    cut = tmp_path / "cut.tif"
    cut.write_bytes(Path(mosaics[0]).read_bytes()[:-100_000])
    for ending in ("csv", "gpkg"):
        output = tmp_path / f"made.{ending}"
        assert_sentence(run("checkradiometry", RASTERS=[str(cut)], OUTPUT=str(output)).complaint, "could be measured")
        assert not output.exists()
        assert run("checkradiometry", RASTERS=mosaics[:1], OUTPUT=str(output)).complaint is None
        before = output.read_bytes()
        assert run("checkradiometry", RASTERS=[str(cut)], OUTPUT=str(output)).complaint is not None
        assert output.read_bytes() == before


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
