"""Mosaics among the sources are known by the others that they follow, and no orthoimage is taken for one."""
from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import numpy as np
import pytest
from osgeo import gdal
from seam_inspector.plugin.imagery.open_raster import describe_mosaic
from seam_inspector.plugin.imagery.rasters import RasterRef
from seam_inspector.plugin.seams.measure.inputs.mosaic_copies import Likeness, likenesses
from seam_inspector.plugin.seams.measure.inputs.mosaics_among import mosaics_among
from seam_inspector.plugin.seams.measure.source_images import gather_sources

from tests.numbers.conftest import MakeRaster
from tests.numbers.synthetic import orthoimage

SIDE = 384


def remarkable(mosaic: str, paths: Sequence[str]) -> dict[str, Likeness]:
    """What is known of the rasters that are not plainly orthoimages, by their names."""
    raster = describe_mosaic(RasterRef(mosaic))
    sources, _ = gather_sources(map(RasterRef, paths), (), raster.wkt, raster.ref)
    found = mosaics_among(raster, sources, likenesses(raster, sources), lambda: False)
    return {Path(sources[n].ref.path).stem: one for n, one in found.items()}


def cut(images: Sequence[np.ndarray], column: int) -> np.ndarray:
    """A mosaic of the first image in the west and of the second in the east."""
    return np.concatenate([images[0][..., :column], images[1][..., column:]], axis=-1)


@pytest.fixture
def images() -> list[np.ndarray]:
    return [orthoimage((SIDE, SIDE), seed=seed) for seed in (1, 2)]


@pytest.fixture
def paths(make_raster: MakeRaster, images: list[np.ndarray]) -> list[str]:
    """Both images and a mosaic of them, all of one extent."""
    return [make_raster(f"{name}.tif", one) for name, one in zip(("a", "b", "mosaic"), (*images, cut(images, 200)))]


def test_orthoimages_on_the_mosaic_s_very_extent_stay(paths: list[str]) -> None:
    assert remarkable(paths[2], paths[:2]) == {}


def test_other_mosaics_and_parts_of_one_are_none(
    make_raster: MakeRaster, images: list[np.ndarray], paths: list[str]
) -> None:
    """Images follow two mosaics, each in its place, and are orthoimages all the same."""
    editions = [make_raster(f"edition{column}.tif", cut(images, column)) for column in (150, 250)]
    part = make_raster("part.tif", cut(images, 200)[..., 90:310], origin=(500009.0, 5000000.0))
    assert remarkable(paths[2], [*paths[:2], *editions, part]) == dict.fromkeys(
        ("edition150", "edition250", "part"), Likeness.MOSAIC
    )


def test_a_part_of_the_mosaic_is_told_where_no_two_sources_tell_more(
    make_raster: MakeRaster, images: list[np.ndarray], paths: list[str]
) -> None:
    part = make_raster("part.tif", images[0][..., :190])
    assert remarkable(paths[2], [*paths[:2], part]) == {"part": Likeness.EQUAL}


def test_two_of_which_one_is_a_mosaic_are_told_where_nobody_can_say_which(
    make_raster: MakeRaster, images: list[np.ndarray], paths: list[str]
) -> None:
    edition = make_raster("edition.tif", cut(images, 100))
    assert remarkable(paths[2], [edition, paths[1]]) == {"edition": Likeness.TURNING, "b": Likeness.TURNING}


def test_a_map_over_the_mosaic_is_told(make_raster: MakeRaster, paths: list[str]) -> None:
    drawn = np.full((3, SIDE, SIDE), 255, np.uint8)
    drawn[:, ::40], drawn[:, :, ::55] = 30, 90
    assert remarkable(paths[2], [*paths[:2], make_raster("map.tif", drawn)]) == {"map": Likeness.UNLIKE}


def test_tiles_of_one_image_stay(make_raster: MakeRaster, images: list[np.ndarray], paths: list[str]) -> None:
    """They are the same where they overlap, and beat the other image there."""
    tiles = [
        make_raster(f"tile{left}.tif", images[0][..., left : left + 160], origin=(500000 + left / 10, 5000000.0))
        for left in (60, 140, 220)
    ]
    found = remarkable(paths[2], [paths[1], *tiles])
    assert set(found.values()) <= {Likeness.EQUAL}  # the first one is the mosaic wherever it lies


# --- real images -----------------------------------------------------------------------------------------------


@pytest.mark.slow
def test_brighton_s_other_mosaic_and_a_part(data_folder: Path, tmp_path: Path) -> None:
    folder = data_folder / "seams" / "brighton"
    mosaic = str(folder / "mosaic_feather0p4m.tif")
    images = sorted(map(str, folder.glob("DJI*.tif")))
    part = str(tmp_path / "part.tif")
    gdal.Translate(part, mosaic, srcWin=[400, 400, 900, 900])
    assert remarkable(mosaic, [*images, part, str(folder / "mosaic_hardseam.tif")]) == dict.fromkeys(
        ("part", "mosaic_hardseam"), Likeness.MOSAIC
    )
