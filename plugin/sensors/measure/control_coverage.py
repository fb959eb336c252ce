"""How control points lie in an image, and what of it they leave to extrapolation."""
from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ...imagery.message import Message
from . import messages

MIN_SPREAD = 0.05  # of their shorter extent to the longer one: narrower ones lie on a line
MAX_EXTRAPOLATED = 0.5  # share of the image outside the control points' outline

ImageBox = tuple[float, float, float, float]
"""First column, first row, last column, last row."""


@dataclass(frozen=True)
class ControlCoverage:
    """What part of an image control points cover."""

    extrapolated: float
    """Share of the image outside the points' outline."""
    spread: float
    """Their shorter extent over the longer one: near 0 on a line."""
    outline: np.ndarray
    """(k, 2) corners of the points' convex hull, px."""


def control_coverage(control: np.ndarray, image: ImageBox) -> ControlCoverage:
    """What part of an image (n, 2) control points cover."""
    outline = convex_hull(control)
    area = (image[2] - image[0]) * (image[3] - image[1])
    within = _area(_clipped(outline, image))  # points may be measured a little beyond the image
    singular = np.linalg.svd(control - control.mean(axis=0), compute_uv=False)
    spread = float(singular[1] / singular[0]) if len(singular) > 1 and singular[0] > 0 else 0.0
    return ControlCoverage(float(np.clip(1 - within / area, 0, 1)) if area > 0 else 1.0, spread, outline)


def coverage_warnings(coverage: ControlCoverage) -> list[Message]:
    """What is to be said of points that cover too little."""
    if coverage.spread < MIN_SPREAD:
        return [messages.CONTROL_ON_A_LINE(share=coverage.extrapolated)]
    if coverage.extrapolated > MAX_EXTRAPOLATED:
        return [messages.CONTROL_IN_A_CORNER(share=coverage.extrapolated)]
    return []


def convex_hull(points: np.ndarray) -> np.ndarray:
    """(k, 2) corners of the convex hull of (n, 2) points, in order (Andrew's monotone chain)."""
    ordered = sorted(set(map(tuple, points.tolist())))
    if len(ordered) < 3:
        return np.array(ordered)
    chains = []
    for row in (ordered, ordered[::-1]):
        chain: list[tuple[float, ...]] = []
        for point in row:
            while len(chain) > 1 and _turn(chain[-2], chain[-1], point) <= 0:
                chain.pop()
            chain.append(point)
        chains += chain[:-1]
    return np.array(chains)


def _clipped(corners: np.ndarray, box: ImageBox) -> np.ndarray:
    """(k, 2) corners of what of a convex outline lies in a box (Sutherland and Hodgman)."""
    for axis, limit, sign in ((0, box[0], 1), (1, box[1], 1), (0, box[2], -1), (1, box[3], -1)):
        kept: list[np.ndarray] = []
        inner = sign * (corners[:, axis] - limit) if len(corners) else np.zeros(0)
        for number in range(len(corners)):
            here, there = inner[number - 1], inner[number]
            if (here < 0) != (there < 0):
                kept.append(corners[number - 1] + here / (here - there) * (corners[number] - corners[number - 1]))
            if there >= 0:
                kept.append(corners[number])
        corners = np.array(kept).reshape(-1, 2)
    return corners


def _turn(a: tuple[float, ...], b: tuple[float, ...], c: tuple[float, ...]) -> float:
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])


def _area(corners: np.ndarray) -> float:
    if len(corners) < 3:
        return 0.0
    x, y = corners.T
    return float(abs(x @ np.roll(y, 1) - y @ np.roll(x, 1)) / 2)
