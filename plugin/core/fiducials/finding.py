"""Where a photo's marks are: looked for all together, named, and each measured at full resolution."""
from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Callable

import numpy as np
from scipy import ndimage

from .. import messages, thresholds
from ..errors import PhotoError
from ..messages import Message
from ..photos import Photo
from ..windows import PixelWindow
from . import lying
from .calibration import Calibration
from .lying import Evidence, Labelling, Lying
from .measuring import Found, Lost, Template, Window, aimed, levelled, measure, refined
from .results import Position, Settings
from .search import (
    Area,
    Arrangement,
    Frame,
    Place,
    Scene,
    View,
    bank,
    blocks,
    cut_out_patterns,
    find_arrangements,
    tolerance,
    whole_photo,
    windows_only,
)
from .templates import CutOut, Kind, Shape, all_shapes
from .transformations import Model, fit


@dataclass(frozen=True)
class Finding:
    """What became of the marks that were looked for."""

    results: Mapping[str, Found | Lost] = field(default_factory=dict)
    """By the calibration's names; marks with a given place are not among them."""
    template: Shape | CutOut | None = None
    """What they were measured with."""
    lying: Lying | None = None
    """How the photo lies, where the search told."""
    evidence: Evidence | None = None
    """What told."""
    notices: tuple[Message, ...] = ()
    """What the user should know."""

    @property
    def found(self) -> int:
        """How many were measured."""
        return sum(isinstance(one, Found) for one in self.results.values())


@dataclass(frozen=True)
class _Candidate:
    """Places that may be the marks."""

    frame: Frame
    arrangement: Arrangement
    template: Shape | CutOut
    fitness: float = 1.0
    """How like the figure its marks are: the median correlation, less where marks are missing."""

    @property
    def side(self) -> int:
        """Of the template, px."""
        return 2 * self.template.margin + 1 if isinstance(self.template, Shape) else min(self.template.pixels.shape)

    @property
    def weight(self) -> float:
        """How much the fit tells: the share of the pixels' variance that is left, by how many pixels there are."""
        return -math.log(max(1 - self.fitness**2, 1e-6)) * self.side**2


def find_marks(
    photo: Photo,
    calibration: Calibration,
    positions: Mapping[str, Position],
    settings: Settings,
    cancelled: Callable[[], bool],
) -> Finding:
    """Look for all marks of a calibration that have no given place.

    Raises PhotoError for positions that contradict the calibration or the photo, and for a photo without contrast.
    """
    finder = _Finder(photo, calibration, positions, settings, cancelled)
    predicted = finder.predicted_frame()
    return finder.in_whole_photo() if predicted is None else finder.around_positions(*predicted)


def window_around(photo: Photo, place: Place, half: int) -> Window:
    """The photo around a place, (2 half + 1, 2 half + 1), a little smoothed. Raises PhotoError outside the photo."""
    left, top = math.floor(place[0]) - half, math.floor(place[1]) - half
    if not (0 <= place[0] < photo.columns and 0 <= place[1] < photo.rows):
        raise PhotoError(messages.MARK_OUTSIDE())
    pixels = photo.grey(PixelWindow(left, top, 2 * half + 1, 2 * half + 1))
    return Window(ndimage.gaussian_filter(pixels, thresholds.SMOOTHING_PX), left, top)


