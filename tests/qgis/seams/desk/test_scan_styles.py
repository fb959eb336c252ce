"""The styles of a scan's layers: even ground can be seen through, losses are yellow to red, verdicts as elsewhere."""
from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from qgis.core import (
    QgsApplication,
    QgsExpression,
    QgsExpressionContext,
    QgsGeometry,
    QgsMapRendererSequentialJob,
    QgsMapSettings,
    QgsRasterLayer,
    QgsRectangle,
)
from qgis.PyQt.QtCore import QSize
from qgis.PyQt.QtGui import QColor
from seam_inspector.plugin.seams.tables.scan_layers import SCAN_LAYERS
from seam_inspector.plugin.seams.words import VERDICTS
from seam_inspector.plugin.toolkit.layer_styles import load_style
from seam_inspector.plugin.toolkit.resources import style_path

from tests.numbers.synthetic import write_raster
from tests.qgis.scenes import layer, line

KEPT = (1.3, 0.95, 0.91, 0.85, 0.75, 0.65, 0.55, 0.45, 0.1)


@pytest.fixture
def picture(qgis_app: QgsApplication, tmp_path: Path) -> QgsRasterLayer:
    """One pixel for each of ``KEPT``, and one where nothing was measured."""
    pixels = np.array([[*KEPT, -1.0]], np.float32)
    write_raster(tmp_path / "loss.tif", pixels, nodata=-1)
    made = QgsRasterLayer(str(tmp_path / "loss.tif"), "loss")
    message, worked = made.loadNamedStyle(style_path("loss"))
    assert worked, message
    return made


def colours(picture: QgsRasterLayer) -> list[QColor]:
    """Colours as they are drawn, one for each pixel."""
    settings = QgsMapSettings()
    settings.setLayers([picture])
    settings.setExtent(picture.extent())
    settings.setOutputSize(QSize(10 * picture.width(), 10))
    settings.setBackgroundColor(QColor(0, 0, 0, 0))
    job = QgsMapRendererSequentialJob(settings)
    job.start()
    job.waitForFinished()
    image = job.renderedImage()
    return [image.pixelColor(10 * column + 5, 5) for column in range(picture.width())]


def test_losses_go_from_yellow_to_red(picture: QgsRasterLayer) -> None:
    losses = colours(picture)[3:-1]
    hues = [(colour.hsvHue() + 60) % 360 for colour in losses]  # red is at 60 then, yellow at 120
    assert 100 <= hues[0] <= 120
    assert all(after < before for before, after in zip(hues, hues[1:-1]))
    assert losses[-1] == losses[-2]  # half of it, or less, is as bad as it gets
    assert all(40 <= hue <= 65 for hue in hues[-2:])


def test_seams_have_the_colours_of_verdicts(qgis_app: QgsApplication) -> None:
    seams = layer("LineString", [line((0, 0), (9, 9))], verdict=("string", ["reduced"]))
    message, worked = seams.loadNamedStyle(style_path("seams"))
    assert worked, message
    categories = {category.value(): category for category in seams.renderer().categories()}
    assert set(categories) == set(VERDICTS) - {""}
    for verdict in ("significant", "reduced", "preserved"):
        symbol = categories[verdict].symbol()
        assert symbol.symbolLayer(symbol.symbolLayerCount() - 1).color().name() == VERDICTS[verdict].colour
        assert symbol.symbolLayer(symbol.symbolLayerCount() - 1).useCustomDashPattern()  # windows' frames are not
    widths = [categories[verdict].symbol().width() for verdict in ("significant", "reduced", "preserved")]
    assert sorted(widths, reverse=True) == widths
    thin = categories["not_comparable"].symbol()
    colour = thin.symbolLayer(thin.symbolLayerCount() - 1).color()
    assert colour.saturation() == 0
    assert thin.width() < min(widths)


def test_every_layer_has_its_style() -> None:
    assert all(Path(style_path(item.style)).is_file() for item in SCAN_LAYERS)


@pytest.mark.parametrize(
    ("style", "number", "said"),
    [("defects", 20, "F20"), ("seams", 0.47, "47 %"), ("seams", 0.699, "69.9 %"), ("seams", 0.6996, "69.96 %"),
     ("seams", 0.7, "70 %"), ("seams", 0.703, "70.3 %")],
)  # fmt: skip
def test_labels_are_no_windows_numbers_and_seen_to_lie_beyond_the_limit(
    qgis_app: QgsApplication, style: str, number: float, said: str
) -> None:
    fields = {"defect": ("double", [number]), "kept_1": ("double", [number]), "verdict": ("string", ["reduced"])}
    shown = layer("LineString", [line((0, 0), (9, 9))], **fields)
    load_style(shown, style)
    context = QgsExpressionContext()
    context.setFeature(next(shown.getFeatures()))
    assert QgsExpression(shown.labeling().settings().fieldName).evaluate(context) == said


@pytest.mark.parametrize("style", ["windows", "seams", "defects"])
def test_numbers_of_map_tips_lie_on_their_side_of_the_limit(qgis_app: QgsApplication, style: str) -> None:
    numbers = {"kept_1": 0.6996, "kept_low": 0.62, "kept_high": 0.703, "band_width": 1.26, "defect": 3.0, "length": 5.0}
    words = {"verdict": "reduced", "reference": "seam", "left_source": "a", "right_source": "b"}
    kinds = {**{name: ("double", [number]) for name, number in numbers.items()},
             **{name: ("string", [word]) for name, word in words.items()}}
    outline = QgsGeometry.fromRect(QgsRectangle(0, 0, 9, 9))
    polygon, course = ("Polygon", [outline]), ("LineString", [line((0, 0), (9, 9))])
    shown = layer(*(polygon if style == "windows" else course), **kinds)
    shown.loadNamedStyle(style_path(style))
    context = QgsExpressionContext()
    context.setFeature(next(shown.getFeatures()))
    tip = QgsExpression.replaceExpressionText(shown.mapTipTemplate(), context)
    assert ": 69.96 % (62" in tip
    assert "70.3 %), in a width of 1.3 m" in tip
