"""What given seams say lies beside them, by place."""
from __future__ import annotations

import numpy as np
from seam_inspector.plugin.imagery.grids import Grid, PixelWindow
from seam_inspector.plugin.seams.measure.blocks.seam_sides import SeamSides, Sides
from seam_inspector.plugin.seams.measure.seamlines.piece_index import PieceIndex
from seam_inspector.plugin.seams.measure.seamlines.seam_pieces import SeamPiece

GRID = Grid(0.0, 0.0, 1.0, 1.0, 2000, 2000)
DOWN, ACROSS = [(100.0, 0.0), (100.0, 500.0)], [(1000.0, 900.0), (1400.0, 900.0)]


def sides_of(*seams: tuple[list[tuple[float, float]], Sides]) -> SeamSides:
    """Through columns and rows."""
    pieces = []
    for number, (places, _) in enumerate(seams):
        vertices = np.array(places) * (1, -1)
        pieces.append(SeamPiece(number, 0.0, 500.0, vertices, None, None))
    return SeamSides(PieceIndex(pieces, GRID), {number: sides for number, (_, sides) in enumerate(seams)})


def test_a_part_lies_on_one_hand_of_a_seam() -> None:
    parts = sides_of((DOWN, (3, 5))).parts(PixelWindow(40, 40, 128, 64))
    assert parts.shape == (64, 128)
    east, west = parts[:, 64:], parts[:, :56]
    assert (east == east[0, 0]).all()
    assert (west == west[0, 0]).all()
    assert east[0, 0] != west[0, 0]


def test_two_seams_of_the_same_two_sources_have_the_same_parts_and_others_have_their_own() -> None:
    further = [(100.0, 500.0), (100.0, 900.0)]
    window = PixelWindow(40, 400, 128, 200)
    same = sides_of((DOWN, (3, 5)), (further, (3, 5))).parts(window)
    others = sides_of((DOWN, (3, 5)), (further, (3, 6))).parts(window)
    assert len(np.unique(same)) == 2
    assert len(np.unique(others)) == 4


def test_sources_are_named_by_the_seams_of_their_place() -> None:
    sides = sides_of((DOWN, (3, 5)), (ACROSS, (5, None)))
    assert sides.named_near(PixelWindow(64, 64, 64, 64)) == {3, 5}
    assert sides.named_near(PixelWindow(960, 864, 128, 64)) == set()  # one of them is not named
    assert sides.named_near(PixelWindow(500, 64, 64, 64)) == set()
