"""Transformations, outliers, comparison: formulas against numpy and by hand; a photo's world file as GDAL reads it."""
from __future__ import annotations

import math
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from osgeo import gdal
from seam_inspector.plugin.imagery.errors import PhotoError
from seam_inspector.plugin.photos.measure import limits
from seam_inspector.plugin.photos.measure.camera_calibration import read_calibration
from seam_inspector.plugin.photos.measure.interior_orientation import fail_misplaced_marks, fit_marks
from seam_inspector.plugin.photos.measure.mark_comparison import (
    ComparedMark,
    distance_statistics,
    mark_differences,
    pixel_size,
)
from seam_inspector.plugin.photos.measure.orientation import MarkResult, world_file
from seam_inspector.plugin.photos.measure.transformations import (
    LEAST_MARKS,
    Transformation,
    fit_transformation,
)

from tests.numbers.photos.photos import CAMERA, EIGHT
from tests.numbers.synthetic import write_plain


@pytest.mark.parametrize("model", limits.MODELS)
@given(seed=st.integers(0, 10_000))
def test_a_transformation_is_found_again(model: str, seed: int) -> None:
    random = np.random.default_rng(seed)
    turns = np.arange(6) * math.pi / 3  # round the frame: six at random may lie on a line
    points = 80 * np.column_stack([np.cos(turns), np.sin(turns)]) + random.uniform(-20, 20, (6, 2))
    angle, scale = random.uniform(-3, 3), random.uniform(5, 50)
    matrix = np.eye(3)
    matrix[:2, :2] = scale * np.array([[math.cos(angle), -math.sin(angle)], [math.sin(angle), math.cos(angle)]])
    matrix[:2, 2] = random.uniform(0, 5000, 2)
    if model != limits.SIMILARITY:
        matrix[:2, :2] += scale * random.uniform(-0.1, 0.1, (2, 2))
    if model == limits.PROJECTIVE:
        matrix[2, :2] = random.uniform(-1e-3, 1e-3, 2)
    elif random.random() < 0.5:
        matrix[:, 0] *= -1  # mirrored
    target = Transformation(model, matrix)(points)
    made = fit_transformation(model, points, target)
    assert made(points) == pytest.approx(target, abs=1e-6)
    assert made.inverse(target) == pytest.approx(points, abs=1e-6)
    assert made.inverse.matrix[2, 2] == pytest.approx(1)


@pytest.mark.parametrize("model", limits.MODELS)
def test_too_few_points_or_points_on_a_line(model: str) -> None:
    line = np.array([(float(n), 2.0 * n) for n in range(6)])
    with pytest.raises(PhotoError, match=f"needs {LEAST_MARKS[model]}"):
        fit_transformation(model, line[: LEAST_MARKS[model] - 1], line[: LEAST_MARKS[model] - 1])
    with pytest.raises(PhotoError, match="the same place or on one line"):
        fit_transformation(model, line * (0 if model == limits.SIMILARITY else 1), line)


@pytest.mark.parametrize(("model", "names"), [
    (limits.AFFINE, "154"), (limits.PROJECTIVE, "1546"), (limits.PROJECTIVE, "1827")
])
def test_marks_nearly_on_a_line_determine_nothing_beside_it(model: str, names: str) -> None:
    """Three at one side of the frame: a micrometre at them would be a tenth of a millimetre across the photo."""
    points = np.array([EIGHT[name] for name in names])
    for source, target in ((points, 25 * points), (25 * points, points)):
        with pytest.raises(PhotoError, match="on one line"):
            fit_transformation(model, source, target)


def marks(
    camera: dict[str, tuple[float, float]], moved: dict[str, tuple[float, float]] | None = None
) -> list[MarkResult]:
    """Marks in a scan of 25 px/mm, some of them moved (px), with a few micrometres of noise."""
    random = np.random.default_rng(2)
    made = []
    for name, (x, y) in camera.items():
        dx, dy = (moved or {}).get(name, (0, 0))
        noise = random.normal(0, 0.05, 2)
        place = 3000 + 25 * x + dx + noise[0], 3000 - 25 * y + dy + noise[1]
        made.append(MarkResult(name, (x, y), limits.MEASURED, place))
    return made


