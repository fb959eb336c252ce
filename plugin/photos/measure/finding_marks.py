"""The search for a photo's marks: looked for all together, named, and each measured at full resolution."""
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
from .arrangements import Arrangement, Candidate, candidates, turned_with_frame
from .camera_calibration import CameraCalibration
from .correlation import correlate, peak_pixel, peaks
from .mark_templates import CutOut, MarkShape
from .measuring_marks import MeasuredMark, MeasuringTemplate, measure_mark, window_around
from .orientation import GivenPosition, MarkSearch, OrientationSettings
from .photo import MarkFrame, Photo, PhotoView, Place, Scene, SearchArea, block_means, whole_photo_views, window_views
from .scan_orientation import Labelling
from .transformations import fit_transformation

COARSE_TEMPLATE_PX = 10  # of the shorter side while the photo is searched
LOOKED_AT = 12  # places that look alike there
MIN_LOOK = 0.5  # of them: reduced on other pixel bounds than the photo, a cut-out still fits itself so well
SAME_PIXELS = 0.98  # correlation of a piece of the photo with itself, stored anew with loss
SEARCH_SIDE_PX = 3000  # the longer side of the photo for the first search: 80 um on a 23 cm photo
SEARCH_WINDOW_PX = 768  # of a search window at its finest: larger ones are reduced
SCALE_RANGE = (0.9, 1.1)  # against the scale that the positions imply, roughly placed as they are
DISTINCT_SHARE = 1.5  # of a mark's size: so far around it nothing may look alike
DISTINCT_FRAME_SHARE = 0.03  # of the frame: 6 mm on 23 cm, so that an arm's end is told from its counterpart
MARK_ROOM = 0.05  # of the frame: around a search area, so that a mark at its edge is seen whole


def within(place: Place | None, other: Place | None, reach: float) -> bool:
    """Whether two places are known and within reach (px) of each other."""
    return place is not None and other is not None and math.dist(place, other) <= reach


