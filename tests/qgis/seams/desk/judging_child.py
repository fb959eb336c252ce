"""A QGIS of its own that places, inspects and judges windows, says what it did line by line, and waits to be killed.

Arguments: the folder; whether the project is ``saved`` before its windows are made, ``moved`` beside its file then,
``unsaved`` or the ``second`` unsaved one of this QGIS; the mosaic and its two sources.
"""
from __future__ import annotations

import sys
from itertools import count
from pathlib import Path

from qgis.core import QgsApplication
from seam_inspector.plugin.seams.desk import window_home

from tests.qgis.scenes import Scene
from tests.qgis.seams.desk.session_desk import BLURRED_WINDOW, SHARP_WINDOW, Desk, settle

WORDS = ("visible", "invisible", "unsure")


def main(folder: Path, kind: str, paths: list[str]) -> None:
    """Never returns."""
    window_home.unsaved_folder = lambda: folder / "profile"
    scene = Scene(*map(Path, paths))
    desk = Desk(scene, folder)
    desk.project.setPresetHomePath("")
    project, is_first = str(folder / "project" / "project.qgz"), kind == "second"
    if kind == "saved":
        assert desk.project.write(project)
    desk.set(desk.inputs())
    if is_first:
        desk.session.judge([desk.add(SHARP_WINDOW)], "visible")
        desk.project.clear()
        desk.lay_out(scene)
        desk.set(desk.inputs())
    desk.session.place_windows()
    desk.wait()
    for window in (SHARP_WINDOW, BLURRED_WINDOW):
        desk.add(window)
    desk.session.inspect_pending()
    desk.wait()
    if kind == "moved":
        assert desk.project.write(project)
    windows = [row.window_id for row in desk.session.windows()]
    for done in count():
        number, word = windows[done % len(windows)], WORDS[done % len(WORDS)]
        row = desk.session.numbered(number)
        assert row is not None
        desk.session.judge([row.fid], word)
        print("judged", number, word, flush=True)  # noqa: T201
        if done % 5 == 4:
            desk.session.remove([row.fid])
            print("judged", number, "removed", flush=True)  # noqa: T201
            desk.undo()
            print("judged", number, word, flush=True)  # noqa: T201
        settle(0.01)


if __name__ == "__main__":
    application = QgsApplication([], True)
    application.initQgis()
    main(Path(sys.argv[1]), sys.argv[2], sys.argv[3:])
