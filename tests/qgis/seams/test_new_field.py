"""A new field of windows is one entry: it is written, read, shown, called and filtered by that alone."""
from __future__ import annotations

import subprocess
import sys
from pathlib import Path

PLAY = """
from qgis.core import QgsApplication

application = QgsApplication([], False)
QgsApplication.initQgis()
from seam_inspector.plugin.seams.measure.window import window_tables

made = window_tables.WindowField(
    "roughness", "real", lambda result: 0.25, title="roughness of the ground", heading="roughness",
    help="Made up for a test.", shown="percent", called=("rough",),
)
window_tables.MEASURED = (*window_tables.MEASURED, made)
window_tables.WINDOW_FIELDS = (*window_tables.WINDOW_FIELDS, made)
window_tables.in_filter.__defaults__ = (window_tables.WINDOW_FIELDS,)

from seam_inspector.plugin.seams.desk.windows.window_columns import CHOSEN_COLUMNS
from seam_inspector.plugin.seams.desk.windows.windows_filter import window_test
from seam_inspector.plugin.seams.tables import window_layer
from seam_inspector.plugin.toolkit.layer_styles import field_title
from tests.qgis.scenes import SHARP, layer, outline
from tests.qgis.seams.test_window_summary import result
from tests.qgis.seams.written_results import write_results

drawn = layer("Polygon", [outline(SHARP)])
write_results(drawn, {1: result("blur")})
(record,) = window_layer.read_layer(drawn)
assert record.read("roughness") == 0.25
(column,) = [one for one in CHOSEN_COLUMNS if one.name == "roughness"]
assert column.text(record) == "25 %"
assert field_title("roughness") == "roughness of the ground"
assert window_test("rough < 0.3", 3)(record)
assert not window_test("roughness > 0.3", 3)(record)
print("played")
"""


def test_a_new_field_is_one_entry(repository: Path) -> None:
    played = subprocess.run([sys.executable, "-c", PLAY], capture_output=True, text=True, cwd=repository, check=False)
    assert "played" in played.stdout, played.stderr
