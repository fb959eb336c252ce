"""What a scan tells: pieces of seam with what they kept and the verdict on each, windows of the worst, and tables.

The tables have one entry per column. The field names are contracts; layers and plain rows are made of them.
"""
from __future__ import annotations

import math
from collections import defaultdict
from collections.abc import Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, field, replace
from typing import Any, Callable

import numpy as np

from ....imagery import limits as imagery_limits
from ....imagery.documents import plugin_version
from ....imagery.errors import Message, RasterError
from ....imagery.grids import PixelWindow, standard_side_px
from ....imagery.lines import line_wkt
from ....imagery.raster_pool import open_raster
from ....imagery.rasters import Raster
from ....imagery.records import GEOMETRY, Column, Row, TableRows, kinds_of, rows_of
from ....imagery.seam_totals import PIECE, STANDARD_LEAST_KEPT, STRETCH, SYSTEM, PieceState, RowTotals, piece_state
from .. import messages
from ..following.likely_source import MIN_FIT
from ..judgement.verdicts import Verdict, judge_profile
from ..judgement.visibility import visibility
from ..limits import MEASURABLE_SIDE_PX
from ..planning.window_placing import SIDES_ACROSS, PlacedWindow, WindowIndex, fitting_window
from ..profile.seam_profile import LEAST_SEAM_PX, MIN_STRIP_PX
from ..profile.seam_sums import StripProfile
from ..seamlines.seam_pieces import SeamPiece
from ..seamlines.seam_tracing import SourcePolygon

MOST_GRAIN = 1.5 / 255
"""Rms of a source's finest detail, as a share of white: what sensors leave on even ground, and compression takes."""
LEAST_WITHOUT_VERDICT = 0.02  # of the seams: more is told
LEAST_FIT, FAINT = 1 / 3, 2 / 255
"""Share of the finest detail that its sources explain, and its rms as a share of white: with less a failure may be
what codecs leave over. Failed truly: 0.37 and 3 DN at least (Brighton, demo block; lossless, JPEG 75, 85); seemingly:
0.31 and 1.4 DN at most (generated ground of 2 to 20 DN; JPEG and WebP 85 to 95)."""
MIN_TEXTURE = 0.3  # of the energy that a source would have: with less its detail was brushed away


@dataclass(frozen=True)
class JudgedPiece:
    """A piece of seam with what it kept, or several that are too short by themselves: one feature of SEAMS."""

    piece: SeamPiece
    """Its course."""
    left: str | None
    """Name of the source on the left hand; None where nothing says."""
    right: str | None
    """Name of the source on the right hand."""
    kept: tuple[float | None, ...] | None
    """In the strip beside the seam, levels 1..R; None where nothing could be measured."""
    low: float | None
    """Lower end of the 95 % interval of kept_1."""
    high: float | None
    """Upper end."""
    band_width_m: float | None
    """Full width of the band in which less than 0.9 is kept."""
    verdict: Verdict
    """Verdict by what it kept beside the seam."""
    reason: Message | None = None
    """Why there is no verdict."""
    visibility: float | None = None
    """The loss in just noticeable differences of contrast at 2x; None too where no source says what there was."""
    feather_width_m: float | None = None
    """Full width of the feather; 0 for a cut, None where it was not looked for."""
    left_date: str | None = None
    """When the source on the left hand was taken, where the seams say so."""
    right_date: str | None = None
    """When the source on the right hand was taken, likewise."""
    state: PieceState = PieceState.NOT_MEASURED
    """What it counts as, where ``STANDARD_LEAST_KEPT`` has to be kept."""
    profile: str = ""
    """What is kept of the finest detail by distance from the seam, by the sums that ``kept`` is of: the field of SEAMS,
    as ``profile_text`` writes it; empty without orthoimages."""
    is_stretch: bool = False
    """Whether it is what several pieces keep together, and no piece that adds up."""

    @property
    def least_kept(self) -> float | None:
        """kept_1."""
        return self.kept[0] if self.kept else None


