"""What an inspection of the demonstration found, read from its tables, and printed."""
from __future__ import annotations

import csv
import math
from collections import defaultdict
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import NamedTuple

from qgis.core import NULL, QgsVectorLayer
from seam_inspector.plugin.imagery.grids import Extent
from seam_inspector.plugin.seams.charts.curves_painter import ChartCurve

from demo.block import FEATHER, Damage

AS_A_WHOLE = (
    "Sharpness is that of the whole window against its sources; its square is the share of the finest detail that is\n"
    "left."
)
EVERYWHERE = "Everywhere: tones balanced source by source, cubic resampling by 0.2 to 0.6 px to where the images fit."
MOST_SHOWN = 3
MIN_DAMAGED_SHARE = 0.3  # of a window, for what was done there to be its story


@dataclass(frozen=True)
class Inspected:
    """One row of the inspected windows."""

    window_id: int
    verdict: str
    paper_verdict: str
    causes: str
    ratio_1: float | None
    """None where no source covers all of it."""
    kept_1: float | None
    kept_low: float | None
    kept_high: float | None
    band_width: float | None
    """m"""
    sharpness_1: float | None
    """Sharpness of the whole window against its sources."""
    extent: Extent

    @property
    def kept(self) -> str:
        """What is kept along the seam, with its interval, %."""
        if self.kept_1 is None or self.kept_low is None or self.kept_high is None:
            return "no seam"
        return f"{100 * self.kept_1:.0f} % ({100 * self.kept_low:.0f} to {100 * self.kept_high:.0f})"

    @property
    def sharpness(self) -> str:
        """Sharpness of the whole window, %."""
        return "" if self.sharpness_1 is None else f"{100 * self.sharpness_1:.0f} %"

    @property
    def badness(self) -> float:
        """The smaller the worse."""
        return next((value for value in (self.kept_1, self.ratio_1) if value is not None), math.inf)

    @property
    def ratio(self) -> str:
        """The paper's."""
        return "" if self.ratio_1 is None else f"ratio 1: {self.ratio_1:.2f}"


class ProfilePoint(NamedTuple):
    """What is kept at one distance from the seam."""

    distance: float
    kept: float
    low: float
    high: float


Profile = dict[int, list[ProfilePoint]]
"""Points by level, from the seam outwards."""


def read_windows(uri: str) -> list[Inspected]:
    """The windows, most spoilt first."""
    layer = QgsVectorLayer(uri, "inspected", "ogr")
    rows = []
    for feature in layer.getFeatures():
        box = feature.geometry().boundingBox()
        extent = (box.xMinimum(), box.yMinimum(), box.xMaximum(), box.yMaximum())
        names = ("ratio_1", "kept_1", "kept_low", "kept_high", "band_width", "sharpness_1")
        ratio, kept, low, high, width, sharpness = (_number(feature[name]) for name in names)
        causes = "" if feature["causes"] == NULL else feature["causes"]
        rows.append(Inspected(
            feature["window_id"], feature["verdict"], feature["paper_verdict"], causes, ratio, kept, low, high, width,
            sharpness, extent,
        ))  # fmt: skip
    return sorted(rows, key=lambda row: row.badness)


