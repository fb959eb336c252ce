"""Every report on A4, in both languages: no page is empty, nothing is cut off, pages are numbered, the result is first."""
from __future__ import annotations

from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from qgis.core import QgsApplication, QgsProcessingProvider
from seam_inspector.plugin.toolkit.translation import Translation, tr

from tests.numbers.synthetic import orthoimage, write_raster
from tests.printing import PrintedPage, print_page, why_not
from tests.qgis.resolution.bar_scenes import bar_layer, make_bar_scene
from tests.qgis.runs import run
from tests.qgis.scenes import BLURRED, SHARP, Scene, windows

Report = Callable[[dict[str, Any], Scene, Path], dict[str, Any]]

LONG = "a_name_without_any_space_that_nobody_could_break_into_lines_by_itself_because_it_is_so_very_long.tif"
MARGIN = 42  # points, 15 mm
FOOT = 0.94  # of the page's height: what stands below is the page's number
HEADING = 14.5  # points: the height of a word in a heading
TITLE = 21.5  # of one in a title, where the browser had not to shrink the page to make it fit


def inspection(given: dict[str, Any], scene: Scene, folder: Path) -> dict[str, Any]:
    words = ["", "visible", "visible", ""]
    drawn = windows(SHARP, BLURRED, (192, 0, 128, 128), (0, 0, 9, 9), observer=("string", words))
    found = run("inspectwindows", WINDOWS=drawn, MOSAIC=given["mosaic"], SOURCES=given["sources"])
    tables = {name: found.layer(name) for name in ("CURVES", "PAIRS", "PROFILES")}
    return {
        "": "report", "WINDOWS": found.layer(), "MOSAIC": given["mosaic"], "SOURCES": given["sources"], **tables,
        "OUTPUT": str(folder / "report.html"),
    }


def radiometry(given: dict[str, Any], scene: Scene, folder: Path) -> dict[str, Any]:
    long = write_raster(folder / LONG, orthoimage((300, 300)))
    return {"": "checkradiometry", "RASTERS": [given["mosaic"], *given["sources"], long], "SEAMLINES": given["seams"]}


def noise(given: dict[str, Any], scene: Scene, folder: Path) -> dict[str, Any]:
    long = write_raster(folder / LONG, orthoimage((600, 600)))
    return {"": "checknoise", "RASTERS": [given["mosaic"], *given["sources"], long]}


def resolution(given: dict[str, Any], scene: Scene, folder: Path) -> dict[str, Any]:
    return {"": "measureresolution", "RASTER": given["target"], "GROUPS": given["bars"], "REFERENCE_GRD": 100.0}


def one_line(given: dict[str, Any], scene: Scene, folder: Path) -> dict[str, Any]:
    bars = make_bar_scene(folder, bands=1)
    return {"": "measureresolution", "RASTER": bars.path, "GROUPS": bars.lines([(2, "across")])}


def many_groups(given: dict[str, Any], scene: Scene, folder: Path) -> dict[str, Any]:
    """Sixty lines across a target that is forty times as wide as high."""
    bars = make_bar_scene(folder, bands=4)
    shapes, groups, directions = [], [], []
    for group, direction in [key for key in bars.groups for _ in range(6)]:
        place = 1 + sum(one == direction for one in directions)
        shapes.append(bars.geometry(group, direction))
        groups.append(place)
        directions.append(direction)
    return {"": "measureresolution", "RASTER": bars.path, "GROUPS": bar_layer(shapes, groups, directions)}


def orientation(given: dict[str, Any], scene: Scene, folder: Path) -> dict[str, Any]:
    return {"": "interiororientation", "PHOTO": given["photo"], "CALIBRATION": given["calibration"]}


def sensor_model(given: dict[str, Any], scene: Scene, folder: Path) -> dict[str, Any]:
    return {"": "fitsensormodel", "GCPS": given["gcps"], "MODEL": "polynomial_2d", "HEIGHTS": "ellipsoid"}


def sensor_comparison(given: dict[str, Any], scene: Scene, folder: Path) -> dict[str, Any]:
    return {"": "comparesensormodels", "GCPS": given["gcps"], "HEIGHTS": "ellipsoid"}


REPORTS: dict[Report, str] = {
    inspection: "Flagged is a significant loss, or one that the observer saw.",
    radiometry: "failed",
    noise: "",
    resolution: "geometric mean",
    one_line: "across the flight",
    many_groups: "",
    orientation: "root mean square of the residuals",
    sensor_model: "",
    sensor_comparison: "",
}
"""How each is made, and what of its result the first page has to say; what the report makes up by itself is empty."""


@pytest.fixture(scope="module", autouse=True)
def printer() -> None:
    why = why_not()
    if why:
        pytest.skip(why)


@pytest.fixture(params=["en", "pl"])
def language(request: pytest.FixtureRequest, monkeypatch: pytest.MonkeyPatch) -> Iterator[str]:
    """QGIS speaks it."""
    monkeypatch.setattr(QgsApplication, "locale", staticmethod(lambda: request.param))
    made = Translation()
    yield request.param
    made.remove()


def printed(report: Report, given: dict[str, Any], scene: Scene, folder: Path) -> list[PrintedPage]:
    parameters = report(given, scene, folder)
    algorithm, path = parameters.pop(""), folder / "report.html"
    if algorithm != "report":
        parameters["REPORT"] = str(path)
    assert run(algorithm, **parameters).complaint is None
    return print_page(path, folder)


@pytest.mark.parametrize("report", REPORTS, ids=lambda report: report.__name__)
def test_a_report_is_fit_for_paper(
    report: Report, language: str, provider: QgsProcessingProvider, given: dict[str, Any], scene: Scene, tmp_path: Path
) -> None:
    pages = printed(report, given, scene, tmp_path)
    first = pages[0].text
    assert tr(REPORTS[report]) in first
    assert "Seam Inspector" in first
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
