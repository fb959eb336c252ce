"""The place of a raster on the map, and what is no raster to measure: one sentence."""
from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from osgeo import gdal
from seam_inspector.plugin.imagery.errors import NotCoveredError, RasterError
from seam_inspector.plugin.imagery.grids import standard_side_px
from seam_inspector.plugin.imagery.open_raster import describe, describe_mosaic, placed
from seam_inspector.plugin.imagery.rasters import Raster, RasterRef
from seam_inspector.plugin.imagery.reference_systems import extent_on

from tests.numbers.clips import SIZE, STRETCHING, MakeRaster, clip_of, inside, metres_by_arcs
from tests.numbers.synthetic import ORIGIN, UTM33, orthoimage, wkt


@pytest.mark.parametrize(
    "system",
    [
        wkt(UTM33).replace("WGS 84 / UTM zone 33N", "site grid"),
        "+proj=utm +zone=33 +datum=WGS84 +units=m +no_defs",
        "+proj=tmerc +lat_0=0 +lon_0=15 +k=0.9996 +x_0=500000 +y_0=0 +datum=WGS84 +units=m",
        wkt(25833),  # ETRS89: other numbers by the continent's drift only, which PROJ leaves alone
    ],
    ids=["renamed", "PROJ's UTM", "PROJ's transverse Mercator", "ETRS89"],
)
def test_the_same_system_under_another_name_is_not_warped(
    make_raster: MakeRaster, mosaic: Raster, system: str
) -> None:
    image = orthoimage(SIZE)
    clip = clip_of(make_raster("source.tif", image, system=None), mosaic, system=system)
    assert clip.raster.wkt != mosaic.wkt
    assert not clip.resampled
    np.testing.assert_array_equal(clip.bands, inside(image))


def test_the_same_numbers_in_another_zone_are_another_place(make_raster: MakeRaster, mosaic: Raster) -> None:
    with pytest.raises(NotCoveredError, match=r"source\.tif"):
        clip_of(make_raster("source.tif", orthoimage(SIZE), system=32634), mosaic)


def test_a_reference_may_bring_the_system_that_a_file_lacks(make_raster: MakeRaster, mosaic: Raster) -> None:
    image = orthoimage(SIZE)
    path = make_raster("bare.tif", image, system=None)
    assert describe(RasterRef(path)).wkt == ""
    with pytest.raises(RasterError, match=r"bare.tif has no coordinate reference system \(CRS\); set it"):
        describe_mosaic(RasterRef(path))
    with pytest.raises(RasterError, match=r"bare.tif has no coordinate reference system \(CRS\); set it"):
        clip_of(path, mosaic)
    assert describe_mosaic(RasterRef(path, wkt(UTM33))).wkt == wkt(UTM33)
    clip = clip_of(path, mosaic, system=wkt(UTM33))
    np.testing.assert_array_equal(clip.bands, inside(image))


def test_the_system_of_the_reference_goes_before_that_of_its_file(make_raster: MakeRaster) -> None:
    path = make_raster("source.tif", orthoimage((64, 64)))
    chosen = describe(RasterRef(path, wkt(32634)))
    assert chosen.wkt == wkt(32634)
    (said,) = chosen.notices
    assert "EPSG:32634" in str(said)
    assert f"EPSG:{UTM33}" in str(said)
    assert describe(RasterRef(path)).notices == ()


@pytest.mark.parametrize("system", [UTM33, "+proj=utm +zone=33 +datum=WGS84", f"EPSG:{UTM33}+5773"])
def test_a_reference_that_means_the_same_leaves_the_system_of_the_file(
    make_raster: MakeRaster, system: int | str
) -> None:
    path = make_raster("source.tif", orthoimage((64, 64)), system=wkt(system))
    image = describe(RasterRef(path, wkt(UTM33)))
    assert image.wkt == describe(RasterRef(path)).wkt
    assert image.notices == ()


@pytest.mark.parametrize(
    "geotransform",
    [
        (ORIGIN[0], 0.1, 0.01, ORIGIN[1], 0.01, -0.1),
        (ORIGIN[0], 0.0, 0.1, ORIGIN[1], 0.1, 0.0),
        (ORIGIN[0], -0.1, 0.0, ORIGIN[1], 0.0, -0.1),
    ],
    ids=["skewed", "turned by 90", "mirrored"],
)
def test_a_mosaic_that_is_not_north_up_is_refused(
    make_raster: MakeRaster, geotransform: tuple[float, ...]
) -> None:
    path = make_raster("turned.tif", orthoimage((64, 64)), geotransform=geotransform)
    with pytest.raises(RasterError, match=r"turned.tif is rotated, mirrored or south-up; warp it to a north-up grid"):
        describe_mosaic(RasterRef(path))
    assert describe(RasterRef(path)).ground_sample_distance == pytest.approx(0.1, rel=0.01)