def representative(inspected: list[Inspected], damage: Sequence[Damage] | None) -> list[Inspected]:
    """Windows to show: of the generated block the most spoilt of each kind, else the best, the median and the worst."""
    compared = [one for one in inspected if one.verdict != "not_comparable"]
    if damage is not None:
        kinds: dict[str, Inspected] = {}
        for one in compared:
            kinds.setdefault(made_with(one, damage), one)
        return list(kinds.values())[:MOST_SHOWN]
    if len(compared) < MOST_SHOWN:
        return compared[::-1]
    return [compared[-1], compared[len(compared) // 2], compared[0]]


def read_curves(path: Path) -> dict[int, list[ChartCurve]]:
    """The curves that decided each window's verdict: of luminance, or of the only band."""
    values: dict[tuple[int, str, bool, str], dict[tuple[str, int], float]] = defaultdict(dict)
    with open(path, newline="", encoding="utf-8") as file:
        for row in csv.DictReader(file):
            key = int(row["window_id"]), row["raster"], row["role"] == "mosaic", row["band"]
            values[key][row["component"], int(row["level"])] = float(row["relative_variance"] or "nan")
    bands = {band for _, _, _, band in values}
    decisive = "luminance" if "luminance" in bands else min(bands)
    curves = defaultdict(list)
    for (window, raster, is_mosaic, band), shares in values.items():
        if band == decisive:
            levels = len(shares) - 1
            detail = tuple(shares["detail", level] for level in range(1, levels + 1))
            curves[window].append(ChartCurve(raster, is_mosaic, detail, shares["background", levels]))
    return curves


def read_profiles(path: Path) -> dict[int, Profile]:
    """What each window keeps by distance."""
    profiles: dict[int, Profile] = defaultdict(lambda: defaultdict(list))
    with open(path, newline="", encoding="utf-8") as file:
        for row in csv.DictReader(file):
            point = ProfilePoint(*(float(row[name]) for name in ("distance", "kept", "low", "high")))
            profiles[int(row["window_id"])][int(row["level"])].append(point)
    return profiles


def print_windows(inspected: Iterable[Inspected], damage: Sequence[Damage] | None) -> None:
    """What was found in each window and, in the generated block, what was done there."""
    told = "" if damage is None else "made with"
    head = f"{'window':8}{'verdict':15}{'kept along the seam':22}{'band':>7}  {'sharpness':11}"
    print(f"\n{head}{'paper':15}{told:24}causes")
    for one in sorted(inspected, key=lambda row: row.window_id):
        band = f"{one.band_width:.1f} m" if one.band_width else ""
        done = "" if damage is None else made_with(one, damage)
        measured = f"{one.window_id:<8}{one.verdict:15}{one.kept:22}{band:>7}  {one.sharpness:11}"
        print(f"{measured}{one.paper_verdict:15}{done:24}{one.causes}")
    print(AS_A_WHOLE)
    if damage is not None:
        print(EVERYWHERE)


def made_with(window: Inspected, damage: Iterable[Damage]) -> str:
    """What the block's maker did in a window."""
    spoilt = [one.cause for one in damage if _share(window.extent, one.bounds) >= MIN_DAMAGED_SHARE]
    return ", ".join(spoilt or [f"feather of {FEATHER:g} m"])


def print_table(chosen: Iterable[Inspected], curves: dict[int, list[ChartCurve]]) -> None:
    """Like table 1 of the paper: relative variances of the mosaic and its sources, window by window."""
    widest = max(len(curve.label) for rows in curves.values() for curve in rows)
    levels = len(next(iter(curves.values()))[0].detail)
    heads = [*(f"detail {level}" for level in range(1, levels + 1)), f"background {levels}"]
    line = "-" * (26 + widest + 14 * len(heads))
    print(f"\n{'window':26}{'raster':{widest}}" + "".join(f"{head:>14}" for head in heads), line, sep="\n")
    for window in chosen:
        titles = iter([
            f"{window.window_id} {window.verdict}", f"  kept {window.kept}", f"  {window.ratio}"
        ])
        for curve in sorted(curves[window.window_id], key=lambda curve: not curve.is_mosaic):
            shares = "".join(f"{share:14.3f}" for share in (*curve.detail, curve.background))
            print(f"{next(titles, ''):26}{curve.label:{widest}}{shares}")
        print(line)


def _number(value: object) -> float | None:
    return None if value == NULL else float(value)  # type: ignore[arg-type]


def _share(extent: Extent, bounds: Extent) -> float:
    """Share of an extent that lies within bounds."""
    width = min(extent[2], bounds[2]) - max(extent[0], bounds[0])
    height = min(extent[3], bounds[3]) - max(extent[1], bounds[1])
    return max(width, 0) * max(height, 0) / ((extent[2] - extent[0]) * (extent[3] - extent[1]))
