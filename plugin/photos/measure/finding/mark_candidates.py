"""Places in a photo that may be its marks, the likeliest first."""
from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from typing import Callable

import numpy as np

from ..arrangements import Arrangement, FramedArrangement, find_arrangements
from ..mark_patterns import cut_out_patterns, drawn_patterns
from ..mark_templates import CutOut, MarkShape, all_shapes
from ..measuring_marks import window_around
from ..orientation import OrientationSettings
from ..photo import Photo
from ..photo_views import MarkFrame, Scene
from .refining_shapes import refine_shape, without_plane

REFINING_SIZE_PX = 40.0  # of a mark while its figure is fitted: larger ones are reduced for it
GLANCING_SIZE_PX = 20.0  # the same while figures are compared
REFINED_ARRANGEMENTS = 5  # looked at closely, of one for each figure
WORTH_A_LOOK = 0.75  # of the best arrangement's sum of correlations
NEARLY_AS_FIT = 0.15  # correlation below the best figure's: among these the one that explains most pixels is the mark


@dataclass(frozen=True, eq=False)
class Candidate:
    """Places that may be the marks."""

    frame: MarkFrame
    arrangement: Arrangement
    template: MarkShape | CutOut
    fitness: float = 1.0
    """How like the figure its marks are: the median correlation, less where marks are missing."""
    others: tuple[FramedArrangement, ...] = ()
    """What looks alike and lies as the calibration says when it is turned another way."""

    @property
    def side(self) -> int:
        """Of the template, px."""
        return 2 * self.template.margin + 1 if isinstance(self.template, MarkShape) else min(self.template.pixels.shape)

    @property
    def weight(self) -> float:
        """How much the fit tells: the share of the pixels' variance that is left, by how many pixels there are."""
        return -math.log(max(1 - self.fitness**2, 1e-6)) * self.side**2


def candidates(
    photo: Photo,
    scene: Scene,
    frames: Sequence[MarkFrame],
    settings: OrientationSettings,
    cancelled: Callable[[], bool],
) -> Iterator[Candidate]:
    """Arrangements, the likeliest first: its marks, looked at closely, are most like the figure they have."""
    template = settings.template
    shapes = settings.shapes or all_shapes()
    groups = [cut_out_patterns(template)] if template is not None else [drawn_patterns([shape]) for shape in shapes]
    found = find_arrangements(scene, frames, groups, settings.sign, cancelled)
    if template is not None:
        yield from (Candidate(*best, template, others=tuple(others)) for best, *others in found[:1])
        return
    worth = WORTH_A_LOOK * found[0][0][1].score if found else 0.0
    looked_at = []
    for (frame, arrangement), *others in found[: REFINED_ARRANGEMENTS]:
        if arrangement.score >= worth and arrangement.shape is not None:
            shape, fitness = _refined(photo, frame, arrangement, arrangement.shape, GLANCING_SIZE_PX)
            fitness *= len(arrangement.values) / len(frame.marks)
            looked_at.append(Candidate(frame, arrangement, shape, fitness, tuple(others)))
    for one in _by_fitness(looked_at):
        assert isinstance(one.template, MarkShape)
        shape, _ = _refined(photo, one.frame, one.arrangement, one.template, REFINING_SIZE_PX)
        yield replace(one, template=shape)


def _refined(
    photo: Photo, frame: MarkFrame, found: Arrangement, begin: MarkShape, finest: float
) -> tuple[MarkShape, float]:
    """The drawn mark fitted to the photo's marks, and how well it fits."""
    half = math.ceil(1.7 * begin.size + 2 * found.uncertainty + 4)
    windows = {name: without_plane(window_around(photo, place, half)) for name, place in found.places.items()}
    places = {name: (float(x), float(y)) for name, (x, y) in zip(frame.marks, frame.places)}
    return refine_shape(windows, places, begin, found.sign, found.angle, finest)


def _by_fitness(looked_at: Sequence[Candidate]) -> Iterator[Candidate]:
    """The best fitting first; of figures at the same places a larger one that fits nearly as well goes before it.

    The small figure may be a part of the large one, a dot of a ring with a dot, which explains more of the pixels.
    """
    left = sorted(looked_at, key=lambda one: -one.fitness)
    while left:
        best = left[0]
        least = best.fitness - NEARLY_AS_FIT
        same = [one for one in left if _at_one_place(one, best)]
        left = [one for one in left if one not in same]
        yield from sorted(same, key=lambda one: (one.fitness >= least, one.weight), reverse=True)


def _at_one_place(one: Candidate, other: Candidate) -> bool:
    a, b = one.arrangement.places, other.arrangement.places
    distances = [math.dist(a[name], b[name]) for name in a if name in b]
    return bool(distances) and float(np.median(distances)) <= max(one.side, other.side) / 2
