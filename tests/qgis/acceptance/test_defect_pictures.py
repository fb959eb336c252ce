"""Pictures of failures: where they are cut, what is drawn into them, what they weigh."""
from __future__ import annotations

import math
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from osgeo import gdal
from seam_inspector.plugin.acceptance.measure.decision import Decision, defects_of
from seam_inspector.plugin.acceptance.paper.defect_files import (
    IMAGE_PANEL,
    MOSAIC_PANEL,
    PICTURE_PX,
    PROOF_PX,
    DefectPicture,
    DefectPictures,
    ProofPanel,
    save_pictures,
)
from seam_inspector.plugin.imagery.errors import SettingsError
from seam_inspector.plugin.imagery.open_raster import describe_mosaic
from seam_inspector.plugin.imagery.rasters import Raster, RasterRef

from tests.numbers.acceptance.made_decisions import BOTTOM, LEFT, UTM, decided
from tests.numbers.synthetic import write_raster
from tests.qgis.acceptance.papers import ground

UTM_SCALE = 0.9996  # of lengths amid a zone
YELLOW = np.array([255, 214, 0])


def picture_of(decision: Decision, *mosaics: Raster) -> DefectPicture:
    items = DefectPictures(mosaics, decision).of(defects_of(decision)[0])
    assert items is not None
    return items


def dashes(pixels: np.ndarray) -> np.ndarray:
    """(n, 2) rows and columns of the line."""
    return np.argwhere(abs(pixels - YELLOW).sum(axis=2) < 90)


def flat(path: Path, kind: str = "uint8", value: int = 120, pixel: float = 0.1) -> Raster:
    """An even mosaic of 60 x 60 m around the first seam, from 80 m north of its beginning."""
    shape = (3, round(60 / pixel), round(60 / pixel))
    pixels = np.full(shape, value, kind)
    pixels[:, ::7] += value // 4
    write_raster(path, pixels, pixel, (LEFT - 30, BOTTOM + 140), system=UTM)
    return describe_mosaic(RasterRef(str(path)))


def test_the_seam_is_drawn_where_it_runs_and_can_be_seen_between_dashes(tmp_path: Path) -> None:
    decision = decided(failed=[(0, 4)])
    result = picture_of(decision, flat(tmp_path / "mosaic.tif"))
    assert (result.around.shape[1], result.is_whole) == (PICTURE_PX, True)
    assert result.side_m == pytest.approx(40 / UTM_SCALE)
    drawn = dashes(result.around.astype(int))
    path = decision.delivery.pieces[4].vertices
    middle = (path.min(axis=0) + path.max(axis=0)) / 2
    for row, column in drawn[::25]:
        y, x = middle[1] + 20 - row / 10, middle[0] - 20 + column / 10
        assert abs(x - np.interp(y, path[:, 1], path[:, 0])) < 0.4
    rows = np.unique(drawn[:, 0])
    assert 75 < rows.max() - 75 < 330
    assert 0.15 < len(rows) / (rows.max() - rows.min()) < 0.75


def test_panels_show_the_worst_piece_across_its_middle_and_mark_the_seam_at_their_edges(tmp_path: Path) -> None:
    """Whoever has the orthoimages is asked for that place; nothing lies on what is shown, and what was given stays."""
    decision, mosaic = decided(failed=[(0, 4)]), flat(tmp_path / "mosaic.tif")
    bare, asked = np.full((PROOF_PX, PROOF_PX, 3), 90, np.uint8), []

    def prover(*given: object) -> list[ProofPanel]:
        asked.append(given)
        return [ProofPanel(MOSAIC_PANEL, "", bare), ProofPanel(IMAGE_PANEL, "a.tif", bare)]

    made = DefectPictures((mosaic,), decision, prover).of(defects_of(decision)[0])
    assert made is not None
    ((_, part, sides),) = asked
    piece = decision.delivery.pieces[4]
    assert sides == (piece.left_source, piece.right_source)
    x, y = LEFT - 30 + (part.column + PROOF_PX / 2) / 10, BOTTOM + 140 - (part.row + PROOF_PX / 2) / 10
    assert (x, y) == pytest.approx(piece.middle, abs=0.1)
    for panel in made.panels:
        drawn = np.argwhere((panel.pixels == YELLOW).all(axis=2))
        assert {"up" if row < PROOF_PX / 2 else "down" for row, _ in drawn} == {"up", "down"}
        for row, column in drawn:
            y, x = BOTTOM + 140 - (part.row + row + 0.5) / 10, LEFT - 30 + (part.column + column + 0.5) / 10
            assert abs(x - np.interp(y, *piece.vertices.T[::-1])) < 0.2
        assert (panel.pixels[8:-8, 8:-8] == 90).all()
    assert (bare == 90).all()


def test_a_long_failure_is_shown_whole_and_where_least_is_kept_in_full_size(tmp_path: Path) -> None:
    mosaic = ground(tmp_path / "mosaic.tif")
    decision = decided(failed=[(0, number) for number in range(4, 24)])
    pieces = list(decision.pieces)
    pieces[12] = replace(pieces[12], piece=replace(pieces[12].piece, kept_1=0.1))
    result = picture_of(replace(decision, pieces=tuple(pieces)), mosaic)
    assert result.is_whole
    assert result.side_m == pytest.approx(200 / UTM_SCALE)  # as wide as the mosaic
    (panel,) = result.panels
    grid, (x, y) = mosaic.grid, decision.delivery.pieces[12].middle
    row, column = math.floor(grid.row_at(y) - PROOF_PX / 2), math.floor(grid.column_at(x) - PROOF_PX / 2)
    truth = gdal.Open(mosaic.ref.path).ReadAsArray(column, row, PROOF_PX, PROOF_PX)
    np.testing.assert_array_equal(panel.pixels[8:-8, 8:-8], np.moveaxis(truth, 0, 2)[8:-8, 8:-8])
    assert len(result.jpeg()) < 300_000


def test_the_sheet_that_shows_it_is_taken(tmp_path: Path) -> None:
    elsewhere = tmp_path / "elsewhere.tif"
    write_raster(elsewhere, np.full((600, 600), 255, np.uint8), 0.1, (LEFT + 500, BOTTOM + 140), system=UTM)
    other = describe_mosaic(RasterRef(str(elsewhere)))
    items = picture_of(decided(failed=[(0, 4)]), other, flat(tmp_path / "here.tif"))
    assert items.side_m == pytest.approx(40 / UTM_SCALE)
    decision = decided(failed=[(0, 4)])
    assert DefectPictures([other], decision).of(defects_of(decision)[0]) is None


def test_pictures_take_the_place_of_older_ones_but_of_no_sheet(tmp_path: Path) -> None:
    decision = decided(failed=[(0, 4)])
    mosaic, folder = flat(tmp_path / "mosaic.tif"), tmp_path / "failures_pictures"
    result = picture_of(decision, mosaic)
    folder.mkdir()
    for name in ("defect_001.jpg", "defect_7.jpg"):
        (folder / name).write_bytes(b"sheet")
    with pytest.raises(SettingsError, match=r"defect_7\.jpg, which belongs to an input"):
        save_pictures(folder, {1: result}, {}, [mosaic.ref.path, str(folder / "defect_7.jpg")])
    assert {path.name: path.read_bytes() for path in folder.iterdir()} == dict.fromkeys(
        ("defect_001.jpg", "defect_7.jpg"), b"sheet"
    )
    save_pictures(folder, {1: result}, {}, [mosaic.ref.path])
    assert [path.name for path in folder.iterdir()] == ["defect_001.jpg"]
