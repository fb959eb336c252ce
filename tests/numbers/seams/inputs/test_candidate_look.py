"""Which rasters are taken for the sources of a mosaic: by their headers, and by a look at their pixels."""
from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from osgeo import gdal
from seam_inspector.plugin.imagery.errors import RasterError
from seam_inspector.plugin.imagery.rasters import RasterRef
from seam_inspector.plugin.seams.measure.inputs import messages
from seam_inspector.plugin.seams.measure.inputs.candidate_look import (
    Origin,
    PlaceLikeness,
    Rival,
    SourceCandidate,
    look_at_candidates,
    origin_of,
)
from seam_inspector.plugin.seams.measure.inputs.raster_facts import (
    RasterFacts,
    Standing,
    likely_mosaic,
    suitable_by_header,
)

from tests.made_once import the_small_block
from tests.numbers.conftest import MakeRaster
from tests.numbers.synthetic import ORIGIN, orthoimage

MOSAIC = RasterFacts("mosaic", "mosaic", (0, 0, 100, 100), 0.1, 3, "8 bit", True)
SOURCE = replace(MOSAIC, key="a", extent=(-5, 0, 60, 70))


def reasons(mosaic: str, *paths: str) -> dict[str, str]:
    """Templates of what speaks against each raster, empty for a source."""
    candidates = [SourceCandidate(Path(path).stem, Path(path).stem, RasterRef(path)) for path in paths]
    found = look_at_candidates(RasterRef(mosaic), candidates)
    return {name: standing.reason.template if standing.reason else "" for name, standing in found}


# by headers


def test_headers_tell_what_can_not_be_a_source() -> None:
    others = {
        "apart": replace(SOURCE, extent=(100, 0, 160, 70)),
        "nowhere": replace(SOURCE, extent=None),
        "heights": replace(SOURCE, bands=1),
        "half": replace(SOURCE, pixel_size=0.2),
        "fine": replace(SOURCE, pixel_size=0.02),
        "converted": replace(SOURCE, pixel_type="16 bit"),
        "moved": replace(SOURCE, has_mosaic_system=False),
        "whole": replace(SOURCE, extent=(-5, -5, 105, 105)),
        "itself": replace(MOSAIC, is_mosaic=True),
    }
    rasters = [SOURCE, replace(SOURCE, key="b"), replace(SOURCE, key="finer", pixel_size=0.05)]
    found = suitable_by_header(MOSAIC, [*rasters, *(replace(one, key=key) for key, one in others.items())])
    assert [key for key, one in found.items() if one.is_suggested] == ["a", "b", "finer"]
    assert [key for key, one in found.items() if one.standing is Standing.OPEN] == ["whole"]
    told = {key: one.reason.template for key, one in found.items() if one.reason is not None}
    assert told == {
        "apart": messages.APART_FROM_MOSAIC.template,
        "nowhere": messages.APART_FROM_MOSAIC.template,
        "heights": messages.OTHER_BANDS.template,
        "half": messages.LARGER_PIXELS.template,
        "fine": messages.SMALLER_PIXELS.template,
        "converted": messages.OTHER_TYPE.template,
        "moved": messages.OTHER_SYSTEM.template,
        "whole": messages.BEING_LOOKED_AT.template,
        "itself": messages.IS_THE_MOSAIC.template,
    }


def test_sources_that_were_all_converted_stay() -> None:
    moved = [replace(SOURCE, key=key, has_mosaic_system=False, pixel_type="16 bit") for key in "ab"]
    assert all(one.is_suggested for one in suitable_by_header(MOSAIC, moved).values())


def test_one_mosaic_with_sources_is_likely_and_two_are_not() -> None:
    sources = [SOURCE, replace(SOURCE, key="b", extent=(40, 20, 104, 100))]
    assert likely_mosaic([*sources, MOSAIC, replace(MOSAIC, key="dem", bands=1, pixel_size=1.0)]) == "mosaic"
    assert likely_mosaic([*sources, MOSAIC, replace(MOSAIC, key="other")]) is None
    assert likely_mosaic(sources) is None
    close = [replace(SOURCE, key=str(step), extent=(step, step, 60 + step, 60 + step)) for step in (0, 5, 10, 40)]
    assert likely_mosaic([*close, MOSAIC]) == "mosaic"
    assert likely_mosaic(close) is None


# by pixels


