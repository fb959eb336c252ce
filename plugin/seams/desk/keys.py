"""The keys of the desk: one table, of which tools/keys_table.py makes the guide's."""
from __future__ import annotations

from collections.abc import Mapping
from typing import NamedTuple

from ...imagery.statistics import INVISIBLE, UNSURE, VISIBLE

_SURE = {f"sure {10 * digit or 100}": (str(digit),) for digit in range(10)}
MAP, MAP_AND_TABLE, DESK = "map", "map, table", "map, desk"
JUDGING = "while judging: map, desk"
"""The place of the focus for keys to work, and what is on: the words of the guide, by which ``DeskKeys`` goes."""


class KeyLine(NamedTuple):
    """A line of the guide's table, and the keys that are named in it."""

    shown: str
    where: str
    does: str
    keys: Mapping[str, tuple[str, ...]] = {}
    """Keys by what they do, as ``DeskKeys`` and actions call it; empty where a widget of Qt's or QGIS's has them."""
    is_repeating: bool = False  # whether they go on while they are held


KEYS = (
    KeyLine("V, I, U", JUDGING, "judges: visible, invisible, not sure; then the next window",
            {VISIBLE: ("V",), INVISIBLE: ("I",), UNSURE: ("U",)}),
    KeyLine("N, P", JUDGING, "the next window to judge, the one before", {"next": ("N",), "before": ("P",)}, True),
    KeyLine("Backspace", JUDGING, "takes a judgement back", {"take back": ("Backspace",)}),
    KeyLine("1 to 9, 0", JUDGING, "how sure you are, 10 to 100 %", _SURE),
    KeyLine("R", JUDGING, "a remark", {"remark": ("R",)}),
    KeyLine("S", JUDGING, "takes seamlines and a scan's layers off the map, and puts them back",
            {"seamlines": ("S",)}),
    KeyLine("L", JUDGING, "shows or hides where detail was lost", {"lost detail": ("L",)}),
    KeyLine("J", DESK, "judging: QGIS's panels and what lies over the mosaic go; again: all as before",
            {"layout": ("J",)}),
    KeyLine("Space", MAP_AND_TABLE, "held: the hard cut in place of the mosaic; tapped: until the next tap",
            {"flicker": ("Space",)}),
    KeyLine("Tab", MAP, "the next of the window's places that lost most", {"next place": ("Tab",)}, True),
    KeyLine("Ctrl+Z; Ctrl+Shift+Z, Ctrl+Y", "everywhere", "undo; redo",
            {"undo": ("Ctrl+Z",), "redo": ("Ctrl+Shift+Z", "Ctrl+Y")}, True),
    KeyLine("Shift, Ctrl", "map, while drawing",
            "a square, or one more window selected; a new window here, whatever is there"),
    KeyLine("Esc, right click", "map, while drawing", "drops the rectangle; ends drawing"),
    KeyLine("Enter, double click", "table", "the window at 2x"),
    KeyLine("Del", "table", "removes the selected windows"),
    KeyLine("Ctrl+C", "table", "copies the selected rows"),
)  # fmt: skip


def keys_for(name: str) -> tuple[str, ...]:
    """The keys that do something, as QKeySequence reads them."""
    return next(line.keys[name] for line in KEYS if name in line.keys)
