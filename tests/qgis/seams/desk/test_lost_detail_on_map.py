"""Lost detail over the map is of a project, and goes with it."""
from __future__ import annotations

from pathlib import Path

from qgis.core import QgsProject
from qgis.gui import QgsMapCanvas
from seam_inspector.plugin.seams.desk.map.lost_detail import LossLegend, LossOverlay

from tests.qgis.scenes import Scene
from tests.qgis.seams.desk.session_desk import Desk


def test_it_goes_off_with_the_project(scene: Scene, project: QgsProject, tmp_path: Path) -> None:
    canvas = QgsMapCanvas()
    desk = Desk(scene, tmp_path)
    overlay = LossOverlay(canvas, desk.session)
    legend = canvas.findChild(LossLegend)
    desk.set(desk.inputs())
    desk.session.loss_view.show(True)
    assert not legend.isHidden()
    project.clear()
    desk.lay_out(scene)
    desk.set(desk.inputs())
    assert legend.isHidden()
    assert not desk.session.loss_view.is_shown
    overlay.close()
    desk.session.close()
