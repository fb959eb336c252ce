"""Mosaics of made-up sources over a known seam, and how much they truly keep, by PyWavelets."""
from __future__ import annotations

from dataclasses import dataclass, replace
from functools import lru_cache

import numpy as np
from scipy import ndimage
from seam_inspector.plugin.seams.measure.following.expected_mosaic import ExpectedMosaic
from seam_inspector.plugin.seams.measure.profile.cell_table import EDGES_PX, Rows
from seam_inspector.plugin.seams.measure.profile.seam_profile import STRIP_PX, SeamProfile
from seam_inspector.plugin.seams.measure.profile.window_detail import WindowDetail, window_detail

from tests.numbers.synthetic import placed_wavedec, texture

WAVELET, LEVELS, SIDE = "coif3", 3, 512


@dataclass(frozen=True, eq=False)
class Blend:
    """Planes (rows, columns) float64."""

    planes: tuple[np.ndarray, ...]  # the sources
    weights: np.ndarray  # weights of each of them in the mosaic, (sources, rows, columns), together 1
    labels: np.ndarray
    distance: np.ndarray  # from the nearest seam, px

    @property
    def hard(self) -> np.ndarray:
        """The hard cut."""
        return np.choose(self.labels, self.planes)

    @property
    def made(self) -> np.ndarray:
        """The mosaic."""
        return np.asarray(np.einsum("kij,kij->ij", self.weights, np.stack(self.planes)))

    def detail(
        self, mosaic: np.ndarray | None = None, labels: np.ndarray | None = None,
        inside: tuple[slice, slice] | None = None,
    ) -> WindowDetail:
        """Detail of the mosaic against its sources, or of another mosaic or by other labels."""
        made = self.made if mosaic is None else mosaic
        labels = self.labels if labels is None else labels
        hard = np.where(labels < len(self.planes), np.choose(labels % len(self.planes), self.planes), made)
        hard = hard.astype(np.float32)
        shown = {i: plane.astype(np.float32) for i, plane in enumerate(self.planes) if (labels == i).any()}
        expected = ExpectedMosaic(hard, hard, labels, shown, shown)
        detail = window_detail(made.astype(np.float32), expected, WAVELET, LEVELS)
        return detail if inside is None else detail.judged_inside(*inside)

    def profile(self, mosaic: np.ndarray | None = None) -> SeamProfile:
        """Profile of the whole window."""
        measured = self.detail(mosaic).profile
        assert measured is not None
        return measured

    def truth(self, near: float = 0, far: float = STRIP_PX, level: int = 1) -> float:
        """Energy of the sources' details mixed as the mosaic mixes them, over that of the source that is followed,
        between two distances: by ``pywt.wavedec2`` of each source, never of a cut image."""
        details = np.stack([np.stack(placed_wavedec(plane, WAVELET, level)[1]) for plane in self.planes])
        side = 2**level
        middle = (..., slice(side // 2, None, side), slice(side // 2, None, side))
        weights, labels, distance = self.weights[middle], self.labels[middle], self.distance[middle]
        mixed = np.einsum("kij,kdij->dij", weights, details)
        followed = np.take_along_axis(details, np.broadcast_to(labels, (1, 3, *labels.shape)).astype(np.intp), 0)[0]
        where = (distance >= near) & (distance < far)
        return float(np.square(mixed[:, where]).sum() / np.square(followed[:, where]).sum())

    def with_mosaic_of(self, weights: np.ndarray) -> Blend:
        """A blend of its sources mixed otherwise; ``weights`` of the second one, (rows, columns)."""
        return replace(self, weights=np.stack([1 - weights, weights]))


@lru_cache(maxsize=8)
def sources(
    side: int = SIDE, seed: int = 0, in_common: float = 0.0, other_years: float = 0.0
) -> tuple[np.ndarray, ...]:
    """Three planes of ground that changes from place to place; ``in_common``: the share of variance that all show."""
    contrast = 14 * np.exp(0.5 * ndimage.gaussian_filter(texture((side, side), 3.0, seed + 77), 12, mode="wrap"))
    ground = texture((side, side), 1.2, seed + 100)
    return tuple(
        120 + contrast * (in_common**0.5 * ground + (1 - in_common) ** 0.5 * texture((side, side), 1.2, seed + i))
        + other_years * texture((side, side), 5.0, seed + 200 + i)
        for i in range(3)
    )


def crooked(side: int = SIDE, seed: int = 0, count: int = 2) -> np.ndarray:
    """Labels of sources that meet along a crooked line, a third of them below another."""
    row, column = np.mgrid[:side, :side]
    phase = np.random.default_rng(seed).uniform(0, 6, 2)
    labels = (column > side / 2 + 0.06 * side * np.sin(row / 40 + phase[0])).astype(np.uint8)
    if count == 3:
        labels[(labels == 1) & (row > side / 2 + 0.05 * side * np.cos(column / 30 + phase[1]))] = 2
    return labels


def blend(
    width_px: float, ramp: str = "cosine", side: int = SIDE, seed: int = 0, count: int = 2, in_common: float = 0.0,
    other_years: float = 0.0,
) -> Blend:
    """Feathered over a full width, 0 for a hard cut."""
    labels, planes = crooked(side, seed, count), sources(side, seed, in_common, other_years)[:count]
    depths = np.stack([_depth(labels == i) for i in range(count)])
    distance = np.abs(depths).min(axis=0)
    if not width_px:
        return Blend(planes, np.stack([labels == i for i in range(count)]).astype(float), labels, distance)
    parts = np.clip(depths / width_px + 0.5, 0, 1)
    if ramp == "cosine":
        parts = 0.5 - 0.5 * np.cos(np.pi * parts)
    return Blend(planes, parts / parts.sum(axis=0), labels, distance)


def spread(table: Rows, values: np.ndarray, side: int | tuple[int, int]) -> np.ndarray:
    """What a table says by bin and cell, (..., bins, rows, columns); ``values`` (..., rows of the table)."""
    rows, columns = (side, side) if isinstance(side, int) else side
    sums = np.zeros((*values.shape[:-1], len(EDGES_PX), rows, columns))
    np.add.at(sums, (..., table.bin, table.row, table.column), values)
    return sums


def _depth(inside: np.ndarray) -> np.ndarray:
    """Distance from the border, positive inside, px."""
    inner, outer = ndimage.distance_transform_edt(inside), ndimage.distance_transform_edt(~inside)
    return np.asarray(np.where(inside, inner - 0.5, 0.5 - outer))
