"""Windows in a project without a file: they move beside the project's file when it gets one.

Parameters: ``brighton``, ``screenshots``, ``home`` (folders).
"""
from __future__ import annotations

from dataclasses import replace
from pathlib import Path

from demo.desk import Desk

SIDE_M, SPACING_M = 1.9, 2.2


def play(desk: Desk) -> None:
    """The windows are offered when QGIS forgot the project."""
    home = Path(desk.parameters["home"])
    desk.set_up(Path(desk.parameters["brighton"]), SIDE_M, SPACING_M, mosaic="mosaic_feather0p4m")
    desk.session.set_inputs(replace(desk.session.inputs, reference="sources"))
    desk.dock.place.trigger()
    desk.wait(lambda: desk.session.windows() and not desk.session.is_busy, 30, "windows placed")
    desk.pause(1)
    desk.screenshot(Path(desk.parameters["screenshots"]) / "unsaved.png")
    layer = desk.session.window_layer()
    assert desk.project.write(str(home / "project.qgz"))
    desk.pause(1)
    desk.screenshot(Path(desk.parameters["screenshots"]) / "moved.png")
    assert Path(layer.source().split("|")[0]).parent == home
    desk.drop_changes()
