"""The village of the demonstration scene: plots along the roads with houses, sheds, hedges, gardens and cars."""
from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from .canvas import Canvas, Curve, Extent, Patch, patch_at
from .trees import crown, stamp_tree, trees

ROOFS = ((0.62, 0.38, 0.31), (0.56, 0.34, 0.28), (0.48, 0.45, 0.44), (0.37, 0.37, 0.39), (0.53, 0.42, 0.35),
         (0.68, 0.46, 0.37))
CARS = ((0.85, 0.85, 0.86), (0.22, 0.23, 0.26), (0.62, 0.16, 0.15), (0.25, 0.36, 0.55), (0.58, 0.60, 0.62))


@dataclass(frozen=True)
class Plot:
    """A plot of land: its middle, the direction from the road into it and half its sides."""

    x: float
    y: float
    angle: float
    half_u: float
    half_v: float


def draw_objects(canvas: Canvas, extent_m: Extent, main_road: Curve, side_road: Curve,
                 rng: np.random.Generator) -> None:
    """Plots along both roads, then trees, bushes and cars."""
    width, depth = extent_m
    crowns = [crown(rng) for _ in range(14)]
    for plot in plots(extent_m, main_road, side_road, rng):
        draw_plot(canvas, plot, crowns, rng)
    for x, y, radius in trees(extent_m, main_road, side_road, rng):
        stamp_tree(canvas, x, y, radius, crowns[rng.integers(len(crowns))], rng)
    # One car to a place, so that none stands in another.
    for place in rng.permutation(int(depth / 9))[:int(depth / 25)]:
        y = 9.0 * place + rng.uniform(0, 3)
        slope = float(main_road(np.float64(y + 1)) - main_road(np.float64(y)))
        x = float(main_road(np.float64(y))) + rng.choice((-1.7, 1.7))
        draw_car(canvas, x, y, np.pi / 2 - slope, rng)
    for place in rng.permutation(int(width / 9))[:int(width / 25)]:
        x = 9.0 * place + rng.uniform(0, 3)
        draw_car(canvas, x, float(side_road(np.float64(x))) + rng.choice((-1.5, 1.5)), 0.0, rng)


def plots(extent_m: Extent, main_road: Curve, side_road: Curve,
          rng: np.random.Generator) -> list[Plot]:
    """Plots of unequal size on both sides of both roads, none on the crossing, some left empty."""
    width, depth = extent_m
    found = []
    for side in (-1, 1):
        for middle, half in frontages(depth, rng, 0.86):
            if abs(middle - 0.49 * depth) > 18 + half:
                deep = rng.uniform(13.0, 18.0)
                x = float(main_road(np.float64(middle))) + side * (6.6 + deep)
                found.append(Plot(x, middle, 0.0 if side > 0 else np.pi, deep, half))
        for middle, half in frontages(width, rng, 0.74):
            if abs(middle - 0.32 * width) > 36 + half:
                deep = rng.uniform(13.0, 18.0)
                y = float(side_road(np.float64(middle))) + side * (6.1 + deep)
                found.append(Plot(middle, y, side * np.pi / 2, deep, half))
    return found


def frontages(length: float, rng: np.random.Generator, share: float) -> list[tuple[float, float]]:
    """Middles and half widths of plots along a road of a given length; `share` of them is built up."""
    found, start = [], rng.uniform(0, 6)
    while start < length:
        half = rng.uniform(9.4, 13.0)
        if rng.random() < share:
            found.append((start + half, half))
        start += 2 * half + rng.choice((0.4, 0.4, 3.0))
    return found


