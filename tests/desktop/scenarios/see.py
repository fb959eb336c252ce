"""Seeing where detail was lost, on real images: the mosaic beside its hard cut.

Parameters: ``brighton`` (folder), ``screenshots`` (folder).
"""
from __future__ import annotations

from pathlib import Path

from demo.desk import Desk

SIDE_M, SPACING_M = 15, 8


def play(desk: Desk) -> None:
    """All that is measured is in the report."""
    shots = Path(desk.parameters["screenshots"])
    desk.set_up(Path(desk.parameters["brighton"]), SIDE_M, SPACING_M, mosaic="mosaic_feather0p4m")
    desk.dock.place.trigger()
    desk.wait(lambda: desk.session.windows() and not desk.session.is_busy, 60, "windows placed")
    rows = desk.session.windows()
    fid = rows[len(rows) // 2].fid
    desk.session.select([fid])
    desk.session.inspect([fid])
    desk.wait_for_work()
    desk.rest_mouse()  # from the map, whose tips are web views
    compare(desk, shots)


def compare(desk: Desk, shots: Path) -> None:
    """The mosaic beside its hard cut, then a source, with the lost detail on both."""
    desk.show_tab(1)
    panel = desk.dock.images
    for place, name in ((0, "cut"), (1, "source")):
        panel.choice.setCurrentIndex(place)
        panel.choice.activated.emit(place)
        desk.wait(lambda: panel.compared.layer is not None, 30, name)
        desk.wait(lambda: not panel.mosaic.isDrawing() and not panel.other.isDrawing(), 30, f"{name} drawn")
        desk.screenshot(shots / f"see_{name}.png")
    desk.report["units"] = [one.mapUnitsPerPixel() / desk.session.mosaic_grid().pixel_width
                            for one in (panel.mosaic, panel.other)]
    desk.dock.lost.action.trigger()
    desk.report["loss_shown"] = [bool(one.loss.pictures) for one in (panel.mosaic, panel.other)]
    desk.screenshot(shots / "see_loss.png")
    desk.dock.lost.action.trigger()
