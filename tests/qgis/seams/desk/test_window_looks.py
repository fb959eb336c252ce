"""Windows on the map: the verdict's colour in every state, a mark on the judged ones, the worst on top."""
from __future__ import annotations

from collections import Counter

import pytest
from qgis.core import (
    QgsExpressionContext,
    QgsExpressionContextUtils,
    QgsFeature,
    QgsGeometry,
    QgsMapRendererParallelJob,
    QgsMapSettings,
    QgsProject,
    QgsRectangle,
    QgsSingleSymbolRenderer,
    QgsSymbol,
    QgsVectorLayer,
)
from qgis.PyQt.QtCore import QSize
from qgis.PyQt.QtGui import QColor, QImage
from seam_inspector.plugin.seams.words import VERDICTS
from seam_inspector.plugin.toolkit.layer_styles import load_style

from tests.qgis.scenes import SHARP, windows
from tests.qgis.seams.desk.selections import selection_scope
from tests.qgis.seams.desk.session_desk import Desk, wait_until

SELECTION = "#ff00ff"
SIDE_M = 100.0


def drawn(
    project: QgsProject, *rows: dict[str, object], selected: bool = False, apart_m: float = 0.0, view_m: float = 160.0
) -> QImage:
    """The map of windows whose corners lie so far apart, one after another."""
    fields = "field=window_id:integer&field=verdict:string&field=observer:string&field=ratio_1:double"
    layer = QgsVectorLayer(f"Polygon?crs=EPSG:2180&{fields}", "windows", "memory")
    for number, row in enumerate(rows):
        feature = QgsFeature(layer.fields())
        for name, value in row.items():
            feature[name] = value
        left = 500_000 + number * apart_m
        feature.setGeometry(QgsGeometry.fromRect(QgsRectangle(left, 500_000, left + SIDE_M, 500_000 + SIDE_M)))
        layer.dataProvider().addFeature(feature)
    load_style(layer, "windows")
    layer.setLabelsEnabled(False)
    project.addMapLayer(layer)
    if selected:
        layer.selectAll()
    settings = QgsMapSettings()
    settings.setLayers([layer])
    settings.setDestinationCrs(layer.crs())
    settings.setOutputSize(QSize(640, 640))
    settings.setSelectionColor(QColor(SELECTION))
    margin = (view_m - SIDE_M) / 2
    settings.setExtent(QgsRectangle(500_000 - margin, 500_000 - margin, 500_100 + margin, 500_100 + margin))
    context = QgsExpressionContext()
    context.appendScope(QgsExpressionContextUtils.projectScope(project))
    context.appendScope(selection_scope(layer))
    context.appendScope(QgsExpressionContextUtils.mapSettingsScope(settings))
    settings.setExpressionContext(context)
    job = QgsMapRendererParallelJob(settings)
    job.start()
    wait_until(lambda: not job.isActive(), "for the map")
    return job.renderedImage()


def colours(image: QImage) -> Counter[str]:
    result = Counter(image.pixel(x, y) for x in range(image.width()) for y in range(image.height()))
    return Counter({QColor(pixel).name(): count for pixel, count in result.items()})


def inside(image: QImage) -> set[str]:
    """What is seen within a window, away from its outline and its corners."""
    return {QColor(image.pixel(x, y)).name() for x in range(180, 440, 7) for y in range(180, 440, 7)}


@pytest.mark.parametrize("verdict", [verdict for verdict in VERDICTS if verdict])
def test_a_selected_window_keeps_its_colour_and_lets_the_image_be_seen(project: QgsProject, verdict: str) -> None:
    plain, selected = drawn(project, {"verdict": verdict}), drawn(project, {"verdict": verdict}, selected=True)
    colour = VERDICTS[verdict].colour
    before, after = colours(plain), colours(selected)
    assert before[colour] > 200
    assert after[colour] >= 0.9 * before[colour]
    assert before[SELECTION] == 0
    assert after[SELECTION] > 1000
    assert after["#000000"] > before["#000000"] + 1000  # around the verdict's, on the selection's
    assert inside(plain) == inside(selected) == {"#ffffff"}


def test_the_judged_ones_have_a_mark_in_a_corner_that_says_how(project: QgsProject) -> None:
    images = {word: drawn(project, {"verdict": "reduced", "observer": word})
              for word in (None, "visible", "invisible", "unsure")}
    items = list(images.values())
    assert all(item != other for place, item in enumerate(items) for other in items[:place])
    assert all(inside(image) == {"#ffffff"} for image in items)
    changed = [
        (x, y) for x in range(640) for y in range(640)
        if images[None].pixel(x, y) != images["visible"].pixel(x, y)
    ]
    assert min(x for x, _ in changed) > 440
    assert min(y for _, y in changed) > 440


def test_the_worst_lies_on_top_and_a_selected_one_above_it(project: QgsProject) -> None:
    worst, kept = VERDICTS["significant"].colour, VERDICTS["preserved"].colour
    rows = ({"verdict": "significant"}, {"verdict": "preserved"})
    for order in (rows, rows[::-1]):
        result = colours(drawn(project, *order))
        assert result[worst] > 200
        assert result[kept] == 0


# A layer that the desk takes for its windows


def test_only_a_windows_file_gets_our_style_and_only_once(desk: Desk) -> None:
    outside = windows(SHARP)
    desk.project.addMapLayer(outside)
    desk.set(desk.inputs(windows=outside.id()))
    assert outside.renderer().type() == "singleSymbol"
    desk.set(desk.inputs(windows=""))
    desk.add()
    source = desk.layer().source()
    desk.project.removeMapLayer(desk.layer().id())
    again = QgsVectorLayer(source, "windows", "ogr")
    desk.project.addMapLayer(again)
    desk.set(desk.inputs(windows=again.id()))
    assert again.renderer().type() == "categorizedSymbol"
    again.setRenderer(QgsSingleSymbolRenderer(QgsSymbol.defaultSymbol(again.geometryType())))
    desk.set(desk.inputs(windows=""))
    desk.set(desk.inputs(windows=again.id()))
    assert again.renderer().type() == "singleSymbol"  # so its user wanted it
