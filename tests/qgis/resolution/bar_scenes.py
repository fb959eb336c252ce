"""A bar target as a raster, and the lines across its groups as a layer."""
from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from qgis.core import QgsGeometry, QgsVectorLayer

from tests.numbers.resolution.bar_targets import STEP, Bars, image
from tests.numbers.synthetic import UTM33, write_raster
from tests.qgis.scenes import PIXEL, layer, line

COARSEST_CM = 100.0  # distance of the coarsest group of the scene: ten pixels


@dataclass(frozen=True)
class BarScene:
    """A target of five groups in both directions: the first row is crossed along, the second across the flight."""

    path: str
    groups: dict[tuple[int, str], Bars]

    def geometry(self, group: int, direction: str = "along", **options: float) -> QgsGeometry:
        """The line across a group's bars."""
        ends = self.groups[group, direction].line(**options)
        return line(ends[:2], ends[2:])

    def lines(self, keys: Sequence[tuple[int, str]] | None = None, epsg: int | None = UTM33) -> QgsVectorLayer:
        """The layer with a line for each key, all by default."""
        wanted = list(self.groups) if keys is None else list(keys)
        shapes = [self.geometry(*key) for key in wanted]
        return bar_layer(shapes, [group for group, _ in wanted], [direction for _, direction in wanted], epsg)


def bar_layer(
    shapes: Sequence[QgsGeometry | None], groups: Sequence[object], directions: Sequence[object],
    epsg: int | None = UTM33,
) -> QgsVectorLayer:
    """A layer of lines with the fields of bar groups."""
    return layer("LineString", shapes, epsg, group=("integer", groups), direction=("string", directions))


def make_bar_scene(folder: Path, sigma: float = 0.8, bands: int = 3) -> BarScene:
    """Groups 1 to 5, each finer by two steps, 10 to 4 px; ``sigma`` px blurs along the flight, half more across."""
    groups: dict[tuple[int, str], Bars] = {}
    x = 30.0
    for group in range(1, 6):
        cycle = COARSEST_CM / 100 / PIXEL / STEP ** (2 * (group - 1))
        groups[group, "along"] = Bars(x, 40.2, cycle, 25.0)
        groups[group, "across"] = Bars(x, 110.4, cycle, 25.0, np.pi / 2)
        x += 45
    shape = (150, int(x))
    rows = [
        [bars for (_, where), bars in groups.items() if where == direction] for direction in ("along", "across")
    ]
    pixels = []
    for seed in range(bands):
        upper, lower = image(shape, rows[0], sigma, 1.0, seed), image(shape, rows[1], 1.5 * sigma, 1.0, seed)
        pixels.append(np.concatenate([upper[:75], lower[75:]]))
    return BarScene(write_raster(folder / "target.tif", np.stack(pixels), gsd=PIXEL), groups)
