"""The tables of an inspection -> findings. Fields may be missing, and may be text, as in a CSV file."""
from __future__ import annotations

import math
import re
from collections.abc import Iterable, Sequence
from typing import NamedTuple

from qgis.core import QgsCoordinateTransform, QgsFeature

from ...imagery.band_names import judged_band
from ...imagery.errors import SettingsError
from ...toolkit.attribute_values import attributes
from ...toolkit.layers import outline_extent
from ..measure import messages
from ..measure.window_records import CurveRecord, PairRecord, WindowRecord

_BACKGROUND = 0


def read_findings(
    rows: Iterable[QgsFeature], names: Sequence[str], transform: QgsCoordinateTransform | None = None
) -> list[WindowRecord]:
    """The windows of an inspected layer in its order; ``transform`` leads to the system of their extents.

    One without a number of its own gets 0. Raises SettingsError when the layer has no ``ratio_1``,
    WindowError when an outline can't be transformed.
    """
    if "ratio_1" not in names:
        raise SettingsError(messages.WINDOWS_WITHOUT_FIELD(field="ratio_1"))
    ratios, composite, expected = (_levels(names, kind) for kind in ("ratio", "composite_ratio", "expected_ratio"))
    return [
        WindowRecord(
            window_id=row.whole_number("window_id") or 0,
            verdict=row.text("verdict"),
            reason=row.text("reason"),
            cause=row.text("cause"),
            observer=row.text("observer").lower(),
            ratios=tuple(map(row.number, ratios)),
            composite_ratios=tuple(map(row.number, composite)),
            expected_ratios=tuple(map(row.number, expected)),
            background_ratio=row.number("background_ratio"),
            unclear_share=row.number("unclear_share"),
            extent=outline_extent(row.feature, transform),
        )
        for row in attributes(rows, names)
    ]


def read_pairs(rows: Iterable[QgsFeature], names: Sequence[str]) -> dict[int, list[PairRecord]]:
    """The rows of PAIRS by window. Raises SettingsError for a table that is none of pairs."""
    for name in ("window_id", "source", "band"):
        if name not in names:
            raise SettingsError(messages.PAIRS_WITHOUT_FIELD(field=name))
    found: dict[int, list[PairRecord]] = {}
    for row in attributes(rows, names):
        window_id = row.whole_number("window_id")
        if window_id is not None:
            pair = PairRecord(row.text("source"), row.text("band"), row.number("ratio_1"), row.number("contrast_1"))
            found.setdefault(window_id, []).append(pair)
    return found


def read_curves(rows: Iterable[QgsFeature], names: Sequence[str]) -> dict[int, list[CurveRecord]]:
    """The curves of CURVES in the judged band by window, in the table's order.

    Rows of one curve stand together; of two sources with the same name the second starts where a component of the
    first comes again. Raises SettingsError for a table that is none of curves.
    """
    for name in ("window_id", "raster", "role", "band", "component", "level", "relative_variance"):
        if name not in names:
            raise SettingsError(messages.CURVES_WITHOUT_FIELD(field=name))
    windows: dict[int, dict[str, list[_Components]]] = {}
    for row in attributes(rows, names):
        window_id, level = row.whole_number("window_id"), row.whole_number("level")
        if window_id is None or level is None:
            continue
        raster, role, band = map(row.text, ("raster", "role", "band"))
        place = level if row.text("component") == "detail" else _BACKGROUND
        curves = windows.setdefault(window_id, {}).setdefault(band, [])
        own = [one for one in curves if (one.raster, one.role) == (raster, role)]
        if not own or place in own[-1].shares:
            own.append(_Components(raster, role, {}))
            curves.append(own[-1])
        share = row.number("relative_variance")
        own[-1].shares[place] = math.nan if share is None else share
    return {
        window_id: [curve for found in bands[judged_band(bands)] if (curve := found.curve()) is not None]
        for window_id, bands in windows.items()
    }


class _Components(NamedTuple):
    """The components of one curve as they come."""

    raster: str
    role: str
    shares: dict[int, float]
    """By level; the background as _BACKGROUND."""

    def curve(self) -> CurveRecord | None:
        """None while levels are missing."""
        levels = [level for level in self.shares if level != _BACKGROUND]
        if _BACKGROUND not in self.shares or sorted(levels) != list(range(1, len(levels) + 1)) or not levels:
            return None
        detail = tuple(self.shares[level] for level in sorted(levels))
        return CurveRecord(self.raster, self.role, detail, self.shares[_BACKGROUND])


def _levels(names: Sequence[str], kind: str) -> list[str]:
    """The fields of a kind, level by level."""
    found = (re.fullmatch(rf"{kind}_([1-9][0-9]*)", name) for name in names)
    return [match[0] for match in sorted(filter(None, found), key=lambda match: int(match[1]))]
