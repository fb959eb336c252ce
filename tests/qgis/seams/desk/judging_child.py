"""A QGIS of its own that places, inspects and judges windows, says what it did line by line, and waits to be killed.

Arguments: the folder; whether the project is saved ``first`` or ``after`` the windows are made; how many judgements;
the mosaic and its two sources.
"""
from __future__ import annotations

import sys
from pathlib import Path

from qgis.core import QgsApplication

WORDS = ("visible", "invisible", "unsure")


def main(folder: Path, saved: str, count: int, paths: list[str]) -> None:
    """Never returns."""
    from tests.qgis.scenes import Scene
    from tests.qgis.seams.desk.session_desk import BLURRED_WINDOW, SHARP_WINDOW, Desk, settle

    desk = Desk(Scene(*map(Path, paths)), folder)
    desk.set(desk.inputs())
    desk.project.setPresetHomePath("")
    project = str(folder / "project.qgz")
    if saved == "first":
        assert desk.project.write(project)
    desk.project.setFileName(project)
    desk.session.place_windows()
    desk.wait()
    for window in (SHARP_WINDOW, BLURRED_WINDOW):
        desk.add(window)
    desk.session.inspect_pending()
    desk.wait()
    if saved == "after":
        assert desk.project.write(project)
    windows = desk.session.windows()
    for done in range(count):
        row, word = windows[done % len(windows)], WORDS[done % len(WORDS)]
        desk.session.judge([row.fid], word)
        print("judged", row.window_id, word, flush=True)  # noqa: T201
        settle(0.02)
    desk.session.remove([windows[-1].fid])
    settle(1)
    print("removed", windows[-1].window_id, flush=True)  # noqa: T201
    while True:
        settle(0.1)


if __name__ == "__main__":
    application = QgsApplication([], True)
    application.initQgis()
    main(Path(sys.argv[1]), sys.argv[2], int(sys.argv[3]), sys.argv[4:])
