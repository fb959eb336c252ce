"""The tables of an inspection: their fields, and features from results. The field names are contracts."""
from __future__ import annotations

from collections.abc import Iterator

from qgis.core import QgsFeature, QgsFields, QgsGeometry

from ...imagery.shifts import Shift
from ...imagery.wavelets import Curve
from ...toolkit.table_fields import feature, table_fields
from ...toolkit.translation import sentence
from ..measure.explanation import Change
from ..measure.inspection import WindowResult
from ..measure.loss_forecast import Forecast
from ..measure.window_placing import PlacedWindow


def window_fields(levels: int) -> QgsFields:
    """OUTPUT: one polygon per window, as measured."""
    return table_fields(
        ("window_id", "integer"),
        ("verdict", "text"),
        ("reason", "text"),
        ("sources", "integer"),
        *_level_fields("ratio", levels),
        ("background_ratio", "real"),
        ("observer", "text"),
        *_level_fields("composite_ratio", levels),
        *_level_fields("expected_ratio", levels),
        ("unclear_share", "real"),
        ("cause", "text"),
    )


def curve_fields() -> QgsFields:
    """CURVES: one row per window, raster, band and component."""
    return table_fields(
        ("window_id", "integer"),
        ("raster", "text"),
        ("role", "text"),
        ("band", "text"),
        ("component", "text"),
        ("level", "integer"),
        ("relative_variance", "real"),
        ("variance", "real"),
    )


def pair_fields(levels: int) -> QgsFields:
    """PAIRS: one row per window, source and band."""
    return table_fields(
        ("window_id", "integer"),
        ("source", "text"),
        ("band", "text"),
        *_level_fields("ratio", levels),
        ("similarity", "real"),
        ("offset_x", "real"),
        ("offset_y", "real"),
        ("resampled", "integer"),
        ("gain", "real"),
        ("bias", "real"),
        ("gamma", "real"),
        *_level_fields("contrast", levels),
        *_level_fields("sharpness", levels),
        ("clipped", "real"),
        ("colour_shift", "real"),
        ("shift_x", "real"),
        ("shift_y", "real"),
    )


def forecast_fields(levels: int) -> QgsFields:
    """OUTPUT of ``predictloss``: one polygon per window."""
    return table_fields(
        ("window_id", "integer"),
        ("reason", "text"),
        ("sources", "integer"),
        *_level_fields("expected_ratio", levels),
    )


def forecast_pair_fields(levels: int) -> QgsFields:
    """PAIRS of ``predictloss``: one row per window and pair of sources."""
    return table_fields(
        ("window_id", "integer"),
        ("source", "text"),
        ("other", "text"),
        ("band", "text"),
        *_level_fields("rho", levels),
        *_level_fields("ratio", levels),
        ("shift_x", "real"),
        ("shift_y", "real"),
        ("resampled", "integer"),
    )


def placed_fields() -> QgsFields:
    """The windows of ``placewindows``."""
    return table_fields(("window_id", "integer"), ("seam_id", "integer"), ("station", "real"))


def placed_feature(placed: PlacedWindow, geometry: QgsGeometry) -> QgsFeature:
    """The row of a placed window."""
    return feature(placed_fields(), [placed.window_id, placed.seam_id, placed.station_m], geometry)


def window_feature(result: WindowResult, geometry: QgsGeometry, observer: str | None) -> QgsFeature:
    """The row of OUTPUT for a result."""
    judgement, found = result.judgement, result.explanation
    levels = len(judgement.ratios.detail)
    unknown = [None] * levels
    return feature(
        window_fields(levels),
        [
            result.window_id,
            judgement.verdict.value,
            sentence(judgement.reason) if judgement.reason else None,
            result.source_count,
            *judgement.ratios.detail,
            judgement.ratios.background,
            observer,
            *(next(iter(found.ratios.values())).detail if found else unknown),
            *(found.expected if found else unknown),
            found.unclear_share if found else None,
            found.cause.value if found else None,
        ],
        geometry,
    )


def curve_features(result: WindowResult) -> Iterator[QgsFeature]:
    """The rows of CURVES for a result; a constant clip has no relative variances."""
    fields = curve_fields()
    for clip in result.with_composite:
        for band, curve in clip.curves.items():
            for component, level, share in _components(curve):
                row = [result.window_id, clip.raster, clip.role, band, component, level]
                known = curve.variance > 0
                yield feature(fields, [*row, share if known else None, share * curve.variance if known else 0.0])


def pair_features(result: WindowResult) -> Iterator[QgsFeature]:
    """The rows of PAIRS for a result: each source, then their composite."""
    for pair in (*result.pairs, *result.composite_pairs):
        levels = len(pair.ratios.detail)
        yield feature(
            pair_fields(levels),
            [
                result.window_id,
                pair.source,
                pair.band,
                *pair.ratios.detail,
                pair.similarity,
                pair.offset_x,
                pair.offset_y,
                int(pair.resampled),
                *_change_values(pair.change, levels),
            ],
        )


def _change_values(change: Change | None, levels: int) -> list[object]:
    if change is None:
        return [None] * (7 + 2 * levels)
    tone = change.tone
    return [
        *((tone.gain, tone.bias, tone.gamma) if tone else (None, None, None)),
        *change.contrast,
        *change.sharpness,
        change.clipped,
        change.colour_shift,
        *_shift_values(change.shift),
    ]


def _shift_values(shift: Shift | None) -> tuple[float | None, float | None]:
    return (shift.x, shift.y) if shift else (None, None)


def forecast_feature(forecast: Forecast, geometry: QgsGeometry | None) -> QgsFeature:
    """The row of OUTPUT for a forecast."""
    reason = sentence(forecast.reason) if forecast.reason else None
    fields = forecast_fields(len(forecast.expected))
    return feature(fields, [forecast.window_id, reason, forecast.sources, *forecast.expected], geometry)


def forecast_pair_features(forecast: Forecast) -> Iterator[QgsFeature]:
    """The rows of PAIRS for a forecast."""
    fields = forecast_pair_fields(len(forecast.expected))
    for pair in forecast.pairs:
        row = [forecast.window_id, pair.source, pair.other, forecast.band, *pair.feather.rho, *pair.feather.ratios]
        yield feature(fields, [*row, *_shift_values(pair.shift), int(pair.resampled)])


def _components(curve: Curve) -> Iterator[tuple[str, int, float]]:
    for level, share in enumerate(curve.detail, 1):
        yield "detail", level, share
    yield "background", len(curve.detail), curve.background


def _level_fields(name: str, levels: int) -> list[tuple[str, str]]:
    return [(f"{name}_{level}", "real") for level in range(1, levels + 1)]