class _Finder:
    """A photo and what is known of its marks."""

    def __init__(
        self,
        photo: Photo,
        calibration: Calibration,
        positions: Mapping[str, Position],
        settings: Settings,
        cancelled: Callable[[], bool],
    ) -> None:
        self._photo, self._calibration, self._settings, self._cancelled = photo, calibration, settings, cancelled
        self._given = {name for name, one in positions.items() if not one.measure}
        self._near = {name: one.place for name, one in positions.items()}

    # --- where to look ------------------------------------------------------------------------------------------

    def predicted_frame(self) -> tuple[Frame, float] | None:
        """All marks by the positions, and pixels per mm: three at least that are not on a line, or all; else None."""
        names = [name for name in self._calibration.marks if name in self._near]
        every = list(self._calibration.marks)
        if len(names) < 3 and len(names) != len(every):
            return None
        source = np.array([self._calibration.marks[name] for name in names])
        target = np.array([self._near[name] for name in names])
        made = fit(Model.SIMILARITY, source, target)
        scale = float(math.sqrt(abs(np.linalg.det(made.matrix[:2, :2]))))
        worst = float(np.hypot(*(made(source) - target).T).max()) / scale
        if worst > 2 * self._settings.search + thresholds.FILM_DEFORMATION * self._calibration.span:
            raise PhotoError(messages.POSITIONS_OFF(worst=worst))
        places = made(np.array([self._calibration.marks[name] for name in every]))
        places[[every.index(name) for name in names]] = target
        upright = made.matrix[:2, :2] / scale
        frame = self._calibration.points @ upright.T
        return Frame(
            tuple(every), frame, tuple(_around(place, scale * self._settings.search) for place in places),
            (0.9 * scale, 1.1 * scale), math.radians(2 * thresholds.MAX_ROTATION_DEG),
        ), scale

    def around_positions(self, frame: Frame, scale: float) -> Finding:
        """Search the surroundings of the positions, all of them together."""
        wanted = [k for k, name in enumerate(frame.marks) if name not in self._given]
        frame = Frame(
            tuple(frame.marks[k] for k in wanted), frame.places[wanted], tuple(frame.areas[k] for k in wanted),
            frame.scales, frame.rotation,
        )
        self._check_template(scale)
        candidates = self._candidates(windows_only(self._search_views(frame)), [frame])
        finding = _best((self._measured(one, scale) for one in candidates), len(frame.marks))
        return self._one_by_one(frame, scale) if finding is None else finding

    def in_whole_photo(self) -> Finding:
        """Search the whole photo; what the positions say chooses between ways to lie."""
        photo = self._photo
        made = lying.frames(self._calibration, photo.columns, photo.rows)
        scale = max(frame.scales[1] for frame in made)
        self._check_template(scale)
        factor = max(1, math.ceil(max(photo.columns, photo.rows) / thresholds.SEARCH_SIDE_PX))
        image = photo.reduced(factor)
        if np.ptp(image) == 0:
            raise PhotoError(messages.PHOTO_EMPTY(name=photo.ref.name))
        candidates = self._candidates(whole_photo(image, factor), made)
        finding = _best(map(self._named, candidates), len(made[0].marks))
        if finding is not None and finding.results:
            return finding
        alone = self._one_by_one(self._single_frame(made[0], scale), scale)
        return alone if finding is None else replace(alone, notices=finding.notices)

    def _single_frame(self, frame: Frame, scale: float) -> Frame:
        """The marks that have a position, around it; the scale is that of marks that fill the photo."""
        names = [name for name in self._near if name not in self._given]
        places = np.array([frame.places[frame.marks.index(name)] for name in names]).reshape(-1, 2)
        areas = tuple(_around(self._near[name], scale * self._settings.search) for name in names)
        return Frame(tuple(names), places, areas, frame.scales, frame.rotation)

    def _search_views(self, frame: Frame) -> list[View]:
        """The areas of a frame with room for a mark around them, reduced where they are large, all of one size."""
        room = math.ceil(thresholds.MARK_ROOM * self._calibration.span * frame.scales[1])
        side = 2 * room + max(
            math.ceil(max(area.right - area.left, area.bottom - area.top)) for area in frame.areas
        )
        step = max(1, math.ceil(side / thresholds.SEARCH_WINDOW_PX))
        side = step * math.ceil(side / step)
        made: dict[int, View] = {}
        for k in sorted(range(len(frame.areas)), key=lambda k: frame.areas[k].top):
            area = frame.areas[k]
            left, top = math.floor(area.left) - room, math.floor(area.top) - room
            if not (-side < left < self._photo.columns and -side < top < self._photo.rows):
                raise PhotoError(messages.POSITION_OUTSIDE(mark=frame.marks[k]))
            pixels = self._photo.grey(PixelWindow(left, top, side, side))
            made[k] = View(blocks(pixels, step) if step > 1 else pixels, left, top, step)
        return [made[k] for k in range(len(frame.areas))]

    def _check_template(self, scale: float) -> None:
        template = self._settings.template
        if template is None:
            return
        side, search = max(template.pixels.shape) / scale, 2 * self._settings.search
        if side > search:
            raise PhotoError(messages.TEMPLATE_TOO_LARGE(side=side, search=search))

    # --- what is there ------------------------------------------------------------------------------------------

    def _candidates(self, scene: Scene, frames: Sequence[Frame]) -> Iterator[_Candidate]:
        """Arrangements, the likeliest first: its marks, looked at closely, are most like the figure they have."""
        template = self._settings.template
        shapes = self._settings.shapes or all_shapes()
        groups = [cut_out_patterns(template)] if template is not None else [bank([shape]) for shape in shapes]
        found = find_arrangements(scene, frames, groups, self._settings.sign, self._cancelled)
        if template is not None:
            yield from (_Candidate(frame, arrangement, template) for frame, arrangement in found[:1])
            return
        worth = thresholds.WORTH_A_LOOK * found[0][1].score if found else 0.0
        looked_at = []
        for frame, arrangement in found[: thresholds.REFINED_ARRANGEMENTS]:
            if arrangement.score >= worth and arrangement.shape is not None:
                shape, fitness = self._refined(frame, arrangement, arrangement.shape, thresholds.GLANCING_SIZE_PX)
                fitness *= len(arrangement.values) / len(frame.marks)
                looked_at.append(_Candidate(frame, arrangement, shape, fitness))
        for one in _by_fitness(looked_at):
            assert isinstance(one.template, Shape)
            shape, _ = self._refined(one.frame, one.arrangement, one.template, thresholds.REFINING_SIZE_PX)
            yield replace(one, template=shape)

    def _named(self, candidate: _Candidate) -> Finding:
        """Measure the places of an arrangement and find out which mark is where; no results where that can't be."""
        frame, found = candidate.frame, candidate.arrangement
        candidates = lying.labellings(self._calibration, frame, found)
        evidence = Evidence.MARKS
        if self._near:
            candidates = lying.by_positions(candidates, self._near, found.scale * self._settings.search)
            evidence = Evidence.POSITIONS
            if not candidates:
                return Finding(notices=(messages.ARRANGEMENT_NOT_AT_POSITIONS(),))
        measured = self._measured(candidate, found.scale)
        chosen, evidence, notices = self._decide(candidates, measured, candidate, evidence)
        results = {mark: measured.results[site] for mark, site in chosen.sites.items() if site in measured.results}
        return Finding(results, candidate.template, chosen.lying, evidence, notices)

    def _decide(
        self, candidates: Sequence[Labelling], measured: Finding, candidate: _Candidate, evidence: Evidence
    ) -> tuple[Labelling, Evidence, tuple[Message, ...]]:
        """The way to name the marks that the photo itself tells, what told it, and what is to be said of it."""
        places = {name: (one.column, one.row) for name, one in measured.results.items() if isinstance(one, Found)}
        photo, found = self._photo, candidate.arrangement
        tests: tuple[tuple[Evidence, Callable[[Sequence[Labelling]], list[Labelling]]], ...] = (
            (Evidence.DOTS, lambda some: lying.by_dots(some, self._dots(places, candidate))),
            (
                Evidence.DATA_STRIP,
                lambda some: lying.by_data_strip(some, self._calibration, found, photo.columns, photo.rows),
            ),
            (
                Evidence.RESIDUALS,
                lambda some: lying.by_residuals(some, self._calibration, places, self._settings.model),
            ),
        )
        for kind, test in tests:
            if len(candidates) == 1:
                break
            left = test(candidates)
            if left:
                candidates, evidence = left, kind
        plain = min(candidates, key=lambda one: (one.lying.mirrored, one.lying.turned))
        if len(candidates) > 2 or (len(candidates) == 2 and evidence is not Evidence.DATA_STRIP):
            return plain, Evidence.ASSUMED, (messages.LYING_ASSUMED(),)
        return plain, evidence, ()

    def _dots(self, places: Mapping[str, Place], candidate: _Candidate) -> dict[str, int]:
        template, found = candidate.template, candidate.arrangement
        radius = template.size / 2 if isinstance(template, Shape) else min(template.pixels.shape) / 4
        counts = {}
        for name, place in places.items():
            window = window_around(self._photo, place, math.ceil(2.6 * radius))
            count = lying.count_dots(found.sign * window.pixels, radius, found.angle)
            if count:
                counts[name] = count
        return counts

    def _measured(self, candidate: _Candidate, scale: float) -> Finding:
        """Every mark of a frame at full resolution, those that were not among the arrangement's places too."""
        frame, found = candidate.frame, candidate.arrangement
        sites = {name: (float(x), float(y)) for name, (x, y) in zip(frame.marks, frame.places)}
        results = {}
        for name in sorted(sites, key=lambda one: found.places.get(one, (0, 0))[1]):
            if name in found.places:
                near, reach = found.places[name], 2 * found.uncertainty + 2
            else:
                x, y = found.matrix @ np.append(sites[name], 1.0)
                near, reach = (float(x), float(y)), tolerance(frame, found.uncertainty) + 2
            mark = candidate.template
            if isinstance(mark, Shape):
                mark = aimed(mark, sites[name], found.angle)
            results[name] = self._measured_mark(Template(mark, found.sign), mark, near, reach, scale)
        return Finding(results, candidate.template)

    def _measured_mark(
        self, template: Template, mark: Shape | CutOut, near: Place, reach: float, scale: float
    ) -> Found | Lost:
        around = max(reach, thresholds.DISTINCT_SHARE * template.size)
        if not (isinstance(mark, Shape) and mark.kind is Kind.DOT):  # dots there are in every picture
            around = max(around, thresholds.DISTINCT_FRAME_SHARE * self._calibration.span * scale)
        half = math.ceil(around) + max(template.at((0.0, 0.0)).shape) // 2 + 1
        try:
            window = window_around(self._photo, near, half)
        except PhotoError as error:
            return Lost(error.message)
        return measure(window, near, reach, template, self._settings.least, self._settings.surface)

    def _refined(self, frame: Frame, found: Arrangement, begin: Shape, finest: float) -> tuple[Shape, float]:
        """The drawn mark fitted to the photo's marks, and how well it fits."""
        half = math.ceil(1.7 * begin.size + 2 * found.uncertainty + 4)
        windows = {
            name: levelled(window_around(self._photo, place, half)) for name, place in found.places.items()
        }
        places = {name: (float(x), float(y)) for name, (x, y) in zip(frame.marks, frame.places)}
        return refined(windows, places, begin, found.sign, found.angle, finest)

    def _one_by_one(self, frame: Frame, scale: float) -> Finding:
        """No arrangement was found: every mark on its own, where it has a position."""
        results: dict[str, Found | Lost] = {}
        template: Shape | CutOut | None = self._settings.template
        for k, name in enumerate(frame.marks):
            single = Frame((name,), frame.places[k : k + 1], (frame.areas[k],), frame.scales, frame.rotation)
            candidate = next(self._candidates(windows_only(self._search_views(single)), [single]), None)
            if candidate is None:
                results[name] = Lost(messages.MARK_NOT_SEEN())
                continue
            template = candidate.template
            results.update(self._measured(candidate, scale).results)
        return Finding(results, template)


