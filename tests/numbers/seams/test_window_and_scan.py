"""On the same seam a window and the pieces of a scan differ by less than their intervals: both are one estimator."""
from __future__ import annotations

from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import pytest
from osgeo import gdal, ogr
from seam_inspector.plugin.imagery.grids import PixelWindow
from seam_inspector.plugin.imagery.open_raster import describe, describe_mosaic
from seam_inspector.plugin.imagery.rasters import RasterRef
from seam_inspector.plugin.seams.measure.blocks.block_grid import ScanSettings
from seam_inspector.plugin.seams.measure.profile.seam_profile import SeamProfile
from seam_inspector.plugin.seams.measure.scan.scan_request import scan_request
from seam_inspector.plugin.seams.measure.scan.scan_result import JudgedPiece
from seam_inspector.plugin.seams.measure.scan.whole_scan import whole_scan
from seam_inspector.plugin.seams.measure.seam_cells import Cell
from seam_inspector.plugin.seams.measure.seamlines.given_seams import GivenSeams, given_seams
from seam_inspector.plugin.seams.measure.source_images import Source
from seam_inspector.plugin.seams.measure.window.inspection import inspect_window, make_block, window_request
from seam_inspector.plugin.seams.measure.window.measured_window import InspectionSettings
from seam_inspector.plugin.seams.measure.workers import Workers

from demo.block import GAP_FILLER, MIDDLE
from demo.block import make_block as make_demo_block
from tests.numbers.seams.scan.blocks.scenes import beside, blended, images, scene

SIDE_PX = 256  # side of the windows; less than any that has ground enough of its own
SEAM_PX = 400


@dataclass(frozen=True)
class Delivery:
    """A mosaic, its orthoimages, and what is known of its seams."""

    mosaic: Path
    sources: Sequence[Path]
    seams: Path | None = None
    seam_fields: tuple[str, str] = ("left_source", "right_source")
    cells: str = "cells"
    dodged: tuple[float, float, float, float] = (0.0, 0.0, 0.0, 0.0)
    """xmin, ymin, xmax, ymax of a field that lost contrast: a window within it knows no other ground, a scan does."""

    def given(self) -> GivenSeams:
        """Its seamlines with what lies on either side."""
        dataset = ogr.Open(str(self.seams))
        features = [
            ({"left": row[self.seam_fields[0]], "right": row[self.seam_fields[1]]},
             bytes(row.GetGeometryRef().ExportToWkb()))
            for row in dataset.GetLayer("seamlines")
        ]
        return given_seams(features, describe_mosaic(RasterRef(str(self.mosaic))).grid)

    def known_cells(self) -> list[Cell]:
        """The part that each orthoimage has."""
        cells = []
        dataset = ogr.Open(str(self.seams))
        for row in dataset.GetLayer(self.cells):
            left, right, bottom, top = row.GetGeometryRef().GetEnvelope()
            cells.append(Cell(row["source"], bytes(row.GetGeometryRef().ExportToWkb()), (left, bottom, right, top)))
        return cells


def scanned_pieces(delivery: Delivery, folder: Path, is_given: bool, piece_m: float) -> tuple[JudgedPiece, ...]:
    """Whole ones that could be measured."""
    mosaic = describe_mosaic(RasterRef(str(delivery.mosaic)))
    made = tuple(Source(RasterRef(str(path)), describe(RasterRef(str(path))).extent) for path in delivery.sources)
    request, _ = scan_request(mosaic, made, ScanSettings(piece_m=piece_m), delivery.given() if is_given else None)
    with whole_scan(request, folder / "loss.tif") as scan, ThreadPoolExecutor(2) as executor:
        for _ in scan.steps(Workers(executor, 4)):
            pass
        result = scan.result("")
        scan.finish()
    return tuple(piece for piece in result.pieces if piece.kept and piece.piece.length_m > 0.9 * piece_m)


def windows_of(delivery: Delivery, pieces: Sequence[JudgedPiece], with_cells: bool) -> list[SeamProfile | None]:
    """What windows say, each around the middle of a piece; None where it can't be judged."""
    mosaic, profiles = describe_mosaic(RasterRef(str(delivery.mosaic))), []
    refs = [RasterRef(str(path)) for path in delivery.sources]
    block, _ = make_block(mosaic, refs, (), delivery.known_cells() if with_cells else ())
    for piece in pieces:
        columns = mosaic.grid.column_at(piece.piece.vertices[:, 0])
        rows = mosaic.grid.row_at(piece.piece.vertices[:, 1])
        first = [int((ends.min() + ends.max() - SIDE_PX) / 2) for ends in (columns, rows)]
        window = PixelWindow(*first, SIDE_PX, SIDE_PX)
        extent = mosaic.grid.window_extent(window)
        is_inside = window.cut_to(mosaic.columns, mosaic.rows) == window
        request = window_request(block, 1, extent, InspectionSettings())
        profiles.append(inspect_window(request).profile if is_inside else None)
    return profiles