@dataclass(frozen=True, eq=False)
class PieceFigures:
    """A piece of seam and what was measured of it."""

    piece: SeamPiece
    strip: StripProfile
    grey: float = np.nan
    """Mean of the mosaic in the strip, DN; NaN where it is not known."""
    grain: float = np.nan
    """Largest rms of its sources' finest detail, DN; NaN where nothing was measured densely."""
    profile: str = ""
    """Profile as ``JudgedPiece`` has it."""
    beside: tuple[int, int] | None = None
    """What ``sources_beside`` gives for it; None where it was not asked for."""
    is_unchanged: bool = False
    """Whether the mosaic shows one source on both sides, as far as a line may lie aside."""


def judge_piece(
    figures: PieceFigures, sides: Sequence[str | None], ground_sample_distance: float, white: float
) -> JudgedPiece:
    """The verdict on one piece by its profile. ``sides``: names of the sources on its left and on its right; ``white``:
    what is white on a screen, DN."""
    piece, profile, state = figures.piece, figures.strip.profile, PieceState.NOT_MEASURED
    left, right = sides
    fails = profile is not None and (profile.kept[0] or 0) <= STANDARD_LEAST_KEPT
    is_even = figures.grain <= MOST_GRAIN * white  # never where that is not known
    if profile is None:
        why: Message | None = messages.PIECE_NOT_MEASURED()
        if figures.strip.area_px < MIN_STRIP_PX:
            length, needed = piece.length_m, LEAST_SEAM_PX * ground_sample_distance
            short = messages.PIECE_TOO_SHORT(length=length, needed=needed)
            why = short if length < needed else messages.PIECE_NOT_COMPARED()
    elif fails and figures.strip.fit < LEAST_FIT and profile.energy[0] < (FAINT * white) ** 2:
        why = messages.PIECE_NOT_MEASURED()
    # What little is left where detail was brushed away resembles no source.
    elif figures.strip.fit < MIN_FIT and figures.strip.texture >= MIN_TEXTURE:
        why = messages.COMPOSITE_UNCLEAR()
    elif profile.is_between_copies and not fails:
        why = messages.SAME_ALONG_THE_SEAM()
    else:
        verdict, why = judge_profile(profile)
        has_verdict = verdict is not Verdict.NOT_COMPARABLE
        state = piece_state(profile.kept[0], profile.low, profile.high, STANDARD_LEAST_KEPT, has_verdict)
        if state is not PieceState.NOT_MEASURED or not is_even:
            width = profile.band_width_px * ground_sample_distance
            feather = None if profile.feather_width_px is None else profile.feather_width_px * ground_sample_distance
            return JudgedPiece(
                piece, left, right, profile.kept, profile.low, profile.high, width, verdict, why,
                visibility(profile.kept, profile.energy, figures.grey, white), feather, state=state,
                profile=figures.profile,
            )
    if is_even:
        why, state = messages.PIECE_WITHOUT_DETAIL(), PieceState.NO_DETAIL
    return JudgedPiece(piece, left, right, None, None, None, None, Verdict.NOT_COMPARABLE, why, state=state)


def dated(judged: JudgedPiece, dates: Mapping[str, str]) -> JudgedPiece:
    """A piece with the dates of its sources; ``dates``: by their names."""
    return replace(judged, left_date=dates.get(judged.left or ""), right_date=dates.get(judged.right or ""))


def without_verdict(pieces: Sequence[JudgedPiece]) -> tuple[Message, ...]:
    """How much of the seams could not be judged, where that is worth telling, and why, the most metres first."""
    lacking, total = metres(pieces, PieceState.NOT_MEASURED), metres(pieces)
    if lacking <= 0 or lacking < LEAST_WITHOUT_VERDICT * total:
        return ()
    lengths: defaultdict[Message, float] = defaultdict(float)
    for piece in pieces:
        if piece.state is PieceState.NOT_MEASURED and piece.reason is not None:
            lengths[piece.reason] += piece.piece.length_m
    most = sorted(lengths.items(), key=lambda item: -item[1])[:3]
    reasons = (messages.PIECES_NOT_MEASURED(metres=length, reason=reason) for reason, length in most)
    return messages.SEAMS_WITHOUT_VERDICT(metres=lacking, all=total), *reasons


