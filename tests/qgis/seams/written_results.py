"""Results in a window layer, as the desk writes them."""
from __future__ import annotations

from collections.abc import Mapping

from qgis.core import QgsVectorLayer
from seam_inspector.plugin.seams.measure.window.window_result import WindowResult
from seam_inspector.plugin.seams.tables import window_layer


def write_results(layer: QgsVectorLayer, results: Mapping[int, WindowResult], **said: object) -> None:
    """Write results, by feature id, their numbers, and what operators said of all of them."""
    window_layer.add_levels(layer, 3)
    values = {
        fid: {"window_id": result.window_id, **window_layer.measured_values(layer, result), **said}
        for fid, result in results.items()
    }
    window_layer.write(layer, window_layer.WindowChange(values), "")
