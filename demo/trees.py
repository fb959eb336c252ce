"""Trees of the demonstration scene: crowns made of boughs, and where they stand."""
from __future__ import annotations

import numpy as np

from .canvas import Canvas, Curve, Extent, patch_at


def crown(rng: np.random.Generator, side: int = 96) -> np.ndarray:
    """Relief of a tree crown of unit radius, (side, side): the union of many round boughs; 0 outside."""
    axis = (np.arange(side) + 0.5) / side * 2.3 - 1.15
    x, y = axis[None, :], axis[:, None]
    relief = np.zeros((side, side))
    for _ in range(70):
        distance, turn = 0.78 * np.sqrt(rng.random()), rng.uniform(0, 2 * np.pi)
        radius = rng.uniform(0.13, 0.30)
        base = 0.75 * np.sqrt(1 - distance ** 2)
        inside = radius ** 2 - (x - distance * np.cos(turn)) ** 2 - (y - distance * np.sin(turn)) ** 2
        relief = np.maximum(relief, np.where(inside > 0, base + 1.1 * np.sqrt(np.maximum(inside, 0)), 0))
    return relief


def stamp_tree(canvas: Canvas, x: float, y: float, radius: float, relief: np.ndarray,
               rng: np.random.Generator) -> None:
    """Put a crown of a given radius (m) on the ground."""
    tree = patch_at(canvas, x, y, rng.uniform(0, 2 * np.pi), 1.25 * radius)
    if 0 in tree.height.shape:
        return
    # Nothing grows on a roof or under a crown.
    if tree.height[tree.height.shape[0] // 2, tree.height.shape[1] // 2] > 2.0:
        return
    side = relief.shape[0]
    scale = side / (2.3 * radius)
    col = np.clip((tree.u * scale + side / 2).astype(np.int32), 0, side - 1)
    row = np.clip((tree.v * scale + side / 2).astype(np.int32), 0, side - 1)
    top = relief[row, col].astype(np.float32)
    cover = np.clip(top * 8, 0, 1) * (np.hypot(tree.u, tree.v) < 1.15 * radius)
    green = np.array((0.34, 0.42, 0.24)) * rng.normal(1.0, 0.10) + np.array((0.05, 0.0, -0.01)) * rng.normal(0, 0.4)
    tree.paint(cover, green, 0.70 + 0.34 * top + 0.16 * tree.grain)
    crown_height = radius * (0.75 + 0.95 * top) + 0.05 * tree.grain
    tree.raise_to(cover * (crown_height > tree.height), crown_height)


def in_wood(x: np.ndarray, y: np.ndarray, extent_m: Extent) -> np.ndarray:
    """The wood in the south-western corner."""
    width, depth = extent_m
    return x / (0.17 * width) + (depth - y) / (0.28 * depth) < 1.1


def in_orchard(x: np.ndarray, y: np.ndarray, extent_m: Extent) -> np.ndarray:
    """The orchard in the north-west."""
    width, depth = extent_m
    return (np.abs(x - 0.115 * width) < 0.10 * width) & (np.abs(y - 0.175 * depth) < 0.13 * depth)


def trees(extent_m: Extent, main_road: Curve, side_road: Curve,
          rng: np.random.Generator) -> list[tuple[float, float, float]]:
    """Position and radius of the trees: wood, orchard, shore of the pond, field track, and a few anywhere."""
    width, depth = extent_m
    found = []
    for _ in range(int(width * depth / 110)):
        x, y = rng.uniform(-6, 0.2 * width), rng.uniform(0.68 * depth, depth + 6)
        if in_wood(x, y, extent_m):
            found.append((x, y, rng.uniform(1.8, 4.2)))
    for x in np.arange(2.0, 0.25 * width, 4.2):
        for y in np.arange(2.0, 0.35 * depth, 3.6):
            if in_orchard(x, y, extent_m) and rng.random() < 0.94:
                found.append((x + rng.normal(0, 0.2), y + rng.normal(0, 0.2), rng.uniform(0.7, 1.6)))
    for turn in rng.uniform(0, 2 * np.pi, 26):
        away = 0.035 * width + rng.uniform(4, 9)
        found.append((0.845 * width + 1.5 * away * np.cos(turn), 0.80 * depth + away * np.sin(turn),
                      rng.uniform(1.5, 3.6)))
    for y in np.arange(0.0, depth, 9.0):
        if rng.random() < 0.6:
            found.append((0.70 * width + 3 * np.sin(y / 37) + rng.choice((-4, 4)), y + rng.normal(0, 2),
                          rng.uniform(0.7, 3.2)))
    for _ in range(int(width * depth / 1600)):
        found.append((rng.uniform(0, width), rng.uniform(0, depth), rng.uniform(0.5, 2.6)))
    return [(x, y, radius) for x, y, radius in found
            if abs(x - float(main_road(np.float64(y)))) > 6 + radius
            and abs(y - float(side_road(np.float64(x)))) > 6 + radius
            and np.hypot((x - 0.845 * width) / 1.5, y - 0.80 * depth) > 0.035 * width + 3]
