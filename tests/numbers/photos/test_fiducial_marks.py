"""Whole photos: made ones of every kind of mark, in every way to lie, and the real ones."""
from __future__ import annotations

import math
from collections.abc import Mapping
from pathlib import Path

import numpy as np
import pytest
from osgeo import gdal
from scipy import ndimage
from seam_inspector.plugin.imagery.errors import PhotoError
from seam_inspector.plugin.imagery.rasters import RasterRef
from seam_inspector.plugin.photos.measure import finding_marks, limits
from seam_inspector.plugin.photos.measure.camera_calibration import CameraCalibration, read_calibration
from seam_inspector.plugin.photos.measure.interior_orientation import fit_marks, orient_photo
from seam_inspector.plugin.photos.measure.mark_templates import CutOut, chosen_shapes, cut_out
from seam_inspector.plugin.photos.measure.orientation import (
    GivenPosition,
    MarkResult,
    OrientationSettings,
    PhotoOrientation,
)
from seam_inspector.plugin.photos.measure.photo import Photo
from seam_inspector.plugin.photos.measure.scan_orientation import (
    SCAN_ORIENTATIONS,
    ScanOrientation,
)

from tests.numbers.photos.photos import CAMERA, Frame, Look, Place, make_frame
from tests.numbers.synthetic import write_plain

SIDES = {"1": (110.0, 0.0), "2": (0.0, -110.0), "3": (-110.0, 0.0), "4": (0.0, 110.0)}


def measured(
    pixels: np.ndarray, folder: Path, camera: Mapping[str, Place] = CAMERA, settings: OrientationSettings | None = None,
    positions: Mapping[str, GivenPosition] | None = None,
) -> PhotoOrientation:
    photo = Photo(RasterRef(write_plain(folder / "photo.tif", pixels)))
    return orient_photo(photo, CameraCalibration(camera), positions or {}, settings or OrientationSettings())


def errors(made: PhotoOrientation, frame: Frame) -> list[float]:
    """Distances of the measured marks from the truth, by their names, px."""
    return [math.dist(mark.place, frame.places[mark.name]) for mark in made.marks if mark.place is not None]


def frame_of(number: int, strong: bool) -> tuple[Look, Mapping[str, Place], Frame]:
    """One of the made photos: all that may vary does, from its number."""
    random = np.random.default_rng(number)
    kinds = (
        ("ring with cross", True, True, 1.4), ("ring with cross", False, False, 1.0), ("cross", False, False, 1.0),
        ("cross", True, False, 1.0), ("cross", False, True, 1.0), ("ring with dot", False, False, 1.0),
        ("dot", False, False, 1.0), ("wedge", True, False, 1.0), ("wedge", False, False, 1.0),
    )
    kind, diagonal, interrupted, reach = kinds[number % len(kinds)]
    size = random.uniform(12, 24) if kind == "dot" else random.uniform(22, 32)
    look = Look(
        kind, size, max(2.2, size * random.uniform(0.07, 0.12)), diagonal, interrupted, reach, random.uniform(0.5, 1.4),
        grain=0.25 if strong else 0.02, gradient=random.uniform(0, 0.4), scratches=int(random.integers(0, 2)),
        negative=bool(random.random() < 0.4), dots=kind != "wedge",
    )
    camera = SIDES if kind == "wedge" and not diagonal else CAMERA
    frame = make_frame(
        look, camera, 560, random.uniform(0.8, 0.86), random.uniform(-3, 3), tuple(random.uniform(-8, 8, 2)), number
    )
    return look, camera, frame


@pytest.mark.slow
@pytest.mark.parametrize("strong", [False, True], ids=["little grain", "strong grain"])
def test_every_kind_of_mark_is_measured(tmp_path: Path, strong: bool) -> None:
    """Nobody says where the marks are, nor, with little grain, what they look like; none is more than a pixel off."""
    distances: list[float] = []
    for number in range(9):
        look, camera, frame = frame_of(number, strong)
        known = OrientationSettings(shapes=chosen_shapes(look.kind, look.diagonal, None)) if strong else None
        made = measured(frame.pixels, tmp_path, camera, known)
        truth = list(frame.places.values())
        off = [min(math.dist(mark.place, place) for place in truth) for mark in made.marks if mark.place is not None]
        assert max(off) < 1, look
        assert len(off) >= 3, look
        distances += off
    assert len(distances) >= 34
    assert np.mean(distances) <= (0.15 if strong else 0.05)


