"""Where a photo's marks are: looked for all together, named, and each measured at full resolution."""
from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from itertools import islice

import numpy as np

from ...imagery.errors import Message, PhotoError
from ...imagery.grids import PixelWindow
from . import limits, messages, scan_orientation
from .arrangements import Candidate, candidates, placing_tolerance, turned_with_frame
from .camera_calibration import CameraCalibration
from .correlation import correlate, peak_pixel, peaks
from .mark_templates import CutOut, MarkKind, MarkShape
from .measuring_marks import MeasuredMark, MeasuringTemplate, UnmeasuredMark, measure_mark, window_around
from .orientation import FoundMarks, GivenPosition, OrientationSettings
from .photo import MarkFrame, Photo, Place, ReducedView, Scene, SearchArea, block_means, whole_photo_views, window_views
from .scan_orientation import Labelling, OrientationEvidence
from .transformations import PlaneModel, fit_transformation

COARSE_TEMPLATE_PX = 10  # of the shorter side while the photo is searched
LOOKED_AT = 12  # places that look alike there
MIN_LOOK = 0.5  # of them: reduced on other pixel bounds than the photo, a cut-out still fits itself so well
SAME_PIXELS = 0.98  # correlation of a piece of the photo with itself, stored anew with loss


def own_place(photo: Photo, template: CutOut, coarsest: int) -> Place | None:
    """Column and row of the mark that a template was cut out of; None where it is from another photo.

    The photo is searched reduced by ``coarsest`` at least.
    """
    rows, columns = template.pixels.shape
    step = max(min(rows, columns) // COARSE_TEMPLATE_PX, coarsest)
    reduced = block_means(template.pixels, step)
    if min(reduced.shape) < limits.MIN_TEMPLATE_PX or np.ptp(reduced) == 0:
        return None
    field = correlate(photo.reduced(step), reduced)
    best: tuple[float, Place] | None = None
    for peak in peaks(np.maximum(field, 0), 2, MIN_LOOK, LOOKED_AT):
        left, top = round(peak.column * step) - step, round(peak.row * step) - step
        around = photo.grey(PixelWindow(left, top, columns + 2 * step, rows + 2 * step))
        fine = correlate(around, template.pixels)
        row, column = peak_pixel(fine)
        if fine[row, column] >= SAME_PIXELS and (best is None or fine[row, column] > best[0]):
            best = float(fine[row, column]), (left + column + template.centre[0], top + row + template.centre[1])
    return None if best is None else best[1]


def near_own_mark(place: Place | None, other: Place, reach: float) -> bool:
    """Whether a place is known and within reach (px) of another."""
    return place is not None and math.dist(place, other) <= reach


@dataclass(frozen=True, eq=False)
class MeasuredFrame:
    """Places that may be the marks, and what measuring them gave."""

    candidate: Candidate
    marks: FoundMarks
    """By the names of the frame."""


def name_marks(
    photo: Photo,
    calibration: CameraCalibration,
    positions: Mapping[str, GivenPosition],
    settings: OrientationSettings,
    frames: Sequence[MeasuredFrame],
) -> FoundMarks:
    """The marks by their own names, and how the photo lies; no results where none lie at the positions.

    A given place may be wrong: it counts where it agrees with all others, and is judged with the measured ones later.
    ``frames`` are the likeliest one and, for a calibration that looks different when it is turned, the others that
    the photo holds marks for too.
    """
    namer = _Namer(photo, calibration, settings, frames)
    found = frames[0].candidate.arrangement
    named, evidence = namer.labellings(), OrientationEvidence.MARKS
    reach = found.scale * settings.search_mm
    approximate = {name: one for name, one in positions.items() if one.measure}
    for some in (positions, approximate):
        near = {name: one.place for name, one in some.items()}
        at_positions = scan_orientation.matching_positions(named, near, reach)
        if at_positions:
            named, evidence = at_positions, OrientationEvidence.POSITIONS if near else evidence
            break
    else:
        return FoundMarks(notices=(messages.ARRANGEMENT_NOT_AT_POSITIONS(),))
    chosen, evidence, notices = namer.decide(named, evidence)
    results = {mark: namer.results[site] for mark, site in chosen.sites.items() if site in namer.results}
    return FoundMarks(results, frames[0].candidate.template, chosen.orientation, evidence, notices)


class _Namer:
    """Places in a photo, each measured once though several frames may have a mark there."""

    def __init__(
        self, photo: Photo, calibration: CameraCalibration, settings: OrientationSettings,
        frames: Sequence[MeasuredFrame],
    ) -> None:
        self._photo, self._calibration, self._settings, self._frames = photo, calibration, settings, frames
        self._sites: list[dict[str, str]] = []
        """For each frame the place that each of its marks lies at."""
        self.results: dict[str, MeasuredMark | UnmeasuredMark] = {}
        """What was measured, by place."""
        for number, frame in enumerate(frames):
            self._sites.append({mark: self._site(mark, number, one) for mark, one in frame.marks.results.items()})

    def _site(self, mark: str, number: int, result: MeasuredMark | UnmeasuredMark) -> str:
        for site, known in self.results.items():
            if isinstance(known, MeasuredMark) and isinstance(result, MeasuredMark) and _at_one_place(known, result):
                return site
        made = f"{number} {mark}"
        self.results[made] = result
        return made

    def labellings(self) -> list[Labelling]:
        """All ways to name the places that the calibration allows."""
        return [
            replace(one, sites={mark: sites[site] for mark, site in one.sites.items() if site in sites})
            for frame, sites in zip(self._frames, self._sites)
            for one in scan_orientation.labellings(
                self._calibration, frame.candidate.frame, frame.candidate.arrangement
            )
        ]

    def decide(
        self, named: Sequence[Labelling], evidence: OrientationEvidence
    ) -> tuple[Labelling, OrientationEvidence, tuple[Message, ...]]:
        """The way to name the marks that the photo itself tells, what told it, and what is to be said of it."""
        for kind, test in self._tests():
            if len(named) == 1:
                break
            left = test(named)
            if left and len(left) < len(named):
                named, evidence = left, kind
        plain = min(named, key=lambda one: (one.orientation.mirrored, one.orientation.turned))
        if len(named) > 2 or (len(named) == 2 and evidence is not OrientationEvidence.DATA_STRIP):
            return plain, OrientationEvidence.ASSUMED, (messages.SCAN_ORIENTATION_ASSUMED(),)
        return plain, evidence, ()

    def _tests(
        self
    ) -> Iterator[tuple[OrientationEvidence, Callable[[Sequence[Labelling]], list[Labelling]]]]:
        measured = {site: one for site, one in self.results.items() if isinstance(one, MeasuredMark)}
        places = {site: (one.column, one.row) for site, one in measured.items()}
        size, found = (self._photo.columns, self._photo.rows), self._frames[0].candidate.arrangement
        yield OrientationEvidence.DOTS, lambda some: scan_orientation.matching_dots(some, self._dot_counts(places))
        yield OrientationEvidence.MARKS, lambda some: scan_orientation.matching_count(some, places)
        yield OrientationEvidence.DATA_STRIP, lambda some: scan_orientation.matching_data_strip(
            some, self._calibration, found, *size
        )
        yield OrientationEvidence.RESIDUALS, lambda some: scan_orientation.matching_residuals(
            some, self._calibration, places, self._settings.model
        )

    def _dot_counts(self, places: Mapping[str, Place]) -> dict[str, int]:
        candidate = self._frames[0].candidate
        template, found = candidate.template, candidate.arrangement
        radius = template.size / 2 if isinstance(template, MarkShape) else min(template.pixels.shape) / 4
        counts = {}
        for site, place in places.items():
            window = window_around(self._photo, place, math.ceil(2.6 * radius))
            count = scan_orientation.count_numbering_dots(found.sign * window.pixels, radius, found.angle)
            if count:
                counts[site] = count
        return counts


def _at_one_place(one: MeasuredMark, other: MeasuredMark) -> bool:
    return math.dist((one.column, one.row), (other.column, other.row)) < limits.ONE_PLACE_PX


SEARCH_SIDE_PX = 3000  # the longer side of the photo for the first search: 80 um on a 23 cm photo
SEARCH_WINDOW_PX = 768  # of a search window at its finest: larger ones are reduced
SCALE_RANGE = (0.9, 1.1)  # against the scale that the positions imply, roughly placed as they are
DISTINCT_SHARE = 1.5  # of a mark's size: so far around it nothing may look alike
DISTINCT_FRAME_SHARE = 0.03  # of the frame: 6 mm on 23 cm, so that an arm's end is told from its counterpart
MARK_ROOM = 0.05  # of the frame: around a search area, so that a mark at its edge is seen whole


def find_marks(
    photo: Photo,
    calibration: CameraCalibration,
    positions: Mapping[str, GivenPosition],
    settings: OrientationSettings,
    cancelled: Callable[[], bool],
) -> FoundMarks:
    """Look for all marks of a calibration that have no given place.

    Raises PhotoError for positions that contradict the calibration or the photo, and for a photo without contrast.
    """
    finder = _Finder(photo, calibration, positions, settings, cancelled)
    predicted = finder.predicted_frame()
    return finder.in_whole_photo() if predicted is None else finder.around_positions(*predicted)


class _Finder:
    """A photo and what is known of its marks."""

    def __init__(
        self,
        photo: Photo,
        calibration: CameraCalibration,
        positions: Mapping[str, GivenPosition],
        settings: OrientationSettings,
        cancelled: Callable[[], bool],
    ) -> None:
        self._photo, self._calibration, self._settings, self._cancelled = photo, calibration, settings, cancelled
        self._positions = positions
        self._given = {name for name, one in positions.items() if not one.measure}
        self._near = {name: one.place for name, one in positions.items()}

    # --- where to look ------------------------------------------------------------------------------------------

    def predicted_frame(self) -> tuple[MarkFrame, float] | None:
        """All marks by the positions, and pixels per mm: three at least that are not on a line, or all; else None."""
        names = [name for name in self._calibration.marks if name in self._near]
        every = list(self._calibration.marks)
        if len(names) < 3 and len(names) != len(every):
            return None
        source = np.array([self._calibration.marks[name] for name in names])
        target = np.array([self._near[name] for name in names])
        made = fit_transformation(PlaneModel.SIMILARITY, source, target)
        scale = float(math.sqrt(abs(np.linalg.det(made.matrix[:2, :2]))))
        worst = float(np.hypot(*(made(source) - target).T).max()) / scale
        if worst > 2 * self._settings.search_mm + limits.FILM_DEFORMATION * self._calibration.span:
            raise PhotoError(messages.POSITIONS_OFF(worst=worst))
        places = made(np.array([self._calibration.marks[name] for name in every]))
        places[[every.index(name) for name in names]] = target
        upright = made.matrix[:2, :2] / scale
        frame = self._calibration.points @ upright.T
        return MarkFrame(
            tuple(every), frame, tuple(_around(place, scale * self._settings.search_mm) for place in places),
            (SCALE_RANGE[0] * scale, SCALE_RANGE[1] * scale), math.radians(2 * limits.MAX_ROTATION_DEG),
        ), scale

    def around_positions(self, frame: MarkFrame, scale: float) -> FoundMarks:
        """Search the surroundings of the positions, all of them together."""
        wanted = [k for k, name in enumerate(frame.marks) if name not in self._given]
        frame = MarkFrame(
            tuple(frame.marks[k] for k in wanted), frame.places[wanted], tuple(frame.areas[k] for k in wanted),
            frame.scales, frame.rotation,
        )
        self._check_template(scale)
        found = self._candidates(window_views(self._search_views(frame)), [frame])
        found_marks = _best((self._measured(one, scale) for one in found), len(frame.marks))
        return self._one_by_one(frame, scale) if found_marks is None else found_marks

    def in_whole_photo(self) -> FoundMarks:
        """Search the whole photo; what the positions say chooses between ways to lie."""
        photo = self._photo
        made = scan_orientation.possible_frames(self._calibration, photo.columns, photo.rows)
        scale = max(frame.scales[1] for frame in made)
        self._check_template(scale)
        image = photo.reduced(self._factor)
        if np.ptp(image) == 0:
            raise PhotoError(messages.PHOTO_EMPTY(name=photo.ref.name))
        found = self._candidates(whole_photo_views(image, self._factor), made)
        found_marks = _best(map(self._named, found), len(made[0].marks))
        if found_marks is not None and found_marks.results:
            return found_marks
        alone = self._one_by_one(self._single_frame(made[0], scale), scale)
        return alone if found_marks is None else replace(alone, notices=found_marks.notices)

    def _single_frame(self, frame: MarkFrame, scale: float) -> MarkFrame:
        """The marks that have a position, around it; the scale is that of marks that fill the photo."""
        names = [name for name in self._near if name not in self._given]
        places = np.array([frame.places[frame.marks.index(name)] for name in names]).reshape(-1, 2)
        areas = tuple(_around(self._near[name], scale * self._settings.search_mm) for name in names)
        return MarkFrame(tuple(names), places, areas, frame.scales, frame.rotation)

    def _search_views(self, frame: MarkFrame) -> list[ReducedView]:
        """The areas of a frame with room for a mark around them, reduced where they are large, all of one size."""
        room = math.ceil(MARK_ROOM * self._calibration.span * frame.scales[1])
        side = 2 * room + max(math.ceil(max(area.right - area.left, area.bottom - area.top)) for area in frame.areas)
        step = max(1, math.ceil(side / SEARCH_WINDOW_PX))
        side = step * math.ceil(side / step)
        made: dict[int, ReducedView] = {}
        for k in sorted(range(len(frame.areas)), key=lambda k: frame.areas[k].top):
            area = frame.areas[k]
            left, top = math.floor(area.left) - room, math.floor(area.top) - room
            if not (-side < left < self._photo.columns and -side < top < self._photo.rows):
                raise PhotoError(messages.POSITION_OUTSIDE(mark=frame.marks[k]))
            pixels = self._photo.grey(PixelWindow(left, top, side, side))
            made[k] = ReducedView(block_means(pixels, step) if step > 1 else pixels, left, top, step)
        return [made[k] for k in range(len(frame.areas))]

    def _check_template(self, scale: float) -> None:
        template = self._settings.template
        if template is None:
            return
        side, search = max(template.pixels.shape) / scale, 2 * self._settings.search_mm
        if side > search:
            raise PhotoError(messages.TEMPLATE_TOO_LARGE(side=side, search=search))

    # --- what is there ------------------------------------------------------------------------------------------

    @cached_property
    def _own_place(self) -> Place | None:
        """Of the mark that the user's template was cut out of, where that is in this photo."""
        template = self._settings.template
        return None if template is None else own_place(self._photo, template, self._factor)

    @property
    def _factor(self) -> int:
        """By which the photo is reduced to be searched."""
        return max(1, math.ceil(max(self._photo.columns, self._photo.rows) / SEARCH_SIDE_PX))

    def _candidates(self, scene: Scene, frames: Sequence[MarkFrame]) -> Iterator[Candidate]:
        """By the user's template or by drawn marks; by these too where the template has found its own mark only."""
        shapes, sign = self._settings.shapes, self._settings.sign
        yield from candidates(self._photo, scene, frames, self._settings.template, shapes, sign, self._cancelled)
        if self._own_place is not None:
            for one in candidates(self._photo, scene, frames, None, shapes, sign, self._cancelled):
                if len(one.frame.marks) == 1 or self._has_own_mark(one):
                    yield one

    def _has_own_mark(self, candidate: Candidate) -> bool:
        frame, found = candidate.frame, candidate.arrangement
        reach = placing_tolerance(frame, found.uncertainty) + 2
        return any(near_own_mark(self._own_place, place, reach) for place in found.predicted(frame.places))

    def _named(self, candidate: Candidate) -> FoundMarks:
        """Measure the places of an arrangement and find out which mark is where; no results where that can't be."""
        frames = [MeasuredFrame(candidate, self._measured(candidate, candidate.arrangement.scale))]
        if frames[0].marks.found >= limits.MIN_SUPPORT:
            for frame, arrangement in candidate.others:
                other = replace(candidate, frame=frame, arrangement=arrangement)
                measured = self._measured(other, arrangement.scale)
                if measured.found >= limits.MIN_SUPPORT:
                    frames.append(MeasuredFrame(other, measured))
        return name_marks(self._photo, self._calibration, self._positions, self._settings, frames)

    def _measured(self, candidate: Candidate, scale: float) -> FoundMarks:
        """Every mark of a frame at full resolution, those that were not among the arrangement's places too."""
        frame, found = candidate.frame, candidate.arrangement
        sites = {name: (float(x), float(y)) for name, (x, y) in zip(frame.marks, frame.places)}
        results = {}
        for name in sorted(sites, key=lambda one: found.places.get(one, (0, 0))[1]):
            if name in found.places:
                near, reach = found.places[name], 2 * found.uncertainty + 2
            else:
                (near,) = found.predicted(np.array([sites[name]]))
                reach = placing_tolerance(frame, found.uncertainty) + 2
            mark, sign = candidate.template, found.sign
            if isinstance(mark, MarkShape):
                mark = turned_with_frame(mark, sites[name], found.angle)
            if self._settings.template is not None and near_own_mark(self._own_place, near, reach + 2):
                mark, sign, near, reach = self._settings.template, 1, self._own_place or near, 2.0
            results[name] = self._measured_at(MeasuringTemplate(mark, sign), mark, near, reach, scale)
        return FoundMarks(results, candidate.template)

    def _measured_at(
        self, template: MeasuringTemplate, mark: MarkShape | CutOut, near: Place, reach: float, scale: float
    ) -> MeasuredMark | UnmeasuredMark:
        around = max(reach, DISTINCT_SHARE * template.size)
        if not (isinstance(mark, MarkShape) and mark.kind is MarkKind.DOT):  # dots there are in every picture
            around = max(around, DISTINCT_FRAME_SHARE * self._calibration.span * scale)
        half = math.ceil(around) + max(template.at((0.0, 0.0)).shape) // 2 + 1
        try:
            window = window_around(self._photo, near, half)
        except PhotoError as error:
            return UnmeasuredMark(error.message)
        found = measure_mark(window, near, reach, template, self._settings.min_correlation, self._settings.surface)
        if isinstance(found, MeasuredMark) and not self._photo.holds((found.column, found.row), template.radius):
            return UnmeasuredMark(messages.MARK_AT_THE_EDGE(), found.correlation)
        return found

    def _one_by_one(self, frame: MarkFrame, scale: float) -> FoundMarks:
        """No arrangement was found: every mark on its own, where it has a position."""
        results: dict[str, MeasuredMark | UnmeasuredMark] = {}
        template: MarkShape | CutOut | None = self._settings.template
        for k, name in enumerate(frame.marks):
            single = MarkFrame((name,), frame.places[k : k + 1], (frame.areas[k],), frame.scales, frame.rotation)
            found = self._candidates(window_views(self._search_views(single)), [single])
            tries = islice(found, 1 if template is None else 2)  # with the user's own, then drawn
            best = _best((self._measured(candidate, scale) for candidate in tries), 1)
            if best is None:
                results[name] = UnmeasuredMark(messages.MARK_NOT_SEEN())
                continue
            template = template or best.template
            results.update(best.results)
        return FoundMarks(results, template)


def _best(searches: Iterable[FoundMarks], marks: int) -> FoundMarks | None:
    """The first with enough marks to support each other; where none has, the first of all, which says why."""
    first: FoundMarks | None = None
    for one in searches:
        if one.found >= min(limits.MIN_SUPPORT, marks):
            return one
        if first is None:
            first = one
    return first


def _around(place: Place, reach: float) -> SearchArea:
    return SearchArea(place[0] - reach, place[1] - reach, place[0] + reach, place[1] + reach)