def assert_they_say_the_same(delivery: Delivery, pieces: Sequence[JudgedPiece], is_given: bool, fewest: int) -> None:
    both = [(piece, seam) for piece, seam in zip(pieces, windows_of(delivery, pieces, is_given)) if seam is not None]
    assert len(both) >= fewest
    apart = []
    for piece, seam in both:
        if not (seam.low <= piece.high and piece.low <= seam.high):
            apart.append((piece.kept[0], piece.low, piece.high, seam.kept[0], seam.low, seam.high))
    assert not apart
    differences = [abs(np.log(piece.kept[0] / seam.kept[0])) for piece, seam in both if piece.kept and seam.kept[0]]
    widths = [np.log(seam.high / seam.low) for _, seam in both]
    assert np.median(differences) < np.median(widths) / 2


@pytest.mark.slow
@pytest.mark.parametrize("width", [0, 13, 33, 66])
def test_of_made_up_images(tmp_path: Path, width: int) -> None:
    given = images()
    made = scene(tmp_path, blended(*given, beside(SEAM_PX, width)), given)
    delivery = Delivery(Path(made.mosaic.ref.path), [Path(source.ref.path) for source in made.sources])
    assert_they_say_the_same(delivery, scanned_pieces(delivery, tmp_path, False, 20.0), False, 3)


@pytest.mark.parametrize(("name", "is_given"), [("mosaic_hardseam.tif", True), ("mosaic_feather0p4m.tif", False)])
def test_of_brighton(tmp_path: Path, brighton: Path, name: str, is_given: bool) -> None:
    gdal.Translate(str(tmp_path / name), str(brighton / name), srcWin=[1200, 900, 1024, 1024])
    delivery = Delivery(
        tmp_path / name, sorted(brighton.glob("DJI_*.tif")), brighton / "seamlines.gpkg", ("left_src", "right_src"),
        "source_polygons",
    )
    assert_they_say_the_same(delivery, scanned_pieces(delivery, tmp_path, is_given, 6.0), is_given, 4)


HARD, FEATHERED = [pytest.param(0.001, id="hard")], [pytest.param(1.5, id="feathered")]


@pytest.fixture(scope="module", params=HARD + FEATHERED)
def demo_block(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> Delivery:
    """Its orthoimages are resampled and balanced one by one."""
    made = make_demo_block(tmp_path_factory.mktemp("block"), (120.0, 100.0), feather_m=request.param)
    (dodged,) = (damage.bounds for damage in made.damage if damage.cause == "dodging")
    return Delivery(made.mosaic, made.sources, made.seamlines, dodged=dodged)


@pytest.fixture(scope="module")
def given_pieces(demo_block: Delivery, tmp_path_factory: pytest.TempPathFactory) -> tuple[JudgedPiece, ...]:
    """Pieces of the block's own seamlines."""
    return scanned_pieces(demo_block, tmp_path_factory.mktemp("scan"), True, 10.0)


def is_hidden(piece: JudgedPiece) -> bool:
    """Whether the feather that is wider than a window hides a piece."""
    return {piece.left, piece.right} == {MIDDLE, GAP_FILLER}


def is_single(piece: JudgedPiece, delivery: Delivery) -> bool:
    """Whether no other seam and no dodged field reaches into a window around it."""
    x, y = (piece.piece.vertices.min(axis=0) + piece.piece.vertices.max(axis=0)) / 2
    reach = SIDE_PX / 2 * 0.1
    around = ogr.CreateGeometryFromWkt(f"POINT ({x} {y})").Buffer(reach * np.sqrt(2))
    left, bottom, right, top = delivery.dodged
    is_dodged = left - reach < x < right + reach and bottom - reach < y < top + reach
    cells = sum(ogr.CreateGeometryFromWkb(cell.wkb).Intersects(around) for cell in delivery.known_cells())
    return cells == 2 and not is_dodged


@pytest.mark.slow
def test_of_the_demo_block_along_its_seamlines(
    demo_block: Delivery, given_pieces: Sequence[JudgedPiece]
) -> None:
    plain = [piece for piece in given_pieces if is_single(piece, demo_block) and not is_hidden(piece)]
    assert_they_say_the_same(demo_block, plain, True, 5)


@pytest.mark.slow
@pytest.mark.parametrize("demo_block", FEATHERED, indirect=True)  # the wide feather is the same in both
def test_of_a_feather_that_is_wider_than_the_corridor(
    demo_block: Delivery, given_pieces: Sequence[JudgedPiece]
) -> None:
    """All ground that the window has is mixed, and so it hardly knows how much; the scan knows other ground."""
    hidden = list(filter(is_hidden, given_pieces))
    both = [(piece, seam) for piece, seam in zip(hidden, windows_of(demo_block, hidden, True)) if seam is not None]
    assert len(both) >= 3
    assert all(piece.kept is not None and max(piece.kept[0], seam.kept[0]) < 0.85 for piece, seam in both)


@pytest.mark.slow
@pytest.mark.parametrize("demo_block", FEATHERED, indirect=True)
def test_of_the_demo_block_along_the_seams_that_are_found(tmp_path: Path, demo_block: Delivery) -> None:
    pieces = scanned_pieces(demo_block, tmp_path, False, 10.0)
    plain = [piece for piece in pieces if is_single(piece, demo_block) and not is_hidden(piece)]
    assert_they_say_the_same(demo_block, plain, False, 4)
