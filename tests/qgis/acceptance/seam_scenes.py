"""Layers of seams as scans write them, in memory and as files."""
from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from qgis.core import QgsGeometry, QgsVectorLayer

from tests.qgis.scenes import layer, moved, saved

X, Y = 500_000.0, 5_400_000.0
UTM33 = 32633


def straight(start: float, length: float, y: float = 0.0) -> QgsGeometry:
    return QgsGeometry.fromWkt(f"LINESTRING({X + start} {Y + y}, {X + start + length} {Y + y})")


def seams(
    kept: Sequence[float | None], length: float = 25.0, y: float = 0.0, start: float = 0.0, epsg: int = UTM33,
    name: str = "seams", with_length: bool = True,
) -> QgsVectorLayer:
    """One seam along x, in pieces that kept so much."""
    lines = [straight(start + place * length, length, y) for place in range(len(kept))]
    count = len(kept)
    fields = {
        "seam_id": ("integer", [1] * count),
        "station": ("double", [place * length for place in range(count)]),
        **({"length": ("double", [length] * count)} if with_length else {}),
        "kept_1": ("double", list(kept)),
        "kept_low": ("double", [None if value is None else value - 0.05 for value in kept]),
        "kept_high": ("double", [None if value is None else value + 0.05 for value in kept]),
        "verdict": ("string", ["not_comparable" if value is None else "preserved" for value in kept]),
    }
    made = layer("LineString", [line if epsg == UTM33 else moved(line, epsg) for line in lines], epsg, **fields)
    made.setName(name)
    return made



def file(made: QgsVectorLayer, path: Path) -> str:
    path.parent.mkdir(parents=True, exist_ok=True)
    return saved(made, path)