@pytest.mark.slow
@pytest.mark.parametrize("orientation", SCAN_ORIENTATIONS, ids=lambda way: f"{way.turned}{'m' * way.mirrored}")
def test_the_numbers_tell_how_a_photo_lies(tmp_path: Path, orientation: ScanOrientation) -> None:
    frame = make_frame(Look(dots=True, diagonal=True, interrupted=True, contrast=40), side=640, seed=11, rotation=-0.8)
    pixels, places = laid(frame, orientation)
    settings = OrientationSettings(shapes=chosen_shapes("ring with cross", True, None))
    made = measured(pixels, tmp_path, settings=settings)
    assert (made.scan_orientation, made.evidence) == (orientation, limits.DOTS)
    assert max(errors(made, Frame(pixels, places))) < 0.1


def laid(frame: Frame, orientation: ScanOrientation) -> tuple[np.ndarray, Mapping[str, Place]]:
    """A photo as it lies in another way, by numpy alone."""
    pixels, side = frame.pixels, frame.pixels.shape[0]
    places = dict(frame.places)
    if orientation.mirrored:
        pixels = pixels[:, ::-1]
        places = {name: (side - x, y) for name, (x, y) in places.items()}
    for _ in range(orientation.turned // 90):
        pixels = np.rot90(pixels, -1)
        places = {name: (side - y, x) for name, (x, y) in places.items()}
    return np.ascontiguousarray(pixels), places


@pytest.mark.parametrize("orientation", SCAN_ORIENTATIONS, ids=lambda way: f"{way.turned}{'m' * way.mirrored}")
def test_positions_tell_how_a_photo_lies(tmp_path: Path, orientation: ScanOrientation) -> None:
    pixels, places = laid(Frame(np.zeros((500, 500), np.uint8), make_frame(Look(), side=500).places), orientation)
    given = {name: GivenPosition(place, measure=False) for name, place in places.items()}
    made = measured(pixels, tmp_path, positions=given)
    assert (made.scan_orientation, made.evidence) == (orientation, limits.POSITIONS)


@pytest.mark.parametrize("beyond", [-12, 0, 12], ids=["half", "edge in its middle", "gone"])
def test_a_mark_cut_off_by_the_scan_fails_alone(tmp_path: Path, beyond: int) -> None:
    """What lies beyond the edge was made up of its last pixels, where half a wedge looks like a whole one."""
    frame = make_frame(Look("wedge"), SIDES, 500, seed=15)
    pixels = np.ascontiguousarray(frame.pixels[:, : int(frame.places["1"][0]) - beyond])
    made = measured(pixels, tmp_path, SIDES, OrientationSettings(shapes=chosen_shapes("wedge", False, None)))
    assert [mark.status for mark in made.marks] == ["failed", "measured", "measured", "measured"]
    assert max(errors(made, frame)) < 0.1


def with_four_alike(frame: Frame, covered: np.ndarray) -> np.ndarray:
    """The photo with the same light thing on dark ground near each of its corners, in the marks' own arrangement."""
    pixels = frame.pixels.astype(np.float64)
    half = covered.shape[0] // 2
    for column in (105, pixels.shape[1] - 105):
        for row in (105, pixels.shape[0] - 105):
            around = slice(row - half, row + half + 1), slice(column - half, column + half + 1)
            pixels[around] = ndimage.gaussian_filter(90.0 * covered, 2) + 60
    return np.clip(pixels, 0, 255).astype(np.uint8)


@pytest.mark.slow
@pytest.mark.parametrize(
    "thing", ["half a disc, which can't be measured", "a disc with a bite, which fits a dot fairly well"]
)
def test_things_that_lie_as_the_marks_do_are_not_taken_for_them(tmp_path: Path, thing: str) -> None:
    frame = make_frame(Look(diagonal=True, dots=True, size=26, contrast=25, grain=0.1), side=700, share=0.9, seed=1)
    y, x = np.mgrid[-45:46, -45:46]
    disc = np.hypot(x, y) <= (22 if "half" in thing else 28)
    covered = disc & (x < 0) if "half" in thing else disc & ~((x > 14) & (y > 14))
    made = measured(with_four_alike(frame, covered), tmp_path)
    assert max(errors(made, frame)) < 0.1
    assert made.count(limits.MEASURED) == 4


def test_bits_and_colours_do_not_matter(tmp_path: Path) -> None:
    frame = make_frame(Look(dots=True, diagonal=True), side=500, seed=14)
    settings = OrientationSettings(shapes=chosen_shapes("ring with cross", True, None))
    grey = frame.pixels
    for pixels in (
        grey.astype(np.uint16) * 16, np.stack([grey, grey, grey]), np.stack([grey, grey // 2, 255 - grey]),
        grey.astype(np.float32) / 255,
    ):
        assert max(errors(measured(pixels, tmp_path, settings=settings), frame)) < 0.15
    bit = write_plain(tmp_path / "bit.tif", (grey > 72).astype(np.uint8), ["NBITS=1"])
    assert gdal.Open(bit).GetRasterBand(1).GetMetadataItem("NBITS", "IMAGE_STRUCTURE") == "1"
    assert max(errors(orient_photo(Photo(RasterRef(bit)), CameraCalibration(CAMERA), {}, settings), frame)) < 0.5


@pytest.mark.slow
@pytest.mark.parametrize("dtype", [np.uint8, np.uint16, np.float32])
@pytest.mark.parametrize("reduced", [False, True])
def test_black_that_the_file_calls_nodata_is_a_grey_value(
    tmp_path: Path, dtype: type, reduced: bool, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A frame as black as can be around its marks: filled with the picture's mean it would have no marks."""
    if reduced:
        monkeypatch.setattr(finding_marks, "SEARCH_SIDE_PX", 300)
    frame = make_frame(Look(dots=True, diagonal=True), side=500, seed=14)
    pixels = np.where(frame.pixels < 62, 0, frame.pixels)
    near = np.minimum.reduce([np.hypot(*(np.indices(pixels.shape)[::-1] + 0.5 - np.reshape(place, (2, 1, 1))))
                              for place in frame.places.values()])
    pixels = np.where((near > 60) & (pixels == 0), 1, pixels)  # the picture itself has none
    path = write_plain(tmp_path / "photo.tif", pixels.astype(dtype))
    dataset = gdal.Open(path, gdal.GA_Update)
    dataset.GetRasterBand(1).SetNoDataValue(0)
    del dataset
    settings = OrientationSettings(shapes=chosen_shapes("ring with cross", True, None))
    made = orient_photo(Photo(RasterRef(path)), CameraCalibration(CAMERA), {}, settings)
    assert made.count(limits.MEASURED) == 4
    assert max(errors(made, frame)) < 0.1


def test_a_given_place_that_is_off_takes_no_part(tmp_path: Path) -> None:
    """30 px beside its mark it went into the transformation, with residuals of a millimetre."""
    frame = make_frame(Look(dots=True, diagonal=True), side=500, seed=14)
    settings = OrientationSettings(shapes=chosen_shapes("ring with cross", True, None))
    for away, status in ((0.2, limits.GIVEN), (30, limits.FAILED)):
        column, row = frame.places["2"]
        given = {"2": GivenPosition((column + away, row), measure=False)}
        made = measured(frame.pixels, tmp_path, settings=settings, positions=given)
        assert [mark.status for mark in made.marks] == [
            limits.MEASURED, status, limits.MEASURED, limits.MEASURED
        ]
        assert made.fitted.marks == 3 + (status == limits.GIVEN)
    everywhere = {name: GivenPosition((x + 40 * (name == "2"), y), False) for name, (x, y) in frame.places.items()}
    made = measured(frame.pixels, tmp_path, positions=everywhere)
    assert [mark.name for mark in made.marks if mark.place is None] == ["2"]
    everywhere["3"] = GivenPosition((frame.places["3"][0], frame.places["3"][1] + 60), False)
    with pytest.raises(PhotoError, match="can be trusted"):
        measured(frame.pixels, tmp_path, positions=everywhere)
    with pytest.raises(PhotoError, match="The position of '2' lies outside the photo"):
        measured(frame.pixels, tmp_path, positions={"2": GivenPosition((-5.0, 10.0), False)})


def cut(frame: Frame, name: str, aside: tuple[int, int] = (0, 0)) -> CutOut:
    column, row = (int(value) + by for value, by in zip(frame.places[name], aside))
    return cut_out(frame.pixels[row - 24 : row + 25, column - 24 : column + 25].astype(float))


@pytest.mark.slow
@pytest.mark.parametrize("name", ["1", "2"])
def test_a_cut_out_is_used_for_its_own_mark_first(tmp_path: Path, name: str) -> None:
    """Wedges at other sides look otherwise: by the cut-out alone no three were found, now the others are drawn."""
    frame = make_frame(Look("wedge"), SIDES, 1000, seed=8, rotation=1.1)
    made = measured(frame.pixels, tmp_path, SIDES, OrientationSettings(template=cut(frame, name)))
    assert max(errors(made, frame)) < 0.05
    marks = {mark.name: mark for mark in made.marks}
    assert len(errors(made, frame)) == 4
    assert marks[name].correlation == pytest.approx(1, abs=0.002)
    assert marks[name].correlation == max(mark.correlation or 0 for mark in made.marks)


@pytest.mark.slow
def test_a_mark_that_looks_like_no_other_is_measured_by_its_cut_out(tmp_path: Path) -> None:
    frame = make_frame(Look(dots=True, diagonal=True), side=1000, seed=8)
    column, row = (int(value) for value in frame.places["3"])
    around = slice(row - 24, row + 25), slice(column - 24, column + 25)
    pixels = frame.pixels.copy()
    pixels[around] = np.where(np.hypot(*np.mgrid[-24:25, -24:25]) < 13, 230, pixels[around])  # painted over by hand
    template = cut_out(pixels[around].astype(float))
    made = measured(pixels, tmp_path, settings=OrientationSettings(template=template))
    assert made.count(limits.MEASURED) == 4
    assert max(errors(made, frame)) < 1


UNBC = "15BCC02013_114.jpg"


@pytest.fixture(scope="module")
def unbc(data_folder: Path) -> Path:
    return data_folder / "fiducials" / "unbc"


@pytest.fixture(scope="module")
def unbc_orientation(unbc: Path) -> PhotoOrientation:
    """No positions, no kind of mark given."""
    calibration = read_calibration(unbc / "MeasuresCamera.xml")
    return orient_photo(Photo(RasterRef(str(unbc / UNBC))), calibration, {}, OrientationSettings())


def test_a_whole_scanned_frame(unbc: Path, unbc_orientation: PhotoOrientation) -> None:
    """The published places were set by hand, one visibly 0.9 px off."""
    published = read_calibration(unbc / f"MeasuresIm-{UNBC}.xml").marks
    made = unbc_orientation
    assert [mark.status for mark in made.marks] == [limits.MEASURED] * 4
    assert (made.scan_orientation, made.evidence) == (ScanOrientation(0, False), limits.DOTS)
    distances = [math.dist(mark.place, published[mark.name]) for mark in made.marks if mark.place]
    assert np.mean(distances) < 0.62
    assert (made.fitted.rms_x, made.fitted.rms_y) < (14, 14.5)
    assert min(mark.correlation or 0 for mark in made.marks) > 0.9


def test_the_published_places_leave_the_residuals_that_are_known_of_them(unbc: Path) -> None:
    calibration = read_calibration(unbc / "MeasuresCamera.xml").marks
    published = read_calibration(unbc / f"MeasuresIm-{UNBC}.xml").marks
    given = [MarkResult(name, calibration[name], limits.GIVEN, place) for name, place in published.items()]
    fitted = fit_marks(given, limits.AFFINE)[0]
    assert (fitted.rms_x, fitted.rms_y) == pytest.approx((11.6, 14.3), abs=0.05)


@pytest.mark.release
def test_the_same_frame_mirrored_and_turned(unbc: Path, tmp_path: Path) -> None:
    calibration = read_calibration(unbc / "MeasuresCamera.xml")
    turned = np.ascontiguousarray(np.rot90(Photo(RasterRef(str(unbc / UNBC))).grey().astype(np.uint8)[:, ::-1], -1))
    photo = Photo(RasterRef(write_plain(tmp_path / "turned.tif", turned)))
    made = orient_photo(photo, calibration, {}, OrientationSettings())
    assert (made.scan_orientation, made.evidence) == (ScanOrientation(90, True), limits.DOTS)
    assert made.count(limits.MEASURED) == 4


@pytest.mark.release
@pytest.mark.parametrize(
    ("strip", "place"), [("T", (894, 290)), ("L", (287, 895)), ("B", (894, 170)), ("R", (159, 894))]
)
def test_a_mark_in_every_strip(data_folder: Path, strip: str, place: Place) -> None:
    """Seen by eye, to the pixel. Without a position the strip does not tell which mark it has, and it says so."""
    photo = Photo(RasterRef(str(data_folder / "fiducials" / "hipp" / "arc" / f"{strip}.jpg")))
    camera = CameraCalibration({"T": (0.0, 110.0), "R": (110.0, 0.0), "B": (0.0, -110.0), "L": (-110.0, 0.0)})
    made = orient_photo(photo, camera, {strip: GivenPosition((place[0] + 15, place[1] - 12))}, OrientationSettings())
    (mark,) = (mark for mark in made.marks if mark.name == strip)
    assert mark.place is not None
    assert math.dist(mark.place, (place[0] + 0.5, place[1] + 0.5)) < 1.2
    assert all(other.reason is not None for other in made.marks if other.name != strip)
    assert made.fitted is None
    with pytest.raises(PhotoError, match="No mark was found"):
        orient_photo(photo, camera, {}, OrientationSettings(shapes=chosen_shapes("cross", False, None)))
