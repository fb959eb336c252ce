"""The table of a noise check: its fields, and rows from results. The field names are contracts."""
from __future__ import annotations

from collections.abc import Iterator

from qgis.core import QgsFeature, QgsFields

from ..toolkit.table_fields import feature, table_fields
from ..toolkit.translation import sentence
from .measure.band_noise import NoiseVerdict
from .measure.group_noise import ClipNoise


def noise_fields(levels: int) -> QgsFields:
    """OUTPUT: one row per window, raster and band; the last fields say which pixels were measured."""
    return table_fields(
        ("raster", "text"),
        ("group", "integer"),
        ("window_id", "integer"),
        ("band", "text"),
        *((f"detail_{level}", "real") for level in range(1, levels + 1)),
        ("background", "real"),
        *((f"kurtosis_{level}", "real") for level in range(1, levels + 1)),
        ("sigma", "real"),
        ("noise", "text"),
        ("reason", "text"),
        ("column", "integer"),
        ("row", "integer"),
        ("width", "integer"),
        ("height", "integer"),
        ("pixel_size", "real"),
        ("group_name", "text"),
        ("class", "text"),
        ("largest_sigma", "real"),
        ("grain", "real"),
        ("grain_sigma", "real"),
    )


def noise_features(result: ClipNoise, levels: int) -> Iterator[QgsFeature]:
    """The rows of OUTPUT for an image in a window; one without a band where nothing could be measured."""
    fields = noise_fields(levels)
    member, window = result.part.member, result.part.window
    head: list[object] = [member.image.ref.name, member.group, result.window_id]
    tail: list[object] = [window.column, window.row, window.width, window.height, member.ground_sample_distance]
    tail += [member.group_name or None, result.window_class]
    nothing: list[object] = [None] * levels
    if not result.bands:
        reason = sentence(result.reason) if result.reason else None
        unknown = [*nothing, None, *nothing, None, NoiseVerdict.NOT_MEASURABLE.value, reason]
        yield feature(fields, [*head, None, *unknown, *tail, None, None, None])
    for band, noise in result.bands.items():
        known = noise.curve.variance > 0
        shares: list[object] = [*noise.curve.detail, noise.curve.background] if known else [*nothing, None]
        note = sentence(noise.note) if noise.note else None
        grain: list[object] = [None, None] if noise.grain is None else [noise.grain.size, noise.grain.sigma]
        row = [*head, band, *shares, *noise.kurtosis, noise.sigma, noise.verdict.value, note, *tail]
        row += [noise.largest_sigma, *grain]
        yield feature(fields, row)