def metres(pieces: Sequence[JudgedPiece], *states: PieceState) -> float:
    """Length of all pieces, or of those that count as one of some states."""
    return math.fsum(piece.piece.length_m for piece in pieces if not states or piece.state in states)


def worst_windows(
    pieces: Sequence[JudgedPiece], mosaic: Raster, count: int, levels: int,
    is_valid: Callable[[PixelWindow], bool] = lambda window: True,
) -> list[PlacedWindow]:
    """Up to ``count`` windows on the pieces that kept least, the least first, each where the mosaic has pixels; of two
    that share more than half only the worse.

    A window lies around its piece, or is moved aside, or made smaller, as far as it has to be; where it fits nowhere
    there is none. ``is_valid``: whether a window has enough pixels, where the file says nothing of it, or can't be
    read.
    """
    grid = mosaic.grid
    with suppress(RasterError):
        is_valid = is_valid if (opened := open_raster(mosaic.ref)).is_all_valid else opened.is_valid
    # The standard side; of a mosaic that hardly holds such windows a part of it, so that they tell places apart.
    side, shorter = standard_side_px(grid, imagery_limits.STANDARD_SIDE_M), min(grid.columns, grid.rows)
    while side > MEASURABLE_SIDE_PX and side * SIDES_ACROSS > shorter:
        side //= 2
    side = min(side, shorter)
    side -= side % 2**levels
    taken = WindowIndex(max(side, 1))
    worst: list[PlacedWindow] = []
    measured = [(piece.least_kept, number) for number, piece in enumerate(pieces) if piece.least_kept is not None]
    for _, number in sorted(measured):
        judged = pieces[number]
        if len(worst) >= count:
            break
        window = fitting_window(*judged.piece.middle, grid, side, is_valid)
        if window is None or taken.shares_too_much(window):
            continue
        taken.add(window)
        station = judged.piece.station_m + judged.piece.length_m / 2
        worst.append(PlacedWindow(len(worst) + 1, judged.piece.seam_id, station, window))
    return worst


@dataclass(frozen=True)
class ScanResult:
    """What a scan tells."""

    pieces: tuple[JudgedPiece, ...]
    """All seams, piece by piece."""
    polygons: tuple[SourcePolygon, ...]
    """The source that each part came from, by its number in ``sources``."""
    worst: tuple[PlacedWindow, ...] = ()
    """The least kept places, the least first."""
    stretches: tuple[JudgedPiece, ...] = ()
    """What pieces keep together that are too short to be judged one by one, as without orthoimages."""
    notices: tuple[Message, ...] = ()
    """What was left out, assumed or could not be judged."""
    told: Mapping[str, str] = field(default_factory=dict, hash=False)
    """What its layers and its picture say of it: the settings; whether ``seams`` were ``given`` or ``found``;
    which share of textured ground is ``unexplained``, and the metres of ``unexplained_border`` beside no seam; by how
    many metres to the east and north the mosaic lies beside all orthoimages (``mosaic_shift``) where that is why; which
    share of the mosaic within its outline has no pixels (``nodata_inside``); ``unseen_metres`` of border between two
    orthoimages that no seam tells of, ``hidden_metres`` of these along which nothing explains the mosaic, the longest
    of either in one place (``unseen_longest``, ``hidden_longest``); ``unchanged_metres`` of given seams that name two
    orthoimages and along which the mosaic shows one; the share ``looked_at`` where a corridor leaves some out.
    ``unseen_at``, ``hidden_at``, ``unexplained_at``, ``nodata_at``: up to three places each, the largest first, as
    ``x y width height`` (map units, metres), joined by ``; ``; which share of the mosaic is ``unread``, and
    ``unread_at`` a place in it; which files were scanned, by ``mosaic_files`` and ``source_files``; sources that
    ``may_be_copies`` of the mosaic, those that hold it along their seams (``mixed_sources``, ``mixed_metres``, a place
    ``mixed_at``), and those that seamlines name and were ``not_given``; the ``metres`` of all pieces.
    Figures of 0 are left out, but for ``unexplained``, ``metres`` and the reference ``system``."""
    sources: tuple[str, ...] = ()
    """Names of the orthoimages, parts of one image as one, by the numbers of ``polygons``."""

    @property
    def features(self) -> tuple[JudgedPiece, ...]:
        """Features of the layer SEAMS: all pieces, then the stretches."""
        return self.pieces + self.stretches

    def to_dataframe(self) -> Any:
        """The table ``seam_rows`` as a ``pandas.DataFrame``."""
        return seam_rows(self).to_dataframe()

    def to_geodataframe(self) -> Any:
        """The table ``seam_rows`` as a ``geopandas.GeoDataFrame``."""
        return seam_rows(self).to_geodataframe()

    @property
    def seam_metres(self) -> float:
        """Length of all seams."""
        return metres(self.pieces)

    @property
    def failed_metres(self) -> float:
        """Length of the pieces that failed: that keep less than 0.7 (``STANDARD_LEAST_KEPT``)."""
        return metres(self.pieces, PieceState.FAILED)

    @property
    def worst_kept(self) -> float | None:
        """kept_1 of the piece that kept least; None where nothing could be measured."""
        return min((piece.least_kept for piece in self.pieces if piece.least_kept is not None), default=None)


