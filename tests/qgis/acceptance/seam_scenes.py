"""Layers of seams as scans write them, in memory and as files."""
from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np
from qgis.core import NULL, QgsGeometry, QgsVectorLayer
from seam_inspector.plugin.imagery.seam_totals import SYSTEM, TOTALS_DOMAIN, RowTotals
from seam_inspector.plugin.toolkit.layers import layer_notes, system_wkt, write_layer_notes

from tests.qgis.runs import Run, run
from tests.qgis.scenes import layer, moved, saved

X, Y = 500_000.0, 5_400_000.0
UTM33 = 32633


def straight(start: float, length: float, y: float = 0.0) -> QgsGeometry:
    return QgsGeometry.fromWkt(f"LINESTRING({X + start} {Y + y}, {X + start + length} {Y + y})")


def seams(
    kept: Sequence[float | None], length: float = 25.0, y: float = 0.0, start: float = 0.0, epsg: int = UTM33,
    name: str = "seams", with_length: bool = True, reasons: Sequence[str] = (),
) -> QgsVectorLayer:
    """One seam along x, in pieces that kept so much."""
    lines = [straight(start + place * length, length, y) for place in range(len(kept))]
    count = len(kept)
    fields = {
        "seam_id": ("integer", [1] * count),
        "station": ("double", [place * length for place in range(count)]),
        **({"length": ("double", [length] * count)} if with_length else {}),
        "level": ("string", ["piece"] * count),
        "kept_1": ("double", list(kept)),
        "kept_low": ("double", [None if value is None else value - 0.05 for value in kept]),
        "kept_high": ("double", [None if value is None else value + 0.05 for value in kept]),
        "verdict": ("string", ["not_comparable" if value is None else "preserved" for value in kept]),
        **({"reason": ("string", list(reasons))} if reasons else {}),
    }
    made = layer("LineString", [line if epsg == UTM33 else moved(line, epsg) for line in lines], epsg, **fields)
    made.setName(name)
    return sealed(made)


def sealed(made: QgsVectorLayer, **notes: str) -> QgsVectorLayer:
    """A layer as a scan leaves it, with the rows that it holds now."""
    held = [(row.attributeMap(), row.geometry()) for row in made.getFeatures()]
    rows = [
        ({name: None if value == NULL else value for name, value in fields.items()},
         np.array([(point.x(), point.y()) for point in line.vertices()], float).reshape(-1, 2))
        for fields, line in held
    ]  # fmt: skip
    write_layer_notes(made, TOTALS_DOMAIN, RowTotals(rows).sealed({SYSTEM: system_wkt(made.crs()), **notes}))
    return made


def file(made: QgsVectorLayer, path: Path) -> str:
    """The layer as a file, with its seal where the format has a place for it."""
    path.parent.mkdir(parents=True, exist_ok=True)
    written = saved(made, path)
    write_layer_notes(written, TOTALS_DOMAIN, layer_notes(made, TOTALS_DOMAIN))
    return written


def decide(*layers: QgsVectorLayer | str, **parameters: Any) -> Run:
    """A decision on layers of seams, without papers that nobody asks for."""
    papers = dict.fromkeys(("DEFECTS", "REPORT", "QUALITY"))
    return run("acceptmosaic", SEAMS=list(layers), **{**papers, **parameters})


def decision(outcome: Run) -> str:
    """The sentence that decides."""
    starts = ("Accepted by", "Rejected by", "Undecided by")
    return next(text for text in outcome.log.infos if text.startswith(starts))
