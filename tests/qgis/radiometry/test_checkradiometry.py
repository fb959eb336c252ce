"""``checkradiometry`` as QGIS runs it: its contract, its report, and bad input."""
from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from tests.numbers.synthetic import read_pixels, write_raster
from tests.qgis.runs import assert_sentence, run
from tests.qgis.scenes import layer, line

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