def test_rounding_in_a_geotransform_is_no_rotation(make_raster: MakeRaster) -> None:
    geotransform = (ORIGIN[0], 0.1, 1e-11, ORIGIN[1], -1e-11, -0.1)
    assert describe_mosaic(RasterRef(make_raster("mosaic.tif", orthoimage(SIZE), geotransform=geotransform))).grid


def test_a_raster_without_a_position_is_refused(tmp_path: Path) -> None:
    path = str(tmp_path / "photo.tif")
    gdal.GetDriverByName("GTiff").Create(path, 64, 64, 3).FlushCache()
    with pytest.raises(RasterError, match=r"photo.tif has no position on the map; georeference"):
        placed(describe(RasterRef(path)))


@pytest.mark.parametrize(("system", "longitude", "latitude"), STRETCHING.values(), ids=STRETCHING.keys())
def test_metres_are_those_on_the_ground_whatever_the_system(
    make_raster: MakeRaster, system: str | int, longitude: float, latitude: float
) -> None:
    (x, y), east, north = metres_by_arcs(system, longitude, latitude)
    size = 0.1 / east
    place = (x - 32 * size, size, 0.0, y + 32 * size, 0.0, -size)
    path = make_raster("map.tif", orthoimage((64, 64)), geotransform=place, system=wkt(system))
    grid = describe_mosaic(RasterRef(path)).grid
    assert (grid.metres_x, grid.metres_y) == pytest.approx((east, north), rel=1e-6)
    assert standard_side_px(grid, 12.0) == 128


@pytest.mark.parametrize(
    ("system", "top"),
    [(wkt(4326), 5000000.0), (wkt(4326), 90.5), ('LOCAL_CS["no length",UNIT["metre",0]]', 5000000.0)],
    ids=["metres said to be degrees", "over a pole", "a unit without length"],
)
def test_what_lies_nowhere_on_the_ground_is_refused(make_raster: MakeRaster, system: str, top: float) -> None:
    path = make_raster("lost.tif", orthoimage((64, 64)), geotransform=(15.0, 1e-7, 0.0, top, 0.0, -1e-7))
    raster = replace(describe(RasterRef(path)), own_wkt=system)
    with pytest.raises(RasterError, match=r"lost.tif lies outside the area of its coordinate reference system"):
        assert raster.grid


def test_rasters_in_degrees_are_compared_as_they_are(make_raster: MakeRaster) -> None:
    geotransform = (15.0, 1.3e-6, 0.0, 52.0, 0.0, -9e-7)
    image = orthoimage(SIZE)
    block = describe_mosaic(RasterRef(make_raster("m.tif", image, geotransform=geotransform, system=4326)))
    shifted = (15.0 + 4.25 * 1.3e-6, 1.3e-6, 0.0, 52.0 - 3.5 * 9e-7, 0.0, -9e-7)
    clip = clip_of(make_raster("s.tif", image, geotransform=shifted, system=4326), block)
    assert not clip.resampled
    assert clip.offset_x == pytest.approx(-0.25, abs=1e-3)
    assert abs(clip.offset_y) == pytest.approx(0.5, abs=1e-3)
    assert clip.bands.shape == (3, 64, 64)


LOCAL = 'LOCAL_CS["site",UNIT["metre",1]]'


