"""The tables of an inspection, one entry per column: its field, and how its value comes from a result.

The field names are contracts. Those of a window are in ``window_fields``.
"""
from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from typing import NamedTuple

from qgis.core import QgsFeature, QgsFields, QgsGeometry

from ...imagery.shifts import Shift
from ...imagery.statistics.observers import JUDGING_FIELDS
from ...imagery.wavelets import DIRECTIONS, Curve
from ...toolkit.attribute_values import whole_number
from ...toolkit.table_fields import Column, column_features, column_fields, column_values, feature
from ...toolkit.version_differences import field
from ..measure.changes import Change
from ..measure.loss_forecast import Forecast, ForecastPair
from ..measure.placing.window_placing import PlacedWindow
from ..measure.profile.seam_profile import ProfileBin
from ..measure.tone import Tone
from ..measure.window.window_result import ClipResult, PairResult, WindowResult
from .window_fields import MEASURED, reason_words


class _CurveRow(NamedTuple):
    """A component of a curve."""

    window_id: int
    clip: ClipResult
    band: str
    curve: Curve
    component: str
    level: int
    share: float


class _ProfileRow(NamedTuple):
    """What a window kept at one distance from its seam."""

    window_id: int
    bin: ProfileBin
    pixel_m: float


class _PairRow(NamedTuple):
    """The mosaic against a source in a window, and what became of the source's grey values where that is known."""

    window_id: int
    pair: PairResult
    change: Change | None
    tone: Tone | None
    shift: Shift | None


CURVE_COLUMNS: tuple[Column[_CurveRow], ...] = (
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

PROFILE_COLUMNS: tuple[Column[_ProfileRow], ...] = (
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

PAIR_COLUMNS: tuple[Column[_PairRow], ...] = (
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

FORECAST_COLUMNS: tuple[Column[Forecast], ...] = (
    Column("window_id", "integer", lambda forecast: forecast.window_id),
    Column("reason", "text", lambda forecast: reason_words(forecast.reason)),
    Column("sources", "integer", lambda forecast: forecast.sources),
    Column("expected_ratio", "real", lambda forecast: forecast.expected, by_level=True),
    Column("window_kept", "real", lambda forecast: forecast.kept and forecast.kept.window, by_level=True),
    Column("strip_kept", "real", lambda forecast: forecast.kept and forecast.kept.strip, by_level=True),
)
"""OUTPUT of ``predictloss``: one polygon per window."""

FORECAST_PAIR_COLUMNS: tuple[Column[tuple[Forecast, ForecastPair]], ...] = (
    Column("window_id", "integer", lambda row: row[0].window_id),
    Column("source", "text", lambda row: row[1].source),
    Column("other", "text", lambda row: row[1].other),
    Column("band", "text", lambda row: row[0].band),
    Column("rho", "real", lambda row: row[1].feather.rho, by_level=True),
    Column("ratio", "real", lambda row: row[1].feather.ratios, by_level=True),
    Column("window_kept", "real", lambda row: row[1].kept and row[1].kept.window, by_level=True),
    Column("strip_kept", "real", lambda row: row[1].kept and row[1].kept.strip, by_level=True),
    Column("shift_x", "real", lambda row: row[1].shift and row[1].shift.x),
    Column("shift_y", "real", lambda row: row[1].shift and row[1].shift.y),
    Column("resampled", "integer", lambda row: int(row[1].resampled)),
)
"""PAIRS of ``predictloss``: one row per window and pair of sources."""

PLACED_COLUMNS: tuple[Column[PlacedWindow], ...] = (
    Column("window_id", "integer", lambda placed: placed.window_id),
    Column("seam_id", "integer", lambda placed: placed.seam_id),
    Column("station", "real", lambda placed: placed.station_m),
)
"""The windows of ``placewindows``."""


def window_fields(levels: int) -> QgsFields:
    """Of OUTPUT, and of every window layer."""
    return column_fields(MEASURED, levels)


def output_fields(levels: int, said: Iterable[str]) -> QgsFields:
    """Of OUTPUT: those of every window, and what operators said as far as the windows given have it."""
    fields = window_fields(levels)
    for name in said:
        if fields.indexOf(name) < 0:
            fields.append(field(name, JUDGING_FIELDS[name]))
    return fields


def window_feature(result: WindowResult, geometry: QgsGeometry | None, said: Mapping[str, str | None]) -> QgsFeature:
    """The row of OUTPUT for a result; ``said``: what operators said, by the fields' names."""
    levels = len(result.judgement.ratios.detail)
    fields = output_fields(levels, said)
    values = column_values(MEASURED, result, levels)
    row = feature(fields, [*values, *[None] * (fields.count() - len(values))], geometry)
    for name, value in said.items():
        row[name] = whole_number(value) if JUDGING_FIELDS[name] == "integer" else value
    return row


def curve_features(result: WindowResult) -> Iterator[QgsFeature]:
    """The rows of CURVES for a result."""
    return column_features(CURVE_COLUMNS, _curve_rows(result))


def pair_features(result: WindowResult) -> Iterator[QgsFeature]:
    """The rows of PAIRS for a result: each source, then their composite."""
    rows = (
        _PairRow(result.window_id, pair, change, change.tone if change else None, change.shift if change else None)
        for pair in (*result.pairs, *result.composite_pairs)
        for change in (pair.change,)
    )
    return column_features(PAIR_COLUMNS, rows, len(result.judgement.ratios.detail))


def profile_features(result: WindowResult) -> Iterator[QgsFeature]:
    """The rows of PROFILES for a result; none without a seam."""
    bins = result.profile.bins if result.profile else ()
    rows = (_ProfileRow(result.window_id, one, result.ground_sample_distance) for one in bins)
    return column_features(PROFILE_COLUMNS, rows)


def forecast_pair_features(forecast: Forecast) -> Iterator[QgsFeature]:
    """The rows of PAIRS for a forecast."""
    rows = ((forecast, pair) for pair in forecast.pairs)
    return column_features(FORECAST_PAIR_COLUMNS, rows, len(forecast.expected))


def _curve_rows(result: WindowResult) -> Iterator[_CurveRow]:
    for clip in result.with_composite:
        for band, curve in clip.curves.items():
            shares = [*(("detail", level, share) for level, share in enumerate(curve.detail, 1)),
                      ("background", len(curve.detail), curve.background)]
            for level, directions in enumerate(clip.directions.get(band, ()), 1):
                shares += [(component, level, share) for component, share in zip(DIRECTIONS, directions)]
            for component, level, share in shares:
                yield _CurveRow(result.window_id, clip, band, curve, component, level, share)
