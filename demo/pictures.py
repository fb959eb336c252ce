"""The picture of what an inspection found: profiles, curves and clips of some windows side by side."""
from __future__ import annotations

from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import Any

import numpy as np
from matplotlib.figure import Figure
from seam_inspector.plugin.imagery import grids
from seam_inspector.plugin.imagery import limits as imagery_limits
from seam_inspector.plugin.imagery.clips import read_clip
from seam_inspector.plugin.imagery.open_raster import OpenRaster, describe_mosaic
from seam_inspector.plugin.imagery.rasters import Raster, RasterRef
from seam_inspector.plugin.seams.charts.curves_painter import ChartCurve
from seam_inspector.plugin.seams.measure.limits import MAX_SIGNIFICANT_KEPT

from demo.curve_chart import draw_curves
from demo.findings import Inspected, Profile

PICTURE_PX = (220, 150)  # width and height of the mosaic and a source below the curves, at about 2x magnification
LEVEL_COLOURS = ("#0072b2", "#56b4e9", "#a0a0a0")
TOP_KEPT = 1.4  # of the charts


def draw(
    chosen: Iterable[Inspected], profiles: dict[int, Profile], curves: dict[int, list[ChartCurve]], mosaic_file: Path,
    sources: Sequence[Path], path: Path,
) -> None:
    """For each window its profile, its curves, and the mosaic above the least sharp source at 2x."""
    chosen = list(chosen)
    figure = Figure(figsize=(4.6 * len(chosen), 12.4), layout="constrained")
    grid = figure.subplots(3, len(chosen), squeeze=False, gridspec_kw={"height_ratios": [0.6, 0.72, 1.0]})
    mosaic = describe_mosaic(RasterRef(str(mosaic_file)))
    shares = [curve.detail[0] for window in chosen for curve in curves[window.window_id]]
    limits = min(shares) * imagery_limits.MAX_SIGNIFICANT_RATIO, 1.2
    for column, window in enumerate(chosen):
        profile, chart, picture = grid[0][column], grid[1][column], grid[2][column]
        draw_profile(profile, profiles.get(window.window_id, {}))
        title = f"Window {window.window_id}: {window.verdict}, kept {window.kept}"
        profile.set_title(title, fontsize=11, fontweight="bold")
        draw_curves(chart, curves[window.window_id], imagery_limits.MAX_SIGNIFICANT_RATIO)
        chart.set_title(f"by the paper's rule: {window.paper_verdict}, {window.ratio}", fontsize=9)
        chart.set_ylim(*limits)
        chart.legend(fontsize=7.5, frameon=False)
        draw_pictures(picture, window, curves[window.window_id], mosaic, mosaic_file, sources)
    figure.savefig(path, dpi=100)


def draw_profile(axes: Any, profile: Profile) -> None:
    """What is kept by distance from the seam, level by level, with the interval of the first."""
    for (level, points), colour in zip(sorted(profile.items()), LEVEL_COLOURS):
        distances = [point.distance for point in points]
        if level == 1:
            axes.fill_between(
                distances, [point.low for point in points], [point.high for point in points], color=colour, alpha=0.15
            )
        axes.plot(distances, [point.kept for point in points], color=colour, marker=".", label=f"level {level}")
    axes.axhline(1, color="#808080", linewidth=0.8)
    axes.axhline(MAX_SIGNIFICANT_KEPT, color="#d55e00", linewidth=1, linestyle="--", label="significant below")
    axes.set(xscale="log", ylim=(0, TOP_KEPT), xlabel="distance from the seam (m)", ylabel="kept")
    axes.xaxis.set_major_formatter("{x:g}")
    axes.legend(fontsize=7.5, frameon=False, loc="lower right")


def draw_pictures(
    axes: Any, window: Inspected, curves: list[ChartCurve], mosaic: Raster, mosaic_file: Path, sources: Sequence[Path]
) -> None:
    """The middle of a window in the mosaic and, one above the other, in the least sharp source that covers it all."""
    files = {path.name: path for path in sources}  # the composite is no file
    wholly = [curve for curve in curves if curve.label in files]  # those that cover the window in part have no curve
    source = files[min(wholly, key=lambda curve: curve.detail[0]).label] if wholly else None
    shown = [mosaic_file, *([source] if source else [])]
    whole = grids.snap_window(mosaic.grid, window.extent)
    width, height = min(PICTURE_PX[0], whole.width), min(PICTURE_PX[1], whole.height)
    middle = grids.PixelWindow(
        whole.column + (whole.width - width) // 2, whole.row + (whole.height - height) // 2, width, height
    )
    clips = [read_clip(OpenRaster(RasterRef(str(file))), mosaic, middle) for file in shown]
    images = [np.moveaxis(clip.bands[[0, 1, 2] if clip.raster.has_luminance else [0, 0, 0]], 0, -1) for clip in clips]
    gap = np.full((4, width, 3), 255, dtype=np.uint8)
    parts = [part for image in images for part in (stretched(image), gap)]
    axes.imshow(np.concatenate(parts[:-1]), interpolation="nearest")
    axes.set_title(f"above the mosaic, below {source.name}" if source else "the mosaic", fontsize=9)
    axes.axis("off")


def stretched(image: np.ndarray) -> np.ndarray:
    """To 8 bit for the eye, one stretch for all bands."""
    low, high = np.percentile(image, (1, 99))
    return np.clip((image - low) / max(high - low, 1) * 255, 0, 255).astype(np.uint8)
