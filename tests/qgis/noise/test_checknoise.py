"""``checknoise`` as QGIS runs it: its contract, its files, and bad input."""
from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from tests.numbers.synthetic import decompose, luminance, patchy_texture, read_pixels, write_raster
from tests.qgis.runs import Run, assert_sentence, run
from tests.qgis.scenes import windows

pytestmark = pytest.mark.usefixtures("provider")

SIDE = 512
FIELDS = (
    "raster group window_id band detail_1 detail_2 detail_3 background kurtosis_1 kurtosis_2 kurtosis_3 sigma noise"
).split()


@pytest.fixture(scope="module")
def pictures(tmp_path_factory: pytest.TempPathFactory) -> dict[str, str]:
    """Pictures of one ground, clean and with noise."""
    folder, random = tmp_path_factory.mktemp("pictures"), np.random.default_rng(0)
    ground = np.stack([120 + 25 * patchy_texture((SIDE, SIDE), 2.7, 1 + band // 9) for band in range(3)])
    made = {}
    for name, sigma in (("clean", 0.3), ("grainy", 5.0), ("noisy", 15.0)):
        pixels = np.rint(ground + random.normal(0, sigma, ground.shape)).clip(1, 255).astype(np.uint8)
        made[name] = write_raster(folder / f"{name}.tif", pixels, nodata=0)
    return made


def test_the_table_holds_the_figures_of_every_band(pictures: dict[str, str]) -> None:
    outcome = run("checknoise", RASTERS=[pictures["clean"]])
    rows = outcome.rows()
    assert list(rows[0])[: len(FIELDS)] == FIELDS
    assert [row["band"] for row in rows] == ["luminance", "red", "green", "blue"]
    assert outcome.layer().wkbType() == 100  # a table
    pixels = read_pixels(pictures["clean"], 0, 0, SIDE, SIDE)
    for row, band in zip(rows, [luminance(pixels), *pixels]):
        assert (row["raster"], row["group"], row["window_id"]) == ("clean.tif", 1, 1)
        shares = [row["detail_1"], row["detail_2"], row["detail_3"], row["background"]]
        assert shares == pytest.approx(decompose(band).shares, abs=1e-6)
        assert (row["column"], row["row"], row["width"], row["height"]) == (0, 0, SIDE, SIDE)
        assert row["pixel_size"] == pytest.approx(0.1 / 0.9996)  # amid a zone of UTM


def counts(outcome: Run) -> list[int]:
    return [outcome.results[f"{word}_COUNT"] for word in ("LOW", "UNCERTAIN", "MODERATE", "STRONG")]


def test_ground_that_three_images_show_counts_once_with_the_strongest_verdict(pictures: dict[str, str]) -> None:
    outcome = run("checknoise", RASTERS=list(pictures.values()))
    words = {row["raster"]: row["noise"] for row in outcome.rows() if row["band"] == "red"}
    assert words == {"clean.tif": "low", "grainy.tif": "moderate", "noisy.tif": "strong"}
    assert {row["window_id"] for row in outcome.rows()} == {1}
    assert counts(outcome) == [0, 0, 0, 1]
    assert counts(run("checknoise", RASTERS=[pictures["clean"]] * 3)) == [1, 0, 0, 0]
    drawn = windows((0, 0, 256, 256), (256, 256, 256, 256))
    assert sum(counts(run("checknoise", RASTERS=list(pictures.values()), WINDOWS=drawn))) == 2


# --- groups ----------------------------------------------------------------------------------------------------


def test_groups_have_names(pictures: dict[str, str], tmp_path: Path) -> None:
    chart, report = tmp_path / "noise.svg", tmp_path / "noise.html"
    outcome = run(
        "checknoise", RASTERS=[pictures["clean"], pictures["grainy"]], SECOND_GROUP=[pictures["noisy"]],
        GROUP_NAME="DMC <8 bit> & $x$", CHART=str(chart), REPORT=str(report),
    )
    assert {row["group_name"] for row in outcome.rows()} == {"DMC <8 bit> & $x$", "noisy.tif"}
    drawn = chart.read_text(encoding="utf-8").replace("&gt;", ">")
    assert "DMC &lt;8 bit> &amp; $x$" in drawn
    page = report.read_text(encoding="utf-8")
    assert "DMC &lt;8 bit&gt; &amp; $x$" in page
    assert "DMC <8 bit>" not in page


def test_windows_are_grouped_by_a_field(pictures: dict[str, str], tmp_path: Path) -> None:
    chart, report = tmp_path / "noise.svg", tmp_path / "noise.html"
    drawn = windows(
        (0, 0, 192, 192), (192, 0, 192, 192), (0, 192, 192, 192), (256, 256, 192, 192),
        land_use=("string", ["forest", "field", "forest", None]),
    )
    outcome = run(
        "checknoise", RASTERS=[pictures["clean"]], SECOND_GROUP=[pictures["noisy"]], WINDOWS=drawn,
        GROUP_FIELD="land_use", CHART=str(chart), REPORT=str(report),
    )
    classes = {(row["window_id"], row["class"] or None) for row in outcome.rows()}
    assert classes == {(1, "forest"), (2, "field"), (3, "forest"), (4, None)}
    words = chart.read_text(encoding="utf-8")
    titles = "land_use: forest", "land_use: field", "land_use: no value"
    for title in (*titles, "clean.tif: mean and range of 2 windows"):
        assert title in words
    page = report.read_text(encoding="utf-8")
    assert "Groups" in page
    assert page.index(">field</td>") < page.index(">forest</td>") < page.index(">no value</td>")


def test_two_groups_on_the_same_ground_are_compared_window_by_window(pictures: dict[str, str]) -> None:
    drawn = windows((0, 0, 128, 128), (256, 256, 200, 200), window_id=("integer", [11, 12]))
    outcome = run("checknoise", RASTERS=[pictures["clean"]], SECOND_GROUP=[pictures["noisy"]], WINDOWS=drawn, LEVELS=2)
    rows = [row for row in outcome.rows() if row["band"] == "luminance"]
    assert [(row["window_id"], row["group"]) for row in rows] == [(11, 1), (11, 2), (12, 1), (12, 2)]
    assert [row["width"] for row in rows] == [128, 128, 200, 200]
    assert "detail_3" not in rows[0]
    for clean, noisy in (rows[:2], rows[2:]):
        assert noisy["sigma"] > 5 * clean["sigma"]


def test_a_bad_raster_is_named_and_the_others_are_measured(pictures: dict[str, str], tmp_path: Path) -> None:
    (tmp_path / "text.tif").write_text("no raster")
    outcome = run("checknoise", RASTERS=["/nowhere/a.tif", str(tmp_path / "text.tif"), pictures["clean"]])
    assert outcome.complaint is None
    assert len(outcome.rows()) == 4
    assert len(outcome.log.warnings) == 3  # two left out, and smaller windows
    assert_sentence(outcome.log.warnings[0], r"a\.tif is left out: .* does not exist")
    assert_sentence(outcome.log.warnings[1], r"text\.tif is left out: .* is not a raster")
