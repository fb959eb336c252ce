"""Candidates for the marks of a calibration in a photo that nobody looked at, and their arrangement.

Marks are looked for coarse to fine: figures of a few sizes are correlated with the photo at an eighth of the search
resolution, at a quarter, and so on. Of all candidates those are taken that lie as the calibration says, shifted,
turned a little and scaled: four places in the right arrangement by chance are far rarer than four places that look
like a mark. What is drawn is then fitted to the marks, and the arrangement whose figure fits best is the likeliest.
"""
from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import combinations
from typing import Callable

import numpy as np

from . import limits
from .correlation import CorrelatedImage, Peak, peaks
from .mark_templates import CutOut, MarkShape, Pattern, all_shapes, draw, patterns, wedge_to_middle
from .measuring_marks import window_around, without_slope
from .photo import MarkFrame, Photo, PhotoView, Place, Scene, SearchArea, block_means
from .transformations import fit_transformation

CANDIDATES = 10  # a mark, a figure and a size: places that look alike in a search area
MIN_CANDIDATE_CORRELATION = 0.4  # of a coarse figure whose size may be off by 10 %
SURE_CORRELATION = 0.6  # mean of four marks in the right arrangement at one level
ARRANGEMENT_LEVEL_PX = 1.5  # a candidate's place at its level
ARRANGEMENT_PAIRS = 6  # all pairs of four marks, the widest of eight
TELLING_PIXEL_MM = 0.2  # a ring of 2 mm is ten pixels wide
REFINING_SIZES = (0.87, 0.93, 1.0, 1.07, 1.15)  # against the coarse size, which is good to 10 %
REFINING_ROUNDS = 6
REFINING_SIZE_PX = 40.0  # of a mark while its figure is fitted: larger ones are reduced for it
GLANCING_SIZE_PX = 20.0  # the same while figures are compared
REFINED_ARRANGEMENTS = 5  # looked at closely, of one for each figure
WORTH_A_LOOK = 0.75  # of the best arrangement's sum of correlations
NEARLY_AS_FIT = 0.15  # correlation below the best figure's: among these the one that explains most pixels is the mark


@dataclass(frozen=True, eq=False)
class Arrangement:
    """Candidates that lie as the calibration says."""

    frame: MarkFrame  # the frame as which they lie
    shape: MarkShape | None  # what they look like, in pixels of the photo; None for a user's template
    sign: int  # 1 where the marks are as the template, -1 where they are its negative
    places: Mapping[str, Place]  # the candidates by mark
    values: Mapping[str, float]  # their correlations, positive
    matrix: np.ndarray  # (2, 3): mm, as in the frame, to columns and rows
    uncertainty: float = 1.0  # how far a place may be off, px: a pixel of the level it was found at

    @property
    def score(self) -> float:
        return float(sum(self.values.values()))

    @property
    def is_sure(self) -> bool:
        """Whether it can't be chance: four marks at least, each a good fit."""
        return len(self.values) >= 4 and self.score / len(self.values) >= SURE_CORRELATION

    @property
    def angle(self) -> float:
        return math.degrees(math.atan2(self.matrix[1, 0], self.matrix[0, 0]))

    @property
    def scale(self) -> float:
        return float(math.hypot(self.matrix[0, 0], self.matrix[1, 0]))

    @property
    def reach(self) -> float:
        """The distance that a mark may lie from where the others want it, px."""
        return placing_tolerance(self.frame, self.uncertainty)

    def predicted(self, places: np.ndarray) -> list[Place]:
        """Columns and rows in the photo of places of the frame, (n, 2) mm."""
        return [(float(x), float(y)) for x, y in np.column_stack([places, np.ones(len(places))]) @ self.matrix.T]


