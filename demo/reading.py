"""The pictures of docs/start/reading.md: a hard cut, a feather and a dodged field, each with what the desk shows of it.

    python -m demo.reading --block output/demo/block --output docs/pictures

The hard cut is the same block, cut without a feather; it is made beside the given one.
"""
from __future__ import annotations

import argparse
import sys
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from matplotlib.figure import Figure
from seam_inspector import OpenRaster, WindowResult, inspect_window, open_block
from seam_inspector.plugin.imagery import limits as imagery_limits
from seam_inspector.plugin.imagery.clips import read_clip
from seam_inspector.plugin.seams.charts.curves_painter import window_curves
from seam_inspector.plugin.seams.words import LOSS_OPACITY, loss_rgba

from demo import block
from demo.curve_chart import draw_curves
from demo.findings import Profile, ProfilePoint
from demo.pictures import draw_profile, stretched
from demo.screenshot import shrink

HARD_FEATHER_M = 0.001  # less than a pixel: the cut
SIDE_M = 102.4
NOTE: dict[str, Any] = {"fontsize": 9, "color": "#222222", "ha": "center", "va": "center",
                        "bbox": {"boxstyle": "round,pad=0.35", "fc": "#fffbe6", "ec": "#b8a24a", "lw": 0.8}}
Note = tuple[str, tuple[float, float], tuple[float, float]]
"""Words, the place they speak of in the panel's own values, and where they stand, as shares of the panel."""


@dataclass(frozen=True)
class Example:
    """A window and what its picture says."""

    name: str
    title: str
    is_hard: bool
    corner_m: tuple[float, float]
    """Corner of the window, from the mosaic's upper left, right and down."""
    on_clip: tuple[Note, ...]
    on_profile: tuple[Note, ...]
    on_curves: tuple[Note, ...]


ROAD, FIELD = (396.3, 144.6), (168.0, 292.6)
EXAMPLES = (
    Example(
        "reading_hard", "A hard cut", True, ROAD,
        (("no line along the seam", (560, 505), (0.5, 0.16)),),
        (("at 1 and above from the\nseam outwards: nothing is lost", (0.5, 1.03), (0.42, 0.42)),),
        (("below its sources at level 1:\nall of it was resampled", (0, 0.0225), (0.52, 0.2)),),
    ),
    Example(
        "reading_feather", "The same seam, feathered over 1.5 m", False, ROAD,
        (("a line of red: the feather", (560, 505), (0.5, 0.16)),),
        (("more than half is gone", (0.3, 0.4), (0.3, 0.12)),
         ("all is there from here on", (1.2, 1.0), (0.62, 0.9)),
         ("the width of the feather", (0.72, 0.76), (0.74, 0.52))),
        (("as before: a strip of 2 m\nhardly shows in the curve", (0, 0.0225), (0.52, 0.2)),),
    ),
    Example(
        "reading_dodged", "A field that was dodged too hard", False, FIELD,
        (("nothing along the seam", (512, 512), (0.56, 0.3)),),
        (("even: the seam is as soft\nas the field around it", (3.0, 0.95), (0.6, 0.4)),),
        (("far below at levels 1 and 2:\nthe whole window is soft", (0, 0.016), (0.56, 0.16)),),
    ),
)


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--block", type=Path, required=True, help="folder that `make demo` left")
    parser.add_argument("--output", type=Path, required=True, help="folder for the pictures")
    arguments = parser.parse_args()
    draw_all(arguments.block, arguments.output)
    return 0


def draw_all(folder: Path, output: Path) -> None:
    """The pictures of a block and of the same one cut hard."""
    hard = folder.parent / f"{folder.name}_hard"
    if not (hard / "seamlines.gpkg").exists():
        block.make_block(hard, progress=print, feather_m=HARD_FEATHER_M)
    for example in EXAMPLES:
        path = output / f"{example.name}.png"
        draw(example, hard if example.is_hard else folder, path)
        shrink(path)


def measured(folder: Path, corner_m: tuple[float, float]) -> tuple[WindowResult, np.ndarray]:
    """What is found in a window of a block, and the mosaic's pixels there."""
    inputs = open_block(folder / "mosaic.tif", sorted(folder.glob("strip*.tif")))
    mosaic = inputs.mosaic
    left, top = mosaic.grid.left + corner_m[0], mosaic.grid.top - corner_m[1]
    request = inputs.window((left, top - SIDE_M, left + SIDE_M, top))
    assert request.window is not None
    clip = read_clip(OpenRaster(mosaic.ref), mosaic, request.window)
    return inspect_window(request), stretched(np.moveaxis(clip.bands[:3], 0, -1))


def profile_of(result: WindowResult) -> Profile:
    """Its bins by level, in metres."""
    assert result.profile is not None
    profile: Profile = {}
    for one in result.profile.bins:
        distance = one.middle_px * result.ground_sample_distance
        profile.setdefault(one.level, []).append(ProfilePoint(distance, one.kept, one.low, one.high))
    return profile


def draw(example: Example, folder: Path, path: Path) -> None:
    """The clip with its lost detail, the seam profile and the curves, with notes."""
    result, pixels = measured(folder, example.corner_m)
    figure = Figure(figsize=(13.2, 4.6), layout="constrained")
    clip, profile, curves = figure.subplots(1, 3, gridspec_kw={"width_ratios": [0.9, 1, 1]})
    clip.imshow(pixels)
    if result.loss is not None:
        side = result.loss.cell_px
        rows, columns = result.loss.kept.shape
        clip.imshow(loss_rgba(result.loss), extent=(0, columns * side, rows * side, 0), alpha=LOSS_OPACITY)
        clip.set(xlim=(0, pixels.shape[1]), ylim=(pixels.shape[0], 0))
    clip.axis("off")
    clip.set_title("the loss picture (L)", fontsize=10)
    draw_profile(profile, profile_of(result))
    profile.set_title("the seam profile", fontsize=10)
    lines = window_curves(result, "luminance")
    draw_curves(curves, lines, imagery_limits.MAX_SIGNIFICANT_RATIO)
    curves.legend(fontsize=7.5, frameon=False)
    curves.set_title("the curves", fontsize=10)
    annotate(clip, example.on_clip, "#ffffff")
    annotate(profile, example.on_profile)
    annotate(curves, example.on_curves)
    assert result.profile is not None
    kept = 100 * (result.profile.kept[0] or 0), 100 * result.profile.low, 100 * result.profile.high
    words = "{:.0f} % kept ({:.0f} to {:.0f} %)".format(*kept)
    figure.suptitle(f"{example.title}: {result.judgement.verdict.value}, {words}", fontweight="bold", fontsize=12)
    figure.savefig(path, dpi=100)


def annotate(axes: Any, notes: Sequence[Note], colour: str = "#555555") -> None:
    """Words with an arrow to what they speak of."""
    for words, place, at in notes:
        arrow = {"arrowstyle": "->", "color": colour, "lw": 1.6}
        axes.annotate(words, xy=place, xytext=at, textcoords="axes fraction", arrowprops=arrow, **NOTE)


if __name__ == "__main__":
    sys.exit(main())
