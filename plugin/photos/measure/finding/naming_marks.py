"""Which mark of the calibration is which of those found: the ways that the photo may lie, and what tells them apart."""
from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace

from ....imagery.message import Message
from .. import limits, messages, scan_orientation
from ..camera_calibration import CameraCalibration
from ..mark_templates import MarkShape
from ..measuring_marks import MeasuredMark, UnmeasuredMark, window_around
from ..orientation import GivenPosition, OrientationSettings
from ..photo import Photo
from ..photo_views import Place
from ..scan_orientation import Labelling, OrientationEvidence
from .found_marks import FoundMarks
from .mark_candidates import Candidate


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
