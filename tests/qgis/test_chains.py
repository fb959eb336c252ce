"""A layer that an algorithm wrote is whole when the algorithm ends: the next one in a script or model finds it so."""
from __future__ import annotations

import json
import os
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest
from qgis.core import QgsFeatureSink, QgsVectorLayer
from seam_inspector.plugin.toolkit.algorithms.run import Run

from tests.qgis.chains import CHAINS, KINDS
from tests.qgis.runs import Log, run_unchecked
from tests.qgis.scenes import BLURRED, SHARP, Scene, windows

pytestmark = pytest.mark.slow

SAID_BY_THE_SCENE = {
    "placewindows OUTPUT": 4,
    "inspectwindows OUTPUT": 4,
    "inspectwindows PAIRS": 4 * 3 * 4,  # windows, sources with the composite, bands
    "inspectwindows CURVES": 4 * 4 * 4 * 4,  # windows, rasters with the composite, bands, components
    "inspect_mosaic inspect:pairs": 4 * 3 * 4,
    "measureresolution OUTPUT": 10 * 3,  # lines, bands
    "interiororientation OUTPUT": 4,
    "fitsensormodel OUTPUT": 12,
}


@pytest.mark.parametrize(
    "chain", [chain if chain == "seams" else pytest.param(chain, marks=pytest.mark.release) for chain in CHAINS]
)
def test_every_layer_is_whole_without_the_collector(
    chain: str, given: dict[str, Any], tmp_path: Path, repository: Path
) -> None:
    environment = {**os.environ, "QT_QPA_PLATFORM": "offscreen", "PYTHONPATH": str(repository / "build" / "plugins")}
    finished = subprocess.run(
        [sys.executable, "-m", "tests.qgis.chains", chain, json.dumps(given), str(tmp_path)],
        cwd=repository, env=environment, capture_output=True, text=True, timeout=300, check=False,
    )  # fmt: skip
    assert finished.returncode == 0, finished.stderr
    counts = json.loads(finished.stdout.splitlines()[-1])
    assert list(counts) == list(KINDS)
    empty = {name for name, count in counts["memory"].items() if not count}
    assert empty <= {"inspectwindows PROFILES", "inspect_mosaic inspect:profiles"}, counts  # its windows have no seam
    assert counts["gpkg"] == counts["csv"] == counts["memory"]
    expected = {name: count for name, count in SAID_BY_THE_SCENE.items() if name in counts["memory"]}
    assert {name: counts["memory"][name] for name in expected} == expected
    assert expected


class UnexpectedError(Exception):
    """An error of no kind that the algorithms expect."""


@pytest.mark.usefixtures("provider")
@pytest.mark.parametrize("end", ["cancelled", "failed"])
def test_a_layer_is_whole_however_the_algorithm_ends(
    scene: Scene, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, end: str
) -> None:
    held: list[QgsFeatureSink] = []  # as a frame of a traceback would
    plain, written = Run.write, []

    def write(self: Run, sink: QgsFeatureSink, features: Any) -> None:
        plain(self, sink, features)
        held.append(sink)
        written.append(sink)
        if len(written) == 3:  # window, curves and pairs of the first one
            if end == "failed":
                raise UnexpectedError
            log.cancel()

    log = Log()
    monkeypatch.setattr(Run, "write", write)
    output = tmp_path / "inspected.gpkg"
    try:
        run_unchecked(
            "inspectwindows", log, WINDOWS=windows(SHARP, BLURRED), MOSAIC=str(scene.mosaic), SOURCES=scene.sources,
            OUTPUT=str(output), CURVES=str(tmp_path / "curves.csv"),
        )
    except UnexpectedError:
        assert end == "failed"
    rows = (tmp_path / "curves.csv").read_text(encoding="utf-8").splitlines()
    assert len(rows) >= 1 + 4 * 4 * 4
    assert QgsVectorLayer(str(output), "inspected", "ogr").featureCount() >= 1
