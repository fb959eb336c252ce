"""How well spoilt windows are told from sound ones, and their causes from each other: `make benchmark-detection`.

The same windows, once cut hard and once spoilt in each of several ways, by what the plugin measures and by two usual
measures that look at the mosaic alone. The figure is the area under the ROC curve: 1 where a threshold parts them all,
0.5 where the measure knows nothing, below that where spoilt windows look the better ones. Then the causes found in
some 200 windows, and by how much what was measured is off.

On Brighton where SEAM_INSPECTOR_DATA is set, else on a generated block.
"""
from __future__ import annotations

import argparse
import os
import tempfile
import time
from collections import Counter
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Callable

import numpy as np
from osgeo import gdal
from scipy import ndimage
from seam_inspector.plugin.imagery.band_curves import luminance
from seam_inspector.plugin.imagery.band_names import LUMINANCE
from seam_inspector.plugin.seams.measure.causes import Cause
from seam_inspector.plugin.seams.measure.verdicts import judge
from skimage.measure import blur_effect

from demo.block import PIXEL, make_block

from .scenes import Scene, Truth, blur, brighton_scenes, demo_scenes, explained, feather, gain, half_and_half, truths
from .timing import print_table

SIDE, COUNT = 512, 64
DEMO_EXTENT = (330.0, 264.0)
BRIGHTON_PIXEL = 0.03
CAUSE_WINDOWS = 200

SPOILT: Mapping[str, Callable[[Scene], np.ndarray]] = {
    "feather 13 px": lambda scene: feathered(scene, 13),
    "66 px": lambda scene: feathered(scene, 66),
    "256 px": lambda scene: feathered(scene, 256),
    "whole window": half_and_half,
    "blur 0.8 px": lambda scene: blur(scene, 0.8),
    "gain 0.6": lambda scene: gain(scene, 0.6),
}
SKETCH = {  # a first sketch of these measures on 60 windows of Brighton, with the labels known
    "ratio_1 against the sources": (0.52, 0.56, 0.73, 1.00, 1.00, 0.49),
    "composite_ratio_1": (0.99, 1.00, 1.00, 1.00, 1.00, 0.10),
    "contrast_1 against the composite": (1.00, 1.00, 1.00, 1.00, 1.00, 1.00),
    "variance of the Laplacian": (0.52, 0.56, 0.69, 0.94, 1.00, 1.00),
}
MEASURES = (*SKETCH, "blur_effect of scikit-image")


def feathered(scene: Scene, sigma_px: float) -> np.ndarray:
    """The scene's sources, feathered across the known cut."""
    return feather(scene.labels, [clip.bands for clip in scene.sources], sigma_px)


def measures(scene: Scene, bands: np.ndarray) -> tuple[float, ...]:
    """The figures of one mosaic, in the order of ``MEASURES``; each is higher the sharper the mosaic."""
    found, curves, sources = explained(scene, bands)
    against_sources = judge(curves[LUMINANCE], [one[LUMINANCE] for one in sources]).ratios.detail[0]
    of_composite = found.ratios[LUMINANCE].detail[0]
    contrast = found.changes[-1][LUMINANCE].contrast[0]
    grey = luminance(bands)
    plain = float(ndimage.laplace(grey).var()), -float(blur_effect(grey / 255))
    return tuple(np.nan if one is None else one for one in (against_sources, of_composite, contrast, *plain))


def area(sound: Sequence[float], spoilt: Sequence[float]) -> float:
    """Area under the ROC curve: how often a sound window has the higher figure, ties counted half."""
    difference = np.subtract.outer(np.asarray(sound), np.asarray(spoilt))
    return float(((difference > 0) + 0.5 * (difference == 0)).mean())


def run_detection(scenes: Sequence[Scene], is_brighton: bool) -> dict[str, list[float]]:
    """Print the areas under the ROC curves and give them by measure, in the order of ``SPOILT``."""
    sound = np.array([measures(scene, scene.cut()) for scene in scenes])
    areas: dict[str, list[float]] = {name: [] for name in MEASURES}
    for make in SPOILT.values():
        spoilt = np.array([measures(scene, make(scene)) for scene in scenes])
        for name, good, bad in zip(MEASURES, sound.T, spoilt.T):
            areas[name].append(area(good, bad))
    rows = []
    for name, found in areas.items():
        expected = [f" ({one:.2f})" for one in SKETCH[name]] if is_brighton and name in SKETCH else [""] * len(found)
        rows.append([name, *(f"{one:.2f}{before}" for one, before in zip(found, expected))])
    print_table(
        f"Area under the ROC curve, {len(scenes)} windows of {scenes[0].window.width} px, hard cut against spoilt",
        ["measure", *SPOILT], rows,
        "Feathers: sigma of the Gaussian. Whole window: the mean of two sources."
        + (" In brackets: a first sketch." if is_brighton else ""),
    )
    return areas


