"""What an interior orientation is asked for and what comes of it."""
from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, field
from enum import Enum

from ...imagery.errors import Message
from . import limits
from .mark_templates import CutOut, MarkShape
from .measuring_marks import MeasuredMark, SurfaceBasis
from .photo import PhotoView, Place
from .scan_orientation import OrientationEvidence, ScanOrientation
from .transformations import PlaneModel, Transformation


@dataclass(frozen=True)
class FittedTransformation:
    """A transformation and what it leaves."""

    to_mm: Transformation
    """Columns and rows to photo coordinates, mm."""
    to_pixels: Transformation
    """Back, fitted the same way's inverse."""
    marks: int
    """How many took part."""
    redundancy: int
    """Degrees of freedom left over; with 0 the residuals are 0 and tell nothing."""
    rms_x: float
    """Root mean square of the residuals in x, um."""
    rms_y: float
    """Root mean square of the residuals in y, um."""

    @property
    def rms(self) -> float:
        """Root mean square of the residual vectors' lengths, um."""
        return math.hypot(self.rms_x, self.rms_y)


class MarkStatus(Enum):
    """How a mark came to its place."""

    MEASURED = "measured"
    GIVEN = "given"
    FAILED = "failed"


@dataclass(frozen=True)
class OrientationSettings:
    """How a photo is measured."""

    template: CutOut | None = None
    """The user's own; else marks are drawn."""
    shapes: tuple[MarkShape, ...] = ()
    """Which marks are drawn, their sizes of no meaning; none for all there are."""
    sign: int | None = None
    """1 for marks lighter than their ground (or like the template), -1 for darker ones; None for either."""
    search_mm: float = limits.DEFAULT_SEARCH_MM
    """How far around a position a mark is looked for, mm."""
    min_correlation: float = limits.DEFAULT_MIN_CORRELATION
    """Smallest correlation of a measured mark."""
    surface: SurfaceBasis = SurfaceBasis.CORRELATION
    """What the surface is laid through that places a mark to a fraction of a pixel."""
    model: PlaneModel = PlaneModel.AFFINE
    """The transformation from the scan to the calibration."""


@dataclass(frozen=True)
class GivenPosition:
    """Where the user says that a mark is."""

    place: Place
    """Column and row, px, pixel centres at .5."""
    measure: bool = True
    """Whether it is approximate and to be measured; else it is taken as it is."""


@dataclass(frozen=True)
class MarkResult:
    """What became of a mark of the calibration."""

    name: str
    calibrated: Place
    """mm."""
    status: MarkStatus
    place: Place | None
    """Column and row, px, pixel centres at .5; None where it failed."""
    correlation: float | None = None
    reason: Message | None = None
    """Why it failed."""
    residual: Place | None = None
    """Transformed less calibrated, um in x and y; None without a transformation."""


@dataclass(frozen=True)
class PhotoOrientation:
    """The result for one photo."""

    marks: tuple[MarkResult, ...]
    """In the order of the calibration."""
    fitted: FittedTransformation | None
    """The transformation; None where too few marks were found."""
    scan_orientation: ScanOrientation | None
    """How the photo lies in the scan; None where it is not known."""
    evidence: OrientationEvidence | None
    """What decided that."""
    template: MarkShape | CutOut | None
    """What the marks were measured with."""
    notices: tuple[Message, ...] = ()
    """What the user should know."""
    views: Mapping[str, PhotoView] = field(default_factory=dict)
    """The surroundings of each mark, for pictures; of a failed one where it should be."""
    expected: Mapping[str, Place] = field(default_factory=dict)
    """Where the transformation puts the marks that failed, px."""

    def count(self, status: MarkStatus) -> int:
        """How many marks have a status."""
        return sum(mark.status is status for mark in self.marks)


@dataclass(frozen=True)
class FoundMarks:
    """What became of the marks that were looked for."""

    results: Mapping[str, MeasuredMark] = field(default_factory=dict)
    """Measured marks by the calibration's names; marks with a given place are not among them."""
    template: MarkShape | CutOut | None = None
    """What they were measured with."""
    scan_orientation: ScanOrientation | None = None
    """How the photo lies, where the search told."""
    evidence: OrientationEvidence | None = None
    """What told."""
    notices: tuple[Message, ...] = ()
    """What the user should know."""

    @property
    def found(self) -> int:
        """How many were measured."""
        return sum(one.place is not None for one in self.results.values())