def draw_plot(canvas: Canvas, plot: Plot, crowns: list[np.ndarray], rng: np.random.Generator) -> None:
    """Lawn, drive, house, shed, vegetable beds and a hedge around; u runs from the road into the plot."""
    angle = plot.angle + rng.normal(0, 0.02)
    half_u, half_v = plot.half_u, plot.half_v
    land = patch_at(canvas, plot.x, plot.y, angle, half_u + half_v)
    if 0 in land.height.shape:
        return
    lawn = land.box(half_u, half_v)
    mown = 1 + 0.11 * land.grain + 0.05 * land.patches + 0.03 * np.sign(np.cos(2 * np.pi * land.v / 1.1))
    land.paint(lawn, np.array((0.43, 0.50, 0.32)) * rng.normal(1, 0.06) + (rng.normal(0, 0.02), 0, 0), mown)
    land.raise_to(lawn, 0.016 * land.grain)
    sign = rng.choice((-1, 1))
    drive_v = sign * (half_v - 3.0)
    setts = 1 - 0.18 * np.maximum(np.cos(2 * np.pi * land.u / 0.4) > 0.75, np.cos(2 * np.pi * land.v / 0.4) > 0.75)
    drive = np.maximum(land.box(half_u / 2 + 2, 1.6, 2 - half_u / 2, drive_v), land.box(2.4, 5.5, -0.6, 0.0))
    stone = rng.choice(((0.62, 0.58, 0.54), (0.55, 0.52, 0.52), (0.60, 0.52, 0.47)))
    land.paint(drive, stone, setts + 0.05 * land.grain)
    land.raise_to(drive, 0.03)
    beds = land.box(rng.uniform(2, 4), rng.uniform(2, 4.5), half_u - 5, -sign * (half_v - 5.5))
    rows = np.cos(2 * np.pi * land.u / 0.7) * np.cos(2 * np.pi * land.v / 0.5) + 0.25 * land.grain
    leaf = beds * np.clip(rows * 3 - 0.3, 0, 1)
    land.paint(beds, (0.47, 0.39, 0.32), 1 + 0.08 * land.grain)
    land.paint(leaf, (0.41, 0.54, 0.30))
    land.raise_to(leaf, 0.2)
    draw_fence(land, half_u, half_v, drive_v, rng)

    def place(u: float, v: float) -> tuple[float, float]:
        return plot.x + u * np.cos(angle) - v * np.sin(angle), plot.y + u * np.sin(angle) + v * np.cos(angle)

    house = place(8.6 - half_u + rng.uniform(0, 2.5), -sign * rng.uniform(0.8, 2.0))
    draw_house(canvas, *house, angle + rng.choice((0.0, np.pi / 2)), rng)
    if rng.random() < 0.75:
        draw_shed(canvas, *place(half_u - rng.uniform(5, 9), drive_v * 0.92), angle, rng)
    if rng.random() < 0.6:
        draw_car(canvas, *place(rng.uniform(3, 7) - half_u, drive_v), angle, rng)
    for _ in range(rng.integers(2, 9)):
        u, v = rng.uniform(2.5, half_u - 1.2), rng.uniform(1.2 - half_v, half_v - 1.2)
        stamp_tree(canvas, *place(u, v), rng.uniform(0.5, 2.6), crowns[rng.integers(len(crowns))], rng)


def draw_fence(land: Patch, half_u: float, half_v: float, drive_v: float, rng: np.random.Generator) -> None:
    """A clipped hedge or a fence on the plot's border, open at the drive."""
    border = np.abs(np.maximum(np.abs(land.u) - half_u, np.abs(land.v) - half_v))
    closed = (land.u > 1.5 - half_u) | (np.abs(land.v - drive_v) > 2.2)
    if rng.random() < 0.45:
        hedge = land.cover(border - 0.38 - 0.08 * land.grain) * closed
        land.paint(hedge, (0.30, 0.38, 0.22), 1 + 0.16 * land.grain)
        land.raise_to(hedge, 1.2 + 0.16 * land.grain)
    else:
        fence = land.cover(border - 0.06) * closed
        land.paint(fence, (0.55, 0.53, 0.50))
        land.raise_to(fence, 0.8)