@pytest.mark.usefixtures("either_gdal")
class TestWithAndWithoutGdalsExceptions:
    """``gdal.UseExceptions()`` is process-wide, so any plugin may have called it before."""

    @pytest.mark.parametrize(
        ("content", "sentence"),
        [
            (None, "does not exist; check the path"),
            (b"", "is not a raster that GDAL can read"),
            (b"x;y\n500000;5000000\n", "is not a raster that GDAL can read"),
            (b"II*\0" + bytes(60), "is not a raster that GDAL can read"),
        ],
        ids=["missing", "empty", "text", "broken header"],
    )
    def test_no_raster(self, tmp_path: Path, mosaic: Raster, content: bytes | None, sentence: str) -> None:
        path = tmp_path / "file.tif"
        if content is not None:
            path.write_bytes(content)
        with pytest.raises(RasterError, match=rf"file.tif {sentence}"):
            describe(RasterRef(str(path)))
        with pytest.raises(RasterError, match=rf"file.tif {sentence}"):
            clip_of(str(path), mosaic)

    @pytest.mark.parametrize("name", ["D:\\orthos\\a.tif", "GPKG:gone.gpkg:a", "/vsizip/gone.zip/a.tif", "vrt://gone.tif"])
    def test_what_is_not_there_does_not_exist(self, name: str) -> None:
        with pytest.raises(RasterError, match="does not exist"):
            describe(RasterRef(name))

    def test_the_tile_that_a_vrt_lacks_is_named(self, tmp_path: Path, make_raster: MakeRaster, mosaic: Raster) -> None:
        tiles = [make_raster(name, orthoimage(SIZE)) for name in ("there.tif", "gone.tif")]
        gdal.BuildVRT(str(tmp_path / "whole.vrt"), tiles).FlushCache()
        Path(tiles[1]).unlink()
        with pytest.raises(RasterError, match=r"whole.vrt refers to .*gone.tif, which does not exist"):
            clip_of(str(tmp_path / "whole.vrt"), mosaic)

    @pytest.mark.parametrize("gsd", [0.1, 0.05], ids=["as it is", "warped"])
    def test_a_truncated_file(self, make_raster: MakeRaster, mosaic: Raster, gsd: float) -> None:
        path = Path(make_raster("cut.tif", orthoimage((512, 512)), gsd=gsd))
        path.write_bytes(path.read_bytes()[: path.stat().st_size // 8])
        with pytest.raises(RasterError, match=r"cut.tif (can't be read; the file may be truncated|is not a raster)"):
            clip_of(str(path), mosaic)

    def test_a_damaged_mask(self, make_raster: MakeRaster, mosaic: Raster) -> None:
        valid = np.random.default_rng(0).random(SIZE) < 0.5
        path = make_raster("source.tif", orthoimage(SIZE), valid=valid, mask_inside=False)
        mask = Path(path + ".msk")
        content = mask.read_bytes()
        third = len(content) // 3
        mask.write_bytes(content[:third] + b"\x55" * third + content[2 * third :])
        with pytest.raises(RasterError, match=r"pixels of source.tif can't be read"):
            clip_of(path, mosaic)

    def test_complex_values(self, make_raster: MakeRaster, mosaic: Raster) -> None:
        path = make_raster("radar.tif", orthoimage(SIZE, 1).astype(np.complex64))
        with pytest.raises(RasterError, match=r"radar.tif holds complex values; convert them to magnitudes"):
            clip_of(path, mosaic)

    def test_no_bands_of_its_own(self, tmp_path: Path, make_raster: MakeRaster, mosaic: Raster) -> None:
        path, image = str(tmp_path / "two.gpkg"), make_raster("image.tif", orthoimage(SIZE))
        for table, append in (("a", "NO"), ("b", "YES")):
            options = [f"RASTER_TABLE={table}", f"APPEND_SUBDATASET={append}"]
            assert gdal.Translate(path, image, format="GPKG", creationOptions=options)
        with pytest.raises(RasterError, match=r"two.gpkg has no bands of its own; choose one of its subdatasets"):
            clip_of(path, mosaic)

    def test_a_raster_of_one_pixel(self, make_raster: MakeRaster, mosaic: Raster) -> None:
        path = make_raster("pixel.tif", np.full((3, 1, 1), 9, np.uint8), origin=(ORIGIN[0] + 12.0, ORIGIN[1] - 11.0))
        assert describe_mosaic(RasterRef(path)).grid.columns == 1
        with pytest.raises(NotCoveredError, match=r"pixel.tif does not cover the whole window"):
            clip_of(path, mosaic)

    @pytest.mark.parametrize("system", [LOCAL, "nonsense"])
    def test_a_system_that_leads_nowhere(self, make_raster: MakeRaster, mosaic: Raster, system: str) -> None:
        with pytest.raises(RasterError, match="can't be transformed to another coordinate reference system"):
            extent_on((0, 0, 1, 1), system, mosaic.wkt)
        path = make_raster("site.tif", orthoimage(SIZE), system=None)
        with pytest.raises(RasterError, match="can't be transformed to another coordinate reference system"):
            clip_of(path, mosaic, system=system)