@dataclass(frozen=True, eq=False)
class MarkFinder:
    """A photo and what is known of its marks; finds all marks of a calibration that have no given place."""

    photo: Photo
    calibration: CameraCalibration
    positions: Mapping[str, GivenPosition]
    settings: OrientationSettings
    cancelled: Callable[[], bool]

    def search(self) -> MarkSearch:
        """Look for the marks around the positions where these tell enough, else in the whole photo. Raises PhotoError
        for positions that contradict the calibration or the photo, and for a photo without contrast."""
        predicted = self._predicted_frame()
        return self._in_whole_photo() if predicted is None else self._around_positions(*predicted)

    @cached_property
    def _near(self) -> dict[str, Place]:
        """Places of marks by the positions, px."""
        return {name: position.place for name, position in self.positions.items()}

    def _is_given(self, name: str) -> bool:
        """Whether a mark has a place that is not measured."""
        return name in self.positions and not self.positions[name].measure

    def _predicted_frame(self) -> tuple[MarkFrame, float] | None:
        """All marks by the positions, and pixels per mm: three at least that are not on a line, or all; else None."""
        names = [name for name in self.calibration.marks if name in self._near]
        every = list(self.calibration.marks)
        if len(names) < 3 and len(names) != len(every):
            return None
        source = np.array([self.calibration.marks[name] for name in names])
        target = np.array([self._near[name] for name in names])
        made = fit_transformation(limits.SIMILARITY, source, target)
        scale = float(math.sqrt(abs(np.linalg.det(made.matrix[:2, :2]))))
        worst = float(np.hypot(*(made(source) - target).T).max()) / scale
        if worst > 2 * self.settings.search_mm + limits.FILM_DEFORMATION * self.calibration.span:
            raise PhotoError(messages.POSITIONS_OFF(worst=worst))
        places = made(np.array([self.calibration.marks[name] for name in every]))
        places[[every.index(name) for name in names]] = target
        upright = made.matrix[:2, :2] / scale
        frame = self.calibration.points @ upright.T
        return MarkFrame(
            tuple(every), frame, tuple(_around(place, scale * self.settings.search_mm) for place in places),
            (SCALE_RANGE[0] * scale, SCALE_RANGE[1] * scale), math.radians(2 * limits.MAX_ROTATION_DEG),
        ), scale

    def _around_positions(self, frame: MarkFrame, scale: float) -> MarkSearch:
        """Search the surroundings of the positions, all of them together."""
        frame = frame.only([k for k, name in enumerate(frame.marks) if not self._is_given(name)])
        self._check_template(scale)
        tries = self._candidates(window_views(self._search_views(frame)), [frame])
        search = _best((self._measured(candidate, scale) for candidate in tries), len(frame.marks))
        return self._one_by_one(frame, scale) if search is None else search

    def _in_whole_photo(self) -> MarkSearch:
        """Search the whole photo; what the positions say chooses between ways to lie."""
        photo = self.photo
        made = scan_orientation.possible_frames(self.calibration, photo.columns, photo.rows)
        scale = max(frame.scales[1] for frame in made)
        self._check_template(scale)
        image = photo.reduced(self._factor)
        if np.ptp(image) == 0:
            raise PhotoError(messages.PHOTO_EMPTY(name=photo.ref.name))
        tries = self._candidates(whole_photo_views(image, self._factor), made)
        search = _best(map(self._named, tries), len(made[0].marks))
        if search is not None and search.results:
            return search
        # The marks that have a position, around it; the scale is that of marks that fill the photo.
        names = [name for name in self._near if not self._is_given(name)]
        places = np.array([made[0].places[made[0].marks.index(name)] for name in names]).reshape(-1, 2)
        areas = tuple(_around(self._near[name], scale * self.settings.search_mm) for name in names)
        alone = self._one_by_one(replace(made[0], marks=tuple(names), places=places, areas=areas), scale)
        return alone if search is None else replace(alone, notices=search.notices)

    def _search_views(self, frame: MarkFrame) -> list[PhotoView]:
        """The areas of a frame with room for a mark around them, reduced where they are large, all of one size."""
        room = math.ceil(MARK_ROOM * self.calibration.span * frame.scales[1])
        side = 2 * room + max(math.ceil(max(area.right - area.left, area.bottom - area.top)) for area in frame.areas)
        step = max(1, math.ceil(side / SEARCH_WINDOW_PX))
        side = step * math.ceil(side / step)
        made: dict[int, PhotoView] = {}
        for k in sorted(range(len(frame.areas)), key=lambda k: frame.areas[k].top):
            area = frame.areas[k]
            left, top = math.floor(area.left) - room, math.floor(area.top) - room
            if not (-side < left < self.photo.columns and -side < top < self.photo.rows):
                raise PhotoError(messages.POSITION_OUTSIDE(mark=frame.marks[k]))
            pixels = self.photo.grey(PixelWindow(left, top, side, side))
            made[k] = PhotoView(block_means(pixels, step) if step > 1 else pixels, left, top, step)
        return [made[k] for k in range(len(frame.areas))]

    def _check_template(self, scale: float) -> None:
        template = self.settings.template
        if template is None:
            return
        side, search = max(template.pixels.shape) / scale, 2 * self.settings.search_mm
        if side > search:
            raise PhotoError(messages.TEMPLATE_TOO_LARGE(side=side, search=search))

    @cached_property
    def _template_place(self) -> Place | None:
        """Place of the mark the user's template was cut out of: None without one, or where it is from another photo. It
        fits there as nothing else does, so it is used there first."""
        template = self.settings.template
        if template is None:
            return None
        rows, columns = template.pixels.shape
        step = max(min(rows, columns) // COARSE_TEMPLATE_PX, self._factor)
        reduced = block_means(template.pixels, step)
        if min(reduced.shape) < limits.MIN_TEMPLATE_PX or np.ptp(reduced) == 0:
            return None
        field = correlate(self.photo.reduced(step), reduced)
        best: tuple[float, Place] | None = None
        for peak in peaks(np.maximum(field, 0), 2, MIN_LOOK, LOOKED_AT):
            left, top = round(peak.column * step) - step, round(peak.row * step) - step
            around = self.photo.grey(PixelWindow(left, top, columns + 2 * step, rows + 2 * step))
            fine = correlate(around, template.pixels)
            row, column = peak_pixel(fine)
            if fine[row, column] >= SAME_PIXELS and (best is None or fine[row, column] > best[0]):
                best = float(fine[row, column]), (left + column + template.centre[0], top + row + template.centre[1])
        return None if best is None else best[1]

    @property
    def _factor(self) -> int:
        """Factor by which the photo is reduced to be searched."""
        return max(1, math.ceil(max(self.photo.columns, self.photo.rows) / SEARCH_SIDE_PX))

    def _candidates(self, scene: Scene, frames: Sequence[MarkFrame]) -> Iterator[Candidate]:
        """Candidates by the user's template, else by drawn marks; by these too where the template is of this photo."""
        shapes, sign = self.settings.shapes, self.settings.sign
        yield from candidates(self.photo, scene, frames, self.settings.template, shapes, sign, self.cancelled)
        if self._template_place is None:
            return
        for candidate in candidates(self.photo, scene, frames, None, shapes, sign, self.cancelled):
            drawn = candidate.arrangement
            places = drawn.predicted(drawn.frame.places)
            if len(places) == 1 or any(within(self._template_place, place, drawn.reach + 2) for place in places):
                yield candidate

    def _named(self, candidate: Candidate) -> MarkSearch:
        """Measure the places of an arrangement and find out which mark is where; no results where that can't be."""
        measured = [(candidate.arrangement, self._measured(candidate, candidate.arrangement.scale))]
        for other in candidate.others if measured[0][1].count >= limits.MIN_SUPPORT else ():
            marks = self._measured(replace(candidate, arrangement=other), other.scale)
            if marks.count >= limits.MIN_SUPPORT:
                measured.append((other, marks))
        return self._with_names(candidate, measured)

    def _with_names(self, candidate: Candidate, measured: Sequence[tuple[Arrangement, MarkSearch]]) -> MarkSearch:
        """The marks by their own names, and how the photo lies; no results where none lie at the positions. A given
        place may be wrong: it counts where it agrees with all others, and is judged with the measured ones later.
        ``measured`` are the likeliest arrangement and, for a calibration that looks different when it is turned, the
        others that the photo holds marks for too, each with what was measured by the names of its frame."""
        best = measured[0][0]
        results, sites_of_frames = _measured_once([marks.results for _, marks in measured])
        places = {site: mark.place for site, mark in results.items() if mark.place is not None}
        named, evidence = [
            replace(labelling, sites=dict(labelling.marks_at(sites)))
            for (arrangement, _), sites in zip(measured, sites_of_frames)
            for labelling in scan_orientation.labellings(self.calibration, arrangement)
        ], limits.MARKS
        approximate = {name: place for name, place in self._near.items() if not self._is_given(name)}
        for near in (self._near, approximate):
            at_positions = scan_orientation.matching_positions(named, near, best.scale * self.settings.search_mm)
            if at_positions:
                named, evidence = at_positions, limits.POSITIONS if near else evidence
                break
        else:
            return MarkSearch(notices=(messages.ARRANGEMENT_NOT_AT_POSITIONS(),))
        size = self.photo.columns, self.photo.rows
        tests: dict[str, Callable[[Sequence[Labelling]], list[Labelling]]] = {
            limits.DOTS: lambda open_ones: scan_orientation.matching_dots(
                open_ones, _dot_counts(self.photo, candidate.template, best, places)
            ),
            limits.MARKS: lambda open_ones: scan_orientation.matching_count(open_ones, places),
            limits.DATA_STRIP: lambda open_ones: scan_orientation.matching_data_strip(
                open_ones, self.calibration, best.places.values(), size
            ),
            limits.RESIDUALS: lambda open_ones: scan_orientation.matching_residuals(
                open_ones, self.calibration, places, self.settings.model
            ),
        }
        for kind, matching in tests.items():
            chosen = matching(named) if len(named) > 1 else []
            if chosen and len(chosen) < len(named):
                named, evidence = chosen, kind
        notices: tuple[Message, ...] = ()
        if len(named) > 2 or (len(named) == 2 and evidence != limits.DATA_STRIP):
            evidence, notices = limits.ASSUMED, (messages.SCAN_ORIENTATION_ASSUMED(),)
        plain = min(named, key=lambda labelling: (labelling.orientation.mirrored, labelling.orientation.turned))
        return MarkSearch(dict(plain.marks_at(results)), candidate.template, plain.orientation, evidence, notices)

    def _measured(self, candidate: Candidate, scale: float) -> MarkSearch:
        """Every mark of a frame at full resolution, those that were not among the arrangement's places too."""
        arrangement = candidate.arrangement
        sites = arrangement.frame.sites
        results = {}
        for name in sorted(sites, key=lambda mark: arrangement.places.get(mark, (0, 0))[1]):
            if name in arrangement.places:
                near, reach = arrangement.places[name], 2 * arrangement.uncertainty + 2
            else:
                (near,) = arrangement.predicted(np.array([sites[name]]))
                reach = arrangement.reach + 2
            mark, sign = candidate.template, arrangement.sign
            if isinstance(mark, MarkShape):
                mark = turned_with_frame(mark, sites[name], arrangement.angle)
            if self.settings.template is not None and within(self._template_place, near, reach + 2):
                mark, sign, near, reach = self.settings.template, 1, self._template_place or near, 2.0
            results[name] = self._measured_at(MeasuringTemplate(mark, sign), mark, near, reach, scale)
        return MarkSearch(results, candidate.template)

    def _measured_at(
        self, template: MeasuringTemplate, mark: MarkShape | CutOut, near: Place, reach: float, scale: float
    ) -> MeasuredMark:
        around = max(reach, DISTINCT_SHARE * template.size)
        if not (isinstance(mark, MarkShape) and mark.kind == limits.DOT):  # dots there are in every picture
            around = max(around, DISTINCT_FRAME_SHARE * self.calibration.span * scale)
        half = math.ceil(around) + max(template.at((0.0, 0.0)).shape) // 2 + 1
        try:
            window = window_around(self.photo, near, half)
        except PhotoError as error:
            return MeasuredMark(reason=error.message)
        measured = measure_mark(window, near, reach, template, self.settings.min_correlation, self.settings.surface)
        if measured.place is not None and not self.photo.holds(measured.place, template.radius):
            return MeasuredMark(None, measured.correlation, messages.MARK_AT_THE_EDGE())
        return measured

    def _one_by_one(self, frame: MarkFrame, scale: float) -> MarkSearch:
        """No arrangement was found: every mark on its own, where it has a position."""
        results: dict[str, MeasuredMark] = {}
        template: MarkShape | CutOut | None = self.settings.template
        for k, name in enumerate(frame.marks):
            single = frame.only([k])
            tries = self._candidates(window_views(self._search_views(single)), [single])
            likeliest = islice(tries, 1 if template is None else 2)  # with the user's template, then drawn
            best = _best((self._measured(candidate, scale) for candidate in likeliest), 1)
            if best is None:
                results[name] = MeasuredMark(reason=messages.MARK_NOT_SEEN())
                continue
            template = template or best.template
            results.update(best.results)
        return MarkSearch(results, template)


def _best(searches: Iterable[MarkSearch], marks: int) -> MarkSearch | None:
    """The first with enough marks to support each other; where none has, the first of all, which says why."""
    first: MarkSearch | None = None
    for search in searches:
        if search.count >= min(limits.MIN_SUPPORT, marks):
            return search
        first = first or search
    return first


def _around(place: Place, reach: float) -> SearchArea:
    return SearchArea(place[0] - reach, place[1] - reach, place[0] + reach, place[1] + reach)


def _measured_once(
    frames: Sequence[Mapping[str, MeasuredMark]]
) -> tuple[dict[str, MeasuredMark], list[dict[str, str]]]:
    """The measured marks by site, though several frames may have a mark there, and the site of each frame's marks."""
    results: dict[str, MeasuredMark] = {}
    sites: list[dict[str, str]] = []
    for number, marks in enumerate(frames):
        sites.append({})
        for name, mark in marks.items():
            known = (site for site, other in results.items() if within(mark.place, other.place, limits.ONE_PLACE_PX))
            site = next(known, f"{number} {name}")
            sites[-1][name] = site
            results.setdefault(site, mark)
    return results, sites


def _dot_counts(
    photo: Photo, template: MarkShape | CutOut, arrangement: Arrangement, places: Mapping[str, Place]
) -> dict[str, int]:
    """The number of dots beside the mark at each site, where there are any."""
    radius = template.size / 2 if isinstance(template, MarkShape) else min(template.pixels.shape) / 4
    counts = {}
    for site, place in places.items():
        window = window_around(photo, place, math.ceil(2.6 * radius))
        count = scan_orientation.count_numbering_dots(arrangement.sign * window.pixels, radius, arrangement.angle)
        if count:
            counts[site] = count
    return counts
