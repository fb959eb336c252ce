"""What became of the marks that were looked for."""
from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

from ....imagery.message import Message
from ..mark_templates import CutOut, MarkShape
from ..measuring_marks import MeasuredMark, UnmeasuredMark
from ..scan_orientation import OrientationEvidence, ScanOrientation


@dataclass(frozen=True)
class FoundMarks:
    """What became of the marks that were looked for."""

    results: Mapping[str, MeasuredMark | UnmeasuredMark] = field(default_factory=dict)
    """By the calibration's names; marks with a given place are not among them."""
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
        return sum(isinstance(one, MeasuredMark) for one in self.results.values())