SEAM_COLUMNS: tuple[Column[JudgedPiece], ...] = (
    Column("seam_id", "integer", lambda judged: judged.piece.seam_id),
    Column("station", "real", lambda judged: judged.piece.station_m),
    Column("left_source", "text", lambda judged: judged.left),
    Column("right_source", "text", lambda judged: judged.right),
    Column("left_date", "text", lambda judged: judged.left_date),
    Column("right_date", "text", lambda judged: judged.right_date),
    Column("length", "real", lambda judged: judged.piece.length_m),
    Column("level", "text", lambda judged: STRETCH if judged.is_stretch else PIECE),
    Column("state", "text", lambda judged: judged.state.value),
    Column("kept", "real", lambda judged: judged.kept, by_level=True),
    Column("kept_low", "real", lambda judged: judged.low),
    Column("kept_high", "real", lambda judged: judged.high),
    Column("band_width", "real", lambda judged: judged.band_width_m),
    Column("feather_width", "real", lambda judged: judged.feather_width_m),
    Column("visibility", "real", lambda judged: judged.visibility),
    Column("profile", "text", lambda judged: judged.profile or None),
    Column("verdict", "text", lambda judged: judged.verdict.value),
    Column("reason", "text", lambda judged: judged.reason),
)
"""SEAMS: one line per piece of seam."""

CELL_COLUMNS: tuple[Column[str], ...] = (Column("source", "text", lambda name: name),)
"""CELLS: one polygon per source."""


def seam_rows(result: ScanResult) -> TableRows:
    """One row per piece of seam: what it kept with its 95 % interval, widths (m), verdict.

    The fields are those of the layer SEAMS (docs/reference/tables.md), and ``geometry``: the line as WKT in the
    mosaic's reference system.
    """
    imagery_limits.check_type("result", result, ScanResult)
    held, levels = _field_rows(result.features)
    rows = ({**row, GEOMETRY: line_wkt(feature.piece.vertices)} for row, feature in zip(held, result.features))
    return TableRows(rows, result.told.get(SYSTEM, ""), {**kinds_of(SEAM_COLUMNS, levels), GEOMETRY: "text"})


def seam_notes(result: ScanResult) -> dict[str, str]:
    """What stands beside the rows of SEAMS: how and of what they were measured, their totals, and the seal."""
    notes = {"version": plugin_version(), **result.told}
    lines = (feature.piece.vertices for feature in result.features)
    return RowTotals(zip(_field_rows(result.features)[0], lines)).sealed(notes)


def _field_rows(features: Sequence[JudgedPiece]) -> tuple[Iterator[Row], int]:
    levels = max((len(feature.kept) for feature in features if feature.kept), default=1)
    return rows_of(SEAM_COLUMNS, features, levels), levels