@pytest.fixture
def images() -> list[np.ndarray]:
    """Two images of one ground, their noise and place as of two flights, and a third of other ground."""
    ground = orthoimage((512, 512)).astype(float)
    rng = np.random.default_rng(5)
    moved = np.roll(ground, (2, 1), axis=(1, 2))
    both = [np.clip(one + rng.normal(0, 8, ground.shape), 1, 255).astype(np.uint8) for one in (ground, moved)]
    return [*both, np.ascontiguousarray(both[0][:, ::-1, ::-1])]


@pytest.mark.slow
def test_sources_copies_and_other_mosaics_are_told_apart(make_raster: MakeRaster, images: list[np.ndarray]) -> None:
    west, east, elsewhere = images
    mosaic = np.concatenate([west[..., :256], east[..., 256:]], axis=-1)
    other = np.concatenate([west[..., :120], east[..., 120:]], axis=-1)
    rasters = {
        "west": (west[..., :350], 0), "east": (east[..., 160:], 160), "copy": (mosaic, 0), "other": (other, 0),
        "part": (mosaic[..., 100:400], 100), "again": (west[..., :350], 0), "map": (elsewhere, 0),
        "piece": (elsewhere[..., :350], 0),
    }
    paths = {
        name: make_raster(f"{name}.tif", pixels, origin=(ORIGIN[0] + 0.1 * column, ORIGIN[1]))
        for name, (pixels, column) in rasters.items()
    }
    assert reasons(make_raster("mosaic.tif", mosaic), *paths.values()) == {
        "west": "", "east": "", "copy": messages.MOSAIC_AGAIN.template, "other": messages.ANOTHER_MOSAIC.template,
        "part": messages.MOSAIC_PART_AGAIN.template, "again": messages.SAME_IMAGE.template,
        "map": messages.NOT_FOLLOWED.template, "piece": messages.OTHER_CONTENT.template,
    }


def test_sources_that_cover_the_whole_mosaic_stay_where_there_are_two(
    make_raster: MakeRaster, images: list[np.ndarray]
) -> None:
    west, east, _ = images
    mosaic = make_raster("mosaic.tif", np.concatenate([west[..., :256], east[..., 256:]], axis=-1))
    both = make_raster("west.tif", west), make_raster("east.tif", east)
    assert reasons(mosaic, *both) == {"west": "", "east": ""}
    # One alone could as well be a mosaic with another seam.
    assert reasons(mosaic, both[0]) == {"west": messages.MAY_BE_MOSAIC.template}


def test_a_raster_of_labels_says_that_it_is_one(make_raster: MakeRaster, images: list[np.ndarray]) -> None:
    west, east, _ = images
    labels = np.repeat(np.where(np.arange(512) < 256, 1, 2).astype(np.uint8)[None, None], 512, axis=1)
    lake = (40 + np.random.default_rng(3).normal(0, 2, (1, 512, 350))).astype(np.uint8)  # few values, and an image
    mosaic = make_raster("mosaic.tif", np.concatenate([west[:1, :, :256], east[:1, :, 256:]], axis=-1))
    paths = [make_raster(f"{name}.tif", pixels) for name, pixels in (
        ("west", west[:1, :, :350]), ("labels", labels), ("piece", labels[..., 100:400]), ("lake", lake)
    )]  # fmt: skip
    found = reasons(mosaic, *paths)
    assert found["labels"] == found["piece"] == messages.HOLDS_LABELS.template
    assert found["west"] == ""
    assert found["lake"] != messages.HOLDS_LABELS.template


def test_what_can_not_be_read_is_left_out_and_a_mosaic_that_can_not_raises(
    make_raster: MakeRaster, images: list[np.ndarray], tmp_path: Path
) -> None:
    mosaic = make_raster("mosaic.tif", images[0])
    assert reasons(mosaic, str(tmp_path / "none.tif"))["none"] == messages.PIXELS_NOT_READ.template
    with pytest.raises(RasterError):
        reasons(str(tmp_path / "none.tif"), mosaic)


