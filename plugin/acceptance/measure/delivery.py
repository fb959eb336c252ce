"""What is delivered: the pieces of seam of all sheets, and the windows that were inspected."""
from __future__ import annotations

import math
import re
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field, replace
from enum import Enum
from functools import cached_property, lru_cache
from typing import NamedTuple

import numpy as np

from ...imagery.errors import SettingsError
from ...imagery.grids import Extent, middle_of
from ...imagery.lines import vertex_stations
from ...imagery.reference_systems import metres_per_unit
from ...imagery.seam_totals import KeptBeside
from . import messages

NUMBERS = {
    "station": "station_m", "length": "length_m", "kept_1": "kept_1", "kept_low": "kept_low", "kept_high": "kept_high",
    "band_width": "band_width_m", "feather_width": "feather_width_m", "visibility": "visibility",
}  # fmt: skip
TEXTS = ("left_source", "right_source", "left_date", "right_date", "verdict", "reason")
"""Fields of a scan's layer, the attributes of a piece that hold them; texts are called alike."""


@dataclass(frozen=True)
class DeliveredPiece:
    """A piece of seam as the scan measured it."""

    number: int  # its place among all pieces of the delivery, from 0
    sheet: str  # the layer it comes from, or the sheet in which its middle lies
    seam_id: str  # which seam of its sheet; empty where the layer does not say
    station_m: float | None  # along its seam, where it begins
    length_m: float
    kept_1: float | None  # share of the finest detail that the mosaic kept; None where nothing could be measured
    kept_low: float | None  # lower end of the 95 % interval of kept_1
    kept_high: float | None  # upper end
    band_width_m: float | None  # full width of the band in which less than 0.9 is kept, or of the feather if wider
    verdict: str  # the scan's word; empty where there is none
    reason: str  # why the scan has no verdict
    vertices: np.ndarray = field(compare=False)  # (n, 2) x and y in the delivery's reference system
    left_source: str = ""  # the orthoimage on the left hand
    right_source: str = ""
    left_date: str = ""  # when the orthoimage on the left hand was taken, as the layer has it
    right_date: str = ""
    sample_number: int | None = None  # place in the order of drawing, from 1; None where the layer is no sample
    scan: str = ""  # what seam_id numbers the seams of, where that is not the sheet: a scan of many sheets
    feather_width_m: float | None = None  # of the mixture
    visibility: float | None = None  # the loss in just noticeable differences at 2x; None where the scan does not say
    profile: tuple[KeptBeside, ...] = ()  # the judged strip, then step by step from the seam; empty where unknown
    has_detail: bool = True  # False on ground that has nothing to lose, as the scan says

    @property
    def seam(self) -> tuple[str, str]:
        """Key of its seam: the same for all pieces of one seam, and for no others."""
        return self.scan or self.sheet, self.seam_id

    @property
    def middle(self) -> tuple[float, float]:
        return self.point(0.5)

    def point(self, share: float) -> tuple[float, float]:
        x, y = self.vertices.T
        along = vertex_stations(self.vertices)
        return float(np.interp(share * along[-1], along, x)), float(np.interp(share * along[-1], along, y))


def typical_m(pieces: Iterable[DeliveredPiece]) -> float:
    """Length of pieces in the middle of all metres, m, so that crumbs of polygons count as little as they are long."""
    lengths = np.sort([0.0, *(piece.length_m for piece in pieces)])
    return float(lengths[np.searchsorted(lengths.cumsum(), lengths.sum() / 2)])


def extent_of(lines: Iterable[np.ndarray]) -> Extent:
    """Around lines of (n, 2) x and y each."""
    points = np.concatenate([*lines])
    xmin, ymin, xmax, ymax = np.concatenate([points.min(axis=0), points.max(axis=0)]).tolist()
    return xmin, ymin, xmax, ymax


def unit_metres(lines: Iterable[np.ndarray], wkt: str) -> float:
    """Metres on the ground in a unit of a reference system, where lines of (n, 2) lie.

    Raises SettingsError where that is nowhere.
    """
    metres = math.sqrt(math.prod(metres_per_unit(wkt, middle_of(extent_of(lines)))))
    if not 0 < metres < math.inf:
        raise SettingsError(messages.SEAMS_NOT_ON_GROUND())
    return metres


def in_order(pieces: Iterable[DeliveredPiece]) -> tuple[DeliveredPiece, ...]:
    """Pieces by sheet, seam and station, whatever the order in which layers were given, and numbered so."""
    ordered = sorted(pieces, key=lambda piece: (
        in_words(piece.sheet), in_words(piece.seam_id), -1.0 if piece.station_m is None else piece.station_m,
        *np.round(piece.vertices[0], 3).tolist(),
    ))  # fmt: skip
    return tuple(replace(piece, number=number) for number, piece in enumerate(ordered))


@lru_cache(maxsize=1 << 16)
def in_words(name: str) -> tuple[tuple[int, int, str], ...]:
    """For sorting: sheet_2 before sheet_10."""
    parts = re.split(r"([0-9]+)", name)
    return tuple((1, int(part), part) if part.isdecimal() else (0, 0, part.casefold()) for part in parts if part)


@dataclass(frozen=True)
class SeenWindow:
    """A window that was inspected."""

    extent: Extent  # in the delivery's reference system
    cause: str = ""  # the strongest one
    remarks: tuple[str, ...] = ()  # what the operators wrote
    observer: str = ""  # what they saw at 2x: visible or invisible


