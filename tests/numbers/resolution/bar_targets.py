"""Bar targets as a camera with a known blur would see them, and what theory says about them.

None of it uses the code under test: bars are the integrals of a Gaussian, pixels their means over a square.
"""
from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from scipy.optimize import brentq
from scipy.special import ndtr

STEP = 2 ** (1 / 6)
DARK, BRIGHT = 40.0, 200.0  # DN of the ground and the gaps, and of the bars

Ends = tuple[float, float, float, float]  # column and row of both ends of a line


@dataclass(frozen=True)
class Bars:
    """A group of bars; what lies across them is at ``angle``."""

    x: float  # column of the middle
    y: float  # row of the middle
    cycle: float  # width of a bar and a gap together, px
    length: float  # length of the bars, px
    angle: float = 0.0  # from the direction of the columns to the rows, radians
    count: int = 3

    def line(self, half: float = 1.6, turned: float = 0.0, aside: float = 0.0) -> Ends:
        """A line across the bars: half its length in cycles, its error in radians, and how far it lies beside, px."""
        c, s = math.cos(self.angle + turned), math.sin(self.angle + turned)
        x, y = self.x - aside * math.sin(self.angle), self.y + aside * math.cos(self.angle)
        reach = half * self.cycle * (self.count - 0.5) / 2.5
        return x - reach * c, y - reach * s, x + reach * c, y + reach * s


def coverage(shape: tuple[int, int], groups: list[Bars], sigma: float = 0.0, oversampling: int = 4) -> np.ndarray:
    """(rows, columns) how much of each pixel is bar, 0 to 1, behind a Gaussian blur of ``sigma`` px."""
    rows, columns = shape
    parts = (np.arange(oversampling) + 0.5) / oversampling
    made = np.zeros(shape)
    for bars in groups:
        reach = math.ceil(math.hypot(bars.cycle * (bars.count - 0.5), bars.length) / 2 + 4.5 * sigma + 1)
        left, right = max(0, int(bars.x) - reach), min(columns, int(bars.x) + reach)
        top, bottom = max(0, int(bars.y) - reach), min(rows, int(bars.y) + reach)
        dx = (np.arange(left, right)[:, np.newaxis] + parts).ravel() - bars.x
        dy = ((np.arange(top, bottom)[:, np.newaxis] + parts).ravel() - bars.y)[:, np.newaxis]
        c, s = math.cos(bars.angle), math.sin(bars.angle)
        across, along = dx * c + dy * s, dy * c - dx * s
        middles = (np.arange(bars.count) - (bars.count - 1) / 2) * bars.cycle
        seen = sum(blurred_box(across - middle, bars.cycle / 2, sigma) for middle in middles)
        seen = seen * blurred_box(along, bars.length, sigma)
        pixels = seen.reshape(bottom - top, oversampling, right - left, oversampling).mean(axis=(1, 3))
        made[top:bottom, left:right] += pixels
    return made


def blurred_box(places: np.ndarray, width: float, sigma: float) -> np.ndarray:
    """A box of height 1 around 0 behind a Gaussian blur."""
    if sigma == 0:
        return (np.abs(places) < width / 2).astype(float)
    return np.asarray(ndtr((places + width / 2) / sigma) - ndtr((places - width / 2) / sigma))


def image(
    shape: tuple[int, int], groups: list[Bars], sigma: float = 0.0, noise: float = 0.0, seed: int = 0
) -> np.ndarray:
    """(rows, columns) uint8 of bright bars on dark ground."""
    seen = DARK + (BRIGHT - DARK) * coverage(shape, groups, sigma)
    seen += np.random.default_rng(seed).normal(0, noise, shape)
    return np.clip(np.rint(seen), 0, 255).astype(np.uint8)


def theoretical_share(cycle: float, sigma: float) -> float:
    """The smallest difference of one of three bars to a gap beside it, over brightest bar less ground.

    In one dimension, without noise, at every phase: what the pixels' own size blurs is included.
    """
    places = np.linspace(-2.2 * cycle, 2.2 * cycle, 2201)
    pixel = (np.arange(15) + 0.5) / 15 - 0.5
    seen = sum(blurred_box(places[:, np.newaxis] + pixel - k * cycle, cycle / 2, sigma) for k in (-1, 0, 1))
    profile = np.asarray(seen).mean(axis=1)
    bars = [profile[np.abs(places - k * cycle) < 0.3 * cycle].max() for k in (-1, 0, 1)]
    gaps = [profile[np.abs(places - k * cycle) < 0.2 * cycle].min() for k in (-0.5, 0.5)]
    return float((min(bars) - max(gaps)) / (max(bars) - profile.min()))


def theoretical_cycle(sigma: float, criterion: float = 0.5) -> float:
    """px of a bar and a gap at which the bars' modulation crosses the criterion."""
    return float(brentq(lambda cycle: theoretical_share(cycle, sigma) - criterion, 1.0, 12 * sigma + 4, xtol=1e-3))


def row_of_groups(cycles: list[float], angle: float, random: np.random.Generator) -> tuple[tuple[int, int], list[Bars]]:
    """Groups beside each other, each at a place of its own on the pixel grid, and the shape of their image."""
    x, groups = 20.0, []
    for cycle in cycles:
        x += 1.25 * cycle + 8
        dx, dy = random.uniform(-0.5, 0.5, 2)
        groups.append(Bars(x + dx, 40 + dy, cycle, max(2.5 * cycle, 9.0), angle))
        x += 1.25 * cycle + 8
    return (80, int(x) + 20), groups
