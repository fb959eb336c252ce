"""A failure's page can't refute it: title, curve, pictures and the layer of failures say the same, for each of all."""
from __future__ import annotations

import re
from pathlib import Path

import numpy as np
import pytest
from osgeo import gdal
from qgis.core import QgsVectorLayer
from seam_inspector.plugin.acceptance.paper.defect_files import PROOF_PX

from tests.pages import outline
from tests.qgis.acceptance.planted import GSD, Planted, make_block
from tests.qgis.acceptance.test_planted_deliveries import decide, scan

pytestmark = [pytest.mark.usefixtures("provider"), pytest.mark.slow]

ROUNDED, CODED = 0.0006, 4.0  # of three digits; DN of a JPEG of quality 95, in the mean
DELIVERIES: dict[str, tuple[tuple[Planted, ...], int, dict[str, object]]] = {
    "long": (((0, 133, 713), (1, 57, 637), (2, 248, 861)), 0, {}),
    "short": (((0, 100, 260), (0, 500, 610), (1, 300, 420), (2, 20, 140), (2, 700, 880)), 0, {}),
    "JPEG 85": (((0, 133, 713), (2, 248, 861)), 85, {}),
    "seams found": (((0, 200, 500), (1, 350, 700)), 0, {"SEAMLINES": None}),
}


def picture(data: bytes) -> np.ndarray:
    path = "/vsimem/panel.jpg"
    gdal.FileFromMemBuffer(path, data)
    return np.moveaxis(gdal.Open(path).ReadAsArray().astype(float), 0, 2)


@pytest.mark.parametrize("name", [
    "long", "JPEG 85", *(pytest.param(name, marks=pytest.mark.release) for name in ("short", "seams found"))
])  # fmt: skip
def test_all_that_a_page_shows_of_a_failure_is_what_decided(name: str, tmp_path: Path) -> None:
    planted, jpeg, more = DELIVERIES[name]
    block = make_block(tmp_path / "block", planted, jpeg=jpeg)
    seams = scan(block, tmp_path / "scan", **more).results["SEAMS"]
    outcome = decide(tmp_path / "paper", seams, MOSAIC=[block.mosaic], SOURCES=list(block.sources))
    assert outcome.complaint is None
    page = outline((tmp_path / "paper" / "decision.html").read_text(encoding="utf-8"))
    failures = list(QgsVectorLayer(str(tmp_path / "paper" / "failures.gpkg"), "", "ogr").getFeatures())
    titles = re.findall(r"Failure F(\d+): ([\d.]+).m, least kept (\d+)", page.words)
    assert [int(number) for number, _, _ in titles] == [row["defect"] for row in failures] != []
    pieces = {round(row["kept_1"], 3): row for row in QgsVectorLayer(seams, "", "ogr").getFeatures() if row["kept_1"]}
    curves = page.captions.count("Kept by the worst piece, by distance from the seam")
    assert curves == len(failures)
    panels = [item for item in map(picture, page.pictures("jpeg")) if item.shape[:2] == (PROOF_PX, PROOF_PX)]
    assert len(panels) == 4 * len(failures)  # mosaic, cut, two orthoimages
    mosaic = gdal.Open(block.mosaic)
    left, top = mosaic.GetGeoTransform()[::3]
    pixels = np.moveaxis(mosaic.ReadAsArray()[:3].astype(float), 0, 2)
    for (_, length, kept), row, panel in zip(titles, failures, panels[::4]):
        assert float(length) == pytest.approx(row["length"], abs=0.06)
        assert float(kept) == pytest.approx(100 * row["kept_1"], abs=0.51)
        piece = pieces[row["kept_1"]]
        strip, *steps = ([*map(float, item.split())] for item in piece["profile"].split("; "))
        assert strip[2] == pytest.approx(piece["kept_1"], abs=ROUNDED)
        within = [share for _, far, share in steps if far <= strip[1] + 1e-6]
        assert min(within) - ROUNDED <= strip[2] <= max(within) + ROUNDED, piece["profile"]
        middle = piece.geometry().interpolate(piece.geometry().length() / 2).asPoint()
        corner = np.floor([(top - middle.y()) / GSD - PROOF_PX / 2, (middle.x() - left) / GSD - PROOF_PX / 2])
        first = np.clip(corner.astype(int), 0, np.array(pixels.shape[:2]) - PROOF_PX)
        shown = pixels[first[0] : first[0] + PROOF_PX, first[1] : first[1] + PROOF_PX]
        inside = slice(8, -8)
        assert np.abs(panel - shown)[inside, inside].mean() < CODED
