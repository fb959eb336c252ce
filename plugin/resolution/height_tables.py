"""Tables of the minimum flying height: rows -> observations, results -> rows. The field names are contracts."""
from __future__ import annotations

from collections.abc import Sequence

from qgis.core import QgsFeature, QgsFields

from ..imagery.message import Message
from ..toolkit.attribute_values import number, text
from ..toolkit.table_fields import feature, table_fields
from ..toolkit.translation import sentence
from .measure import messages
from .measure.minimum_height import HeightResult, Observation

HEIGHT, GRD = "height", "grd"
_KEYS = ("sensor", "image_type", "direction")


def key_fields(names: Sequence[str], by_height: bool) -> tuple[str, ...]:
    """What the rows are grouped by: the fields of the key that the table has, and the height if that is wanted."""
    return tuple(name for name in _KEYS if name in names) + ((HEIGHT,) if by_height else ())


def observation(row: QgsFeature, keys: Sequence[str]) -> tuple[Observation | None, Message | None]:
    """A row as an observation, or why it is none."""
    height, grd = number(row[HEIGHT]), number(row[GRD])
    if height is None or grd is None:
        return None, messages.OBSERVATION_EMPTY()
    found = Observation(height, grd, tuple(text(row[name]) for name in keys))
    return (found, None) if found.fault is None else (None, found.fault)


def height_fields(keys: Sequence[str]) -> QgsFields:
    """OUTPUT: one row per group of observations."""
    return table_fields(
        *((name, "text") for name in keys),
        ("count", "integer"),
        ("mean", "real"),
        ("spread", "real"),
        ("reference", "real"),
        ("tolerance", "real"),
        ("notice", "text"),
    )


def height_feature(result: HeightResult, keys: Sequence[str]) -> QgsFeature:
    """The row of OUTPUT for a group."""
    numbers = [len(result.heights_m), result.mean_m, result.spread_m, result.reference_m, result.tolerance_percent]
    notice = None if result.notice is None else sentence(result.notice)
    return feature(height_fields(keys), [*result.key, *numbers, notice])


def pass_fields(keys: Sequence[str]) -> QgsFields:
    """HEIGHTS: one row per observation."""
    others = [(name, "text") for name in keys if name != HEIGHT]
    return table_fields(*others, (HEIGHT, "real"), (GRD, "real"), ("h_min", "real"))


def pass_feature(one: Observation, keys: Sequence[str], required_cm: float) -> QgsFeature:
    """The row of HEIGHTS for an observation."""
    words = [word for name, word in zip(keys, one.key) if name != HEIGHT]
    return feature(pass_fields(keys), [*words, one.height_m, one.grd_cm, one.minimum_height(required_cm)])