class SheetState(Enum):
    """What a sheet is to the mosaic of all sheets. The values are words of the checked layer."""

    SHOWN = "shown"  # the mosaic shows all of it
    DAMAGED = "damaged"  # some of its pixels can't be read
    OVERLAPS = "overlaps"  # it and another sheet differ where they overlap, and the mosaic shows one of them
    LEFT_OUT = "left_out"  # it was ordered, and is no part of the mosaic
    NOT_ORDERED = "not_ordered"  # it was not ordered, and is no part of the mosaic

    @classmethod
    def of_word(cls, word: str) -> SheetState:
        """State that a word stands for; layers without a word of ours say nothing against a sheet."""
        return next((state for state in cls if state.value == word), cls.SHOWN)


@dataclass(frozen=True)
class SheetOutline:
    """The outline of a sheet, of which there may be no seam; a sheet may have several."""

    name: str
    shape: bytes  # WKB of its polygons, in the delivery's reference system; empty where they are not known
    findings: str = ""  # what 'Check a delivery' found wrong with its file, in words
    state: SheetState = SheetState.SHOWN  # what the same check says of its part in the mosaic of all sheets


class Seal(Enum):
    """Whether a layer is as its scan, or ``planinspection``, left it."""

    WHOLE = "whole"
    BROKEN = "broken"  # rows, lines, their reference system, or what stands beside them were changed
    MISSING = "missing"  # it has none, as exports and layers of other makers
    NOT_ASKED = "not_asked"  # nobody needs it: rows in memory


@dataclass(frozen=True)
class DeliveredLayer:
    name: str
    seal: Seal  # anything but a whole one, where it is asked for, and nothing is accepted
    lacking_m: float  # metres that the scan had and the layer does not
    settings: Mapping[str, str] = field(hash=False)  # how its seams were measured, as far as the layer says
    digest: str = ""  # SHA-256 of its rows, as RowTotals has it
    lot_size: int = 0  # pieces of the lot that it is a sample of; 0 where it is none
    is_blank: bool = False  # whether it has no piece of seam, and not as a scan that found none left it


class SeamCover(NamedTuple):
    """What the two orthoimages beside a piece show of the strip along it; shares from 0 to 1."""

    side: float  # of its half, what the one shows that shows less, as far as the seam is known
    both: float  # of the strip, what both show at least
    is_short: bool = False  # whether what is there of it is too short to be measured, or the mosaic ends along it


@dataclass(frozen=True)
class FileDoubts:
    """Names of files, and of layers that are of others, by what is wrong with them."""

    not_scanned: tuple[str, ...] = ()  # given as mosaic or orthoimage, and none of those that were scanned
    changed: tuple[str, ...] = ()  # changed since they were scanned
    gone: tuple[str, ...] = ()  # files of the mosaic that are not found any more
    gone_sources: tuple[str, ...] = ()  # orthoimages that are not found any more
    layers_of_others: tuple[str, ...] = ()  # layers of mosaics that are not given, where any is
    twice: tuple[str, ...] = ()  # layers of different scans of one mosaic
    mosaics: int = 0  # how many the layers are of, where none is given
    cover: Mapping[int, SeamCover] = field(default_factory=dict, hash=False)  # as ``seam_cover`` gives it


@dataclass(frozen=True)
class Delivery:
    pieces: tuple[DeliveredPiece, ...]  # pieces of all sheets, in order
    wkt: str  # the reference system of all coordinates
    windows: tuple[SeenWindow, ...] = ()  # that were inspected
    lot_size: int | None = None  # pieces of the lot that the pieces are a sample of; None where they are no sample
    outlines: tuple[SheetOutline, ...] = ()  # outlines of the sheets where they were given
    is_checked: bool = False  # whether the outlines come from a check of the files: those without findings are complete
    layers: tuple[DeliveredLayer, ...] = ()  # that the pieces were read from, in the order in which they were given
    files: FileDoubts = field(default_factory=FileDoubts)  # whether what was scanned is what is given, or there, now

    @cached_property
    def unit_m(self) -> float:
        """Metres on the ground in a unit of the coordinates. Raises SettingsError as ``unit_metres``."""
        return unit_metres((piece.vertices for piece in self.pieces), self.wkt)

    @property
    def not_given(self) -> list[str]:
        """Names of orthoimages that seamlines name and the scans lacked."""
        names = ", ".join(layer.settings.get("not_given", "") for layer in self.layers).split(", ")
        return [*dict.fromkeys(filter(None, names))]

    @property
    def lacking_m(self) -> float:
        """Metres that are known to be missing; a sample lacks what was not drawn."""
        return 0.0 if self.is_part else sum(layer.lacking_m for layer in self.layers)

    @property
    def sampled_numbers(self) -> tuple[int, ...] | None:
        """The pieces of the sample in the order in which they were drawn; None where the layers are no sample."""
        drawn = [(piece.sample_number, piece.number) for piece in self.pieces if piece.sample_number is not None]
        return tuple(number for _, number in sorted(drawn)) if drawn else None

    @property
    def is_part(self) -> bool:
        """Whether the layers are a sample that leaves some of its lot out."""
        drawn = self.sampled_numbers
        return drawn is not None and (self.lot_size is None or self.lot_size > len(drawn))

    @property
    def findings(self) -> dict[str, str]:
        """What was found wrong with the files of sheets, by the names of these."""
        words: dict[str, list[str]] = {}
        for outline in self.outlines:
            if outline.findings:
                words.setdefault(outline.name, []).append(outline.findings)
        return {name: "; ".join(each) for name, each in words.items()}

    @property
    def sheets(self) -> tuple[str, ...]:
        """Their names in order: those with seams, and those whose outlines were given."""
        piece_sheets = {piece.sheet for piece in self.pieces}
        return tuple(sorted(piece_sheets | {outline.name for outline in self.outlines}, key=in_words))
