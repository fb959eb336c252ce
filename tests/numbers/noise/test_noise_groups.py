"""Noise of whole images: windows, groups and masks; and of real images, with their radiometry."""
from __future__ import annotations

from collections.abc import Callable, Sequence
from pathlib import Path

import numpy as np
import pytest
from osgeo import gdal, ogr
from seam_inspector.plugin.imagery.clips import DrawnWindow
from seam_inspector.plugin.imagery.grids import PixelWindow
from seam_inspector.plugin.imagery.lines import find_seams
from seam_inspector.plugin.imagery.open_raster import OpenRaster, describe
from seam_inspector.plugin.imagery.rasters import RasterRef
from seam_inspector.plugin.noise.measure import group_noise, noise_plan
from seam_inspector.plugin.noise.measure.group_noise import ClipNoise
from seam_inspector.plugin.noise.measure.noise_plan import GroupedImage, NoiseRequest, Part, Plan
from seam_inspector.plugin.noise.measure.window_choice import choose_windows
from seam_inspector.plugin.radiometry.measure.assessment import Assessment

from tests.numbers.noise.measuring import measured
from tests.numbers.radiometry.judging import checked
from tests.numbers.synthetic import (
    ORIGIN,
    decompose,
    luminance,
    orthoimage,
    patchy_texture,
    read_pixels,
    texture,
    wkt,
    write_raster,
)

MakeRaster = Callable[..., str]


def images(paths: Sequence[str], group: int = 1) -> list[GroupedImage]:
    return [GroupedImage(describe(RasterRef(path)), group) for path in paths]


def measure(plan: Plan, levels: int = 3) -> list[ClipNoise]:
    return measured(plan.requests, levels)


def chosen(path: str, levels: int = 3) -> list[PixelWindow]:
    return choose_windows(OpenRaster(RasterRef(path)), levels)


def grey(side: tuple[int, int] = (512, 512), seed: int = 0) -> np.ndarray:
    return orthoimage(side, bands=1, seed=seed)


