"""Parameters that are not files: what no form offers and a script, a model or a typo gives."""
from __future__ import annotations

import math
import random
from typing import Any

from qgis.core import QgsProcessingParameterDefinition, QgsProcessingParameterEnum, QgsProcessingParameterNumber

NUMBERS: tuple[Any, ...] = (
    0, -1, 1, 0.5, 1e-3, 1e-9, 1e-300, 2, 7, 1000, 1e6, 1e9, 2**31 - 1, -(2**31), 2**31, 1e15, 1e300, -1e300, math.nan,
    math.inf, -math.inf, "nan", "inf", "abc", "", None, "1e400", True, "0x10", "1,5",
)  # fmt: skip
TEXTS: tuple[Any, ...] = (
    "", " ", "x", "0", "-1", "nan", None, "a" * 100_000, "<script>alert(1)</script>", "'\"; DROP", "\u202ex", "\0",
    "%s%n", "{0}", "{x.__class__}", "../../..", "1, 2, 999999999", "6, nan", "6;8", "tcp://127.0.0.1:9", [], {},
    5, 1e300,
)  # fmt: skip
SYSTEMS: tuple[Any, ...] = (
    "", "EPSG:4326", "EPSG:999999", "garbage", "EPSG:4978", "EPSG:5773", "EPSG:32733", "EPSG:3857", None, 5,
    "PROJ:+proj=lcc", 'LOCAL_CS["x",UNIT["metre",1]]', "EPSG:32633+5773", "+proj=utm +zone=99", "IAU_2015:30100",
    "WKT:PROJCS[", "EPSG:32661", "x" * 10_000,
)  # fmt: skip
EXTENTS: tuple[Any, ...] = (
    "nan,nan,nan,nan", "0,0,0,0", "1,0,1,0", "-inf,inf,-inf,inf", "1e300,2e300,1e300,2e300", "a,b,c,d", "0,1", None,
    "330000,350000,4830000,4850000", "330000,330001,4830000,4830001 [EPSG:32632]", "-180,180,-90,90 [EPSG:4326]",
    "0,1e9,0,1e9 [EPSG:32632]", "0,1,0,1 [EPSG:999999]", "5,6,5,6 [garbage]",
)  # fmt: skip


def other_value(definition: QgsProcessingParameterDefinition, chance: random.Random) -> Any:
    """Another value for a parameter that is no file."""
    kind = definition.type()
    if kind == "number":
        assert isinstance(definition, QgsProcessingParameterNumber)
        ends = [one for one in (definition.minimum(), definition.maximum()) if abs(one) < 1e300]
        near = [end + step for end in ends for step in (-1, -1e-6, 0, 1e-6, 1)]
        return chance.choice((*NUMBERS, *near))
    if kind == "enum":
        assert isinstance(definition, QgsProcessingParameterEnum)
        return chance.choice((*definition.options(), *TEXTS))
    if kind == "crs":
        return chance.choice(SYSTEMS)
    if kind == "extent":
        return chance.choice(EXTENTS)
    if kind == "range":
        return chance.choice(([0, math.nan], [5, 1], "1,2", "x", [], [1, 2, 3], [-math.inf, math.inf], "0,1e400", None))
    if kind == "boolean":
        return chance.choice((True, False, "x", None, 5, "false"))
    return chance.choice(TEXTS)


def other_input(sound: Any, definition: QgsProcessingParameterDefinition, chance: random.Random) -> Any:
    """Something that is no file for a parameter that wants one, or files: nothing, the wrong type, the same twice."""
    one = sound[0] if isinstance(sound, list) else sound
    many = [[one, one], [one] * 40, [[one]], [None, one], [one, "/nowhere/a.tif"]]
    return chance.choice((None, "", [], {}, 5, 1.5, True, "no_such_layer_id", [None], [""], *many))
