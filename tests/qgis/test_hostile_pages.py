"""Reports of inputs whose names are made to run or fetch something, in a browser: they are words, nothing happens."""
from __future__ import annotations

import re
import shutil
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from qgis.core import QgsProcessingProvider, QgsVectorLayer
from seam_inspector.plugin.imagery.errors import printable

from tests.browser import SeenPage, see
from tests.printing import why_not
from tests.qgis.acceptance.seam_scenes import seams
from tests.qgis.runs import run
from tests.qgis.scenes import BLURRED, SHARP, layer, line, windows

FILE = "javascript:parent.ran(self)\"'><img src=x onerror=parent.ran(self)>&lt;b {{7*7}}\u202egnp"
"""What the name of a file can be: no slash, 255 bytes."""
NAME = f"{FILE}</title></style></script><script>parent.ran(self)</script><a href=javascript:parent.ran(self)>-->"
POLICY = re.compile(r"<meta http-equiv=\"Content-Security-Policy\"[^>]*>")
CONTROL = f"<!DOCTYPE html><title>control</title><p>{NAME}</p>"


def inspection(given: dict[str, Any], folder: Path, path: Path) -> None:
    said = {name: ("string", [NAME, NAME]) for name in ("remark", "remark_2", "observer_2")}
    drawn = windows(SHARP, BLURRED, observer=("string", ["visible", "visible"]), **said)
    rasters = {"MOSAIC": named(given["mosaic"], folder), "SOURCES": [named(path, folder) for path in given["sources"]]}
    inspected = run("inspectwindows", WINDOWS=called(drawn), SEAMLINES=called(seamline()), **rasters)
    tables = {name: called(inspected.layer(name)) for name in ("CURVES", "PAIRS", "PROFILES")}
    made("report", path, "OUTPUT", WINDOWS=called(inspected.layer()), **rasters, **tables, TITLE=NAME)


def radiometry(given: dict[str, Any], folder: Path, path: Path) -> None:
    rasters = [named(path, folder) for path in (given["mosaic"], *given["sources"])]
    made("checkradiometry", path, RASTERS=rasters, SEAMLINES=called(seamline()))


def orientation(given: dict[str, Any], folder: Path, path: Path) -> None:
    files = {name.upper(): named(given[name], folder) for name in ("photo", "calibration")}
    made("interiororientation", path, **files)


def sensor_model(given: dict[str, Any], folder: Path, path: Path) -> None:
    made("fitsensormodel", path, GCPS=points(given), MODEL="polynomial_2d", HEIGHTS="ellipsoid")


def acceptance(given: dict[str, Any], folder: Path, path: Path) -> None:
    kept = [0.9] * 4 + [0.5] * 14 + [0.9, 0.5] * 6
    made("acceptmosaic", path, SEAMS=[seams(kept, name=NAME)], PLAN="iso2859", DEFECTS=None)


def named(path: str, folder: Path) -> str:
    """A file by a hostile name."""
    copy = folder / f"{FILE}{len(list(folder.iterdir()))}{Path(path).suffix}"
    return str(shutil.copy(path, copy))


def called(given: QgsVectorLayer) -> QgsVectorLayer:
    """A layer by a hostile name."""
    given.setName(NAME)
    return given


def seamline() -> QgsVectorLayer:
    return layer("LineString", [line((200, 0), (300, 256))])


def points(given: dict[str, Any]) -> QgsVectorLayer:
    read = list(QgsVectorLayer(given["gcps"].split("://", 1)[1], "", "delimitedtext").getFeatures())
    fields = {name: ("double", [row[name] for row in read]) for name in ("column", "row", "z")}
    return called(layer("Point", [row.geometry() for row in read], id=("string", [NAME] * len(read)), **fields))


def made(algorithm: str, path: Path, output: str = "REPORT", **parameters: Any) -> None:
    assert run(algorithm, **{output: str(path)}, **parameters).complaint is None


REPORTS: tuple[Callable[[dict[str, Any], Path, Path], None], ...] = (
    inspection, radiometry, orientation, sensor_model, acceptance,
)  # fmt: skip


@pytest.fixture(scope="module")
def seen(
    provider: QgsProcessingProvider, given: dict[str, Any], tmp_path_factory: pytest.TempPathFactory
) -> dict[str, SeenPage]:
    """Every report as it is and without its policy, and a page that escapes nothing, in one browser."""
    if why := why_not():
        pytest.skip(why)
    pages = {"control": CONTROL}
    for report in REPORTS:
        folder = tmp_path_factory.mktemp(report.__name__)
        report(given, folder, folder / "report.html")
        page = (folder / "report.html").read_text(encoding="utf-8")
        pages[report.__name__] = page
        pages[f"{report.__name__}_without_policy"], count = POLICY.subn("", page)
        assert count == 1
    return see(pages)


def test_the_eyes_see_what_runs_and_what_is_asked_for(seen: dict[str, SeenPage]) -> None:
    control = seen["control"]
    assert control.ran >= 2
    assert control.asked == ["/control/x"]
    assert control.handlers >= 2


@pytest.mark.parametrize("policy", ["", "_without_policy"])
@pytest.mark.parametrize("report", [report.__name__ for report in REPORTS])
def test_names_are_words_on_a_page(report: str, policy: str, seen: dict[str, SeenPage]) -> None:
    """Escaped alone they do nothing; the page's policy is a second wall."""
    page = seen[f"{report}{policy}"]
    assert page.ran == 0
    assert page.asked == []
    assert page.handlers == 0
    assert "\u202e" not in page.words
    assert printable(FILE) in page.words