@pytest.fixture(scope="module")
def large(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A virtual raster of 20 000 x 12 000 px: one tile over and over, its right third saturated."""
    folder = tmp_path_factory.mktemp("large")
    tile = grey((1000, 1000))
    bright = np.full_like(tile, 255)
    sources = {name: write_raster(folder / f"{name}.tif", array, origin=(0, 0)) for name, array in
               (("tile", tile), ("bright", bright))}
    boxes = []
    for row in range(12):
        for column in range(20):
            name = "bright" if column >= 14 else "tile"
            boxes.append(
                f'<SimpleSource><SourceFilename relativeToVRT="0">{sources[name]}</SourceFilename><SourceBand>1'
                f'</SourceBand><SrcRect xOff="0" yOff="0" xSize="1000" ySize="1000"/><DstRect xOff="{1000 * column}" '
                f'yOff="{1000 * row}" xSize="1000" ySize="1000"/></SimpleSource>'
            )
    path = folder / "large.vrt"
    path.write_text(
        '<VRTDataset rasterXSize="20000" rasterYSize="12000"><GeoTransform>0,0.1,0,0,0,-0.1</GeoTransform>'
        f'<VRTRasterBand dataType="Byte" band="1">{"".join(boxes)}</VRTRasterBand></VRTDataset>'
    )
    return path


def test_up_to_25_windows_of_1024_are_spread_and_the_least_saturated_come_first(large: Path) -> None:
    windows = chosen(str(large))
    assert len(windows) == 25
    assert {(window.width, window.height) for window in windows} == {(1024, 1024)}
    assert not any(a.shared_pixels(b) for i, a in enumerate(windows) for b in windows[:i])
    assert all(window.column + window.width <= 14_500 for window in windows)  # a third of the raster is saturated
    for edge in (range(3500), range(4500, 8000), range(9000, 12000)):  # of rows: all of the height is seen
        assert any(window.row + 512 in edge for window in windows)


def test_a_raster_too_small_or_empty_gets_none_and_the_reason(make_raster: MakeRaster) -> None:
    tiny = make_raster("tiny.tif", grey((60, 200)))
    empty = make_raster("empty.tif", np.zeros((200, 200), np.uint8), nodata=0)
    plan = noise_plan.plan_chosen(images([tiny, empty]), 3)
    assert plan.requests == ()
    said = [str(notice) for notice in plan.notices]
    assert said[0].startswith("tiny.tif has no valid part of 64 x 64 px")
    assert said[1].startswith("empty.tif has no valid part of 64 x 64 px")


def test_a_photograph_without_a_place_on_the_map_is_measured(tmp_path: Path) -> None:
    pixels = orthoimage((256, 256))
    memory = gdal.GetDriverByName("MEM").Create("", 256, 256, 3, gdal.GDT_Byte)
    memory.WriteArray(pixels)
    path = str(tmp_path / "photo.png")
    gdal.GetDriverByName("PNG").CreateCopy(path, memory)
    (image,) = images([path])
    assert image.ground_sample_distance is None
    (whole,) = measure(noise_plan.plan_chosen([image], 3))
    assert whole.bands["red"].curve.detail == pytest.approx(decompose(pixels[0]).shares[:3], abs=1e-6)
    drawn = DrawnWindow(7, (64.2, -191.9, 191.7, -64.1), "")  # as QGIS shows such a picture: rows run down from 0
    (part,) = measure(noise_plan.plan_drawn([image], [drawn], 3))
    assert (part.window_id, part.part.window) == (7, PixelWindow(64, 64, 128, 128))
    expected = decompose(pixels[1, 64:192, 64:192]).shares[:3]
    assert part.bands["green"].curve.detail == pytest.approx(expected, abs=1e-6)


def test_drawn_windows_come_over_from_another_system_and_those_outside_are_said(make_raster: MakeRaster) -> None:
    path = make_raster("a.tif", grey())
    extent = (ORIGIN[0] + 10, ORIGIN[1] - 30, ORIGIN[0] + 30, ORIGIN[1] - 10)
    from seam_inspector.plugin.imagery.reference_systems import extent_on

    inside = DrawnWindow(1, extent_on(extent, wkt(32633), wkt(4326)), wkt(4326))
    outside = DrawnWindow(2, (0, 0, 1, 1), wkt(32633))
    plan = noise_plan.plan_drawn(images([path]), [inside, outside], 3)
    assert [request.window_id for request in plan.requests] == [1]
    assert abs(plan.requests[0].parts[0].window.column - 100) <= 8
    assert [str(notice) for notice in plan.notices] == [
        "Window 2 lies on none of the rasters; draw it on one of them."
    ]


def test_a_window_with_too_many_invalid_pixels_says_so_and_costs_nothing_else(make_raster: MakeRaster) -> None:
    pixels = grey()
    pixels[0, :100, :100] = 0
    path = make_raster("holes.tif", pixels, nodata=0)
    windows = [DrawnWindow(i, (ORIGIN[0] + x, ORIGIN[1] - 25.6, ORIGIN[0] + x + 25.6, ORIGIN[1]), wkt(32633))
               for i, x in ((1, 0.0), (2, 25.6))]
    first, second = measure(noise_plan.plan_drawn(images([path]), windows, 3))
    assert first.bands == {}
    assert "of the pixels of holes.tif are invalid" in str(first.reason)
    assert second.bands


def test_the_same_pixels_are_left_out_of_both(make_raster: MakeRaster) -> None:
    pixels = grey()
    holes = np.ones((512, 512), bool)
    holes[200:260, 300:360] = False
    first = make_raster("first.tif", pixels)
    second = make_raster("second.tif", np.where(holes, pixels, 255).astype(np.uint8), valid=holes)
    window = DrawnWindow(1, (ORIGIN[0], ORIGIN[1] - 51.2, ORIGIN[0] + 51.2, ORIGIN[1]), wkt(32633))
    plan = noise_plan.plan_drawn([*images([first]), *images([second], 2)], [window], 3)
    assert plan.requests[0].paired
    a, b = measure(plan)
    assert [request.part.member.group for request in (a, b)] == [1, 2]
    assert a.paired
    assert a.bands == b.bands  # nothing of what differs is in them
    (alone,) = measure(noise_plan.plan_drawn(images([first]), [window], 3))
    assert a.bands["band_1"].curve.detail != alone.bands["band_1"].curve.detail
    assert a.bands["band_1"].curve.detail == pytest.approx(alone.bands["band_1"].curve.detail, rel=0.03)


@pytest.mark.parametrize(("right", "down", "shared"), [
    (160, 0, PixelWindow(160, 0, 352, 512)), (-160, 0, PixelWindow(0, 0, 352, 512)),
    (0, 160, PixelWindow(0, 160, 512, 352)), (0, -160, PixelWindow(0, 0, 512, 352)),
    (280, 0, None), (0, -280, None),  # the second shows less than half of the window
])
def test_a_pair_is_cut_to_what_both_show_and_who_shows_less_than_half_takes_no_part(
    make_raster: MakeRaster, right: int, down: int, shared: PixelWindow | None
) -> None:
    origin = (ORIGIN[0] + 0.1 * right, ORIGIN[1] - 0.1 * down)
    first, second = make_raster("first.tif", grey()), make_raster("second.tif", grey(), origin=origin)
    window = DrawnWindow(1, (ORIGIN[0], ORIGIN[1] - 51.2, ORIGIN[0] + 51.2, ORIGIN[1]), wkt(32633))
    (request,) = noise_plan.plan_drawn([*images([first]), *images([second], 2)], [window], 3).requests
    parts = [(part.member.group, part.window) for part in request.parts]
    if shared is None:
        assert parts == [(1, PixelWindow(0, 0, 512, 512))]
    else:
        theirs = PixelWindow(shared.column - right, shared.row - down, shared.width, shared.height)
        assert parts == [(1, shared), (2, theirs)]


def test_too_many_invalid_pixels_leave_the_raster_out_of_the_window(make_raster: MakeRaster) -> None:
    pixels = grey()
    holes = np.ones((512, 512), bool)
    holes[:200, :200] = False
    first, second = make_raster("first.tif", pixels), make_raster("second.tif", pixels, valid=holes)
    window = DrawnWindow(1, (ORIGIN[0], ORIGIN[1] - 51.2, ORIGIN[0] + 51.2, ORIGIN[1]), wkt(32633))
    a, b = measure(noise_plan.plan_drawn([*images([first]), *images([second], 2)], [window], 3))
    assert a.bands
    assert not a.paired  # so it was measured with all its pixels
    assert "15.26% of the pixels of second.tif are invalid" in str(b.reason)
    some = np.ones((512, 512), bool)
    some[:40, :40] = False  # 0.6 %: as much as a pair may lack, and more than a raster alone
    third = make_raster("third.tif", pixels, valid=some)
    assert measure(noise_plan.plan_drawn([*images([first]), *images([third], 2)], [window], 3))[1].bands
    alone, _ = measure(noise_plan.plan_drawn([*images([third]), *images([second], 2)], [window], 3))
    assert not alone.bands
    assert "0.6% of the window is invalid" in str(alone.reason)


def test_noise_tells_two_cameras_of_the_same_ground_apart(make_raster: MakeRaster) -> None:
    random = np.random.default_rng(3)
    ground = 120 + 25 * patchy_texture((1100, 1100), 2.7, 8)
    clean = make_raster("digital.tif", np.rint(ground).clip(0, 255).astype(np.uint8))
    film = np.rint(ground + random.normal(0, 9, ground.shape)).clip(0, 255).astype(np.uint8)
    a, b = measure(noise_plan.plan_chosen([*images([clean]), *images([make_raster("film.tif", film)], 2)], 3))
    assert [result.bands["band_1"].verdict.value for result in (a, b)] == ["low", "strong"]
    assert b.bands["band_1"].sigma == pytest.approx(9, rel=0.08)


def test_the_quiet_ground_of_one_window_bounds_the_noise_of_another_that_is_as_bright(make_raster: MakeRaster) -> None:
    rough, smooth = (120 + scale * texture((512, 512), 2.6, 1) for scale in (25, 2))
    wide = np.rint(np.concatenate([rough, smooth, smooth - 80], axis=1)).clip(0, 255).astype(np.uint8)
    image, = images([make_raster("a.tif", wide)])
    parts = [Part(image, PixelWindow(column, 0, 512, 512)) for column in (0, 512, 1024)]
    bright, quiet, dark = measured([NoiseRequest(number, (part,)) for number, part in enumerate(parts)])
    alone, beside_dark, beside_quiet = (
        group_noise.pooled([bright, *others], "coif3")[0].bands["band_1"] for others in ([], [dark], [quiet, dark])
    )
    assert alone == beside_dark == bright.bands["band_1"]
    assert (alone.verdict.value, alone.amount.value) == ("uncertain", "at most some")
    assert (beside_quiet.verdict.value, beside_quiet.amount.value) == ("low", "little")
    assert beside_quiet.largest_sigma == pytest.approx(quiet.bands["band_1"].largest_sigma)


def test_pairs_of_other_pixel_sizes_are_said(make_raster: MakeRaster) -> None:
    fine = grey((1024, 1024))
    coarse = fine.reshape(1, 512, 2, 512, 2).mean(axis=(2, 4)).astype(np.uint8)
    paths = make_raster("fine.tif", fine, gsd=0.1), make_raster("coarse.tif", coarse, gsd=0.2)
    plan = noise_plan.plan_chosen([*images(paths[:1]), *images(paths[1:], 2)], 3)
    assert "0.1 m and 0.2 m" in str(noise_plan.pixel_size_notice(plan))
    (request,) = plan.requests
    assert request.paired
    assert [part.window.width for part in request.parts] == [1024, 512]


def test_windows_are_chosen_where_both_groups_show_the_ground(make_raster: MakeRaster) -> None:
    first = make_raster("first.tif", grey((1100, 2300)))
    second = make_raster("second.tif", grey((1100, 1100), seed=3), origin=(ORIGIN[0] + 120, ORIGIN[1]))
    plan = noise_plan.plan_chosen([*images([first]), *images([second], 2)], 3)
    assert [request.paired for request in plan.requests] == [True]
    ours, theirs = (part.window for part in plan.requests[0].parts)
    assert ours.column - theirs.column == 1200
    assert ours.row == theirs.row


def check(*paths: Path, most: int = 3) -> list[ClipNoise]:
    plan = noise_plan.plan_chosen([noise_plan.GroupedImage(describe(RasterRef(str(path))), 1) for path in paths], 3)
    return measured(plan.requests[:most])


def verdicts(results: list[ClipNoise]) -> set[str]:
    return {result.bands["luminance"].verdict.value for result in results}


def test_the_scanned_frame(data_folder: Path) -> None:
    path = data_folder / "fiducials" / "unbc" / "15BCC02013_114.jpg"
    results = check(path)
    assert "low" in verdicts(results) <= {"low", "uncertain"}  # 42 um a pixel and JPEG: the grain is averaged away
    window = results[1].part.window
    pixels = read_pixels(str(path), window.column, window.row, window.width, window.height)
    expected = decompose(luminance(pixels)).shares[:3]
    assert results[1].bands["luminance"].curve.detail == pytest.approx(expected, abs=1e-6)


def test_the_drone_photo_and_the_production_orthoimages(data_folder: Path) -> None:
    # Its trees and grass are as fine and even as grain of several DN would be: that can't be told from a photo.
    assert verdicts(check(data_folder / "noise" / "seneca" / "IMG_0460.jpg")) <= {"low", "uncertain"}
    sharp = check(*sorted((data_folder / "seams" / "packo").glob("*.tif")))
    assert verdicts(sharp) <= {"low", "uncertain"}
    kurtoses = [result.bands["luminance"].kurtosis[0] for result in sharp]
    assert int(np.argmax(kurtoses)) == 2  # type: ignore[arg-type]  # the blurred one: its few edges stand out most


def test_brightons_orthoimages_are_noisy_in_every_window(data_folder: Path) -> None:
    assert verdicts(check(data_folder / "seams" / "brighton" / "mosaic_hardseam.tif", most=4)) == {"strong"}


def test_feathering_halves_brightons_steps_and_takes_a_tenth_of_the_contrast_beside_them(data_folder: Path) -> None:
    folder = data_folder / "seams" / "brighton"
    layer = ogr.Open(str(folder / "seamlines.gpkg"))
    lines = [bytes(feature.GetGeometryRef().ExportToWkb()) for feature in layer.GetLayer("seamlines")]
    results: list[Assessment] = []
    for name in ("mosaic_hardseam.tif", "mosaic_feather0p4m.tif"):
        results.append(checked(str(folder / name), seams=find_seams(lines, 0.03)))
    figures = [
        {(entry.rule.check, entry.band): entry.value for entry in result.checked_figures if entry.value is not None}
        for result in results
    ]
    hard, feathered = figures
    most = {"seam_step": 0.6, "contrast": 1.0, "seam_contrast": 0.9}
    assert set(most) <= {check for check, _ in hard}
    for check, band in hard:
        if check in most:
            assert feathered[check, band] < most[check] * hard[check, band]
