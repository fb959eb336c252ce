"""The colours of lost detail are those of the scan's picture, class by class."""
from __future__ import annotations

import numpy as np
from qgis.core import QgsRasterLayer
from seam_inspector.plugin.seams.words import LOSS_CLASSES, loss_legend, loss_rgba
from seam_inspector.plugin.toolkit.resources import style_path

from tests.numbers.synthetic import write_raster


def test_every_share_has_the_colour_of_the_scans_style(tmp_path) -> None:
    layer = QgsRasterLayer(write_raster(tmp_path / "kept.tif", np.ones((1, 8, 8), np.float32)), "kept")
    _, loaded = layer.loadNamedStyle(style_path("loss"))
    assert loaded
    shader = layer.renderer().shader().rasterShaderFunction()
    shares = np.array([[0, 0.3, 0.49, 0.51, 0.6, 0.65, 0.75, 0.81, 0.899, 0.91, 1.0, 3.0]], np.float32)
    for share, colour in zip(shares[0].tolist(), loss_rgba(shares)[0].tolist()):
        _, *expected = shader.shade(share)
        assert colour[3] == expected[3], share
        assert colour == expected or not colour[3], share
    labels = [item.label for item in shader.colorRampItemList()]
    assert [words for words, _ in loss_legend()] == labels[: len(LOSS_CLASSES)]


def test_what_can_not_be_told_is_transparent() -> None:
    assert loss_rgba(np.array([[np.nan, 0.2]], np.float32))[0, :, 3].tolist() == [0, 255]
