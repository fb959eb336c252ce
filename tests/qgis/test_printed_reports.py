"""Every report on A4, the widest in Polish, too: no page is empty or cut off, all are numbered, the result is first."""
from __future__ import annotations

from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from qgis.core import QgsApplication, QgsProcessingProvider
from seam_inspector.plugin.toolkit.translation import Translation, tr

from tests.numbers.synthetic import orthoimage, write_raster
from tests.printing import print_page, why_not
from tests.qgis.acceptance.seam_scenes import UTM33, X, Y, sealed, seams
from tests.qgis.resolution.bar_scenes import bar_layer, make_bar_scene
from tests.qgis.runs import run
from tests.qgis.scenes import BLURRED, SHARP, windows
from tests.qgis.seams.scan_scenes import write_scene

pytestmark = pytest.mark.slow

Report = Callable[[dict[str, Any], Path, Path], None]
"""From the inputs and a folder for more of them to the report's file."""

LONG = "a_name_without_any_space_that_nobody_could_break_into_lines_by_itself_because_it_is_so_very_long.tif"
MARGIN = 42  # points, 15 mm
FOOT = 0.94  # of the page's height: what stands below is the page's number
HEADING = 14.5  # points: the height of a word in a heading
TITLE = 21.5  # of one in a title, where the browser had not to shrink the page to make it fit


def inspection(given: dict[str, Any], folder: Path, path: Path) -> None:
    words = ["", "visible", "visible", ""]
    drawn = windows(SHARP, BLURRED, (192, 0, 128, 128), (0, 0, 9, 9), observer=("string", words))
    rasters = {"MOSAIC": given["mosaic"], "SOURCES": given["sources"]}
    inspected = run("inspectwindows", WINDOWS=drawn, **rasters)
    tables = {name: inspected.layer(name) for name in ("CURVES", "PAIRS", "PROFILES")}
    assert run("report", WINDOWS=inspected.layer(), OUTPUT=str(path), **rasters, **tables).complaint is None


def mending(given: dict[str, Any], folder: Path, path: Path) -> None:
    """A feathered seam, with its pictures."""
    files = write_scene(folder, width=40.0)
    scan = run("scanmosaic", **files.given())
    made(
        "mendseams", path, MOSAIC=files.mosaic, SOURCES=files.sources, SEAMS=scan.layer("SEAMS"), WHAT="all",
        PATCHES=str(folder / "patches"), MENDED=str(folder / "mended.vrt"),
    )


def radiometry(given: dict[str, Any], folder: Path, path: Path) -> None:
    long = write_raster(folder / LONG, orthoimage((300, 300)))
    made("checkradiometry", path, RASTERS=[given["mosaic"], *given["sources"], long], SEAMLINES=given["seams"])


def noise(given: dict[str, Any], folder: Path, path: Path) -> None:
    long = write_raster(folder / LONG, orthoimage((600, 600)))
    made("checknoise", path, RASTERS=[given["mosaic"], *given["sources"], long])


def resolution(given: dict[str, Any], folder: Path, path: Path) -> None:
    made("measureresolution", path, RASTER=given["target"], GROUPS=given["bars"], REFERENCE_GRD=100.0)


def one_line(given: dict[str, Any], folder: Path, path: Path) -> None:
    bars = make_bar_scene(folder, bands=1)
    made("measureresolution", path, RASTER=bars.path, GROUPS=bars.lines([(2, "across")]))


def many_groups(given: dict[str, Any], folder: Path, path: Path) -> None:
    """Sixty lines, six across each group as if they were groups of their own, in four bands."""
    bars = make_bar_scene(folder, bands=4)
    keys = [key for key in bars.groups for _ in range(6)]
    shapes, directions = [bars.geometry(*key) for key in keys], [direction for _, direction in keys]
    groups = [1 + directions[:place].count(direction) for place, direction in enumerate(directions)]
    made("measureresolution", path, RASTER=bars.path, GROUPS=bar_layer(shapes, groups, directions))


def orientation(given: dict[str, Any], folder: Path, path: Path) -> None:
    made("interiororientation", path, PHOTO=given["photo"], CALIBRATION=given["calibration"])


def sensor_model(given: dict[str, Any], folder: Path, path: Path) -> None:
    made("fitsensormodel", path, GCPS=given["gcps"], MODEL="polynomial_2d", HEIGHTS="ellipsoid")


def sensor_comparison(given: dict[str, Any], folder: Path, path: Path) -> None:
    made("comparesensormodels", path, GCPS=given["gcps"], HEIGHTS="ellipsoid")


def acceptance(given: dict[str, Any], folder: Path, path: Path) -> None:
    """One sheet, by a plan, with pictures of its failures."""
    pixels = np.random.default_rng(1).integers(60, 190, (3, 400, 1600)).astype(np.uint8)
    mosaic = write_raster(folder / LONG, pixels, 0.5, (X - 50, Y + 100), system=UTM33)
    kept = [0.9] * 4 + [0.5] * 14 + [0.9, 0.5] * 6
    made("acceptmosaic", path, SEAMS=[seams(kept)], MOSAIC=[mosaic], PLAN="iso2859", DEFECTS=None)


def acceptance_of_many(given: dict[str, Any], folder: Path, path: Path) -> None:
    """Forty sheets with long names, some of them with failures."""
    sheets = [
        seams([0.9, 0.5 if number % 3 else 0.9, 0.9, 0.5] * 3, y=30 * number, name=f"{LONG}_{number}")
        for number in range(40)
    ]
    made("acceptmosaic", path, SEAMS=sheets, DEFECTS=None)


