"""A window of the benchmark of the detection that is made up: two images of one scene, cut from top to bottom."""
from __future__ import annotations

import numpy as np

from benchmarks.known_windows import KnownWindow
from tests.numbers.synthetic import orthoimage


def made_up_window(side: int) -> KnownWindow:
    """A window of ``side`` px."""
    scene = orthoimage((side, side)) // 2
    sources = tuple(scene + orthoimage((side, side), seed=seed) // 2 for seed in (1, 2))
    labels = (np.arange(side) >= side // 2)[np.newaxis].repeat(side, axis=0).astype(np.uint8)
    return KnownWindow("made up", 0, False, 0.1, side, sources, (np.ones((side, side), bool),) * 2, labels)
