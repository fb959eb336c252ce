"""The colours of lost detail are those of the scan's picture, class by class."""
from __future__ import annotations

import numpy as np
import pytest
from qgis.core import QgsRasterLayer
from seam_inspector.plugin.seams.measure.profile.window_detail import LossPicture
from seam_inspector.plugin.seams.words import LOSS_CLASSES, loss_legend, loss_rgba
from seam_inspector.plugin.toolkit.resources import style_path

from tests.numbers.synthetic import write_raster


def test_every_share_has_the_colour_of_the_scans_style(tmp_path) -> None:
    layer = QgsRasterLayer(write_raster(tmp_path / "kept.tif", np.ones((1, 8, 8), np.float32)), "kept")
    _, loaded = layer.loadNamedStyle(style_path("loss"))
    assert loaded
    shader = layer.renderer().shader().rasterShaderFunction()
    shares = np.array([[0, 0.3, 0.49, 0.51, 0.6, 0.65, 0.75, 0.81, 0.899, 0.91, 1.0, 3.0]], np.float32)
    for share, colour in zip(shares[0].tolist(), loss_rgba(LossPicture(shares))[0].tolist()):
        _, *expected = shader.shade(share)
        assert colour[3] == expected[3], share
        assert colour == expected or not colour[3], share
    labels = [item.label for item in shader.colorRampItemList()]
    assert [words for words, _ in loss_legend()] == labels[: len(LOSS_CLASSES)]


def test_what_can_not_be_told_is_transparent() -> None:
    assert loss_rgba(LossPicture(np.array([[np.nan, 0.2]], np.float32)))[0, :, 3].tolist() == [0, 255]


@pytest.mark.parametrize("width_px", [4, 20, 43, 70])
def test_a_seam_is_painted_as_wide_as_it_is_told(width_px: int) -> None:
    """On average over places of the seam on the cells, whatever their smoothing spread."""
    widths = []
    for column in range(96, 112):  # of the seam, in samples
        seam = np.array([(row, side) for row in range(256) for side in (column - 1, column)], np.uint16)
        away_px = np.abs(8 * np.arange(64) + 4 - 2 * column)
        kept = np.where(np.tile(away_px, (64, 1)) < width_px / 2 + 70, 0.4, 1.0).astype(np.float32)
        kept[:, 60:] = 0.4  # no business of the seam
        painted = loss_rgba(LossPicture(kept, seam=seam), width_px)[0, :, 3] > 0
        widths.append(8 * int(painted[:50].sum()))
        assert painted[60:].all()
    assert min(widths) > 0  # a narrow one is seen all the same
    assert np.mean(widths) == pytest.approx(max(width_px, 12), abs=3)
