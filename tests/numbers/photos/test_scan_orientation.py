"""How a photo lies in its scan, of eight ways, and a calibration that has only some of its marks."""
from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import combinations

import numpy as np
import pytest
from seam_inspector.plugin.imagery.errors import PhotoError
from seam_inspector.plugin.imagery.rasters import RasterRef
from seam_inspector.plugin.photos.measure import limits
from seam_inspector.plugin.photos.measure.arrangements import Arrangement
from seam_inspector.plugin.photos.measure.camera_calibration import CameraCalibration, check_calibration
from seam_inspector.plugin.photos.measure.interior_orientation import orient_photo
from seam_inspector.plugin.photos.measure.mark_templates import chosen_shapes
from seam_inspector.plugin.photos.measure.orientation import OrientationSettings, PhotoOrientation
from seam_inspector.plugin.photos.measure.photo import Photo
from seam_inspector.plugin.photos.measure.scan_orientation import (
    SCAN_ORIENTATIONS,
    Labelling,
    ScanOrientation,
    count_numbering_dots,
    labellings,
    matching_data_strip,
    matching_dots,
    matching_residuals,
    possible_frames,
)

from tests.numbers.photos.photos import CAMERA, EIGHT, Look, Place, make_frame
from tests.numbers.synthetic import write_plain

SCALE = 20.0  # px/mm
STRIP = CameraCalibration(CAMERA, data_strip=(0.0, 118.0))  # above the picture
MARGIN = 10 * SCALE