def find_arrangements(
    scene: Scene, frames: Sequence[MarkFrame], marks: Sequence[MarkShape | CutOut], sign: int | None = None,
    cancelled: Callable[[], bool] = lambda: False,
) -> list[list[Arrangement]]:
    """The arrangements of each kind of marks, the best kind and its best first: one at most for each frame.

    A calibration that looks different when it is turned has several frames, and a photo may hold marks for more than
    one of them. A kind of which nothing fits together is left out.

    Levels are taken coarse to fine. The search ends at the first level that has a sure arrangement, not before a
    level at which a mark can be told from the frame's own corners. ``sign`` is as in ``Arrangement``, None for
    either.
    """
    best: list[dict[int, Arrangement]] = [{} for _ in marks]
    signs = (1, -1) if sign is None else (sign,)
    for at_level in zip(*[scene(frame) for frame in frames]):
        for way, (frame, views) in enumerate(zip(frames, at_level)):
            images = [CorrelatedImage(view.pixels, np.float32) for view in views]
            for mark, ways in zip(marks, best):
                if cancelled():
                    return []
                arrangement = _at_level(views, images, frame, mark, signs)
                if arrangement is not None and (way not in ways or arrangement.score > ways[way].score):
                    ways[way] = arrangement
        width = at_level[0][0].factor / frames[0].scales[1]
        if width <= TELLING_PIXEL_MM and any(arrangement.is_sure for ways in best for arrangement in ways.values()):
            break
    kinds = [sorted(ways.values(), key=lambda arrangement: -arrangement.score) for ways in best if ways]
    return sorted(kinds, key=lambda kind: -kind[0].score)


def _at_level(
    views: Sequence[PhotoView], images: Sequence[CorrelatedImage], frame: MarkFrame, mark: MarkShape | CutOut,
    signs: Sequence[int],
) -> Arrangement | None:
    factor = views[0].factor
    runs = [patterns(mark, factor, (float(x), float(y))) for x, y in frame.places]
    best: Arrangement | None = None
    for row in zip(*runs):
        places = [
            _candidates(image.correlate(pattern.pixels), pattern, view, area)
            for image, pattern, view, area in zip(images, row, views, frame.areas)
        ]
        for sign in signs:
            lists = [[peak for peak in peaks_of_mark if sign * peak.value > 0] for peaks_of_mark in places]
            arranged = best_arrangement(frame, lists, placing_tolerance(frame, factor))
            if arranged is not None and (best is None or arranged.score > best.score):
                shape = row[0].shape
                scaled = shape.scaled(factor) if shape else None
                best = replace(arranged, sign=sign, shape=scaled, uncertainty=factor)
    return best


def placing_tolerance(frame: MarkFrame, factor: float) -> float:
    """The distance, px, that a candidate may lie from where the others want it: the level's pixels and the film's."""
    span = float(np.ptp(frame.places, axis=0).max())
    return ARRANGEMENT_LEVEL_PX * factor + limits.FILM_DEFORMATION * span * frame.scales[1]


