"""The plugin is updated, as QGIS and the plugin reloader do it, while one of its algorithms runs in a task."""
from __future__ import annotations

import sys
from typing import Any

import pytest
from seam_inspector.plugin.radiometry.checkradiometry import CheckRadiometry
from seam_inspector.plugin.toolkit.algorithms import base

from tests.qgis.runs import run
from tests.qgis.scenes import Scene


@pytest.mark.usefixtures("provider")
@pytest.mark.parametrize("forgotten", [False, True])
def test_what_can_not_be_imported_any_more_is_a_sentence(
    forgotten: bool, scene: Scene, monkeypatch: pytest.MonkeyPatch
) -> None:
    def execute(self: CheckRadiometry, run: Any) -> dict[str, Any]:
        if forgotten:  # by QGIS, meanwhile
            monkeypatch.delitem(sys.modules, base.__name__)
        raise AttributeError("of modules that are half there")

    monkeypatch.setattr(CheckRadiometry, "execute", execute)
    ended = run("checkradiometry", RASTERS=[str(scene.mosaic)])
    said = "Seam Inspector was updated or turned off while this ran; start it again."
    assert (ended.complaint == said) is forgotten, ended.complaint
    assert ended.complaint is not None  # any other fault is still told whole
    assert ("half there" in ended.complaint) is not forgotten
