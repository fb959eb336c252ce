"""The tables of an inspection, one entry per column: its field, and how its value comes from a result; and a window's
result as bytes that are kept beside the window layer, and back.

The field names are contracts; layers, the desk and plain rows are made of them.
"""
from __future__ import annotations

from collections.abc import Iterable, Iterator
from functools import cache
from typing import Any, NamedTuple

from ....imagery import messages as imagery_messages
from ....imagery.errors import Message
from ....imagery.records import Column, NotUnderstoodError, Row, record_of, rows_of, value_of
from ....imagery.shifts import Shift
from ....imagery.wavelets import DIRECTIONS, Curve
from .. import messages
from ..compared_image import Change
from ..profile.seam_profile import ProfileBin
from ..tone import Tone
from .window_result import ClipResult, PairResult, WindowResult


class CurveRow(NamedTuple):
    """A component of a curve."""

    window_id: int
    clip: ClipResult
    band: str
    curve: Curve
    component: str
    level: int
    share: float


class ProfileRow(NamedTuple):
    """What a window kept at one distance from its seam."""

    window_id: int
    bin: ProfileBin
    pixel_m: float


class PairRow(NamedTuple):
    """The mosaic against a source in a window, and what became of the source's grey values where that is known."""

    window_id: int
    pair: PairResult
    change: Change | None
    tone: Tone | None
    shift: Shift | None


CURVE_COLUMNS: tuple[Column[CurveRow], ...] = (
    Column("window_id", "integer", lambda row: row.window_id),
    Column("raster", "text", lambda row: row.clip.raster),
    Column("role", "text", lambda row: row.clip.role),
    Column("band", "text", lambda row: row.band),
    Column("component", "text", lambda row: row.component),
    Column("level", "integer", lambda row: row.level),
    Column("relative_variance", "real", lambda row: row.share if row.curve.variance > 0 else None),
    Column("variance", "real", lambda row: row.share * row.curve.variance if row.curve.variance > 0 else 0.0),
)
"""CURVES: one row per window, raster, band and component; a constant clip has no relative variances."""

PROFILE_COLUMNS: tuple[Column[ProfileRow], ...] = (
    Column("window_id", "integer", lambda row: row.window_id),
    Column("level", "integer", lambda row: row.bin.level),
    Column("distance", "real", lambda row: row.pixel_m * row.bin.middle_px),
    Column("kept", "real", lambda row: row.bin.kept),
    Column("low", "real", lambda row: row.bin.low),
    Column("high", "real", lambda row: row.bin.high),
    Column("area", "real", lambda row: row.pixel_m**2 * row.bin.area_px),
    Column("mixture", "real", lambda row: row.bin.mixture),
)
"""PROFILES: one row per window, level and distance from the seam."""

PAIR_COLUMNS: tuple[Column[PairRow], ...] = (
    Column("window_id", "integer", lambda row: row.window_id),
    Column("source", "text", lambda row: row.pair.source),
    Column("band", "text", lambda row: row.pair.band),
    Column("ratio", "real", lambda row: row.pair.ratios.detail, by_level=True),
    Column("similarity", "real", lambda row: row.pair.similarity),
    Column("offset_x", "real", lambda row: row.pair.offset_x),
    Column("offset_y", "real", lambda row: row.pair.offset_y),
    Column("resampled", "integer", lambda row: int(row.pair.resampled)),
    Column("gain", "real", lambda row: row.tone and row.tone.gain),
    Column("bias", "real", lambda row: row.tone and row.tone.bias),
    Column("gamma", "real", lambda row: row.tone and row.tone.gamma),
    Column("contrast", "real", lambda row: row.change and row.change.contrast, by_level=True),
    Column("sharpness", "real", lambda row: row.change and row.change.sharpness, by_level=True),
    Column("clipped", "real", lambda row: row.change and row.change.clipped),
    Column("colour_shift", "real", lambda row: row.change and row.change.colour_shift),
    Column("shift_x", "real", lambda row: row.shift and row.shift.x),
    Column("shift_y", "real", lambda row: row.shift and row.shift.y),
)
"""PAIRS: one row per window, source and band."""

