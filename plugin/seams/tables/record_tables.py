"""The tables of an inspection -> findings. Fields may be missing, and may be text, as in a CSV file."""
from __future__ import annotations

import math
import re
from collections.abc import Iterable, Sequence
from typing import NamedTuple

from qgis.core import QgsCoordinateTransform, QgsFeature

from ...imagery.band_names import judged_band
from ...imagery.errors import SettingsError
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
            window_id=whole(row, "window_id", names) or 0,
            verdict=text(row, "verdict", names),
            reason=text(row, "reason", names),
            cause=text(row, "cause", names),
            observer=text(row, "observer", names).lower(),
            ratios=tuple(number(row, name, names) for name in ratios),
            composite_ratios=tuple(number(row, name, names) for name in composite),
            expected_ratios=tuple(number(row, name, names) for name in expected),
            background_ratio=number(row, "background_ratio", names),
            unclear_share=number(row, "unclear_share", names),
            extent=outline_extent(row, transform),
        )
        for row in rows
    ]


def read_pairs(rows: Iterable[QgsFeature], names: Sequence[str]) -> dict[int, list[PairRecord]]:
    """The rows of PAIRS by window. Raises SettingsError for a table that is none of pairs."""
    for name in ("window_id", "source", "band"):
        if name not in names:
            raise SettingsError(messages.PAIRS_WITHOUT_FIELD(field=name))
    found: dict[int, list[PairRecord]] = {}
    for row in rows:
        window_id = whole(row, "window_id", names)
        if window_id is not None:
            source, band = text(row, "source", names), text(row, "band", names)
            pair = PairRecord(source, band, number(row, "ratio_1", names), number(row, "contrast_1", names))
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
    for row in rows:
        window_id, level = whole(row, "window_id", names), whole(row, "level", names)
        if window_id is None or level is None:
            continue
        raster, role, band = (text(row, name, names) for name in ("raster", "role", "band"))
        place = level if text(row, "component", names) == "detail" else _BACKGROUND
        curves = windows.setdefault(window_id, {}).setdefault(band, [])
        own = [one for one in curves if (one.raster, one.role) == (raster, role)]
        if not own or place in own[-1].shares:
            own.append(_Components(raster, role, {}))
            curves.append(own[-1])
        share = number(row, "relative_variance", names)
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


def text(row: QgsFeature, name: str, names: Sequence[str]) -> str:
    """A word or sentence; empty where there is none."""
    value = row[name] if name in names else None
    return value.strip() if isinstance(value, str) else ""


def number(row: QgsFeature, name: str, names: Sequence[str]) -> float | None:
    """A finite number."""
    try:
        value = float(str(row[name])) if name in names else math.nan
    except ValueError:  # NULL, or a word
        return None
    return value if math.isfinite(value) else None


def whole(row: QgsFeature, name: str, names: Sequence[str]) -> int | None:
    """A whole number."""
    value = number(row, name, names)
    return int(value) if value is not None and value.is_integer() else None

