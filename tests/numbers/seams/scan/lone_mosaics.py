"""Made-up mosaics with known seams, of which nothing is given but the seam lines."""
from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from scipy import ndimage
from seam_inspector.plugin.imagery.grids import Grid, PixelWindow
from seam_inspector.plugin.imagery.rasters import Raster, RasterRef
from seam_inspector.plugin.seams.measure.compared_image import ComparedImage
from seam_inspector.plugin.seams.measure.scan.lone_kept import LoneSeams
from seam_inspector.plugin.seams.measure.scan.lone_stretches import LoneTable, lone_cells, lone_stretches
from seam_inspector.plugin.seams.measure.seamlines.seam_pieces import PieceIndex, SeamPiece, cut_in_pieces

from tests.numbers.synthetic import luminance, texture

WAVELET = "coif3"
SHAPE = (2048, 768)
SEAM_COLUMN = SHAPE[1] / 2
SEAM_SHAPE_PX = 40  # how far the seam swings to either side


@dataclass(frozen=True, eq=False)
class LoneMosaic:
    """Planes (rows, columns) float32 of two sources and the seam between them."""

    first: np.ndarray
    second: np.ndarray
    distance: np.ndarray  # from the seam, positive on the second source's side, px
    pieces: tuple[SeamPiece, ...]
    grid: Grid

    def blended(self, width_px: float) -> np.ndarray:
        """Linear over a full width, 0 for a hard cut."""
        share = np.clip(self.distance / width_px + 0.5, 0, 1) if width_px else self.distance > 0
        return np.asarray(self.first * (1 - share) + self.second * share, np.float32)

    def seams(self, plane: np.ndarray, bands: np.ndarray | None = None, valid: np.ndarray | None = None) -> LoneSeams:
        """What is measured of a mosaic made of it."""
        return seams_of(plane, self.pieces, self.grid, bands, valid)


def table_of(
    plane: np.ndarray, pieces: Sequence[SeamPiece], grid: Grid, bands: np.ndarray | None = None,
    valid: np.ndarray | None = None,
) -> LoneTable:
    """The cells of a mosaic in one window; without ``bands`` it has three that are alike."""
    window = PixelWindow(0, 0, grid.columns, grid.rows)
    bands = np.stack([plane] * 3) if bands is None else bands
    return lone_cells(image_of(plane, bands, valid), window, window, PieceIndex(pieces, grid), WAVELET)


def image_of(plane: np.ndarray, bands: np.ndarray, valid: np.ndarray | None = None) -> ComparedImage:
    """Pixels of a mosaic in the band that is judged, and its bands."""
    rows, columns = plane.shape
    raster = Raster(RasterRef("mosaic.tif"), columns, rows, None, "", ("band_1",), "float32")
    return ComparedImage(bands, raster.band_names, {}, {}, raster, valid=valid, judged=plane)


def seams_of(
    plane: np.ndarray, pieces: Sequence[SeamPiece], grid: Grid, bands: np.ndarray | None = None,
    valid: np.ndarray | None = None,
) -> LoneSeams:
    table = table_of(plane, pieces, grid, bands, valid)
    stretches = lone_stretches(table, pieces, range(len(pieces)), PieceIndex(pieces, grid), grid.ground_sample_distance)
    return LoneSeams(stretches, [piece.seam_id for piece in pieces])


def lone_mosaic(
    piece_px: float = 256.0, seed: int = 0, in_common: float = 0.0, rows: int = SHAPE[0],
    uneven: float = 0.6,
) -> LoneMosaic:
    """Ground whose contrast changes from place to place; ``in_common``: share of variance that both sources show."""
    shape = rows, SHAPE[1]
    contrast = 12 * np.exp(uneven * ndimage.gaussian_filter(texture(shape, 3.0, seed), 12, mode="wrap"))
    ground, first_detail, other = (texture(shape, 1.2, seed + number) for number in (1, 2, 3))
    first, second = (
        np.asarray(120 + contrast * (in_common**0.5 * ground + (1 - in_common) ** 0.5 * detail), np.float32)
        for detail in (first_detail, other)
    )
    row = np.arange(rows)
    border = SEAM_COLUMN + SEAM_SHAPE_PX * np.sin(row / 150 + seed)
    across = np.arange(SHAPE[1]) + 0.5 - border[:, np.newaxis]
    distance = across / np.hypot(1, np.gradient(border))[:, np.newaxis]
    return LoneMosaic(first, second, distance, *pieces_along(border, shape, piece_px))


def pieces_along(border: np.ndarray, shape: tuple[int, int], piece_px: float) -> tuple[tuple[SeamPiece, ...], Grid]:
    """A line from top to bottom by its column in each row, in pieces, on a grid of 1 m."""
    rows, columns = shape
    grid = Grid(0.0, float(rows), 1.0, 1.0, columns, rows)
    vertices = np.column_stack([border, rows - np.arange(rows) - 0.5])[::4]
    return tuple(cut_in_pieces([Line(vertices)], piece_px, grid)), grid


@dataclass(frozen=True, eq=False)
class Line:
    """A seam without names on its sides."""

    vertices: np.ndarray
    left: None = None
    right: None = None


def brightness(bands: np.ndarray) -> np.ndarray:
    """The plane that is measured of three bands, float32."""
    return np.asarray(luminance(bands), np.float32)
