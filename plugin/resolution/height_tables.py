"""Tables of the minimum flying height: rows -> observations, results -> rows. The field names are contracts."""
from __future__ import annotations

from collections.abc import Sequence

from qgis.core import QgsFeature, QgsFields

from ..imagery.errors import Message
from ..toolkit.attribute_values import number, text
from ..toolkit.table_fields import feature, table_fields
from ..toolkit.translation import sentence
from .line_table import check_fields
from .measure import messages
from .measure.minimum_height import HeightResult, Observation

HEIGHT, GRD = "height", "grd"
_KEYS = ("sensor", "image_type", "direction")
MEASURED = ("grd_error",)
"""Fields of measured groups that begin as those of observers do."""


def key_fields(names: Sequence[str], by_height: bool) -> tuple[str, ...]:
    """What the rows are grouped by: the fields of the key that the table has, and the height if that is wanted."""
    return tuple(name for name in _KEYS if name in names) + ((HEIGHT,) if by_height else ())


def reading_fields(names: Sequence[str]) -> list[str]:
    """The fields with the distances that observers read: ``grd``, ``grd_2`` and so on, or names after ``grd_``.

    Raises SettingsError where there is none, or no height.
    """
    fields = [name for name in names if name == GRD or (name.startswith(f"{GRD}_") and name not in MEASURED)]
    check_fields(names, (HEIGHT, *(fields[:1] or [GRD])))
    return fields


def observation(
    row: QgsFeature, keys: Sequence[str], readings: Sequence[str]
) -> tuple[Observation | None, Message | None]:
    """A row as an observation, or why it is none. ``readings``: the fields of its observers, of whom some may lack."""
    words = [row[name] for name in readings if text(row[name])]
    height, grds = number(row[HEIGHT]), [number(word) for word in words]
    wrong = [text(word) for word, grd in zip([row[HEIGHT], *words], [height, *grds]) if grd is None and text(word)]
    if wrong:
        return None, messages.OBSERVATION_NO_NUMBER(word=wrong[0])
    if height is None or not grds:
        return None, messages.OBSERVATION_EMPTY()
    read = tuple(grd for grd in grds if grd is not None)
    found = Observation(height, read, tuple(text(row[name]) for name in keys))
    return (found, None) if found.fault is None else (None, found.fault)


def height_fields(keys: Sequence[str]) -> QgsFields:
    """OUTPUT: one row per group of observations."""
    return table_fields(
        *((name, "text") for name in keys),
        ("count", "integer"),
        ("mean", "real"),
        ("spread", "real"),
        ("observers", "integer"),
        ("observer_spread", "real"),
        ("reference", "real"),
        ("tolerance", "real"),
        ("notice", "text"),
    )


def height_feature(result: HeightResult, keys: Sequence[str]) -> QgsFeature:
    """The row of OUTPUT for a group."""
    numbers = [len(result.heights_m), result.mean_m, result.spread_m, result.observers, result.observer_spread_m]
    numbers += [result.reference_m, result.tolerance_percent]
    notice = None if result.notice is None else sentence(result.notice)
    return feature(height_fields(keys), [*result.key, *numbers, notice])


def pass_fields(keys: Sequence[str]) -> QgsFields:
    """HEIGHTS: one row per observation."""
    others = [(name, "text") for name in keys if name != HEIGHT]
    return table_fields(*others, (HEIGHT, "real"), (GRD, "real"), ("h_min", "real"), ("observers", "integer"))


def pass_feature(one: Observation, keys: Sequence[str], required_cm: float) -> QgsFeature:
    """The row of HEIGHTS for an observation."""
    words = [word for name, word in zip(keys, one.key) if name != HEIGHT]
    height = one.minimum_height(required_cm)
    grd = one.height_m * required_cm / height  # the distance that this height goes with: of several, a harmonic mean
    return feature(pass_fields(keys), [*words, one.height_m, grd, height, len(one.grds_cm)])