class Errors:
    """By how much measured values are off, by what they are."""

    def __init__(self) -> None:
        self.found: dict[str, list[float]] = {"A, %": [], "B, DN": [], "gamma": [], "A by channel, %": [],
                                              "shift, px": []}
        """nan where nothing was measured."""

    def add(self, scene: Scene, truth: Truth, changes: Sequence[Mapping]) -> None:
        """Compare what was measured against the composite and, for shifts, against the moved source."""
        tones = {band: change.tone for band, change in changes[-1].items()}
        tone = tones[LUMINANCE]
        if truth.colours is None:
            self.found["gamma"].append(tone.gamma - truth.gamma)
        linear = truth.linear(scene) if truth.linear else (truth.gain, truth.bias)
        if linear[0] is not None and linear[1] is not None:
            self.found["A, %"].append(100 * (tone.gain / linear[0] - 1))
            self.found["B, DN"].append(tone.bias - linear[1])
        for band, factor in zip(("red", "green", "blue"), truth.colours or ()):
            self.found["A by channel, %"].append(100 * (tones[band].gain / factor - 1))
        if truth.shift:
            shift = changes[scene.main[1]][LUMINANCE].shift
            off = np.hypot(shift.x - truth.shift[0], shift.y - truth.shift[1]) if shift else np.nan
            self.found["shift, px"].append(float(off))

    def rows(self) -> list[list[str]]:
        """Number, median, 95 % and largest of the absolute errors, and where nothing was measured."""
        rows = []
        for name, errors in self.found.items():
            known = np.abs(np.asarray(errors))[~np.isnan(errors)]
            figures = (np.median(known), np.percentile(known, 95), known.max())
            rows.append([name, str(len(errors)), *(f"{one:.3f}" for one in figures), str(len(errors) - len(known))])
        return rows


def run_causes(scenes: Sequence[Scene], pixel_m: float, count: int) -> tuple[int, int, Errors]:
    """Print the causes found in ``count`` windows or some more; how many are right, of how many, and the errors."""
    operations = truths(pixel_m)
    each = -(-count // len(operations))
    errors, rows, right = Errors(), [], 0
    head = [cause.value for cause in Cause]
    for number, truth in enumerate(operations):
        causes: Counter[str] = Counter()
        for place in range(number * each, (number + 1) * each):
            scene = scenes[place % len(scenes)]
            found = explained(scene, truth.make(scene))[0]
            causes[found.cause.value] += 1
            errors.add(scene, truth, found.changes)
        right += causes[truth.cause.value]
        rows.append([truth.name, *(str(causes[name] or ".") for name in head)])
    total = each * len(operations)
    print_table(f"Causes found in {total} windows of {scenes[0].window.width} px, by what was done to them",
                ["operation", *head], rows, f"Right: {right} of {total}, {right / total:.1%}.")
    print_table("Measured less true, absolute", ["", "windows", "median", "95 %", "largest", "not measured"],
                errors.rows())
    return right, total, errors


def main() -> int:
    parser = argparse.ArgumentParser(prog="python -m benchmarks.detection", description=__doc__.split("\n")[0])
    parser.add_argument("--windows", type=int, default=COUNT, help="for the ROC curves")
    parser.add_argument("--cause-windows", type=int, default=CAUSE_WINDOWS, help="for the causes")
    arguments = parser.parse_args()
    gdal.UseExceptions()
    started = time.perf_counter()
    folder = Path(os.environ.get("SEAM_INSPECTOR_DATA", "")) / "seams" / "brighton"
    is_brighton = "SEAM_INSPECTOR_DATA" in os.environ and folder.is_dir()
    with tempfile.TemporaryDirectory(prefix="seam_inspector_") as temporary:
        if is_brighton:
            print(f"Brighton's orthoimages, {folder}")
            scenes = brighton_scenes(folder, SIDE, arguments.windows)
        else:
            print("A generated block; set SEAM_INSPECTOR_DATA for real orthoimages")
            block = make_block(temporary, DEMO_EXTENT)
            scenes = demo_scenes(block.mosaic, block.sources, block.seamlines, SIDE, arguments.windows)
    run_detection(scenes, is_brighton)
    run_causes(scenes, BRIGHTON_PIXEL if is_brighton else PIXEL, arguments.cause_windows)
    print(f"\n{time.perf_counter() - started:.0f} s")
    return 0


if __name__ == "__main__":
    raise SystemExit(main())
