"""A hundred small windows side by side: what the map tells of them from afar, from near, selected and judged."""
from __future__ import annotations

from pathlib import Path

from demo.desk import Desk

OBSERVERS = ("visible", "invisible", "unsure")


def look(desk: Desk, shots: Path) -> None:
    """Pictures; what is judged for them is taken back."""
    desk.session.select([])
    desk.wait_for_map()
    desk.screenshot(shots / "dense_far.png")
    rows = desk.session.windows()
    for place, observer in enumerate(OBSERVERS):
        desk.session.judge([row.fid for row in rows[place::6]], observer)
    near = desk.canvas.extent()
    near.scale(0.25)
    for shot, selected in (("judged", ()), ("selected", rows[:40:3])):
        desk.session.select([row.fid for row in selected])
        desk.canvas.zoomToFullExtent()
        desk.wait_for_map()
        desk.screenshot(shots / f"dense_{shot}_far.png")
        desk.canvas.setExtent(near)
        desk.canvas.refresh()
        desk.wait_for_map()
        desk.screenshot(shots / f"dense_{shot}_near.png")
    desk.dock.zoom_to(rows[0].fid)
    desk.wait_for_map()
    desk.screenshot(shots / "dense_twofold.png")
    desk.session.judge([row.fid for row in rows], "")
