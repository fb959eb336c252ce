"""The map's style knows the selected windows by a variable of the map, and asks nothing that a drawing thread can't."""
from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import pytest
from qgis.core import QgsFeature, QgsVectorLayer
from qgis.gui import QgsMapCanvas
from seam_inspector.plugin.seams.desk.map.window_view import SELECTED, SelectedWindows

from tests.qgis.scenes import BLURRED, SHARP, windows
from tests.qgis.seams.desk.session_desk import Desk, settle


@pytest.fixture
def selection(desk: Desk) -> Iterator[SelectedWindows]:
    made = SelectedWindows(QgsMapCanvas(), desk.session)
    yield made
    made.close()
    assert not made._canvas.expressionContextScope().hasVariable(SELECTED)


def known(selection: SelectedWindows) -> set[str]:
    return set(selection._canvas.expressionContextScope().variable(SELECTED))


def keys(layer: QgsVectorLayer, *features: int | QgsFeature) -> set[str]:
    return {f"{layer.id()} {feature}" for feature in features}


def test_the_map_knows_the_selection_before_it_is_drawn_again(desk: Desk, selection: SelectedWindows) -> None:
    assert known(selection) == set()
    layer = desk.use(windows(SHARP, BLURRED))
    first, second = (feature.id() for feature in layer.getFeatures())
    settle(0.02)
    layer.selectByIds([first])
    assert known(selection) == keys(layer, first)
    desk.session.select([second, first])
    assert known(selection) == keys(layer, first, second)
    layer.startEditing()
    layer.deleteFeature(first)
    settle(0.02)
    assert known(selection) == keys(layer, second)
    layer.rollBack()
    other = desk.use(windows(SHARP, BLURRED))
    other.selectByIds([second])
    settle(0.02)
    assert known(selection) == keys(other, second)
    desk.session.set_inputs(replace(desk.session.inputs, windows=""))
    settle(0.02)
    assert known(selection) == set()


def test_no_style_looks_into_the_layer(repository: Path) -> None:
    """The map is drawn in threads of its own, where QGIS before 3.30 crashes when the layer changes meanwhile."""
    for path in (repository / "resources" / "styles").glob("*.qml"):
        text = path.read_text(encoding="utf-8")
        for asking in ("is_selected", "num_selected", "get_feature", "aggregate(", "layer_property"):
            assert asking not in text, f"{path.name} asks {asking}"
