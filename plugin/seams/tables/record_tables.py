"""The tables of an inspection -> records. Fields may be missing, and may be text, as in a CSV file."""
from __future__ import annotations

import math
import re
from collections import Counter
from collections.abc import Callable, Iterable, Sequence
from dataclasses import fields
from typing import Any, NamedTuple

from qgis.core import QgsCoordinateTransform, QgsFeature

from ...imagery.errors import Message, SettingsError, of_cell
from ...imagery.limits import judged_band
from ...imagery.seam_totals import possible
from ...imagery.statistics import OPERATORS
from ...toolkit.layers import outline_extent
from ...toolkit.table_fields import attributes, number, text, whole_number
from ..measure import messages
from ..measure.window.window_tables import MEASURED, MOST_RATIO, WINDOW_FIELDS, WindowField
from ..measure.window_records import CurveRecord, PairRecord, ProfileRecord, WindowRecord

_BACKGROUND = 0
_IN_RECORDS = {column.name for column in fields(WindowRecord)}


def check_inspected(names: Iterable[str]) -> None:
    """Raise SettingsError for a window layer without ratios."""
    if "ratio_1" not in names:
        raise SettingsError(messages.WINDOWS_WITHOUT_FIELD(field="ratio_1"))


def read_windows(
    rows: Iterable[QgsFeature],
    names: Sequence[str],
    transform: QgsCoordinateTransform | None = None,
    unnumbered: int = 0,
) -> list[WindowRecord]:
    """The windows of a layer in its order; ``transform`` leads to the system of their extents.

    One without a number of its own is ``unnumbered``; numbers that no measurement gives are left out. Raises
    WindowError when an outline can't be transformed.
    """
    read: dict[str, Callable[[object], Any]] = {"text": _words, "real": number, "integer": whole_number}
    held = [field for field in WINDOW_FIELDS if field in MEASURED or field.name in names]
    levels = [(field.read_as, level_names(field.name, names)) for field in held if field.by_level]
    single = [(field.read_as, field.name, read[field.kind]) for field in held if not field.by_level]
    bounded = [field for field in held if field.most is not None]
    records, observers = [], [operator.observer for operator in OPERATORS]
    for row in attributes(rows, names):
        values: dict[str, Any] = {name: value(row[field]) for name, field, value in single}
        values.update((name, tuple([number(row[field]) for field in fields])) for name, fields in levels)
        impossible = _without_impossible(values, bounded)
        if values["window_id"] is None:
            values["window_id"] = unnumbered
        values.update((name, values[name].lower()) for name in observers if name in values)
        others = {name: values.pop(name) for name in values.keys() - _IN_RECORDS}
        extent = outline_extent(row.feature, transform)
        fid = row.feature.id()
        records.append(WindowRecord(extent=extent, fid=fid, others=others, impossible=impossible, **values))
    return records


def _without_impossible(values: dict[str, Any], bounded: Sequence[WindowField]) -> tuple[str, ...]:
    """The fields whose numbers no measurement gives; these are taken out of the values of a row."""
    impossible: list[str] = []
    for field in bounded:
        held = values[field.read_as]
        if field.by_level and not all(map(field.is_possible, held)):
            levels = [level for level, value in enumerate(held, 1) if not field.is_possible(value)]
            impossible += [f"{field.name}_{level}" for level in levels]
            values[field.read_as] = tuple(value if field.is_possible(value) else None for value in held)
        elif not field.by_level and not field.is_possible(held):
            impossible.append(field.name)
            values[field.read_as] = None
    return tuple(impossible)


def doubts(windows: Iterable[WindowRecord]) -> list[Message]:
    """What is to be told of numbers that are left out, field by field."""
    counts = Counter(name for window in windows for name in window.impossible)
    return [messages.VALUES_IMPOSSIBLE(field=name, count=count) for name, count in counts.items()]