def failed(made: list[MarkResult]) -> set[str]:
    return {mark.name for mark in made if mark.status == limits.FAILED}


def test_an_outlier_among_eight_is_found_by_the_model() -> None:
    fitted, made, notices = fit_marks(marks(EIGHT, {"7": (9, 0)}), limits.AFFINE)
    assert failed(made) == {"7"}
    assert (fitted.marks, fitted.redundancy) == (7, 8)
    assert fitted.rms < 5
    assert notices == []
    clean, made, notices = fit_marks(marks(EIGHT), limits.AFFINE)
    assert failed(made) == set()
    assert notices == []
    assert clean.redundancy == 10


@pytest.mark.parametrize(("others", "moved", "out", "named"), [
    (1, 2, set(), False),  # px of 0.04 mm: as far as the others
    (0, 1, set(), False),  # no farther than film and scanner leave on good photos
    (0, 3, set(), True), (0, 5, set(), True),  # stands out, but film deforms by a thousandth of 220 mm
    (0, 6, {"7"}, False), (1, 12, {"7"}, False),
])
def test_what_makes_an_outlier(others: float, moved: float, out: set[str], named: bool) -> None:
    aside = zip(EIGHT, [(1, 0), (0, 1), (-1, 0), (0, -1), (0, 1), (1, 0), (0, 0), (-1, 0)])
    places = {name: (others * x, others * y) for name, (x, y) in aside}
    _, made, notices = fit_marks(fail_misplaced_marks(marks(EIGHT, {**places, "7": (moved, 0)})), limits.AFFINE)
    assert failed(made) == out
    assert [str(notice)[:25] for notice in notices] == ["The mark '7' stands out: "] * named


@pytest.mark.slow
@pytest.mark.parametrize("model", limits.MODELS)
@pytest.mark.parametrize("names", ["1234", "12345", "12345678", "5678"])
@given(seed=st.integers(0, 10_000))
def test_film_that_is_deformed_costs_no_mark(model: str, names: str, seed: int) -> None:
    """Bent by up to 0.04 mm, each mark its own way or the whole film: a limit of 0.05 mm threw good marks out."""
    random = np.random.default_rng(seed)
    points = np.array([EIGHT[name] for name in names]) / 110
    bent = np.stack([points[:, 0] ** 2, points[:, 0] * points[:, 1], points[:, 1] ** 2], 1) @ random.normal(size=(3, 2))
    moves = bent if seed % 2 else random.uniform(-1, 1, points.shape)
    moves *= 0.04 * 25 / np.hypot(*moves.T).max()
    made = marks({name: EIGHT[name] for name in names}, {name: (x, y) for name, (x, y) in zip(names, moves)})
    assert failed(fit_marks(fail_misplaced_marks(made), model)[1]) == set()


def test_residuals_are_where_the_transformation_puts_a_mark_less_where_it_should_be() -> None:
    fitted, made, _ = fit_marks(marks(CAMERA, {"2": (2, -1)}), limits.AFFINE)
    for mark in made:
        assert mark.place is not None
        put = fitted.to_mm(np.array([mark.place]))[0]
        assert mark.residual == pytest.approx(1000 * (put - mark.calibrated), abs=1e-6)
    squares = np.array([mark.residual for mark in made]) ** 2
    assert (fitted.rms_x, fitted.rms_y) == pytest.approx(np.sqrt(squares.mean(axis=0)))


def test_where_no_three_agree_none_is_blamed_alone() -> None:
    made = fail_misplaced_marks(marks(CAMERA, {"2": (30, -10), "4": (-20, 40)}))
    assert failed(made) == set("1234")
    assert len({str(mark.reason) for mark in made}) == 1


def test_of_four_marks_a_gross_error_is_named_and_a_small_one_is_not() -> None:
    made = fail_misplaced_marks(marks(CAMERA, {"2": (30, -10)}))
    assert failed(made) == {"2"}
    made = fail_misplaced_marks(marks(CAMERA, {"2": (2, 0)}))
    made = fit_marks(made, limits.AFFINE)[1]
    assert failed(made) == set()  # two degrees of freedom: all four residuals are of one size
    sizes = [math.hypot(*mark.residual) for mark in made if mark.residual]
    assert max(sizes) < 1.1 * min(sizes)
    three = {name: CAMERA[name] for name in "123"}
    made = fail_misplaced_marks(marks(three, {"2": (60, 0)}))
    assert failed(made) == {"1", "2", "3"}


