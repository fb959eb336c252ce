"""Random noise in plain words, counts and table rows. Knows no matplotlib."""
from __future__ import annotations

import math
from collections import Counter
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from typing import NamedTuple

from qgis.core import QgsFeature, QgsFields
from qgis.PyQt.QtCore import QT_TR_NOOP

from ..imagery.limits import judged_band
from ..imagery.records import Column
from ..imagery.wavelets import Curve
from ..toolkit.table_fields import column_features, column_fields, number
from ..toolkit.translation import tr
from .measure.band_noise import SEVERITY, BandNoise, NoiseVerdict, noisiest_band
from .measure.grain import NoiseAmount
from .measure.group_noise import ClipNoise

VERDICT_WORDS = {
    NoiseVerdict.LOW: QT_TR_NOOP("low"),
    NoiseVerdict.UNCERTAIN: QT_TR_NOOP("uncertain"),
    NoiseVerdict.MODERATE: QT_TR_NOOP("moderate"),
    NoiseVerdict.STRONG: QT_TR_NOOP("strong"),
    NoiseVerdict.NOT_MEASURABLE: QT_TR_NOOP("not measurable"),
}

AMOUNT_WORDS = {
    NoiseAmount.LITTLE: QT_TR_NOOP("little"),
    NoiseAmount.SOME: QT_TR_NOOP("some"),
    NoiseAmount.MUCH: QT_TR_NOOP("much"),
    NoiseAmount.AT_MOST_SOME: QT_TR_NOOP("at most some"),
    NoiseAmount.UNCERTAIN: QT_TR_NOOP("uncertain"),
    NoiseAmount.NOT_MEASURABLE: QT_TR_NOOP("not measurable"),
}


def verdict_counts(results: Iterable[ClipNoise]) -> Counter[NoiseVerdict]:
    """The number of windows by verdict. A window that several images of a group show counts once in the group, with
    their strongest verdict: it is the same ground."""
    verdicts: dict[tuple[int, int], NoiseVerdict] = {}
    for result in results:
        window = result.part.member.group, result.window_id
        known = verdicts.get(window, NoiseVerdict.NOT_MEASURABLE)
        verdicts[window] = max(known, verdict_of(result), key=SEVERITY.index)
    return Counter(verdicts.values())


def verdict_of(result: ClipNoise) -> NoiseVerdict:
    """The verdict of the noisiest band."""
    judged = judged_noise(result)
    return judged.verdict if judged else NoiseVerdict.NOT_MEASURABLE


def judged_noise(result: ClipNoise) -> BandNoise | None:
    """The noise of the noisiest band; None where nothing could be measured."""
    return result.bands[noisiest_band(result.bands)] if result.bands else None


def compared_curve(result: ClipNoise) -> tuple[float, ...] | None:
    """The curve by which windows are compared: of the luminance, or the first band (Pyka 2009, figure 3).

    The noisiest band is another one from window to window.
    """
    noise = result.bands[judged_band(result.bands)] if result.bands else None
    return noise.curve.detail if noise is not None and noise.curve.variance > 0 else None


@dataclass(frozen=True)
class NoiseGroup:
    """The results on the windows of one class in one group of images."""

    window_class: str | None
    group: int
    name: str  # name of the group of images
    results: tuple[ClipNoise, ...]

    @property
    def windows(self) -> int:
        """The number of windows with a curve; ground that several images show counts once."""
        return len({result.window_id for result in self.results if compared_curve(result) is not None})

    @property
    def curves(self) -> list[tuple[float, ...]]:
        """Curves by which they are compared."""
        return [curve for result in self.results if (curve := compared_curve(result)) is not None]


def noise_groups(results: Sequence[ClipNoise]) -> list[NoiseGroup]:
    """The results by class of windows, numbers by size and those without one last, and by group of images."""
    groups: dict[tuple[str | None, int], list[ClipNoise]] = {}
    for result in results:
        groups.setdefault((result.window_class, result.part.member.group), []).append(result)

    def order(key: tuple[str | None, int]) -> tuple[bool, float, str, int]:
        value = number(key[0])
        return key[0] is None, math.inf if value is None else value, key[0] or "", key[1]

    ordered = sorted(groups.items(), key=lambda item: order(item[0]))
    return [NoiseGroup(*key, members[0].part.member.group_name, tuple(members)) for key, members in ordered]


def class_title(window_class: str | None) -> str:
    """A class of windows in words."""
    return tr("no value") if window_class is None else window_class


class _NoiseRow(NamedTuple):
    """A band of an image in a window; none where nothing could be measured."""

    clip: ClipNoise
    band: str | None
    noise: BandNoise | None


def _shares(row: _NoiseRow) -> Curve | None:
    return row.noise.curve if row.noise is not None and row.noise.curve.variance > 0 else None


_COLUMNS: tuple[Column[_NoiseRow], ...] = (
    Column("raster", "text", lambda row: row.clip.part.member.image.ref.name),
    Column("group", "integer", lambda row: row.clip.part.member.group),
    Column("window_id", "integer", lambda row: row.clip.window_id),
    Column("band", "text", lambda row: row.band),
    Column("detail", "real", lambda row: (curve := _shares(row)) and curve.detail, by_level=True),
    Column("background", "real", lambda row: (curve := _shares(row)) and curve.background),
    Column("kurtosis", "real", lambda row: row.noise and row.noise.kurtosis, by_level=True),
    Column("sigma", "real", lambda row: row.noise and row.noise.sigma),
    Column("noise", "text", lambda row: (row.noise.verdict if row.noise else NoiseVerdict.NOT_MEASURABLE).value),
    Column("reason", "text", lambda row: row.clip.reason if row.noise is None else row.noise.note),
    Column("column", "integer", lambda row: row.clip.part.window.column),
    Column("row", "integer", lambda row: row.clip.part.window.row),
    Column("width", "integer", lambda row: row.clip.part.window.width),
    Column("height", "integer", lambda row: row.clip.part.window.height),
    Column("pixel_size", "real", lambda row: row.clip.part.member.ground_sample_distance),
    Column("group_name", "text", lambda row: row.clip.part.member.group_name or None),
    Column("class", "text", lambda row: row.clip.window_class),
    Column("largest_sigma", "real", lambda row: row.noise and row.noise.largest_sigma),
    Column("grain", "real", lambda row: row.noise and row.noise.grain and row.noise.grain.size),
    Column("grain_sigma", "real", lambda row: row.noise and row.noise.grain and row.noise.grain.sigma),
    Column("amount", "text", lambda row: (row.noise.amount if row.noise else NoiseAmount.NOT_MEASURABLE).value),
    Column("noise_sigma", "real", lambda row: row.noise and row.noise.noise),
    Column("signal_to_noise", "real", lambda row: row.noise and row.noise.signal_to_noise),
)


def noise_fields(levels: int) -> QgsFields:
    """OUTPUT: one row per window, raster and band; its fields from ``column`` on say which pixels were measured."""
    return column_fields(_COLUMNS, levels)


def noise_features(result: ClipNoise, levels: int) -> Iterator[QgsFeature]:
    """The rows of OUTPUT for an image in a window; one without a band where nothing could be measured."""
    rows = [_NoiseRow(result, band, noise) for band, noise in result.bands.items()] or [_NoiseRow(result, None, None)]
    return column_features(_COLUMNS, rows, levels)
