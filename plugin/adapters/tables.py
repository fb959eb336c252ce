"""The tables of an inspection: their fields, and features from results. The field names are contracts."""
from __future__ import annotations

from collections.abc import Iterator

from qgis.core import QgsFeature, QgsFields, QgsGeometry

from ..core.inspection import WindowResult
from ..core.placing import PlacedWindow
from ..core.wavelets import Curve
from .compat import field
from .text import sentence


def window_fields(levels: int) -> QgsFields:
    """OUTPUT: one polygon per window, as measured."""
    return make_fields(
        ("window_id", "integer"),
        ("verdict", "text"),
        ("reason", "text"),
        ("sources", "integer"),
        *_ratio_fields(levels),
        ("background_ratio", "real"),
        ("observer", "text"),
    )


def curve_fields() -> QgsFields:
    """CURVES: one row per window, raster, band and component."""
    return make_fields(
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
    return make_fields(
        ("window_id", "integer"),
        ("source", "text"),
        ("band", "text"),
        *_ratio_fields(levels),
        ("similarity", "real"),
        ("offset_x", "real"),
        ("offset_y", "real"),
        ("resampled", "integer"),
    )


def placed_fields() -> QgsFields:
    """The windows of ``placewindows``."""
    return make_fields(("window_id", "integer"), ("seam_id", "integer"), ("station", "real"))


def placed_feature(placed: PlacedWindow, geometry: QgsGeometry) -> QgsFeature:
    """The row of a placed window."""
    return feature(placed_fields(), [placed.window_id, placed.seam_id, placed.station_m], geometry)


def window_feature(result: WindowResult, geometry: QgsGeometry, observer: str | None) -> QgsFeature:
    """The row of OUTPUT for a result."""
    judgement = result.judgement
    return feature(
        window_fields(len(judgement.ratios.detail)),
        [
            result.window_id,
            judgement.verdict.value,
            sentence(judgement.reason) if judgement.reason else None,
            result.source_count,
            *judgement.ratios.detail,
            judgement.ratios.background,
            observer,
        ],
        geometry,
    )


def curve_features(result: WindowResult) -> Iterator[QgsFeature]:
    """The rows of CURVES for a result; a constant clip has no relative variances."""
    fields = curve_fields()
    for clip in result.clips:
        for band, curve in clip.curves.items():
            for component, level, share in _components(curve):
                row = [result.window_id, clip.raster, clip.role, band, component, level]
                known = curve.variance > 0
                yield feature(fields, [*row, share if known else None, share * curve.variance if known else 0.0])


def pair_features(result: WindowResult) -> Iterator[QgsFeature]:
    """The rows of PAIRS for a result."""
    for pair in result.pairs:
        yield feature(
            pair_fields(len(pair.ratios.detail)),
            [
                result.window_id,
                pair.source,
                pair.band,
                *pair.ratios.detail,
                pair.similarity,
                pair.offset_x,
                pair.offset_y,
                int(pair.resampled),
            ],
        )


def feature(fields: QgsFields, values: list[object], geometry: QgsGeometry | None = None) -> QgsFeature:
    """A feature with all of its attributes."""
    row = QgsFeature(fields)
    row.setAttributes(values)
    if geometry is not None:
        row.setGeometry(geometry)
    return row


def _components(curve: Curve) -> Iterator[tuple[str, int, float]]:
    for level, share in enumerate(curve.detail, 1):
        yield "detail", level, share
    yield "background", len(curve.detail), curve.background


def _ratio_fields(levels: int) -> list[tuple[str, str]]:
    return [(f"ratio_{level}", "real") for level in range(1, levels + 1)]


def make_fields(*columns: tuple[str, str]) -> QgsFields:
    """Fields by name and kind (``integer``, ``real`` or ``text``)."""
    fields = QgsFields()
    for name, kind in columns:
        fields.append(field(name, kind))
    return fields
