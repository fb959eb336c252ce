"""The curve of one band against `pywt.wavedec2` on the same clip."""
from __future__ import annotations

from collections.abc import Iterator

import numpy as np
import pywt
from seam_inspector.plugin.imagery.wavelets import clip_curves

from .timing import Goal, Timing, interleaved, is_system_blas, print_table

WAVELET, LEVELS = "coif3", 3
WANTED, WANTED_ON_DEBIAN = 10, 8
JUDGED_SIDE = 1024


def clips(band: np.ndarray, quick: bool) -> Iterator[tuple[str, np.ndarray]]:
    """Clips of an 8-bit band by what they are; 16 bit and float carry its noise on in their lower bits."""
    corner = np.ascontiguousarray(band[:JUDGED_SIDE, :JUDGED_SIDE])
    lower_bits = np.random.default_rng(3).integers(0, 16, corner.shape)
    finer = (16 * corner.astype(np.uint16) + lower_bits).astype(np.uint16)
    yield "1024 px, uint8", corner
    yield "1024 px, uint16", finer
    yield "1024 px, float32", (finer / np.float32(4095)).astype(np.float32)
    for side in (256, 512) if quick else (256, 512, 2048):
        yield f"{side} px, uint8", np.ascontiguousarray(band[:side, :side])


def by_pywavelets(clip: np.ndarray) -> list:
    """The decomposition that the curve is checked against, without the energies that the curve still needs."""
    return pywt.wavedec2(clip, WAVELET, mode="periodization", level=LEVELS)


def share_error(clip: np.ndarray) -> float:
    """How much the curve's shares differ from PyWavelets' in float64, at most."""
    coarse, *details = by_pywavelets(clip - clip.mean(dtype=np.float64))
    energies = [sum(float((part**2).sum()) for part in level) for level in reversed(details)]
    energies.append(float((coarse**2).sum()))
    curve = clip_curves(clip[np.newaxis], WAVELET, LEVELS)[0][0]
    return float(np.abs(np.array([*curve.detail, curve.background]) - np.array(energies) / sum(energies)).max())


def compare(clip: np.ndarray, repetitions: int) -> tuple[Timing, Timing, Timing]:
    """Our curve, PyWavelets in float32 and in float64; the clip is converted for it beforehand."""
    single, double = clip.astype(np.float32), clip.astype(np.float64)
    calls = (
        lambda: clip_curves(clip[np.newaxis], WAVELET, LEVELS),
        lambda: by_pywavelets(single),
        lambda: by_pywavelets(double),
    )
    ours, by_single, by_double = interleaved(calls, repetitions)
    return ours, by_single, by_double


def run(band: np.ndarray, quick: bool) -> list[Goal]:
    """Print the table; the goal is for 1024 x 1024, against the faster of PyWavelets' two precisions."""
    repetitions = 7 if quick else 11
    wanted = WANTED_ON_DEBIAN if is_system_blas() else WANTED
    rows, goals = [], []
    for name, clip in clips(band, quick):
        ours, single, double = compare(clip, repetitions)
        ratio = single.over(ours)
        rows.append([name, ours.milliseconds, single.milliseconds, str(ratio), f"{single.cpu_over(ours):.1f}",
                     double.milliseconds, str(double.over(ours)), f"{share_error(clip):.0e}"])
        if clip.shape[0] == JUDGED_SIDE:
            goals.append(Goal(f"curve, {name}: times faster than pywt.wavedec2 in float32", wanted, ratio.median,
                              processor=single.cpu_over(ours)))
    print_table(
        f"Curve of one band ({WAVELET}, {LEVELS} levels) against pywt.wavedec2, periodization",
        ["clip", "ours", "pywt float32", "ratio (least-most)", "CPU", "pywt float64", "ratio (least-most)", "off by"],
        rows,
        f"Medians of {repetitions} interleaved repetitions, ratios pair by pair. CPU: the first ratio in processor\n"
        "  time. Off by: largest difference of a share from PyWavelets in float64. For PyWavelets the clip is\n"
        "  converted beforehand; it takes 8 and 16 bit as float64 itself.\n"
        f"  Goal at 1024 px: {WANTED} times as fast, {WANTED_ON_DEBIAN} times with the BLAS of the system's packages.",
    )
    return goals
