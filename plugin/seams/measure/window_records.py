"""Windows and what was found in them, as a window layer and the tables of an inspection hold it.

Plain data to count, to draw and to report. Tables of others lack some of it; what is not there is None or empty.
"""
from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field

from ...imagery.grids import NumberedWindow
from ...imagery.limits import judged_band
from ...imagery.statistics import DECIDED

COMPOSITE = "composite"
"""The hard-cut composite of the sources, where a source's name or a clip's role would stand."""
SEAM, SOURCES = "seam", "sources"
REFERENCES = (SEAM, COMPOSITE, SOURCES)
"""What a verdict can be taken by: the seam profile, the hard-cut composite, or whole sources as in the paper."""
MAY_BE_SIGNIFICANT, OF_THE_REST = "may be significant", "of the rest"
"""Reasons that what is said of a window goes by, as ``reason_code`` has them."""
_NOT_COMPARED = ("", "not_comparable")  # words of Verdict, which is not loaded when QGIS starts


@dataclass(frozen=True)
class WindowRecord(NumberedWindow):
    """One window of a layer, inspected or not. Its number is for good.

    Fields are those of the layer (docs/reference/tables.md); ``ratios``, ``composite_ratios``, ``expected_ratios`` and
    ``kept`` have an entry for each level, and ``contrast``, ``sharpness`` and ``added`` are of level 1. Words are empty
    and numbers None where nothing is known.
    """

    verdict: str = ""
    reason: str = ""
    sources: int | None = None
    ratios: tuple[float | None, ...] = ()
    background_ratio: float | None = None
    observer: str = ""
    confidence: int | None = None
    remark: str = ""
    observer_2: str = ""
    confidence_2: int | None = None
    remark_2: str = ""
    seam_id: int | None = None
    station: float | None = None
    composite_ratios: tuple[float | None, ...] = ()
    expected_ratios: tuple[float | None, ...] = ()
    unclear_share: float | None = None
    cause: str = ""
    causes: str = ""
    reference: str = ""
    paper_verdict: str = ""
    loss: float | None = None
    kept: tuple[float | None, ...] = ()
    kept_low: float | None = None
    kept_high: float | None = None
    band_width: float | None = None
    feather_width: float | None = None
    visibility: float | None = None
    misfit: float | None = None
    contrast: float | None = None
    sharpness: float | None = None
    added: float | None = None
    explained: float | None = None
    reason_code: str = ""
    fid: int = 0
    """Feature id; changes when a new feature is saved."""
    stale: bool = False
    """Whether it or the inputs changed after it was inspected, as far as the desk knows."""
    others: Mapping[str, object] = field(default_factory=dict, hash=False)
    """Fields that have no name here."""
    impossible: tuple[str, ...] = ()
    """Fields of its layer whose numbers no measurement gives; what they say is left out."""

    @property
    def is_judged(self) -> bool:
        """Whether the observer said that a loss is to be seen or not; who is not sure did neither."""
        return self.observer in DECIDED

    @property
    def is_compared(self) -> bool:
        """Whether it was inspected and a source took part, be it too little for a verdict."""
        return self.verdict not in _NOT_COMPARED or (self.verdict != "" and self.explained is not None)

    @property
    def ratio(self) -> float | None:
        """At level 1."""
        return self.ratios[0] if self.ratios else None

    def read(self, name: str) -> object:
        """An attribute, or one of the others."""
        return self.others[name] if name in self.others else getattr(self, name, None)

    @property
    def measured(self) -> tuple[object, ...]:
        """What was found in it; a level that its layer has no field for is like one that is not known."""
        ratios = enumerate((self.background_ratio, self.composite_ratio, self.kept_1, *self.ratios))
        known = tuple((place, ratio) for place, ratio in ratios if ratio is not None)
        return self.verdict, self.reason, self.sources, self.causes or self.cause, known

    @property
    def kept_1(self) -> float | None:
        """Share of the finest detail that is kept along the seam."""
        return self.kept[0] if self.kept else None

    @property
    def composite_ratio(self) -> float | None:
        """At level 1."""
        return self.composite_ratios[0] if self.composite_ratios else None


@dataclass(frozen=True)
class PairRecord:
    """The mosaic against one source, or against the composite, in one window and band."""

    source: str
    """File name without its folder, or ``composite``."""
    band: str
    ratio: float | None
    """At level 1."""
    contrast: float | None
    """At level 1, absolute."""


@dataclass(frozen=True)
class CurveRecord:
    """The curve of one raster in one window and band."""

    raster: str
    """File name without its folder."""
    role: str
    """``mosaic``, ``source`` or ``composite``."""
    detail: tuple[float, ...]
    """Relative variance at levels 1..R; NaN for a constant clip."""
    background: float


@dataclass(frozen=True)
class ProfileRecord:
    """What a window keeps of its detail at one level and distance from the seam."""

    level: int
    distance: float
    """Middle of the bin, m."""
    kept: float
    low: float
    high: float
    """95 % interval of ``kept``; NaN where the table does not say it."""
    mixture: float | None = None
    """Share of the source beyond the seam; None where it was not looked for."""


def contrast_of(pairs: Iterable[PairRecord]) -> float | None:
    """Absolute contrast at level 1 in the judged band: against the composite, else the largest over the sources."""
    rows = list(pairs)
    if not rows:
        return None
    band = judged_band(row.band for row in rows)
    known = {row.source: row.contrast for row in rows if row.band == band and row.contrast is not None}
    return known.get(COMPOSITE, max(known.values(), default=None))
