"""What the tests of sensor models are made of: points on models made up, and real ones read without our code."""
from __future__ import annotations

from pathlib import Path

import numpy as np
from osgeo import gdal
from seam_inspector.plugin.sensors.measure.points import Points
from seam_inspector.plugin.sensors.measure.polynomials import Rational
from seam_inspector.plugin.sensors.measure.pushbroom import Pushbroom, fit_pushbroom
from seam_inspector.plugin.sensors.measure.sensor_model import Scaling

WGS84 = "EPSG:4326"
COLUMNS, ROWS = 40000.0, 23000.0
MIDDLE = np.array([7.18, 43.67, 600.0])
REACH = np.array([0.14, 0.075, 600.0])


def points(image: np.ndarray, ground: np.ndarray, check: np.ndarray | None = None, wkt: str = WGS84) -> Points:
    """Points of (n, 2) image and (n, 3) ground coordinates."""
    count = len(image)
    nothing = np.full(count, np.nan)
    roles = np.zeros(count, bool) if check is None else check
    return Points(tuple(map(str, range(count))), image, ground, wkt, nothing, roles)


def places(count: int, seed: int) -> np.ndarray:
    """(n, 3) longitude, latitude, height all over a scene."""
    return MIDDLE + REACH * np.random.default_rng(seed).uniform(-1, 1, (count, 3))


def made_rational(order: int, seed: int, denominator: float = 0.02) -> Rational:
    """Quotients like those of a satellite image, with every coefficient at work."""
    count = {1: 4, 2: 10, 3: 20}[order]
    random = np.random.default_rng(seed)
    numerators = random.uniform(-0.02, 0.02, (count, 2))
    numerators[1:3] += [[1.0, 0.05], [-0.05, -1.0]]
    numerators[3] += [0.01, 0.012]
    denominators = random.uniform(-denominator, denominator, (count, 2))
    denominators[0] = 1
    image = Scaling(np.array([COLUMNS / 2, ROWS / 2]), np.array([COLUMNS / 2, ROWS / 2]))
    return Rational(order, Scaling(MIDDLE, REACH), image, numerators, denominators)


def made_pushbroom(seed: int = 0) -> Pushbroom:
    """A parametric model near a real scene's geometry, every unknown at work."""
    ground = places(60, 5)
    seen = made_rational(1, 3, 0.0005).project(ground)
    nominal = fit_pushbroom(ground, seen, np.ones(60), 694e3, (COLUMNS, ROWS)).model
    assert isinstance(nominal, Pushbroom)
    return Pushbroom(nominal.orbit, np.random.default_rng(seed).normal(0, 0.7, 20))


def pleiades_grid(folder: Path) -> np.ndarray:
    """(heights 5, rows 33, columns 65, 5): column, row, longitude, latitude, height of the physical model's nodes."""
    dataset = gdal.Open(str(folder / "sensors" / "pleiades" / "GRID_P1BP--2017092838284574CP.tif"))
    bands = dataset.ReadAsArray().astype(float)
    left, step_x, _, top, _, step_y = dataset.GetGeoTransform()
    column, row = np.meshgrid(left + np.arange(65) * step_x, top + np.arange(33) * step_y)
    layers = []
    for index in range(5):
        height = float(dataset.GetMetadataItem(f"ALTITUDE_B{2 * index}"))
        layers.append(np.stack([column, row, bands[2 * index], bands[2 * index + 1], np.full(row.shape, height)], -1))
    return np.array(layers)


def ten_spread(grid: np.ndarray, random: np.random.Generator) -> np.ndarray:
    """(10, 5) nodes of three heights, one in each ninth of the image and one more, as a surveyor would choose them."""
    heights = random.permutation([0, 2, 4] * 3 + [2])
    ninths = [(row, column) for row in range(3) for column in range(3)] + [tuple(random.integers(0, 3, 2))]
    chosen = [
        grid[height, row * 11 + random.integers(0, 11), column * 22 + random.integers(0, 21)]
        for height, (row, column) in zip(heights, ninths)
    ]
    return np.array(chosen)