@pytest.mark.parametrize("name", ["mosaic_hardseam", "mosaic_feather0p4m"])
def test_relatives_of_brighton(data_folder: Path, tmp_path: Path, name: str) -> None:
    folder = data_folder / "seams" / "brighton"
    if not folder.is_dir():
        pytest.skip(f"no real data at {folder}")
    mosaic, other = str(folder / f"{name}.tif"), {"mosaic_hardseam", "mosaic_feather0p4m"} - {name}
    sources = sorted(str(path) for path in folder.glob("DJI*.tif"))
    made = {one: str(tmp_path / f"{one}.tif") for one in ("rgba", "deep", "degrees", "jpeg", "crop")}
    gdal.Warp(made["rgba"], mosaic, dstAlpha=True)
    gdal.Translate(made["deep"], mosaic, outputType=gdal.GDT_UInt16, scaleParams=[[0, 255, 0, 65535]])
    gdal.Warp(made["degrees"], mosaic, dstSRS="EPSG:4326", resampleAlg="cubic")
    gdal.Translate(made["jpeg"], mosaic, creationOptions=["COMPRESS=JPEG", "JPEG_QUALITY=75"])
    gdal.Translate(made["crop"], mosaic, srcWin=[800, 700, 1500, 1500])
    gdal.BuildVRT(str(tmp_path / "block.vrt"), sources)
    gdal.BuildVRT(str(tmp_path / "linked.vrt"), [mosaic])
    found = reasons(
        mosaic, str(folder / f"{other.pop()}.tif"), *made.values(), str(tmp_path / "block.vrt"),
        str(tmp_path / "linked.vrt"), *sources,
    )
    assert [name for name, reason in found.items() if not reason] == [Path(path).stem for path in sources]
    assert found["crop"] == messages.MOSAIC_PART_AGAIN.template
    assert found["linked"] == messages.MADE_OF_MOSAIC.template
    assert found["block"] == messages.ANOTHER_MOSAIC.template
    for one in ("rgba", "deep", "degrees", "jpeg"):
        assert found[one] in (messages.MOSAIC_AGAIN.template, messages.MOSAIC_OR_ITS_SOURCE.template)


@pytest.mark.slow
def test_well_registered_sources_stay_and_crops_and_earlier_states_of_their_mosaic_do_not(
    tmp_path: Path, tmp_path_factory: pytest.TempPathFactory
) -> None:
    block = the_small_block(tmp_path_factory)
    crop, earlier = str(tmp_path / "crop.tif"), str(tmp_path / "earlier.tif")
    gdal.Translate(crop, str(block.mosaic), srcWin=[240, 200, 720, 600])
    altered = gdal.GetDriverByName("GTiff").CreateCopy(earlier, gdal.Open(str(block.mosaic)))
    altered.WriteArray(altered.ReadAsArray(0, 0, 300, 300)[..., ::-1])
    del altered
    found = reasons(str(block.mosaic), crop, earlier, *map(str, block.sources))
    assert found == {
        "crop": messages.MOSAIC_PART_AGAIN.template, "earlier": messages.MOSAIC_ALTERED.template,
        **{path.stem: "" for path in block.sources},
    }


@pytest.mark.parametrize(("here", "there", "origin"), [
    (0.9, 0.5, Origin.MOSAIC), (0.7, 0.7, Origin.UNKNOWN), (0.5, 0.9, Origin.UNKNOWN),
])
def test_a_copy_turns_with_the_mosaic_from_one_image_to_the_other(here: float, there: float, origin: Origin) -> None:
    """What is as like both of them says nothing, nor what turns the other way."""
    places = [
        PlaceLikeness(0.99, {"first": Rival(0.9, here), "second": Rival(0.5, there)}),
        PlaceLikeness(0.99, {"first": Rival(0.5, there), "second": Rival(0.9, here)}),
    ]
    assert origin_of(places, is_whole=True) is origin


@pytest.mark.parametrize(("there", "is_copy"), [(0.45, True), (0.7, False)])
def test_what_turns_with_the_mosaic_is_a_copy_of_it_even_where_others_are_more_like_it(
    there: float, is_copy: bool
) -> None:
    """As one that was compressed: the images that the mosaic was made of are nearer to it, here the one, there the
    second; what shows much less of their difference is an orthoimage of the same ground."""
    more, less = Rival(0.95, 0.8), Rival(0.5, there)
    turns = [{"first": more, "second": less}, {"first": less, "second": more}]
    places = [PlaceLikeness(0.8, turns[number % 2]) for number in range(10)]
    places += [PlaceLikeness(0.99, {"first": Rival(0.5, 0.5)})] * 10
    assert (origin_of(places, is_whole=True) is Origin.MOSAIC) is is_copy
