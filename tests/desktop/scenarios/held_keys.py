"""Keys of the X server, which repeats them while they are held: the hard cut, judging, and what judges nothing.

Parameters: ``block``, ``screenshots`` (folders), ``holds`` (how often Space is held).
"""
from __future__ import annotations

import subprocess
from pathlib import Path

from qgis.PyQt.QtWidgets import QWidget
from qgis.utils import iface

from demo.desk import Desk

HELD_S = 0.9  # the server repeats a key from 0.66 s on
LETTERS = ("v", "i", "u", "r", "s", "l", "n", "7")


def play(desk: Desk) -> None:
    """With the table and with the map in focus."""
    desk.set_up(Path(desk.parameters["block"]), 25.6, 12.8)
    session, dock, shots = desk.session, desk.dock, Path(desk.parameters["screenshots"])
    dock.place.trigger()
    desk.wait(lambda: session.windows() and not session.is_busy, 60, "windows placed")
    dock.inspect.trigger()
    desk.wait(lambda: all(row.verdict for row in session.windows()), 120, "all windows inspected")
    desk.wait_for_work()
    xdotool("windowfocus", str(int(desk.window.winId())))
    session.select([next(row.fid for row in session.windows() if row.is_compared)])
    type_elsewhere(desk)
    take_focus(desk, dock.windows.table)
    hold_space(desk, "table")
    take_focus(desk, desk.canvas)
    xdotool("key", "j")
    desk.wait(lambda: dock.layout_of_judging.is_on, 5, "judging")
    hold_space(desk, "map")
    desk.report["judged_by_v"] = judge_by_a_held_key(desk)
    xdotool("key", "space")
    desk.wait(lambda: dock.flicker.is_shown and dock.flicker.hard_cut.layer, 30, "hard cut drawn")
    desk.screenshot(shots / "held_keys_hard_cut.png")
    xdotool("key", "j")
    desk.wait(lambda: not dock.layout_of_judging.is_on, 5, "all of the desk again")
    desk.report["after_judging"] = dock.flicker.is_shown
    take_focus(desk, desk.canvas)
    xdotool("key", "space")
    desk.wait(lambda: dock.flicker.is_shown, 5, "hard cut shown")
    desk.new_project()
    desk.report["in_new_project"] = dock.flicker.is_shown
    desk.screenshot(shots / "held_keys_new.png")


def type_elsewhere(desk: Desk) -> None:
    """While the desk is merely open; then J into the Layers panel."""
    session, tree = desk.session, iface.layerTreeView()
    before = session.selected()
    for widget in (tree, desk.dock.windows.table, desk.canvas):
        take_focus(desk, widget)
        for key in LETTERS:
            xdotool("key", key)
            desk.pause(0.1)
    take_focus(desk, tree)
    xdotool("key", "BackSpace")
    xdotool("key", "j")
    desk.pause(0.3)
    desk.report["judged_elsewhere"] = [row.window_id for row in session.windows() if row.observer or row.confidence]
    desk.report["on_elsewhere"] = desk.session.loss_view.is_shown or desk.dock.layout_of_judging.is_on
    session.select(before)


def hold_space(desk: Desk, where: str) -> None:
    """How often it was shown and hidden in each hold."""
    flicker, seen = desk.dock.flicker, []
    flicker.shown.connect(seen.append)
    holds = []
    for _ in range(desk.parameters["holds"]):
        xdotool("keydown", "space")
        desk.pause(HELD_S)
        held = [*seen, flicker.is_shown]
        xdotool("keyup", "space")
        desk.wait(lambda: not flicker.is_shown, 10, "mosaic again")
        holds.append([*held, *seen[len(held) - 1:]])
        seen.clear()
    flicker.shown.disconnect(seen.append)
    desk.report[f"holds_{where}"] = holds


def judge_by_a_held_key(desk: Desk) -> int:
    """How many windows it judges."""
    xdotool("keydown", "v")
    desk.pause(1.2)
    xdotool("keyup", "v")
    desk.pause(0.2)
    return sum(row.observer == "visible" for row in desk.session.windows())


def take_focus(desk: Desk, widget: QWidget) -> None:
    """Give a widget the focus, as a click does."""
    desk.window.activateWindow()
    widget.setFocus()
    desk.wait(widget.hasFocus, 5, "focus")


def xdotool(*words: str) -> None:
    """A key of the server, and so with its repetitions."""
    subprocess.run(["xdotool", *words], check=True)
