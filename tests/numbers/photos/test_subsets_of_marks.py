"""A calibration that has only some of a photo's marks: they are measured and named, or one sentence says why not."""
from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import combinations

import pytest
from seam_inspector.plugin.imagery.errors import PhotoError
from seam_inspector.plugin.imagery.rasters import RasterRef
from seam_inspector.plugin.photos.measure.camera_calibration import CameraCalibration, check_calibration
from seam_inspector.plugin.photos.measure.interior_orientation import orient_photo
from seam_inspector.plugin.photos.measure.mark_templates import chosen_shapes
from seam_inspector.plugin.photos.measure.orientation import OrientationSettings, PhotoOrientation
from seam_inspector.plugin.photos.measure.photo import Photo
from seam_inspector.plugin.photos.measure.scan_orientation import OrientationEvidence
from seam_inspector.plugin.photos.measure.transformations import PlaneModel

from tests.numbers.photos.photos import EIGHT, Look, Place, make_frame
from tests.numbers.synthetic import write_plain

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


def oriented(path: str, names: Sequence[str], model: PlaneModel) -> PhotoOrientation:
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
    models = list(PlaneModel)
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
        assumed = made.evidence is OrientationEvidence.ASSUMED
        assert assumed == any("The photo's orientation" in str(notice) for notice in made.notices), names
        assert assumed or farthest(made, bare) < 1, names


@pytest.mark.slow
@pytest.mark.parametrize(("names", "model", "words"), [
    ("124", PlaneModel.AFFINE, None), ("2348", PlaneModel.AFFINE, None), ("1234", PlaneModel.PROJECTIVE, None),
    ("154", PlaneModel.AFFINE, "one line"), ("1827", PlaneModel.PROJECTIVE, "one line"),
    ("56", PlaneModel.SIMILARITY, "only 2 possible marks .* 3 are needed"), ("", PlaneModel.AFFINE, "few"),
])
def test_what_becomes_of_a_subset(numbered: Scan, names: str, model: PlaneModel, words: str | None) -> None:
    if words is not None:
        with pytest.raises(PhotoError, match=words):
            oriented(numbered.path, names, model)
        return
    made = oriented(numbered.path, names, model)
    assert made.evidence is OrientationEvidence.DOTS
    assert all(mark.place for mark in made.marks)
    assert farthest(made, numbered) < 0.2