def test_comparison_by_hand() -> None:
    first = [ComparedMark("a", "1", (0, 0), (0, 0)), ComparedMark("a", "2", (10, 0), (0.2, 0))]
    first.append(ComparedMark("b", "1", (5, 5)))
    second = [ComparedMark("b", "1", (5, 6)), ComparedMark("a", "1", (3, 4)), ComparedMark("c", "1", (0, 0))]
    differences, alone = mark_differences(first, second)
    assert alone == [("a", "2"), ("c", "1")]
    assert [(mark.photo, mark.mark, mark.distance) for mark in differences] == [("a", "1", 5), ("b", "1", 1)]
    made = distance_statistics(differences)
    assert (made.count, made.mean, made.maximum, made.minimum) == (2, 3, 5, 1)
    assert made.standard_deviation == pytest.approx(np.std([5, 1], ddof=1))
    assert pixel_size(first) == pytest.approx(20)
    assert distance_statistics(differences, 20).mean == 60
    (of_one_photo,), alone = mark_differences(first[:1], [ComparedMark("", "1", (3, 4))])  # which does not say which
    assert (of_one_photo.distance, alone) == (5, [])
    with pytest.raises(PhotoError, match="no mark in common"):
        mark_differences(first, [ComparedMark("d", "9", (0, 0))])
    with pytest.raises(PhotoError, match="no scanned photo has pixels"):
        mark_differences(first, [ComparedMark("d", "1", (1, 1e300))])
    with pytest.raises(PhotoError, match="twice"):
        mark_differences(first, [ComparedMark("", "1", (0, 0)), ComparedMark("", "1", (1, 0))])


def test_calibration_files(tmp_path: Path) -> None:
    path = tmp_path / "camera.csv"
    path.write_text(
        "\ufeffMark;X_mm;Y_mm\nP1;106,004;-106,002\n P2 ;-105,998;-105,998\n\nprincipal point;0,01;-0,02\n"
        "focal_length;153,21;\n", encoding="utf-8",
    )
    made = read_calibration(path)
    assert made.marks == {"P1": (106.004, -106.002), "P2": (-105.998, -105.998)}
    assert (made.principal_point, made.focal_length, made.data_strip) == ((0.01, -0.02), 153.21, None)
    for text in ("<a", "<!DOCTYPE a><a/>", "x,y\n1,2\n"):
        path.write_text(text, encoding="utf-8")
        with pytest.raises(PhotoError):
            read_calibration(path)


@pytest.mark.parametrize("degrees", [0.0, 1.2, 37.0, 90.0, -135.0])
def test_gdal_puts_every_pixel_where_the_orientation_does(degrees: float, tmp_path: Path) -> None:
    turn, pixel_mm = np.radians(degrees), 0.4
    matrix = np.array([
        [pixel_mm * np.cos(turn), pixel_mm * np.sin(turn), -106.0],
        [pixel_mm * np.sin(turn), -pixel_mm * np.cos(turn), 106.0],
        [0.0, 0.0, 1.0],
    ])
    to_mm = Transformation(limits.AFFINE, matrix)
    marks = [SimpleNamespace(place=place) for place in ((0.0, 0.0), (530.0, 0.0), (0.0, 530.0), (530.0, 530.0))]
    made: Any = SimpleNamespace(fitted=SimpleNamespace(to_mm=to_mm), marks=marks)
    path = write_plain(tmp_path / "photo.png", np.zeros((530, 530), np.uint8))
    (tmp_path / "photo.pgw").write_text(world_file(made))
    transform = gdal.Open(path).GetGeoTransform()
    places = np.array([(0.0, 0.0), (0.5, 0.5), (529.25, 17.75), (265.0, 530.0)])
    transformed = [gdal.ApplyGeoTransform(transform, column, row) for column, row in places.tolist()]
    assert np.array(transformed) == pytest.approx(to_mm(places), abs=1e-9)
