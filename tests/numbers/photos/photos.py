"""Scanned photographs made for tests: frames with marks at places that are known, drawn without the product's code."""
from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, field

import numpy as np
from scipy import ndimage

from tests.numbers.synthetic import texture

Place = tuple[float, float]

SAMPLES = 7  # per pixel and axis
CAMERA: dict[str, Place] = {
    "1": (106.004, -106.002), "2": (-105.998, -105.998), "3": (-106.007, 106.006), "4": (106.0, 105.999)
}
"""mm, x to the right, y upwards; corners as a Wild camera has them."""
EIGHT = {**CAMERA, "5": (110.0, 0.01), "6": (-110.0, -0.02), "7": (0.01, 110.0), "8": (0.0, -110.0)}
"""That camera with marks at its sides, too."""


@dataclass(frozen=True)
class Look:
    """How a mark and the film around it look. Lengths in pixels."""

    kind: str = "ring with cross"
    size: float = 30.0
    width: float = 3.5
    diagonal: bool = False
    interrupted: bool = False
    reach: float = 1.0
    blur: float = 0.8
    contrast: float = 60.0  # grey values from the ground to the mark
    grain: float = 0.03  # standard deviation of the noise as a share of the contrast
    gradient: float = 0.0  # grey values that the ground changes by across a mark, as a share of the contrast
    scratches: int = 0  # around each mark
    negative: bool = False
    dots: bool = False  # dots to the mark's right, as many as its number


@dataclass(frozen=True)
class Frame:
    """A photo and the truth about it."""

    pixels: np.ndarray  # (rows, columns) uint8
    places: Mapping[str, Place] = field(default_factory=dict)  # column and row of each mark, pixel centres at .5
    scale: float = 1.0  # pixels per mm


def figure(look: Look, u: np.ndarray, v: np.ndarray, inwards: float = 0.0) -> np.ndarray:
    """Whether points (px from the mark's centre) belong to the mark; ``inwards`` is the direction of the wedges."""
    r = np.hypot(u, v)
    if look.diagonal and look.kind != "wedge":
        u, v = (u + v) / math.sqrt(2), (v - u) / math.sqrt(2)
    half, line = look.size / 2, look.width / 2
    ring = np.abs(r - half) <= line
    length = half if look.kind == "cross" else half * look.reach
    arms = ((np.abs(u) <= line) & (np.abs(v) <= length)) | ((np.abs(v) <= line) & (np.abs(u) <= length))
    if look.interrupted:
        arms &= np.maximum(np.abs(u), np.abs(v)) > 0.15 * look.size
    if look.kind == "cross":
        return arms
    if look.kind == "dot":
        return r <= half
    if look.kind == "ring with dot":
        return ring | (r <= look.width)
    if look.kind == "ring with cross":
        return ring | arms
    along = u * math.cos(inwards) + v * math.sin(inwards)
    across = np.abs(v * math.cos(inwards) - u * math.sin(inwards))
    return (np.abs(along) <= half) & (across <= np.abs(along) * math.tan(math.radians(30)))


def make_frame(
    look: Look,
    camera: Mapping[str, Place] | None = None,
    side: int = 800,
    share: float = 0.86,
    rotation: float = 0.0,
    offset: Place = (0.0, 0.0),
    seed: int = 0,
) -> Frame:
    """A scan of a photo: a picture, dark corners with a mark each, grain, and what else the look says."""
    camera = camera or CAMERA
    random = np.random.default_rng(seed)
    points = np.array(list(camera.values()))
    span = float(np.ptp(points, axis=0).max())
    scale = share * side / span
    turn = math.radians(rotation)
    spin = np.array([[math.cos(turn), -math.sin(turn)], [math.sin(turn), math.cos(turn)]])
    centre = np.array([side / 2 + offset[0], side / 2 + offset[1]])
    middle = (points.min(axis=0) + points.max(axis=0)) / 2
    places = centre + scale * ((points - middle) * [1, -1]) @ spin.T
    picture = 120 + 40 * texture((side, side), 1.8, seed)
    y, x = np.mgrid[0.5:side, 0.5:side]
    ground = np.minimum.reduce([np.hypot(x - px, y - py) for px, py in places])
    inside = np.clip((ground - 1.9 * look.size * max(look.reach, 1)) / 3, 0, 1)
    dark = 40.0
    made = dark + inside * (picture - dark)
    for (name, _), (px, py) in zip(camera.items(), places):
        inwards = math.atan2(centre[1] - py, centre[0] - px)
        step = math.radians(45 if look.diagonal else 90)
        inwards = turn + step * round((inwards - turn) / step)
        _add_mark(made, look, (px, py), spin, inwards, int(name) if look.dots else 0, random)
    for px, py in places:
        for _ in range(look.scratches):
            _scratch(made, px, py, look, random)
    made = ndimage.gaussian_filter(made, look.blur)
    noise = ndimage.gaussian_filter(random.standard_normal(made.shape), 0.5)
    made += look.grain * look.contrast * noise / noise.std()
    made = np.clip(np.rint(255 - made if look.negative else made), 0, 255).astype(np.uint8)
    return Frame(made, {name: (float(px), float(py)) for name, (px, py) in zip(camera, places)}, scale)


def _add_mark(
    made: np.ndarray, look: Look, place: Place, spin: np.ndarray, inwards: float, dots: int, random: np.random.Generator
) -> None:
    half = int(look.size * 1.5 * max(look.reach, 1)) + 4
    left, top = int(place[0]) - half, int(place[1]) - half
    fine = (np.arange((2 * half + 1) * SAMPLES) + 0.5) / SAMPLES
    u, v = np.meshgrid(fine + left - place[0], fine + top - place[1])
    u, v = spin[0, 0] * u + spin[1, 0] * v, spin[0, 1] * u + spin[1, 1] * v
    angle = inwards - math.atan2(spin[1, 0], spin[0, 0])
    covered = figure(look, u, v, angle)
    for k in range(dots):
        covered |= np.hypot(u - 0.85 * look.size, v - (k - (dots - 1) / 2) * 0.15 * look.size) <= 0.045 * look.size
    share = covered.reshape(2 * half + 1, SAMPLES, 2 * half + 1, SAMPLES).mean(axis=(1, 3))
    rows = slice(max(top, 0), min(top + 2 * half + 1, made.shape[0]))
    columns = slice(max(left, 0), min(left + 2 * half + 1, made.shape[1]))
    inside = share[rows.start - top : rows.stop - top, columns.start - left : columns.stop - left]
    across = np.arange(columns.start, columns.stop) + 0.5 - place[0]
    slope = look.gradient * look.contrast * across / look.size * random.choice([-1, 1])
    away = np.hypot(across[np.newaxis], np.arange(rows.start, rows.stop)[:, np.newaxis] + 0.5 - place[1])
    near = np.clip(4 - 4 * away / half, 0, 1)
    made[rows, columns] += inside * look.contrast + near * slope[np.newaxis]


def _scratch(made: np.ndarray, px: float, py: float, look: Look, random: np.random.Generator) -> None:
    """A bright hair-line somewhere across or beside a mark."""
    angle, away = random.uniform(0, math.pi), random.normal(0, 0.6 * look.size)
    y, x = np.mgrid[0.5 : made.shape[0], 0.5 : made.shape[1]]
    distance = np.abs((x - px) * math.sin(angle) - (y - py) * math.cos(angle) - away)
    along = np.abs((x - px) * math.cos(angle) + (y - py) * math.sin(angle) - random.normal(0, look.size))
    made += 0.8 * look.contrast * np.clip(1.1 - distance, 0, 1) * (along < random.uniform(0.5, 2) * look.size)
