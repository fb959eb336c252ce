"""Keys of the X server, which repeats them while they are held: the hard cut, judging, and what judges nothing.

Windows are inspected before.
"""
from __future__ import annotations

import subprocess

from qgis.PyQt.QtWidgets import QWidget
from qgis.utils import iface

from demo.desk import Desk

HELD_S = 0.9  # the server repeats a key from 0.66 s on
HOLDS = 5
LETTERS = ("v", "i", "u", "r", "s", "l", "n", "7")


def play(desk: Desk) -> None:
    """What is seen is in the report; one window is judged afterwards."""
    session, dock = desk.session, desk.dock
    xdotool("windowfocus", str(int(desk.window.winId())))
    session.select([next(row.fid for row in session.windows() if row.is_compared)])
    type_elsewhere(desk)
    take_focus(desk, desk.canvas)
    xdotool("key", "j")
    desk.wait(lambda: dock.judging.is_on, 5, "judging")
    desk.report["holds"] = [hold_space(desk) for _ in range(HOLDS)]
    xdotool("keydown", "v")
    desk.pause(1.2)
    xdotool("keyup", "v")
    desk.pause(0.2)
    desk.report["judged_by_v"] = sum(row.observer == "visible" for row in session.windows())
    xdotool("key", "j")
    desk.wait(lambda: not dock.judging.is_on, 5, "all of the desk again")


def type_elsewhere(desk: Desk) -> None:
    """While the desk is merely open; then J into the Layers panel."""
    session, tree = desk.session, iface.layerTreeView()
    before = session.selected()
    for widget in (tree, desk.dock.windows.table, desk.canvas):
        take_focus(desk, widget)
        for letter in LETTERS:
            xdotool("key", letter)
            desk.pause(0.1)
    take_focus(desk, tree)
    xdotool("key", "BackSpace")
    xdotool("key", "j")
    desk.pause(0.3)
    desk.report["judged_elsewhere"] = [row.window_id for row in session.windows() if row.observer or row.confidence]
    desk.report["on_elsewhere"] = session.lost_detail.isChecked() or desk.dock.judging.is_on
    session.select(before)


def hold_space(desk: Desk) -> list[bool]:
    """How often the hard cut was shown and hidden."""
    shower, seen = desk.dock.flicker, []
    shower.shown.connect(seen.append)
    xdotool("keydown", "space")
    desk.pause(HELD_S)
    held = [*seen, shower.is_shown]
    xdotool("keyup", "space")
    desk.wait(lambda: not shower.is_shown, 10, "mosaic again")
    shower.shown.disconnect(seen.append)
    return [*held, *seen[len(held) - 1:]]


def take_focus(desk: Desk, widget: QWidget) -> None:
    """Give a widget the focus, as a click does."""
    desk.window.activateWindow()
    widget.setFocus()
    desk.wait(widget.hasFocus, 5, "focus")


def xdotool(*words: str) -> None:
    """A key of the server, and so with its repetitions."""
    subprocess.run(["xdotool", *words], check=True)
