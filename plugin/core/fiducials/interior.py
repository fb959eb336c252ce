"""The interior orientation of one photo: from pixels and a calibration to marks and a transformation."""
from __future__ import annotations

import math
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace
from typing import Callable

import numpy as np
from scipy import ndimage

from .. import messages, thresholds
from ..errors import PhotoError
from ..messages import Message
from ..photos import Photo
from ..windows import PixelWindow
from . import lying
from .calibration import Calibration, check_calibration
from .fitting import fit_marks, off_marks
from .lying import Evidence, Labelling, Lying
from .measuring import Found, Lost, Template, Window, aimed, levelled, measure, refined
from .results import Fitted, Mark, Orientation, Position, Settings, Status
from .search import (
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


def orient(
    photo: Photo,
    calibration: Calibration,
    positions: Mapping[str, Position],
    settings: Settings,
    cancelled: Callable[[], bool] = lambda: False,
) -> Orientation:
    """Measure the marks of a photo and fit the transformation.

    Raises PhotoError where nothing can be measured at all.
    """
    check_calibration(calibration, settings.model)
    _check_positions(calibration, positions)
    return _Run(photo, calibration, positions, settings, cancelled).orientation()


def _check_positions(calibration: Calibration, positions: Mapping[str, Position]) -> None:
    unknown = [name for name in positions if name not in calibration.marks]
    if unknown:
        raise PhotoError(
            messages.POSITION_UNKNOWN(mark=unknown[0], marks=", ".join(calibration.marks))
        )
    seen: dict[Place, str] = {}
    for name, position in positions.items():
        for place, other in seen.items():
            if math.dist(place, position.place) < 1:
                raise PhotoError(messages.POSITIONS_AT_ONE_PLACE(one=other, other=name))
        seen[position.place] = name


class _Run:
    """The steps for one photo, each leaving what the next one needs."""

    def __init__(
        self,
        photo: Photo,
        calibration: Calibration,
        positions: Mapping[str, Position],
        settings: Settings,
        cancelled: Callable[[], bool],
    ) -> None:
        self._photo, self._calibration, self._settings, self._cancelled = photo, calibration, settings, cancelled
        self._positions = positions
        self._given = {name: one.place for name, one in positions.items() if not one.measure}
        self._near = {name: one.place for name, one in positions.items()}
        self._notices: list[Message] = []
        self._results: dict[str, Found | Lost] = {}
        self._windows: dict[str, Window] = {}
        self._template: Shape | CutOut | None = settings.template
        self._lying: Lying | None = None
        self._evidence: Evidence | None = None
        self._scale = 0.0

    def orientation(self) -> Orientation:
        calibration = self._calibration
        if set(self._given) != set(calibration.marks):
            predicted = self._predicted_frame()
            if predicted is not None:
                self._from_positions(predicted)
            else:
                self._from_photo()
        marks = [self._mark(name) for name in calibration.marks]
        marks = self._without_doubles(marks)
        marks, notices = off_marks(marks, self._settings.model)
        self._notices += notices
        marks = self._supported(marks)
        fitted, marks, notices = fit_marks(marks, self._settings.model)
        self._notices += notices
        if fitted is None and not any(mark.place for mark in marks):
            self._raise_nothing(marks)
        if fitted is not None and self._lying is None:
            self._lying, self._evidence = _nearest_lying(fitted), Evidence.POSITIONS
        self._look_around(marks)
        return Orientation(
            tuple(marks), fitted, self._lying, self._evidence, self._template, tuple(self._notices), self._windows
        )

    # --- where to look ------------------------------------------------------------------------------------------

    def _predicted_frame(self) -> Frame | None:
        """All marks by the positions given: three at least that are not on a line, or all; else None."""
        names = [name for name in self._calibration.marks if name in self._near]
        every = list(self._calibration.marks)
        if len(names) < 3 and len(names) != len(every):
            return None
        source = np.array([self._calibration.marks[name] for name in names])
        target = np.array([self._near[name] for name in names])
        made = fit(Model.SIMILARITY, source, target)
        self._scale = float(math.sqrt(abs(np.linalg.det(made.matrix[:2, :2]))))
        worst = float(np.hypot(*(made(source) - target).T).max()) / self._scale
        if worst > 2 * self._settings.search + thresholds.FILM_DEFORMATION * self._calibration.span:
            raise PhotoError(messages.POSITIONS_OFF(worst=worst))
        places = made(np.array([self._calibration.marks[name] for name in every]))
        places[[every.index(name) for name in names]] = target
        scale = self._scale
        upright = made.matrix[:2, :2] / scale
        frame = self._calibration.points @ upright.T
        return Frame(
            tuple(every), frame, tuple(_around(place, scale * self._settings.search) for place in places),
            (0.9 * scale, 1.1 * scale), math.radians(2 * thresholds.MAX_ROTATION_DEG),
        )

    def _from_positions(self, frame: Frame) -> None:
        """Search the surroundings of the positions, all of them together."""
        wanted = [k for k, name in enumerate(frame.marks) if name not in self._given]
        frame = Frame(
            tuple(frame.marks[k] for k in wanted), frame.places[wanted], tuple(frame.areas[k] for k in wanted),
            frame.scales, frame.rotation,
        )
        self._check_template(frame.scales[1] / 1.1)
        scene = windows_only(self._search_views(frame))
        found = self._search(scene, [frame])
        if found is None:
            self._one_by_one(frame)
            return
        self._measure(found[0], found[1], {name: name for name in frame.marks})

    def _from_photo(self) -> None:
        """Search the whole photo; what the positions say chooses between ways to lie."""
        photo, calibration = self._photo, self._calibration
        made = lying.frames(calibration, photo.columns, photo.rows)
        self._scale = max(frame.scales[1] for frame in made)
        self._check_template(self._scale)
        factor = max(1, math.ceil(max(photo.columns, photo.rows) / thresholds.SEARCH_SIDE_PX))
        image = photo.reduced(factor)
        if np.ptp(image) == 0:
            raise PhotoError(messages.PHOTO_EMPTY(name=photo.ref.name))
        found = self._search(whole_photo(image, factor), made)
        if found is None or not self._name_marks(*found):
            self._one_by_one(self._single_frame(made[0]))

    def _single_frame(self, frame: Frame) -> Frame:
        """The marks that have a position, around it; the scale is that of marks that fill the photo."""
        names = [name for name in self._near if name not in self._given]
        places = np.array([frame.places[frame.marks.index(name)] for name in names]).reshape(-1, 2)
        reach = self._scale * self._settings.search
        areas = tuple(_around(self._near[name], reach) for name in names)
        return Frame(tuple(names), places, areas, frame.scales, frame.rotation)

    def _search(self, scene: Scene, made: Sequence[Frame]) -> tuple[Frame, Arrangement] | None:
        """The arrangement whose marks, looked at closely, are most like the figure they were found by."""
        template = self._settings.template
        shapes = self._settings.shapes or all_shapes()
        groups = [cut_out_patterns(template)] if template is not None else [bank([shape]) for shape in shapes]
        found = find_arrangements(scene, made, groups, self._settings.sign, self._cancelled)
        if not found or template is not None:
            return found[0] if found else None
        looked_at = []
        worth = thresholds.WORTH_A_LOOK * found[0][1].score
        for one in [one for one in found if one[1].score >= worth][: thresholds.REFINED_ARRANGEMENTS]:
            shape, fitness = self._refined(*one, one[1].shape, thresholds.GLANCING_SIZE_PX)
            looked_at.append((fitness * len(one[1].values) / len(one[0].marks), shape, one))
        best = max(fitness for fitness, _, _ in looked_at)
        likely = [one for one in looked_at if one[0] >= best - thresholds.NEARLY_AS_FIT]
        _, shape, chosen = max(likely, key=lambda one: _weight(one[0], one[1]))
        self._template = self._refined(*chosen, shape, thresholds.REFINING_SIZE_PX)[0]
        return chosen

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

    def _name_marks(self, frame: Frame, found: Arrangement) -> bool:
        """Measure the places of an arrangement and find out which mark is where; False where that can't be."""
        candidates = lying.labellings(self._calibration, frame, found)
        self._evidence = Evidence.MARKS
        if self._near:
            reach = found.scale * self._settings.search
            candidates = lying.by_positions(candidates, self._near, reach)
            self._evidence = Evidence.POSITIONS
            if not candidates:
                self._notices.append(messages.ARRANGEMENT_NOT_AT_POSITIONS())
                return False
        self._scale = found.scale
        self._measure(frame, found, {site: site for site in frame.marks})
        chosen = self._decide(candidates, found)
        results, windows = dict(self._results), dict(self._windows)
        self._results = {mark: results[site] for mark, site in chosen.sites.items() if site in results}
        self._windows = {mark: windows[site] for mark, site in chosen.sites.items() if site in windows}
        self._lying = chosen.lying
        return True

    def _decide(self, candidates: Sequence[Labelling], found: Arrangement) -> Labelling:
        measured = {name: (one.column, one.row) for name, one in self._results.items() if isinstance(one, Found)}
        tests: tuple[tuple[Evidence, Callable[[Sequence[Labelling]], list[Labelling]]], ...] = (
            (Evidence.DOTS, lambda some: lying.by_dots(some, self._dots(found))),
            (
                Evidence.DATA_STRIP,
                lambda some: lying.by_data_strip(
                    some, self._calibration, found, self._photo.columns, self._photo.rows
                ),
            ),
            (
                Evidence.RESIDUALS,
                lambda some: lying.by_residuals(some, self._calibration, measured, self._settings.model),
            ),
        )
        for evidence, test in tests:
            if len(candidates) == 1:
                break
            left = test(candidates)
            if left:
                candidates, self._evidence = left, evidence
        if len(candidates) > 1:
            plain = sorted(candidates, key=lambda one: (one.lying.mirrored, one.lying.turned))
            if len(candidates) > 2 or self._evidence is not Evidence.DATA_STRIP:
                self._evidence = Evidence.ASSUMED
                self._notices.append(messages.LYING_ASSUMED())
            return plain[0]
        return candidates[0]

    def _dots(self, found: Arrangement) -> dict[str, int]:
        counts = {}
        shape = self._template
        radius = shape.size / 2 if isinstance(shape, Shape) else 0.0
        if isinstance(self._template, CutOut):
            radius = min(self._template.pixels.shape) / 4
        half = math.ceil(2.6 * radius)
        for name, one in self._results.items():
            if isinstance(one, Found):
                window = self._window((one.column, one.row), half)
                count = lying.count_dots(found.sign * window.pixels, radius, found.angle)
                if count:
                    counts[name] = count
        return counts

    def _measure(self, frame: Frame, found: Arrangement, names: Mapping[str, str]) -> None:
        """Measure every mark of a frame at full resolution, those that were not among the candidates too."""
        places = dict(zip(frame.marks, (tuple(place) for place in frame.places)))
        for name in sorted(names, key=lambda one: found.places.get(one, (0, 0))[1]):
            if name in found.places:
                near, reach = found.places[name], 2 * found.uncertainty + 2
            else:
                x, y = found.matrix @ np.append(places[name], 1.0)
                near, reach = (float(x), float(y)), tolerance(frame, found.uncertainty) + 2
            self._results[name] = self._measured(name, near, reach, found, places[name])

    def _measured(
        self, name: str, near: Place, reach: float, found: Arrangement, place: Place
    ) -> Found | Lost:
        mark = self._template
        assert mark is not None
        if isinstance(mark, Shape):
            mark = aimed(mark, place, found.angle)
        template = Template(mark, found.sign)
        around = max(reach, thresholds.DISTINCT_SHARE * template.size)
        if not (isinstance(mark, Shape) and mark.kind is Kind.DOT):  # dots there are in every picture
            around = max(around, thresholds.DISTINCT_FRAME_SHARE * self._calibration.span * self._scale)
        half = math.ceil(around) + max(template.at((0.0, 0.0)).shape) // 2 + 1
        try:
            window = self._window(near, half)
        except PhotoError as error:
            return Lost(error.message)
        return measure(window, near, reach, template, self._settings.least, self._settings.surface)

    def _refined(self, frame: Frame, found: Arrangement, begin: Shape | None, finest: float) -> tuple[Shape, float]:
        """The drawn mark fitted to the photo's marks, and how well it fits."""
        assert begin is not None
        half = math.ceil(1.7 * begin.size + 2 * found.uncertainty + 4)
        windows = {name: levelled(self._window(place, half)) for name, place in found.places.items()}
        places = {name: (float(x), float(y)) for name, (x, y) in zip(frame.marks, frame.places)}
        return refined(windows, places, begin, found.sign, found.angle, finest)

    def _one_by_one(self, frame: Frame) -> None:
        """No arrangement was found: every mark on its own, where it has a position."""
        for k, name in enumerate(frame.marks):
            single = Frame((name,), frame.places[k : k + 1], (frame.areas[k],), frame.scales, frame.rotation)
            found = self._search(windows_only(self._search_views(single)), [single])
            if found is None:
                self._results[name] = Lost(messages.MARK_NOT_SEEN())
                continue
            self._measure(found[0], found[1], {name: name})

    def _window(self, place: Place, half: int) -> Window:
        left, top = math.floor(place[0]) - half, math.floor(place[1]) - half
        if not (0 <= place[0] < self._photo.columns and 0 <= place[1] < self._photo.rows):
            raise PhotoError(messages.MARK_OUTSIDE())
        pixels = self._photo.grey(PixelWindow(left, top, 2 * half + 1, 2 * half + 1))
        return Window(ndimage.gaussian_filter(pixels, thresholds.SMOOTHING_PX), left, top)

    # --- what it comes to ---------------------------------------------------------------------------------------

    def _mark(self, name: str) -> Mark:
        calibrated = self._calibration.marks[name]
        if name in self._given:
            return Mark(name, calibrated, Status.GIVEN, self._given[name])
        found = self._results.get(name, Lost(messages.MARK_NOT_ARRANGED()))
        if isinstance(found, Lost):
            return Mark(name, calibrated, Status.FAILED, None, found.correlation, found.reason)
        return Mark(name, calibrated, Status.MEASURED, (found.column, found.row), found.correlation)

    def _without_doubles(self, marks: list[Mark]) -> list[Mark]:
        """Two marks at one place are none."""
        made = []
        for mark in marks:
            twin = next(
                (
                    other for other in marks
                    if other is not mark and mark.place and other.place and math.dist(mark.place, other.place) < 3
                ),
                None,
            )
            if twin is not None and mark.status is Status.MEASURED:
                mark = replace(
                    mark, status=Status.FAILED, place=None, reason=messages.MARK_TWICE(other=twin.name)
                )
            made.append(mark)
        return made

    def _supported(self, marks: list[Mark]) -> list[Mark]:
        """Marks that nobody pointed at have to confirm each other."""
        count = sum(mark.place is not None for mark in marks)
        least = min(thresholds.MIN_SUPPORT, len(marks))
        if count >= least:
            return marks
        reason = messages.MARK_UNSUPPORTED(count=count, least=least)
        return [
            replace(mark, status=Status.FAILED, place=None, reason=reason)
            if mark.status is Status.MEASURED and mark.name not in self._near else mark
            for mark in marks
        ]

    def _raise_nothing(self, marks: Sequence[Mark]) -> None:
        reasons = {str(mark.reason): mark.reason for mark in marks if mark.reason is not None}
        raise PhotoError(
            messages.NO_MARK_FOUND(name=self._photo.ref.name, why=next(iter(reasons.values())))
        )

    def _look_around(self, marks: Iterable[Mark]) -> None:
        """The surroundings of every mark that has a place, for the report."""
        size = self._template.size if isinstance(self._template, Shape) else 0.0
        if isinstance(self._template, CutOut):
            size = max(self._template.pixels.shape)
        half = math.ceil(max(size, 2 * thresholds.MIN_PICTURE_PX) * 0.75)
        self._windows = {
            mark.name: self._window(mark.place, half) for mark in marks if mark.place is not None
            and 0 <= mark.place[0] < self._photo.columns and 0 <= mark.place[1] < self._photo.rows
        }


def _weight(fitness: float, shape: Shape) -> float:
    """How much a fit tells: a large figure that fits says more than a small one that may be a part of it."""
    return -math.log(max(1 - fitness * fitness, 1e-6)) * (2 * shape.margin + 1) ** 2


def _around(place: Place, reach: float) -> lying.Area:
    return lying.Area(place[0] - reach, place[1] - reach, place[0] + reach, place[1] + reach)


def _nearest_lying(fitted: Fitted) -> Lying:
    """The way to lie that a transformation comes nearest."""
    back = fitted.to_pixels.linear(np.array([[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]]))[:, :2]
    return max(lying.LYINGS, key=lambda one: float(np.sum(one.matrix * back)))
