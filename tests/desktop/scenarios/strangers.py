"""Projects of strangers: what the plugin keeps in a project and its layers is of the wrong kind, huge, or no text.

Parameters: ``block`` (folder), ``side_m``, ``screenshots`` (folder).
"""
from __future__ import annotations

import json
from dataclasses import fields
from pathlib import Path

from seam_inspector.plugin.seams.desk.inputs.project_inputs import Inputs
from seam_inspector.plugin.seams.desk.judging import JudgingSettings

from demo.desk import Desk

SCOPE = "SeamInspector"
KEPT = ("inputs", "places", "judging")
TEXTS = (
    "[" * 100_000, '{"levels":' * 50_000, "{", "null", "[]", '"\\ud800"', "NaN", '{"levels": 1e999}', "9" * 5000,
    '{"sources": ' + json.dumps(["x"] * 20_000) + "}", '{"__class__": {"a": 1}, "mosaic": "\\u0000"}',
)  # fmt: skip
VALUES = (
    None, True, -1, 0, 10**15, 10**300, 10**390, -(10**390), 1e308, float("nan"), float("inf"), -float("inf"), "", "x",
    "\0", "\ud800", "\u202e" * 99, "9" * 4000, [], [[]], [None, 5, "x"], ["\0"] * 3, {}, {"a": {}},
)  # fmt: skip
STALE = ("--5", "\u00b2", "9" * 5000, "[[1]]", 1.5, -1, 10**9, [], ["--5", None, "\u00b2", 10**9], {"a": 1}, True)


def play(desk: Desk) -> None:
    """Each project is opened beside the open desk, looked at in all tabs, and drawn in."""
    side_m = float(desk.parameters["side_m"])
    desk.set_up(Path(desk.parameters["block"]), side_m, side_m)
    centre = desk.session.mosaic_layer().extent().center()
    path = desk.folder / "project.qgs"
    named = {one.name for kind in (Inputs, JudgingSettings) for one in fields(kind)}
    ids = {name: getattr(desk.session.inputs, name) for name in ("mosaic", "sources", "seamlines")}
    hostile = list(TEXTS) + [json.dumps({**dict.fromkeys(named, value), **ids}) for value in VALUES]
    opened = 0
    for number, text in enumerate(hostile):
        for key in KEPT:
            desk.project.writeEntry(SCOPE, key, text)
        for layer in desk.project.mapLayers().values():
            for name in ("stale", "style", "scanned", "mosaic", "styled"):
                layer.setCustomProperty(f"seam_inspector/{name}", STALE[number % len(STALE)])
        assert desk.project.write(str(path))
        desk.new_project()
        assert desk.project.read(str(path))
        desk.open_dock()
        desk.pause(0.2)
        for tab in range(4):
            desk.show_tab(tab)
        desk.move((centre.x(), centre.y()))
        desk.pause(0.1)
        opened += 1
    desk.report["opened"] = opened
    desk.screenshot(Path(desk.parameters["screenshots"]) / "strangers.png")