def _best(findings: Iterable[Finding], marks: int) -> Finding | None:
    """The first with enough marks to support each other; where none has, the first of all, which says why."""
    first: Finding | None = None
    for one in findings:
        if one.found >= min(thresholds.MIN_SUPPORT, marks):
            return one
        if first is None:
            first = one
    return first


def _by_fitness(looked_at: Sequence[_Candidate]) -> Iterator[_Candidate]:
    """The best fitting first; of figures at the same places a larger one that fits nearly as well goes before it.

    The small figure may be a part of the large one, a dot of a ring with a dot, which explains more of the pixels.
    """
    left = sorted(looked_at, key=lambda one: -one.fitness)
    while left:
        best = left[0]
        least = best.fitness - thresholds.NEARLY_AS_FIT
        same = [one for one in left if _at_one_place(one, best)]
        left = [one for one in left if one not in same]
        yield from sorted(same, key=lambda one: (one.fitness >= least, one.weight), reverse=True)


def _at_one_place(one: _Candidate, other: _Candidate) -> bool:
    a, b = one.arrangement.places, other.arrangement.places
    distances = [math.dist(a[name], b[name]) for name in a if name in b]
    return bool(distances) and float(np.median(distances)) <= max(one.side, other.side) / 2


def _around(place: Place, reach: float) -> Area:
    return Area(place[0] - reach, place[1] - reach, place[0] + reach, place[1] + reach)
