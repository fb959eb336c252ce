"""What an officer signs: whose delivery it is, proof of each failure, verdicts of sheets, what was decided on."""
from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest
from osgeo import gdal
from qgis.core import QgsGeometry
from seam_inspector.plugin.acceptance.paper.defect_files import PROOF_PX
from seam_inspector.plugin.imagery.grids import PixelWindow
from seam_inspector.plugin.imagery.rasters import Raster
from seam_inspector.plugin.imagery.seam_totals import RowTotals
from seam_inspector.plugin.proven_acceptance import proof_panels
from seam_inspector.plugin.seams.measure.window.inspection import open_block
from seam_inspector.python.scan_files import read_seams

from tests.pages import Outline, outline
from tests.qgis.acceptance.seam_scenes import seams
from tests.qgis.acceptance.test_whole_deliveries_on_paper import index
from tests.qgis.runs import Run, run
from tests.qgis.seams.scan_scenes import Files, write_scene

pytestmark = pytest.mark.usefixtures("provider")

HEAD = {
    "TITLE": "Protocol 7", "CONTRACT": "12/2026", "PRODUCER": "Maker & Sons", "CLIENT": "Agency",
    "DELIVERY": "North, third", "DELIVERY_DATE": "2026-11-20",
}  # fmt: skip


@pytest.fixture(scope="module")
def feathered(tmp_path_factory: pytest.TempPathFactory) -> Files:
    return write_scene(tmp_path_factory.mktemp("feathered"), width=24.0)


@pytest.fixture(scope="module")
def paper(
    provider: None, feathered: Files, tmp_path_factory: pytest.TempPathFactory
) -> Iterator[tuple[Run, Path]]:
    """Scanned and decided on; nobody names the orthoimages a second time."""
    folder = tmp_path_factory.mktemp("paper")
    scanned = run("scanmosaic", **feathered.given(LOSS=str(folder / "loss.tif"), SEAMS=str(folder / "seams.gpkg")))
    assert scanned.complaint is None
    made = run(
        "acceptmosaic", SEAMS=[str(folder / "seams.gpkg")], MOSAIC=[feathered.mosaic],
        DEFECTS=str(folder / "failures.gpkg"), REPORT=str(folder / "decision.html"),
        QUALITY=str(folder / "quality.xml"), **HEAD,
    )  # fmt: skip
    assert made.complaint is None
    yield made, folder
    scanned.close()
    made.close()


def page(folder: Path) -> Outline:
    return outline((folder / "decision.html").read_text(encoding="utf-8"))


def test_the_head_says_whose_delivery_it_is(paper: tuple[Run, Path]) -> None:
    _, folder = paper
    words = page(folder).words
    for value in HEAD.values():
        assert value in words
    xml = (folder / "quality.xml").read_text(encoding="utf-8")
    for value in ("Protocol 7", "12/2026", "Maker &amp; Sons", "2026-11-20"):
        assert value in xml


def test_each_failure_is_proved_beside_its_orthoimages(paper: tuple[Run, Path]) -> None:
    made, folder = paper
    read = page(folder)
    failures = made.features("DEFECTS")
    assert failures
    captions = [item for item in read.captions if item.startswith(("The mosaic", "Its orthoimages", "Orthoimage "))]
    assert captions == ["The mosaic", "Its orthoimages, cut hard", "Orthoimage east.tif", "Orthoimage west.tif"] * len(
        failures
    )
    assert all(0 < row["visibility"] < 20 for row in made.rows("DEFECTS"))
    jpeg = gdal.Open(str(folder / "failures_pictures" / "defect_001.jpg"))
    assert jpeg.RasterXSize == 4 * 2 * PROOF_PX + 3 * 8  # the four panels at 2x below the picture


def middle_part(raster: Raster) -> PixelWindow:
    """Across the seam, which runs 20 m from the west."""
    return PixelWindow(200 - PROOF_PX // 2, (raster.rows - PROOF_PX) // 2, PROOF_PX, PROOF_PX)


def test_the_proof_shows_pixels_of_the_same_place_and_what_the_cut_would_have_kept(feathered: Files) -> None:
    block = open_block(feathered.mosaic, feathered.sources)
    part = middle_part(block.mosaic)
    mosaic, cut, east, west = (
        item.pixels.astype(float) for item in proof_panels(block, part, ("west", "east.tif"))
    )
    for shown, path in ((mosaic, feathered.mosaic), (east, feathered.east), (west, feathered.west)):
        true = gdal.Open(path).ReadAsArray(part.column, part.row, part.width, part.height)
        np.testing.assert_array_equal(shown, np.moveaxis(true, 0, 2))

    def fine(pixels: np.ndarray) -> float:
        return float(np.diff(pixels[..., 1], axis=0).var())

    assert fine(mosaic) < 0.97 * fine(cut)
    assert fine(cut) == pytest.approx((fine(east) + fine(west)) / 2, rel=0.1)


def test_without_orthoimages_there_is_the_mosaic_alone(
    tmp_path: Path, feathered: Files, paper: tuple[Run, Path]
) -> None:
    """The layer is like an export, which lost what its scan wrote beside its rows."""
    exported = str(tmp_path / "seams.shp")
    gdal.VectorTranslate(exported, str(paper[1] / "seams.gpkg"), layers=["seams"])
    made = run(
        "acceptmosaic", SEAMS=[exported], MOSAIC=[feathered.mosaic], DEFECTS=None,
        REPORT=str(tmp_path / "decision.html"),
    )  # fmt: skip
    assert made.complaint is None
    read = page(tmp_path)
    assert read.pictures("jpeg")
    assert set(read.captions) >= {"The mosaic"}
    assert "Its orthoimages, cut hard" not in read.captions


def test_sheets_come_back_with_their_verdicts() -> None:
    made = run("acceptmosaic", SEAMS=[seams([0.5] * 3 + [0.9] * 5)], SHEETS=index(), DEFECTS=None, REPORT=None)
    assert made.complaint is None
    rows = {row["sheet"]: row for row in made.rows("SHEETS_OUT")}
    assert {name: row["verdict"] for name, row in rows.items()} == {
        "sheet_1": "no_seams", "sheet_2": "accepted", "sheet_3": "no_seams", "sheet_10": "rejected",
    }  # fmt: skip
    assert rows["sheet_10"]["failed"] == pytest.approx(75)
    assert rows["sheet_10"]["failed_share"] == pytest.approx(75)
    assert all(feature.geometry().area() == pytest.approx(10_000) for feature in made.features("SHEETS_OUT"))


def test_page_and_record_say_which_rows_were_decided_on(paper: tuple[Run, Path]) -> None:
    _, folder = paper
    rows, _ = read_seams(folder / "seams.gpkg")
    totals = RowTotals()
    for row in rows:
        line = QgsGeometry.fromWkt(row["geometry"])
        totals.add(row, np.array([(point.x(), point.y()) for point in line.vertices()]))
    assert totals.digest in page(folder).words
    assert totals.digest in (folder / "quality.xml").read_text(encoding="utf-8")