def made(algorithm: str, path: Path, **parameters: Any) -> None:
    assert run(algorithm, REPORT=str(path), **parameters).complaint is None


REPORTS: dict[Report, str] = {
    inspection: "Flagged: a significant loss, or one that the observer saw.",
    mending: "mended",
    radiometry: "failed",
    noise: "",
    resolution: "geometric mean",
    one_line: "across the flight",
    many_groups: "",
    orientation: "root mean square of the residuals",
    sensor_model: "",
    sensor_comparison: "",
    acceptance: "Rejected",
    acceptance_of_many: "Rejected",
}
"""How each is made, and what of its result the first page has to say; what the report makes up by itself is empty."""


@pytest.fixture(scope="module", autouse=True)
def printer() -> None:
    why = why_not()
    if why:
        pytest.skip(why)


POLISH = (acceptance, many_groups, inspection)  # their tables are the widest, and Polish words are longer
DAILY = ((radiometry, "en"), (orientation, "en"), (acceptance, "pl"), (inspection, "pl"))
OTHERS = [(report, "en") for report in REPORTS if report is not many_groups] + [(report, "pl") for report in POLISH]
PRINTED = [*DAILY, *(pytest.param(*each, marks=pytest.mark.release) for each in OTHERS if each not in DAILY)]


@pytest.fixture
def language(request: pytest.FixtureRequest, monkeypatch: pytest.MonkeyPatch) -> Iterator[str]:
    """QGIS speaks it."""
    monkeypatch.setattr(QgsApplication, "locale", staticmethod(lambda: request.param))
    made = Translation()
    yield request.param
    made.remove()


@pytest.mark.parametrize(("report", "language"), PRINTED, indirect=["language"])
def test_a_report_is_fit_for_paper(
    report: Report, language: str, provider: QgsProcessingProvider, given: dict[str, Any], tmp_path: Path
) -> None:
    path = tmp_path / "report.html"
    report(given, tmp_path, path)
    pages = print_page(path, tmp_path)
    first = pages[0].text
    assert tr(REPORTS[report]) in first
    assert "Seam Inspector" in first
    assert report not in (acceptance, acceptance_of_many) or tr("signature") in first, "nobody signs on the cover"
    title = max(word.height for word in pages[0].words)
    assert title > TITLE, "something is wider than the page, so that all was shrunk to fit it"
    assert tr("How it was measured") in " ".join(page.text for page in pages)
    for number, page in enumerate(pages, 1):
        assert page.text.endswith(f"{number} / {len(pages)}"), f"page {number} has no number"
        assert (round(page.width), round(page.height)) == (595, 842)
        for word in page.words:
            assert word.left > MARGIN - 2, f"page {number}: {word.text} begins in the margin"
            assert word.right < page.width - MARGIN + 2, f"page {number}: {word.text} reaches into the margin"
        margin = round(0.6 * MARGIN / page.width * page.ink.shape[1])
        assert not page.ink[:, -margin:].any(), f"page {number}: something is cut off on the right"
        body = np.flatnonzero(page.ink[: int(FOOT * len(page.ink))].any(axis=1))
        assert body.size, f"page {number} is empty"
        lines = [word for word in page.words if word.bottom < FOOT * page.height]
        if number < len(pages):
            assert page.share_of(body[-1]) > 0.5, f"page {number} is nearly empty"
            assert max(lines, key=lambda word: word.bottom).height < HEADING, f"page {number} ends in a heading"
        else:
            assert len(lines) > 6, "the last page has hardly anything on it"


@pytest.mark.parametrize("language", ["pl"], indirect=True)
def test_a_cover_full_of_findings_is_one_page(
    language: str, provider: QgsProcessingProvider, tmp_path: Path
) -> None:
    facts = {
        "wavelet": "coif3", "seams": "given", "not_given": "cam2_101", "unexplained": "0.095",
        "unexplained_at": "500104 5187812 64 80", "unseen_metres": "163.3", "unseen_longest": "163.3",
        "unseen_at": "500088 5187870 48 99", "unchanged_metres": "69.7",
    }  # fmt: skip
    kept = [0.5, 0.5, *[0.9] * 10, *[None] * 12]
    reasons = [
        f"There is too little to measure along this piece: {why}"
        for why in ("a source ends beside it", "it is blurred", "it is too short", "there is no texture")
    ] * 6
    made("acceptmosaic", tmp_path / "report.html", SEAMS=[sealed(seams(kept, reasons=reasons), **facts)],
         DEFECTS=None, CONTRACT="7/2026", CLIENT="Agency", PRODUCER="Producer", DELIVERY="Delivery")
    first, second, *_ = print_page(tmp_path / "report.html", tmp_path)
    assert "cam2_101" in first.text
    assert "metadanych" in first.text
    assert second.text.startswith(tr("Where the seams failed"))


@pytest.mark.release
def test_three_sheets_of_radiometry_fit_a_page(
    provider: QgsProcessingProvider, given: dict[str, Any], tmp_path: Path
) -> None:
    rasters = [write_raster(tmp_path / f"sheet_{number}.tif", orthoimage((300, 300))) for number in range(9)]
    made("checkradiometry", tmp_path / "report.html", RASTERS=rasters, READY_RULES="jrc_lpis_each_band")
    pages = print_page(tmp_path / "report.html", tmp_path)
    of_sheets = [page.text for page in pages if page.text.count(tr("check")) and "sheet_" in page.text][1:-1]
    assert len(pages) <= 2 + 9 / 3
    assert all(len({number for number in range(9) if f"sheet_{number}.tif:" in text}) >= 3 for text in of_sheets)