WINDOW_COLUMNS: tuple[Column[WindowResult], ...] = (
    Column("window_id", "integer", lambda result: result.window_id),
    Column("verdict", "text", lambda result: result.judgement.verdict.value),
    Column("reason", "text", lambda result: result.judgement.reason),
    Column("sources", "integer", lambda result: result.source_count),
    Column("ratio", "real", lambda result: result.judgement.ratios.detail, by_level=True),
    Column("background_ratio", "real", lambda result: result.judgement.ratios.background),
    Column("composite_ratio", "real", lambda result: _composite_ratios(result), by_level=True),
    Column("expected_ratio", "real", lambda result: result.explanation and result.explanation.expected, by_level=True),
    Column("unclear_share", "real", lambda result: result.explanation and result.explanation.unclear_share),
    Column("cause", "text", lambda result: result.explanation and result.explanation.cause.value),
    Column("causes", "text", lambda result: "; ".join(cause.value for cause in result.causes) or None),
    Column("reference", "text", lambda result: result.reference),
    Column("paper_verdict", "text", lambda result: result.paper_verdict.value),
    Column("kept", "real", lambda result: result.profile and result.profile.kept, by_level=True),
    Column("kept_low", "real", lambda result: result.profile and result.profile.low),
    Column("kept_high", "real", lambda result: result.profile and result.profile.high),
    Column("band_width", "real", lambda result: result.band_width_m),
    Column("feather_width", "real", lambda result: result.feather_width_m),
    Column("visibility", "real", lambda result: result.visibility),
    Column("misfit", "real", lambda result: result.misfit),
    Column("contrast_1", "real", lambda result: result.explanation and result.explanation.contrast),
    Column("sharpness_1", "real", lambda result: result.explanation and result.explanation.sharpness),
    Column("added_1", "real", lambda result: result.explanation and result.explanation.added),
    Column("explained", "real", lambda result: result.explained),
)
"""OUTPUT of ``inspectwindows``: one row per window, as measured."""


def window_rows(results: Iterable[WindowResult]) -> list[Row]:
    """One row per window: verdict, ratios, kept along the seam with its interval, widths, causes.

    The fields are those of the table OUTPUT (docs/reference/tables.md); lengths in metres, shares of 1, DN for grey
    values.
    """
    found = list(results)
    return list(rows_of(WINDOW_COLUMNS, found, _most_levels(found)))


def profile_rows(results: Iterable[WindowResult]) -> list[Row]:
    """One row per window, level and distance from the seam (m): what is kept there, with its 95 % interval.

    The fields are those of the table PROFILES; a window without a seam has no rows.
    """
    return [row for result in results for row in rows_of(PROFILE_COLUMNS, bins_of(result))]


def curve_rows(results: Iterable[WindowResult]) -> list[Row]:
    """One row per window, raster, band, component and level: its relative variance, and its variance (DN squared).

    The fields are those of the table CURVES.
    """
    return [row for result in results for row in rows_of(CURVE_COLUMNS, curves_of(result))]


def pair_rows(results: Iterable[WindowResult]) -> list[Row]:
    """One row per window, source and band: ratios, tones and shifts (px) of the mosaic against that source.

    The fields are those of the table PAIRS; the sources' composite comes last.
    """
    found = list(results)
    most = _most_levels(found)
    return [row for result in found for row in rows_of(PAIR_COLUMNS, pairs_of(result), most)]


def bins_of(result: WindowResult) -> Iterator[ProfileRow]:
    """The rows of PROFILES for a result; none without a seam."""
    bins = result.profile.bins if result.profile else ()
    return (ProfileRow(result.window_id, one, result.ground_sample_distance) for one in bins)


def pairs_of(result: WindowResult) -> Iterator[PairRow]:
    """The rows of PAIRS for a result: each source, then their composite."""
    for pair in (*result.pairs, *result.composite_pairs):
        change = pair.change
        yield PairRow(result.window_id, pair, change, change.tone if change else None, change.shift if change else None)


def curves_of(result: WindowResult) -> Iterator[CurveRow]:
    """The rows of CURVES for a result."""
    for clip in result.with_composite:
        for band, curve in clip.curves.items():
            shares = [*(("detail", level, share) for level, share in enumerate(curve.detail, 1)),
                      ("background", len(curve.detail), curve.background)]
            for level, directions in enumerate(clip.directions.get(band, ()), 1):
                shares += [(component, level, share) for component, share in zip(DIRECTIONS, directions)]
            for component, level, share in shares:
                yield CurveRow(result.window_id, clip, band, curve, component, level, share)


def _composite_ratios(result: WindowResult) -> tuple[float | None, ...] | None:
    return next(iter(result.explanation.ratios.values())).detail if result.explanation else None


def _most_levels(results: Iterable[WindowResult]) -> int:
    return max((result.levels for result in results), default=0)


def result_record(result: WindowResult) -> bytes:
    """All that was measured; the picture of the loss to a two-thousandth."""
    return record_of(result)


def result_of(record: bytes) -> WindowResult | None:
    """None for what can't be read, or is of another version."""
    try:
        found: Any = value_of(WindowResult, record, _sentences())
    except NotUnderstoodError:
        return None
    return found if isinstance(found, WindowResult) else None


@cache
def _sentences() -> dict[str, Message]:
    """Those that a result may hold."""
    every = (*vars(imagery_messages).values(), *vars(messages).values())
    return {one.template: one for one in every if isinstance(one, Message)}