def in_scan(camera: Mapping[str, Place], orientation: ScanOrientation) -> dict[str, Place]:
    """Columns and rows of the marks: turned and mirrored by hand, ten millimetres from the scan's edges."""
    made = {}
    for name, (x, y) in camera.items():
        across, down = (-x if orientation.mirrored else x), -y
        for _ in range(orientation.turned // 90):
            across, down = -down, across  # a quarter to the right: what was above is at the right
        made[name] = (MARGIN + SCALE * (across + 106), MARGIN + SCALE * (down + 106))
    return made


def candidates(calibration: CameraCalibration) -> tuple[list[Labelling], Arrangement]:
    """Every way to name four marks that were found."""
    frame, *_ = possible_frames(calibration, 5000, 5000)
    matrix = np.array([[SCALE, 0, MARGIN + SCALE * 106], [0, SCALE, MARGIN + SCALE * 106]])
    places = np.column_stack([frame.places, np.ones(len(frame.places))]) @ matrix.T
    by_mark = dict(zip(frame.marks, map(tuple, places)))
    arrangement = Arrangement(frame, None, 1, by_mark, dict.fromkeys(frame.marks, 1.0), matrix)
    return labellings(calibration, arrangement), arrangement


every_orientation = pytest.mark.parametrize(
    "orientation", SCAN_ORIENTATIONS, ids=lambda way: f"{way.turned}{'m' * way.mirrored}"
)


@every_orientation
def test_marks_are_named_as_they_lie(orientation: ScanOrientation) -> None:
    named = {labelling.orientation: labelling for labelling in candidates(STRIP)[0]}
    assert len(named) == 8
    for name, place in in_scan(CAMERA, orientation).items():
        assert named[orientation].places[name] == pytest.approx(place, abs=0.01 * SCALE)


@every_orientation
def test_the_data_strip_lies_where_the_scan_goes_on(orientation: ScanOrientation) -> None:
    every, arrangement = candidates(STRIP)
    strip = in_scan({"strip": (0.0, 118.0)}, orientation)["strip"]
    size = 2 * MARGIN + SCALE * 212
    beyond = np.array([max(-strip[0], 0), max(-strip[1], 0), max(strip[0] - size, 0), max(strip[1] - size, 0)])
    more = np.where(beyond > 0, MARGIN, 0)  # on one side only, so that the strip is in the scan
    moved = [(x + more[0], y + more[1]) for x, y in arrangement.places.values()]
    whole = round(size + more[0] + more[2]), round(size + more[1] + more[3])
    chosen = [labelling.orientation for labelling in matching_data_strip(every, STRIP, moved, whole)]
    assert orientation in chosen
    assert len(chosen) == 2  # mirrored about the strip's middle it lies there too
    alike = arrangement.places.values(), (round(size), round(size))  # it goes as far on all sides
    assert matching_data_strip(every, STRIP, *alike) == []


@every_orientation
def test_residuals_tell_where_marks_are_no_square_and_only_there(orientation: ScanOrientation) -> None:
    uneven = CameraCalibration({**CAMERA, "4": (107.6, 105.3)})
    every, _ = candidates(uneven)
    site_of = next(labelling.sites for labelling in every if labelling.orientation == orientation)
    measured = {site_of[name]: place for name, place in in_scan(uneven.marks, orientation).items()}
    (chosen,) = matching_residuals(every, uneven, measured, limits.AFFINE)
    assert chosen.orientation == orientation
    name, (x, y) = next(iter(measured.items()))
    off = {**measured, name: (x + 6 * SCALE, y)}  # measured badly: no way to lie fits much better than others
    assert matching_residuals(every, uneven, off, limits.AFFINE) == []
    square, _ = candidates(CameraCalibration(CAMERA))
    sites = dict(zip(square[0].sites.values(), in_scan(CAMERA, orientation).values()))
    assert matching_residuals(square, CameraCalibration(CAMERA), sites, limits.AFFINE) == []


def test_dots_tell_when_all_but_one_of_their_counts_agree() -> None:
    every, _ = candidates(STRIP)
    truth = every[3]
    counts = {site: int(name) for name, site in truth.sites.items()}
    assert matching_dots(every, counts) == [truth]
    assert matching_dots(every, {**counts, truth.sites["2"]: 7}) == [truth]
    assert matching_dots(every, {**counts, truth.sites["2"]: 7, truth.sites["3"]: 7}) == []
    missed = {truth.sites[name]: count for name, count in zip("1234", (1, 1, 2, 3))}  # a dot less beside each
    assert matching_dots(every, missed) == []  # three agree with a frame turned by a quarter
    assert matching_dots(every, {**counts, truth.sites["4"]: 3}) == [truth]
    assert matching_dots(every, {truth.sites["1"]: 1, truth.sites["2"]: 2}) == []  # two are too few of four
    assert matching_dots(every, {truth.sites["1"]: 1}) == []


def test_grain_is_no_dots_and_dots_are_counted() -> None:
    radius, half = 15.0, 40
    for seed in range(10):
        grain = np.random.default_rng(seed).normal(40, 6, (2 * half + 1, 2 * half + 1))
        assert count_numbering_dots(grain, radius, 0.0) is None
    rows, columns = np.mgrid[-half : half + 1, -half : half + 1]
    for count in (1, 2, 3, 4):
        drawn = np.random.default_rng(count).normal(40, 2, rows.shape)
        for place in 6.0 * (np.arange(count) - (count - 1) / 2):
            drawn[np.hypot(columns - 1.7 * radius, rows - place) <= 2] += 60
        for turn in range(4):
            assert count_numbering_dots(np.rot90(drawn, turn), radius, 0.0) == count


SUBSETS = [names for count in range(9) for names in combinations(EIGHT, count)]


@dataclass(frozen=True)
class Scan:
    """A photo and where its marks are."""

    path: str
    places: Mapping[str, Place]


@pytest.fixture(scope="module")
def bare(tmp_path_factory: pytest.TempPathFactory) -> Scan:
    """Eight marks without numbers; the photo lies upright."""
    frame = make_frame(Look(diagonal=True, size=20, width=2.6), EIGHT, 400, 0.82, 0.7, seed=3)
    return Scan(write_plain(tmp_path_factory.mktemp("bare") / "photo.tif", frame.pixels), frame.places)


@pytest.fixture(scope="module")
def numbered(tmp_path_factory: pytest.TempPathFactory) -> Scan:
    """Eight marks with their numbers; the photo lies upside down."""
    side = 560
    frame = make_frame(Look(diagonal=True, size=30, dots=True), EIGHT, side, 0.78, 0.7, seed=3)
    path = write_plain(tmp_path_factory.mktemp("numbered") / "photo.tif", frame.pixels[::-1, ::-1].copy())
    return Scan(path, {name: (side - x, side - y) for name, (x, y) in frame.places.items()})


def oriented(path: str, names: Sequence[str], model: str) -> PhotoOrientation:
    camera = CameraCalibration({name: EIGHT[name] for name in names})
    check_calibration(camera, model)
    shapes = chosen_shapes("ring with cross", None, None)  # two figures, between which to choose
    return orient_photo(Photo(RasterRef(path)), camera, {}, OrientationSettings(shapes=shapes, model=model))


def farthest(made: PhotoOrientation, scan: Scan) -> float:
    """Largest distance of the marks from the truth, px."""
    return max(math.dist(mark.place, scan.places[mark.name]) for mark in made.marks if mark.place)


@pytest.mark.release
def test_every_subset_ends_in_marks_or_a_sentence(bare: Scan) -> None:
    """A photo of eight marks holds turned ones of a subset too: where nothing tells which it is, that is said."""
    models = list(limits.MODELS)
    one_left_out = SUBSETS[-9:-1]
    for number, names in enumerate([*SUBSETS[::47], *one_left_out]):
        made, complaint = None, ""
        try:
            made = oriented(bare.path, names, models[number % 3])
        except PhotoError as error:
            complaint = str(error)
        if made is None:
            assert complaint.endswith("."), names
            assert len(names) < 5, complaint
            continue
        assumed = made.evidence == limits.ASSUMED
        assert assumed == any("The photo's orientation" in str(notice) for notice in made.notices), names
        assert assumed or farthest(made, bare) < 1, names


@pytest.mark.slow
@pytest.mark.parametrize(("names", "model", "words"), [
    ("124", limits.AFFINE, None), ("2348", limits.AFFINE, None), ("1234", limits.PROJECTIVE, None),
    ("154", limits.AFFINE, "one line"), ("1827", limits.PROJECTIVE, "one line"),
    ("56", limits.SIMILARITY, "only 2 possible marks .* 3 are needed"), ("", limits.AFFINE, "few"),
])
def test_what_becomes_of_a_subset(numbered: Scan, names: str, model: str, words: str | None) -> None:
    if words is not None:
        with pytest.raises(PhotoError, match=words):
            oriented(numbered.path, names, model)
        return
    made = oriented(numbered.path, names, model)
    assert made.evidence == limits.DOTS
    assert all(mark.place for mark in made.marks)
    assert farthest(made, numbered) < 0.2
