"""The request and the result of an interior orientation."""
from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, field

from ...imagery.errors import Message
from . import limits
from .mark_templates import CutOut, MarkShape
from .measuring_marks import MeasuredMark
from .photo import PhotoView, Place
from .scan_orientation import ScanOrientation
from .transformations import Transformation


@dataclass(frozen=True)
class FittedTransformation:
    to_mm: Transformation  # columns and rows to photo coordinates, mm
    to_pixels: Transformation  # back, fitted the same way's inverse
    marks: int  # how many took part
    redundancy: int  # degrees of freedom left over; with 0 the residuals are 0 and tell nothing
    rms_x: float  # root mean square of the residuals in x, um
    rms_y: float  # root mean square of the residuals in y, um

    @property
    def rms(self) -> float:
        """Root mean square of the residual vectors' lengths, um."""
        return math.hypot(self.rms_x, self.rms_y)


@dataclass(frozen=True)
class OrientationSettings:
    template: CutOut | None = None  # the user's own; else marks are drawn
    shapes: tuple[MarkShape, ...] = ()  # the marks that are drawn, their sizes of no meaning; none for all there are
    sign: int | None = None
    """1 for marks lighter than their ground (or like the template), -1 for darker ones; None for either."""
    search_mm: float = limits.DEFAULT_SEARCH_MM  # distance around a position within which its mark is looked for, mm
    min_correlation: float = limits.DEFAULT_MIN_CORRELATION  # smallest correlation of a measured mark
    surface: str = limits.CORRELATION  # what a mark is placed to a fraction of a pixel by
    model: str = limits.AFFINE  # the transformation from the scan to the calibration


@dataclass(frozen=True)
class GivenPosition:
    place: Place  # column and row, px, pixel centres at .5
    measure: bool = True  # whether it is approximate and to be measured; else it is taken as it is


@dataclass(frozen=True)
class MarkResult:
    """A mark of the calibration, as measured or failed."""

    name: str
    calibrated: Place  # mm
    status: str
    place: Place | None  # column and row, px, pixel centres at .5; None where it failed
    correlation: float | None = None
    reason: Message | None = None  # why it failed
    residual: Place | None = None  # transformed less calibrated, um in x and y; None without a transformation


@dataclass(frozen=True)
class PhotoOrientation:
    marks: tuple[MarkResult, ...]  # in the order of the calibration
    fitted: FittedTransformation | None  # the transformation; None where too few marks were found
    scan_orientation: ScanOrientation | None  # the way the photo lies in the scan; None where it is not known
    evidence: str | None  # the evidence for that
    template: MarkShape | CutOut | None  # the template that the marks were measured with
    notices: tuple[Message, ...] = ()  # warnings and remarks for the user
    views: Mapping[str, PhotoView] = field(default_factory=dict)
    """The surroundings of each mark, for pictures; of a failed one where it should be."""
    expected: Mapping[str, Place] = field(default_factory=dict)  # where failed marks should be, px

    def count(self, status: str) -> int:
        return sum(mark.status is status for mark in self.marks)


@dataclass(frozen=True)
class MarkSearch:
    """The marks that were looked for, as measured or failed."""

    results: Mapping[str, MeasuredMark] = field(default_factory=dict)  # by the calibration's names, but for given marks
    template: MarkShape | CutOut | None = None  # what they were measured with
    scan_orientation: ScanOrientation | None = None  # how the photo lies, where the search told
    evidence: str | None = None  # what told
    notices: tuple[Message, ...] = ()  # what the user should know

    @property
    def count(self) -> int:
        return sum(mark.place is not None for mark in self.results.values())
