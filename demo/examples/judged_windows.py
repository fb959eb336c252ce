"""Windows that an operator judged, made up: the less detail was kept, the more likely the loss was seen."""
from __future__ import annotations

from pathlib import Path

import numpy as np

from demo.block import EASTING, EPSG, NORTHING

from .files import box, write_layer

WINDOWS, SIDE = 120, 102.4  # how many, m
HALF_SEEN, SPREAD = 0.68, 0.05  # what is kept where half of the losses are seen, and how sharply that changes


def make_judged_windows(folder: Path) -> None:
    """Write `judged.gpkg`."""
    folder.mkdir(parents=True, exist_ok=True)
    random = np.random.default_rng(12)
    features = []
    for number in range(WINDOWS):
        kept = float(random.uniform(0.35, 1.05))
        seen = random.uniform() < 1 / (1 + np.exp((kept - HALF_SEEN) / SPREAD))
        ratio = float(np.clip(kept * random.lognormal(0, 0.25), 0.1, 2))
        left = EASTING + 1000 * (number % 12)  # far from each other: independent
        bottom = NORTHING + 1000 * (number // 12)
        fields = {"window_id": number + 1, "observer": "visible" if seen else "invisible", "kept_1": kept,
                  "ratio_1": ratio}
        features.append((box(left, bottom, left + SIDE, bottom + SIDE), fields))
    write_layer(folder / "judged.gpkg", EPSG, features)
