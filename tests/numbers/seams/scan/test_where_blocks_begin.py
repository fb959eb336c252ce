"""What a scan says of a seam does not hang on where its blocks begin, nor on pixels that are missing beside it."""
from __future__ import annotations

from pathlib import Path

import pytest
from osgeo import gdal
from seam_inspector import ScanResult, open_block, scan
from seam_inspector.plugin.seams.measure.judgement.verdicts import Verdict

from demo.block import Block, Damage
from tests.made_once import the_first_block, the_small_block


def part(block: Block, path: Path, first_column: int) -> Path:
    """The mosaic from a column on."""
    mosaic = gdal.Open(str(block.mosaic))
    window = [first_column, 0, mosaic.RasterXSize - first_column, mosaic.RasterYSize]
    gdal.Translate(str(path), mosaic, srcWin=window)
    return path


def without_corner(block: Block, path: Path, rows: int, first_column: int) -> Path:
    """The mosaic with nodata in its upper rows from a column on."""
    gdal.Translate(str(path), str(block.mosaic), noData=0)
    dataset = gdal.Open(str(path), gdal.GA_Update)
    pixels = dataset.ReadAsArray()
    pixels[:, :rows, first_column:] = 0
    dataset.WriteArray(pixels)
    return path


def scanned(block: Block, mosaic: Path) -> ScanResult:
    return scan(open_block(mosaic, block.sources, keep_copies=True), seamlines=block.seamlines)


def is_within(damage: Damage, x: float, y: float) -> bool:
    """Whether a place lies in the inner half of an ellipse."""
    xmin, ymin, xmax, ymax = damage.bounds
    across, down = 2 * (x - xmin) / (xmax - xmin) - 1, 2 * (y - ymin) / (ymax - ymin) - 1
    return across**2 + down**2 < 0.5


@pytest.mark.parametrize("first_column", [0, 452, 1000])
def test_a_dodged_part_of_a_mosaic_is_no_way_its_orthoimages_come_over(
    tmp_path_factory: pytest.TempPathFactory, tmp_path: Path, first_column: int
) -> None:
    """Whichever share of a block it takes: half of the detail is a quarter of its energy."""
    block = the_first_block(tmp_path_factory)
    (dodging,) = (damage for damage in block.damage if damage.cause == "dodging")
    result = scanned(block, part(block, tmp_path / "part.tif", first_column))
    dodged = [
        piece for piece in result.pieces
        if is_within(dodging, *piece.piece.vertices[len(piece.piece.vertices) // 2]) and piece.kept is not None
    ]
    assert dodged
    assert max(piece.kept[0] for piece in dodged) < 0.6  # type: ignore[index]
    assert not [piece for piece in dodged if piece.verdict is Verdict.PRESERVED]


@pytest.mark.parametrize("rows", [30, 60, 90])
def test_nodata_beside_a_seam_takes_nothing_from_it(
    tmp_path_factory: pytest.TempPathFactory, tmp_path: Path, rows: int
) -> None:
    block = the_small_block(tmp_path_factory)
    whole = scanned(block, block.mosaic)
    cut = scanned(block, without_corner(block, tmp_path / "cut.tif", rows, 600))
    sound = {piece.piece.vertices.tobytes(): piece for piece in whole.pieces if piece.verdict is Verdict.PRESERVED}
    assert len(sound) > 5
    for piece in cut.pieces:
        if (before := sound.get(piece.piece.vertices.tobytes())) is not None:
            assert piece.verdict is Verdict.PRESERVED
            assert piece.kept[0] == pytest.approx(before.kept[0], abs=0.08)  # type: ignore[index]


def stored(raster: Path, path: Path, quality: int) -> Path:
    """A raster stored as JPEG, with a mask where it has no pixels."""
    options = ["COMPRESS=JPEG", f"JPEG_QUALITY={quality}", "PHOTOMETRIC=YCBCR", "TILED=YES"]
    gdal.Translate(str(path), str(raster), creationOptions=options, maskBand="mask", noData="none")
    return path


def test_orthoimages_that_are_nearly_alike_are_told_apart_under_jpeg(
    tmp_path_factory: pytest.TempPathFactory, tmp_path: Path
) -> None:
    """The sharpest of them resembles the mosaic most, until each is seen through what came over it."""
    block = the_first_block(tmp_path_factory)
    sources = [stored(source, tmp_path / source.name, 90) for source in block.sources]
    lossless = scanned(block, block.mosaic)
    result = scan(
        open_block(stored(block.mosaic, tmp_path / "mosaic.tif", 90), sources, keep_copies=True),
        seamlines=block.seamlines,
    )
    verdicts = {piece.piece.vertices.tobytes(): piece.verdict for piece in lossless.pieces}
    sound = {piece.piece.vertices.tobytes() for piece in lossless.pieces if piece.kept and piece.kept[0] >= 0.9}
    measured = sum(piece.piece.length_m for piece in result.pieces if piece.kept is not None)
    assert measured > 0.85 * sum(piece.piece.length_m for piece in result.pieces)
    changed = {(verdicts.get(piece.piece.vertices.tobytes()), piece.verdict) for piece in result.pieces}
    assert (Verdict.SIGNIFICANT, Verdict.PRESERVED) not in changed
    assert not sound & {
        piece.piece.vertices.tobytes() for piece in result.pieces if piece.verdict is Verdict.SIGNIFICANT
    }
