"""What lies beside a piece of seam: by the labels, and by the names that producers write."""
from __future__ import annotations

import numpy as np
from seam_inspector.plugin.imagery.grids import Grid
from seam_inspector.plugin.seams.measure.seam_cells import meant_sources, names_apart
from seam_inspector.plugin.seams.measure.seamlines.seam_features import source_numbers
from seam_inspector.plugin.seams.measure.seamlines.seam_pieces import SeamPiece, Side, sided, sources_beside

from tests.numbers.seams.scan.lines.labelled import estimated

GRID = Grid(1000.0, 2000.0, 0.5, 0.5, 800, 800)


def labels() -> np.ndarray:
    """5 in the west, 3 in the east, 7 in the south east, none in the north, every hundredth wrong."""
    out = np.full((200, 200), 5, np.int16)
    out[:, 100:] = 3
    out[120:, 100:] = 7
    out[:40] = -1
    return estimated(out, 1)


def seam(*places: tuple[float, float], left: Side = None, right: Side = None) -> SeamPiece:
    """A piece of seam by columns and rows of pixels."""
    x, y = np.array(places, dtype=float).T
    return SeamPiece(1, 0, 0, np.column_stack([1000 + x / 2, 2000 - y / 2]), left, right)


def with_sides(pieces: list[SeamPiece], numbers: dict[str, int] | None = None) -> list[SeamPiece]:
    whole = np.pad(labels(), 300, constant_values=-1)
    shown = sources_beside(pieces, lambda columns, rows: whole[rows + 300, columns + 300], GRID, 4)
    return [sided(piece, seen, numbers or {}) for piece, seen in zip(pieces, shown.tolist())]


def sides(piece: SeamPiece, numbers: dict[str, int] | None = None) -> tuple[Side, Side]:
    (sided_piece,) = with_sides([piece], numbers)
    return sided_piece.left, sided_piece.right


def test_the_labels_beside_a_piece_are_its_sides() -> None:
    assert sides(seam((400, 200), (400, 460))) == (3, 5)  # southward: east is left
    assert sides(seam((400, 460), (400, 200))) == (5, 3)
    assert sides(seam((400, 480), (700, 480))) == (3, 7)
    assert sides(seam((100, 480), (300, 480))) == (5, 5)


def test_names_that_are_exchanged_are_set_right_and_others_stay() -> None:
    numbers = {"west": 5, "east": 3}
    line = (400, 200), (400, 460)
    assert sides(seam(*line, left="west", right="east"), numbers) == ("east", "west")
    assert sides(seam(*line, left="east", right="west"), numbers) == ("east", "west")
    assert sides(seam(*line, left="west", right="other"), numbers) == ("other", "west")
    assert sides(seam(*line, left="x", right="y"), numbers) == ("x", "y")


def images_of(paths: list[str]) -> list[tuple[str]]:
    return [(path,) for path in paths]


def test_names_are_found_among_files() -> None:
    files = ["/data/19FD5606Ax00020_16371.tif", "/data/19FD5606Ax00020_16372.TIF", "DJI_0025_ortho.tif"]
    names = ["19FD5606Ax00020_16371", "16372", r"C:\flight\dji_0025_ORTHO.jp2", "0025", "http://x.pl/id/16372", "ortho"]
    numbers, missing = source_numbers(names, images_of(files))
    assert numbers == dict(zip(names, (0, 1, 2, 2, 1, 2)))
    assert missing is None


def test_names_that_mean_no_file_or_several_are_told() -> None:
    numbers, missing = source_numbers(["19FD", "A", "b", "a_2"], images_of(["19FD_1.tif", "19FD_2.tif", "b.tif"]))
    assert numbers == {"b": 2}
    assert missing.values == {"count": 3, "names": "19FD, A, a_2"}
    assert source_numbers(["a"], [])[1] is None


def test_folders_tell_files_of_one_name_apart() -> None:
    paths = ["/flight/A/o.tif", "/flight/B/o.tif", "/flight/B/p.tif"]
    numbers, missing = source_numbers(["A/o.tif", r"..\\b\\O", "/elsewhere/p.tif", "o.tif"], images_of(paths))
    assert numbers == {"A/o.tif": 0, r"..\\b\\O": 1, "/elsewhere/p.tif": 2}
    assert missing is None
    meant = meant_sources(["o.tif", "x/o.tif", "q"], images_of(paths))
    assert meant == {"o.tif": {0, 1}, "x/o.tif": {0, 1}, "q": set()}
    assert names_apart(paths) == ["A/o.tif", "B/o.tif", "p.tif"]
    assert names_apart(["o.tif", "o.tif"]) == ["o.tif", "o.tif"]