def _candidates(field: np.ndarray, pattern: Pattern, view: PhotoView, area: SearchArea) -> list[Peak]:
    """The best places in an area; the view may reach further, so that the template has room."""
    if field.size == 0:
        return []
    x, y = pattern.centre
    columns = view.left + (np.arange(field.shape[1]) + x) * view.factor
    rows = view.top + (np.arange(field.shape[0]) + y) * view.factor
    across = (columns >= area.left - view.factor) & (columns <= area.right + view.factor)
    down = (rows >= area.top - view.factor) & (rows <= area.bottom + view.factor)
    field = np.where(down[:, np.newaxis] & across, field, 0.0)
    distance = max(2, min(pattern.pixels.shape) // 3)
    return [
        Peak(view.left + (peak.column + x) * view.factor, view.top + (peak.row + y) * view.factor, peak.value)
        for peak in peaks(field, distance, MIN_CANDIDATE_CORRELATION, CANDIDATES)
    ]


def best_arrangement(frame: MarkFrame, candidates: Sequence[Sequence[Peak]], reach: float) -> Arrangement | None:
    """The candidates that fit best together, the more marks the better; None for fewer than three (or all, of two). A
    single mark's best candidate is taken as it is. Every pair of candidates of two marks gives a shift, a rotation and
    a scale, which say where the others are.

    ``candidates``: the peaks that may be each mark of the frame (columns and rows in the photo). ``reach``: how far one
    may lie from where the pair puts it, px.
    """
    count = len(frame.marks)
    if count == 1:
        return _single(frame, candidates[0])
    mm = frame.places[:, 0] + 1j * frame.places[:, 1]
    px = [np.array([complex(peak.column, peak.row) for peak in of_mark]) for of_mark in candidates]
    values = [np.array([abs(peak.value) for peak in of_mark]) for of_mark in candidates]
    pairs = sorted(combinations(range(count), 2), key=lambda pair: -abs(mm[pair[0]] - mm[pair[1]]))
    best: tuple[float, dict[int, int]] | None = None
    for i, j in pairs[:ARRANGEMENT_PAIRS]:
        if not len(px[i]) or not len(px[j]):
            continue
        turn = (px[j][np.newaxis] - px[i][:, np.newaxis]) / (mm[j] - mm[i])
        usable = (np.abs(turn) >= frame.scales[0]) & (np.abs(turn) <= frame.scales[1])
        usable &= np.abs(np.angle(turn)) <= frame.rotation
        for a, b in zip(*np.nonzero(usable)):
            fitting = {i: int(a), j: int(b)}
            shift = px[i][a] - turn[a, b] * mm[i]
            for k in range(count):
                if k in fitting or not len(px[k]):
                    continue
                distances = np.abs(px[k] - (turn[a, b] * mm[k] + shift))
                near = np.where(distances <= reach, values[k], -1.0)
                if near.max() > 0:
                    fitting[k] = int(near.argmax())
            score = float(sum(values[k][index] for k, index in fitting.items()))
            if len(fitting) >= min(count, 3) and (best is None or score > best[0]):
                best = score, fitting
    if best is None:
        return None
    chosen = {frame.marks[k]: candidates[k][index] for k, index in best[1].items()}
    places = {mark: (peak.column, peak.row) for mark, peak in chosen.items()}
    source, target = frame.places[list(best[1])], np.array(list(places.values()))
    matrix = fit_transformation(limits.SIMILARITY, source, target, mirrored=False).matrix[:2]
    return Arrangement(frame, None, 1, places, {mark: abs(peak.value) for mark, peak in chosen.items()}, matrix)


def _single(frame: MarkFrame, candidates: Sequence[Peak]) -> Arrangement | None:
    if not candidates:
        return None
    best, mark, scale = candidates[0], frame.marks[0], frame.scales[1]
    shift = np.array([best.column, best.row]) - scale * frame.places[0]
    matrix = np.column_stack([scale * np.eye(2), shift])
    return Arrangement(frame, None, 1, {mark: (best.column, best.row)}, {mark: abs(best.value)}, matrix)


def _refined(photo: Photo, arrangement: Arrangement, begin: MarkShape, finest: float) -> tuple[MarkShape, float]:
    """The drawn mark that correlates best with a photo's marks, in pixels of the photo, and its median correlation.
    ``begin`` has a size good to 15 %. A mark wider than ``finest`` px is reduced to about that, which is faster."""
    half = math.ceil(1.7 * begin.size + 2 * arrangement.uncertainty + 4)
    sites = arrangement.frame.sites
    step = max(1, round(begin.size / finest))
    images = {}
    for mark, place in arrangement.places.items():
        pixels = without_slope(window_around(photo, place, half).pixels)
        images[mark] = CorrelatedImage(arrangement.sign * block_means(pixels, step))

    def fitness(shape: MarkShape) -> float:
        best = []
        for mark, image in images.items():
            values = image.correlate(draw(turned_with_frame(shape, sites[mark], arrangement.angle)))
            best.append(float(values.max()) if values.size else -1.0)
        return float(np.median(best))

    shapes = enumerate(_first_shapes(begin.scaled(1 / step)))
    best, _, shape = max((fitness(shape), number, shape) for number, shape in shapes)
    for _ in range(REFINING_ROUNDS):
        before = best
        for other in _similar_shapes(shape):
            value = fitness(other)
            if value > best:
                best, shape = value, other
        if best - before < 1e-3:
            break
    return shape.scaled(step), best


def turned_with_frame(shape: MarkShape, place: Place, angle: float) -> MarkShape:
    """A shape as it stands in a frame turned by an angle: a wedge looks to the middle."""
    turned = wedge_to_middle(shape, place)
    return replace(turned, angle=turned.angle + angle)


def _first_shapes(shape: MarkShape) -> Iterator[MarkShape]:
    for factor in REFINING_SIZES:
        sized = replace(shape, size=shape.size * factor, softness=0.8)
        if shape.kind in (limits.DOT, limits.WEDGE):
            yield sized
            continue
        for width in (0.06, 0.12):
            yield replace(sized, width=width)
            if shape.kind == limits.RING_WITH_CROSS:
                yield replace(sized, width=width, reach=1.6)


def _similar_shapes(shape: MarkShape) -> Iterator[MarkShape]:
    for factor in (0.95, 1.05, 0.98, 1.02):
        yield replace(shape, size=shape.size * factor)
    for factor in (0.8, 1.25):
        yield replace(shape, softness=min(max(shape.softness * factor, limits.PIXEL_SOFTNESS), shape.size / 4))
        yield replace(shape, width=min(max(shape.width * factor, 0.02), 0.3))
    if shape.kind in (limits.CROSS, limits.RING_WITH_CROSS):
        yield replace(shape, interrupted=not shape.interrupted)
    if shape.kind == limits.RING_WITH_CROSS:
        for reach in (1.0, 1.4, 1.8):
            yield replace(shape, reach=reach)


@dataclass(frozen=True, eq=False)
class Candidate:
    """Places that may be the marks."""

    arrangement: Arrangement
    template: MarkShape | CutOut
    fitness: float = 1.0  # how like the figure its marks are: the median correlation, less where marks are missing
    others: tuple[Arrangement, ...] = ()  # of the same figure, for the calibration turned another way

    @property
    def side(self) -> int:
        return 2 * self.template.margin + 1 if isinstance(self.template, MarkShape) else min(self.template.pixels.shape)

    @property
    def weight(self) -> float:
        """Evidence of the fit: the share of the pixels' variance that it leaves, by the number of pixels."""
        return -math.log(max(1 - self.fitness**2, 1e-6)) * self.side**2

    def is_where(self, other: Candidate) -> bool:
        """Whether the marks of another candidate lie at the same places."""
        places, others = self.arrangement.places, other.arrangement.places
        distances = [math.dist(places[name], others[name]) for name in places if name in others]
        return bool(distances) and float(np.median(distances)) <= max(self.side, other.side) / 2


def candidates(
    photo: Photo, scene: Scene, frames: Sequence[MarkFrame], template: CutOut | None, shapes: Sequence[MarkShape],
    sign: int | None, cancelled: Callable[[], bool],
) -> Iterator[Candidate]:  # fmt: skip
    """Arrangements, the likeliest first: its marks, looked at closely, are most like the figure they have."""
    marks = [template] if template is not None else shapes or all_shapes()
    kinds = find_arrangements(scene, frames, marks, sign, cancelled)
    if template is not None:
        yield from (Candidate(best, template, others=tuple(others)) for best, *others in kinds[:1])
        return
    worth = WORTH_A_LOOK * kinds[0][0].score if kinds else 0.0
    looked_at = []
    for arrangement, *others in kinds[:REFINED_ARRANGEMENTS]:
        if arrangement.score >= worth and arrangement.shape is not None:
            shape, fitness = _refined(photo, arrangement, arrangement.shape, GLANCING_SIZE_PX)
            fitness *= len(arrangement.values) / len(arrangement.frame.marks)
            looked_at.append(Candidate(arrangement, shape, fitness, tuple(others)))
    for candidate in _by_fitness(looked_at):
        assert isinstance(candidate.template, MarkShape)
        shape, _ = _refined(photo, candidate.arrangement, candidate.template, REFINING_SIZE_PX)
        yield replace(candidate, template=shape)


def _by_fitness(looked_at: Sequence[Candidate]) -> Iterator[Candidate]:
    """The best fitting first; of figures at the same places a larger one that fits nearly as well goes before it. The
    small figure may be a part of the large one, a dot of a ring with a dot, which explains more of the pixels."""
    waiting = sorted(looked_at, key=lambda candidate: -candidate.fitness)
    while waiting:
        best = waiting[0]
        least = best.fitness - NEARLY_AS_FIT
        same = [candidate for candidate in waiting if candidate.is_where(best)]
        waiting = [candidate for candidate in waiting if candidate not in same]
        yield from sorted(same, key=lambda candidate: (candidate.fitness >= least, candidate.weight), reverse=True)
