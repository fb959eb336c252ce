"""Many photos in QGIS's own batch dialog."""
from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from processing.gui import BatchAlgorithmDialog
from qgis.core import QgsApplication, QgsVectorLayer
from qgis.PyQt.QtWidgets import QFileDialog

from tests.numbers.synthetic import write_plain
from tests.qgis.photos.photo_scenes import make_photo
from tests.qgis.runs import assert_sentence
from tests.qgis.seams.desk.session_desk import wait_until

pytestmark = [
    pytest.mark.usefixtures("provider"),
    pytest.mark.skipif(
        not hasattr(BatchAlgorithmDialog, "QgsScopedProxyProgressTask"),
        reason="the batch dialog of this QGIS, written anew since, does not end without the desktop",
    ),
]

COUNT = 6


class Progress:
    """In place of the task that shows the progress elsewhere: QGIS 3.22 never ends it, and waits for it at its end."""

    def __init__(self, description: str) -> None:
        self.description = description

    def setProgress(self, progress: float) -> None:
        assert 0 <= progress <= 100


def test_a_batch_goes_on_after_photos_that_fail(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A white photo and one that is lost are said at the end; all others are measured."""
    photos, calibration = [], ""
    for number in range(COUNT):
        folder = tmp_path / str(number)
        folder.mkdir()
        scene = make_photo(folder, seed=number, side=480)
        photos.append(str(scene.photo))
        calibration = str(scene.calibration)
    photos[1] = write_plain(tmp_path / "white.tif", np.full((300, 300), 255, np.uint8))
    photos[3] = str(tmp_path / "lost.tif")
    rows = [
        {
            "PARAMETERS": {
                "PHOTO": repr(photo), "CALIBRATION": repr(calibration), "TEMPLATE_KIND": repr("ring with cross")
            },
            "OUTPUTS": {"OUTPUT": str(tmp_path / f"marks{number}.gpkg")},
        }
        for number, photo in enumerate(photos)
    ]
    saved = tmp_path / "batch.json"
    saved.write_text(json.dumps(rows), encoding="utf-8")
    monkeypatch.setattr(QFileDialog, "getOpenFileName", lambda *_: (str(saved), ""))
    monkeypatch.setattr(BatchAlgorithmDialog, "QgsScopedProxyProgressTask", Progress)
    finished: list[tuple[list[Any], list[Any]]] = []
    monkeypatch.setattr(
        BatchAlgorithmDialog.BatchAlgorithmDialog, "createSummaryTable",
        lambda _, done, errors: finished.append((done, errors)),
    )
    algorithm = QgsApplication.processingRegistry().createAlgorithmById("seaminspector:interiororientation")
    dialog = BatchAlgorithmDialog.BatchAlgorithmDialog(algorithm)
    dialog.mainWidget().checkLoadLayersOnCompletion.setChecked(False)
    dialog.mainWidget().load()
    dialog.runAlgorithm()
    wait_until(lambda: finished, "for the batch")
    dialog.close()
    dialog.deleteLater()
    done, errors = finished[0]
    assert [entry["results"]["FAILED"] for entry in done] == [0] * (COUNT - 2)
    assert [entry["parameters"]["PHOTO"] for entry in errors] == [photos[1], photos[3]]
    white, lost = (entry["errors"][0] for entry in errors)
    assert_sentence(white, "are alike")
    assert_sentence(lost, "does not exist")
    for entry in done:
        assert QgsVectorLayer(entry["results"]["OUTPUT"], "marks", "ogr").featureCount() == 4
