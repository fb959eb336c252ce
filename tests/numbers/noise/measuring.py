"""Noise of windows as a run measures it."""
from __future__ import annotations

from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor

from seam_inspector.plugin.noise.measure import group_noise
from seam_inspector.plugin.noise.measure.group_noise import ClipNoise
from seam_inspector.plugin.noise.measure.noise_plan import NoiseRequest


def measured(requests: Sequence[NoiseRequest], levels: int = 3) -> list[ClipNoise]:
    """Noise of every image in every window, in their order."""
    with ThreadPoolExecutor(2) as executor:
        results = group_noise.measure_requests(requests, "coif3", levels, executor, 3)
        return [clip for clips in results for clip in clips]
