"""The picture of docs/method/causes.md: a feathered window, what it follows and where it is a mixture.

    python -m benchmarks.picture BRIGHTON_FOLDER docs/pictures/causes.png
"""
from __future__ import annotations

import argparse
from pathlib import Path

import numpy as np
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from seam_inspector.plugin.imagery.wavelets import luminance
from seam_inspector.plugin.seams.measure.following.followed_source import follow_planes, high_pass

from .scenes import brighton_scenes, feather

SIDE, NUMBER, SIGMA_PX = 256, 6, 13
COLOURS = ((0.20, 0.45, 0.75), (0.90, 0.60, 0.15), (0.30, 0.62, 0.35), (0.62, 0.38, 0.65))


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("brighton", type=Path)
    parser.add_argument("picture", type=Path)
    arguments = parser.parse_args()
    scene = brighton_scenes(arguments.brighton, SIDE, NUMBER)[-1]
    mosaic = feather(scene.labels, [clip.bands for clip in scene.sources], SIGMA_PX)
    planes = [luminance(bands) for bands in (mosaic, *(clip.bands for clip in scene.sources))]
    fine = [high_pass(plane) for plane in planes]
    found = follow_planes(fine)
    grey = np.repeat(planes[0][..., np.newaxis] / 255, 3, axis=2)
    followed = 0.45 * grey + 0.55 * np.array(COLOURS)[found.labels % len(COLOURS)]
    mixed = np.where(found.clear[..., np.newaxis], grey, 0.35 * grey + 0.65 * np.array([0.80, 0.10, 0.15]))
    figure = Figure(figsize=(7.0, 2.6), dpi=80, layout="constrained")
    panels = ((mosaic.transpose(1, 2, 0), f"Mosaic, feathered (sigma {SIGMA_PX} px)"), (followed, "Source it follows"),
              (mixed, f"No source wins clearly: {100 * found.unclear_share:.0f} %"))
    for axes, (pixels, title) in zip(figure.subplots(1, 3), panels):
        axes.imshow(pixels, interpolation="nearest")
        axes.contour(scene.labels, np.arange(len(scene.sources)) + 0.5, colors="white", linewidths=0.6)
        axes.set_title(title, fontsize=8)
        axes.set_axis_off()
    FigureCanvasAgg(figure).print_figure(arguments.picture)
    return 0


if __name__ == "__main__":
    raise SystemExit(main())