def read_pairs(rows: Iterable[QgsFeature], names: Sequence[str]) -> dict[int, list[PairRecord]]:
    """The rows of PAIRS by window. Raises SettingsError for a table that is none of pairs."""
    for name in ("window_id", "source", "band"):
        if name not in names:
            raise SettingsError(messages.TABLE_WITHOUT_FIELD(table="PAIRS", field=name))
    pairs: dict[int, list[PairRecord]] = {}
    for row in attributes(rows, names):
        window_id = whole_number(row["window_id"])
        if window_id is not None:
            source, band = _words(row["source"]), text(row["band"])
            ratio, contrast = (possible(number(row[name]), MOST_RATIO) for name in ("ratio_1", "contrast_1"))
            pair = PairRecord(source, band, ratio, contrast)
            pairs.setdefault(window_id, []).append(pair)
    return pairs


def read_profiles(rows: Iterable[QgsFeature], names: Sequence[str]) -> dict[int, list[ProfileRecord]]:
    """The rows of PROFILES by window. Raises SettingsError for a table that is none of profiles."""
    for name in ("window_id", "level", "distance", "kept"):
        if name not in names:
            raise SettingsError(messages.TABLE_WITHOUT_FIELD(table="PROFILES", field=name))
    profiles: dict[int, list[ProfileRecord]] = {}
    for row in attributes(rows, names):
        window_id, level = whole_number(row["window_id"]), whole_number(row["level"])
        distance, kept = number(row["distance"]), number(row["kept"])
        if window_id is not None and level is not None and distance is not None and kept is not None:
            low, high = (math.nan if end is None else end for end in (number(row["low"]), number(row["high"])))
            profiles.setdefault(window_id, []).append(
                ProfileRecord(level, distance, kept, low, high, number(row["mixture"]))
            )
    return profiles


def read_curves(rows: Iterable[QgsFeature], names: Sequence[str]) -> dict[int, list[CurveRecord]]:
    """The curves of CURVES in the judged band by window, in the table's order.

    Rows of one curve stand together; of two sources with the same name the second starts where a component of the
    first comes again. Raises SettingsError for a table that is none of curves.
    """
    for name in ("window_id", "raster", "role", "band", "component", "level", "relative_variance"):
        if name not in names:
            raise SettingsError(messages.TABLE_WITHOUT_FIELD(table="CURVES", field=name))
    windows: dict[int, dict[str, list[_Components]]] = {}
    for row in attributes(rows, names):
        window_id, level = whole_number(row["window_id"]), whole_number(row["level"])
        if window_id is None or level is None:
            continue
        raster, role, band = (_words(row[name]) for name in ("raster", "role", "band"))
        place = {"detail": level, "background": _BACKGROUND}.get(text(row["component"]))
        if place is None:  # a part of the detail, by direction
            continue
        curves = windows.setdefault(window_id, {}).setdefault(band, [])
        same_clip = [curve for curve in curves if (curve.raster, curve.role) == (raster, role)]
        if not same_clip or place in same_clip[-1].shares:
            same_clip.append(_Components(raster, role, {}))
            curves.append(same_clip[-1])
        share = number(row["relative_variance"])
        same_clip[-1].shares[place] = math.nan if share is None else share
    return {
        window_id: [curve for components in bands[judged_band(bands)] if (curve := components.curve()) is not None]
        for window_id, bands in windows.items()
    }


class _Components(NamedTuple):
    """The components of one curve as they come."""

    raster: str
    role: str
    shares: dict[int, float]  # shares by level; the background as _BACKGROUND

    def curve(self) -> CurveRecord | None:
        """None while levels are missing."""
        levels = [level for level in self.shares if level != _BACKGROUND]
        if _BACKGROUND not in self.shares or sorted(levels) != list(range(1, len(levels) + 1)) or not levels:
            return None
        detail = tuple(self.shares[level] for level in sorted(levels))
        return CurveRecord(self.raster, self.role, detail, self.shares[_BACKGROUND])


def _words(value: object) -> str:
    """A text, as it was before a table of the desk was written for spreadsheets."""
    return of_cell(text(value))


def level_names(name: str, names: Iterable[str]) -> list[str]:
    """The fields ``name_1``..``name_R`` among some, level by level."""
    matches = (re.fullmatch(rf"{name}_([1-9][0-9]*)", field) for field in names)
    return [match[0] for match in sorted(filter(None, matches), key=lambda match: int(match[1]))]
