"""``seaminspector:scanmosaic`` on real mosaics: Brighton feathered; cut hard before a release."""
from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from osgeo import gdal

from tests.numbers.seams.scan.lines.labelled import points_between
from tests.qgis.runs import Run, run
from tests.qgis.seams.scan_scenes import points_along, share_within

pytestmark = pytest.mark.usefixtures("provider")

HARD, FEATHER = "mosaic_hardseam", "mosaic_feather0p4m"
PIECE_M = 2.0  # 67 px at 3 cm


@pytest.fixture(scope="module")
def true_seams(brighton: Path) -> np.ndarray:
    """(n, 2) map places, one per side of a pixel between two sources."""
    dataset = gdal.Open(str(brighton / "source_label.tif"))
    left, width, _, top, _, height = dataset.GetGeoTransform()
    return points_between(dataset.ReadAsArray().astype(int) - 1) * (width, height) + (left, top)


@pytest.fixture(scope="module", params=[pytest.param(HARD, marks=pytest.mark.release), FEATHER])
def scan(request: pytest.FixtureRequest, provider: None, brighton: Path) -> Iterator[Run]:
    """One of the mosaics with its orthoimages, its seams scan."""
    made = scanned(brighton, request.param, SOURCES=orthoimages(brighton))
    yield made
    made.close()


def orthoimages(brighton: Path) -> list[str]:
    return sorted(map(str, brighton.glob("DJI_*.tif")))


def scanned(brighton: Path, mosaic: str, **given: Any) -> Run:
    ended = run("scanmosaic", MOSAIC=str(brighton / f"{mosaic}.tif"), **{"PIECE": PIECE_M, **given})
    assert ended.complaint is None
    return ended


def mosaic_of(scan: Run) -> str:
    return HARD if scan.results["FAILED_METRES"] == 0 else FEATHER


def failed_places(scan: Run) -> np.ndarray:
    return points_along(
        (feature.geometry() for feature in scan.features("SEAMS") if feature["verdict"] == "significant"), 0.05
    )


def test_seams_are_found_where_they_are(scan: Run, true_seams: np.ndarray) -> None:
    distance, share = (0.3, 0.94) if mosaic_of(scan) == HARD else (0.6, 0.9)
    places = points_along((feature.geometry() for feature in scan.features("SEAMS")), 0.015)
    assert share_within(places, true_seams, distance) >= share
    assert share_within(true_seams, places, distance) >= share


def test_failed_metres_lie_on_the_seams_of_the_feathered_mosaic_alone(scan: Run, true_seams: np.ndarray) -> None:
    verdicts = scan.column("verdict", "SEAMS")
    if scan.results["FAILED_METRES"] == 0:
        assert "significant" not in verdicts
        assert "reduced" not in verdicts
        return
    judged = sum(row["length"] for row in scan.rows("SEAMS") if row["verdict"] != "not_comparable")
    assert scan.results["FAILED_METRES"] > 0.6 * judged
    assert judged > 0.5 * scan.results["SEAM_METRES"]
    assert share_within(failed_places(scan), true_seams, 1.0) >= 0.95


def seamlines(brighton: Path, layer: str = "seamlines") -> str:
    return f"{brighton / 'seamlines.gpkg'}|layername={layer}"


@pytest.mark.release
def test_seamlines_and_polygons_mean_the_same(provider: None, brighton: Path, true_seams: np.ndarray) -> None:
    given = {"SOURCES": orthoimages(brighton), "CORRIDOR": 4.0}
    lines, polygons = (scanned(brighton, FEATHER, SEAMLINES=seamlines(brighton, layer), **given)
                       for layer in ("seamlines", "source_polygons"))
    assert lines.results["SEAM_METRES"] == pytest.approx(polygons.results["SEAM_METRES"], rel=0.01)
    assert lines.results["FAILED_METRES"] == pytest.approx(polygons.results["FAILED_METRES"], rel=0.1)
    assert share_within(failed_places(lines), true_seams, 1.0) >= 0.95


@pytest.mark.release
@pytest.mark.parametrize("mosaic", [HARD, FEATHER])
def test_without_orthoimages_the_seam_network_is_judged(
    provider: None, brighton: Path, true_seams: np.ndarray, mosaic: str
) -> None:
    ended = scanned(brighton, mosaic, SEAMLINES=seamlines(brighton), PIECE=25.0)
    (said,) = (info for info in ended.log.infos if "All seams together keep" in info)
    low, high = (float(word) for word in said.partition("(")[2].partition(" %")[0].split(" to "))
    if mosaic == HARD:
        assert low < 100 < high
        assert "significant" not in ended.column("verdict", "SEAMS")
    else:
        assert high < 100
        assert share_within(failed_places(ended), true_seams, 1.0) >= 0.95
    assert ended.features("CELLS") == []