def draw_house(canvas: Canvas, x: float, y: float, angle: float, rng: np.random.Generator) -> None:
    """A gable or hipped roof of tiles with its ridge, chimneys and skylights; some are flat with vents."""
    half_u, half_v = rng.uniform(5.0, 6.8), rng.uniform(3.9, 5.0)
    house = patch_at(canvas, x, y, angle, 9.5)
    if 0 in house.height.shape:
        return
    colour = np.array(ROOFS[rng.integers(len(ROOFS))]) * rng.normal(1, 0.05)
    roof = house.box(half_u, half_v)
    kind = rng.choice(("gable", "gable", "hip", "flat"))
    if kind == "flat":
        rim = roof * (1 - house.box(half_u - 0.35, half_v - 0.35))
        felt = 1 + 0.08 * house.grain - 0.15 * (np.abs(house.u % 1.0 - 0.5) < 0.04)
        house.paint(roof, (0.58, 0.57, 0.56), felt)
        house.paint(rim, (0.72, 0.71, 0.70))
        house.raise_to(roof, 6.0)
        house.raise_to(rim, 6.4)
        top = 6.0
    else:
        inward = half_v - np.abs(house.v)
        if kind == "hip":
            inward = np.minimum(inward, half_u - np.abs(house.u))
        course = (inward % 0.42) / 0.42
        tile = np.cos(2 * np.pi * house.u / 0.36)
        worn = 1 + 0.09 * house.grain - 0.26 * (course < 0.28) + 0.06 * tile
        house.paint(roof, colour, worn)
        house.raise_to(roof, 4.2 + 0.75 * inward + 0.02 * course)
        ridge = house.box(half_u if kind == "gable" else half_u - half_v, 0.14)
        house.paint(ridge, np.minimum(colour * 1.18, 0.9))
        top = 4.2 + 0.75 * half_v
        for _ in range(rng.integers(0, 4)):
            pane = house.box(0.55, 0.35, rng.uniform(-0.7, 0.7) * half_u, rng.choice((-0.5, 0.5)) * half_v)
            house.paint(pane, (0.32, 0.36, 0.42))
        if rng.random() < 0.3:
            panels = house.box(0.62 * half_u, 0.3 * half_v, 0.0, 0.52 * half_v)
            lines = np.maximum(np.abs(house.u % 1.0 - 0.5) < 0.05, np.abs(house.v % 1.6 - 0.8) < 0.05)
            house.paint(panels, (0.17, 0.20, 0.30), 1 + 1.3 * lines)
    gutter = roof * (1 - house.box(half_u - 0.12, half_v - 0.12))
    house.paint(gutter, (0.40, 0.38, 0.37))
    for _ in range(rng.integers(1, 3)):
        chimney = house.box(0.38, 0.3, rng.uniform(-0.6, 0.6) * half_u, rng.uniform(-0.3, 0.3) * half_v)
        house.paint(chimney, (0.62, 0.47, 0.40))
        house.raise_to(chimney, top + 0.9)


def draw_shed(canvas: Canvas, x: float, y: float, angle: float, rng: np.random.Generator) -> None:
    """A garage or a greenhouse with ribs."""
    shed = patch_at(canvas, x, y, angle, 5.5)
    if 0 in shed.height.shape:
        return
    half_u = rng.uniform(2.4, 3.6)
    roof = shed.box(half_u, 1.7)
    glass = rng.random() < 0.3
    ribs = np.cos(2 * np.pi * shed.u / (0.9 if glass else 0.5)) > 0.7
    shed.paint(roof, (0.74, 0.78, 0.78) if glass else (0.57, 0.56, 0.56), 1 - 0.2 * ribs + 0.05 * shed.grain)
    shed.raise_to(roof, 2.6 + 0.25 * (1.7 - np.abs(shed.v)))


def draw_car(canvas: Canvas, x: float, y: float, angle: float, rng: np.random.Generator) -> None:
    """A parked or driving car with its windows."""
    car = patch_at(canvas, x, y, angle, 3.0)
    if 0 in car.height.shape:
        return
    body = car.cover(np.maximum(np.abs(car.u) - 2.15, np.abs(car.v) - 0.88) + 0.25 * (car.u / 2.3) ** 4)
    colour = CARS[rng.integers(len(CARS))]
    car.paint(body, colour)
    cabin = car.box(1.25, 0.74, -0.25)
    car.paint(cabin, (0.16, 0.18, 0.21))
    car.paint(car.box(0.75, 0.66, -0.3), colour)
    car.raise_to(body, 0.85)
    car.raise_to(cabin, 1.4)
