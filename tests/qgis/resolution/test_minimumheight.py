"""``seaminspector:minimumheight`` and ``seaminspector:simulatebayer`` as QGIS runs them."""
from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from osgeo import gdal
from qgis.core import QgsProcessingProvider, QgsVectorLayer
from seam_inspector.plugin.resolution.measure import bayer

from tests.numbers.synthetic import orthoimage, write_raster
from tests.qgis.runs import Log, assert_refused, run
from tests.qgis.scenes import layer

pytestmark = pytest.mark.usefixtures("provider")


def table(rows: Sequence[tuple[Any, ...]], **fields: str) -> QgsVectorLayer:
    """A table with columns of such types, or ``height`` and ``grd``."""
    kinds = fields or {"height": "double", "grd": "double"}
    columns = {name: (kind, [row[place] for row in rows]) for place, (name, kind) in enumerate(kinds.items())}
    return layer("NoGeometry", [None] * len(rows), **columns)


def test_the_papers_example(provider: QgsProcessingProvider) -> None:
    log = Log()
    made = run("minimumheight", log, OBSERVATIONS=table([(3000.0, 33.67)]), REFERENCE_HEIGHT=2704)
    (row,) = made.rows()
    assert row["count"] == 1
    assert row["mean"] == pytest.approx(2673.0, abs=0.05)
    assert row["spread"] is None
    assert row["tolerance"] == pytest.approx(-1.15, abs=0.01)
    assert any("the Open Skies treaty asks for 5" in warning for warning in log.warnings)
    assert "treaty" in row["notice"]


def test_each_sensor_has_its_reference() -> None:
    rows = [("DMC", 3000.0, 30.0), ("RC20", 2000.0, 30.0)]
    observations = table(rows, sensor="string", height="double", grd="double")
    made = run("minimumheight", OBSERVATIONS=observations, REFERENCE_HEIGHT="DMC 2500; RC20 1600")
    assert made.column("tolerance") == [20, 25]
    assert_refused("minimumheight", "for RMK, but", OBSERVATIONS=observations, REFERENCE_HEIGHT="RMK 2000")


def test_groups_and_passes() -> None:
    rows = [("DMC", "PAN", "along", 3000, 30.0 + number) for number in range(5)] + [("DMC", "RGB", "along", 2500, 60.0)]
    observations = table(rows, sensor="string", image_type="string", direction="string", height="integer", grd="double")
    made = run("minimumheight", OBSERVATIONS=observations)
    assert made.layer().fields().names() == (
        "sensor image_type direction count mean spread observers observer_spread reference tolerance notice".split()
    )
    pan, rgb = made.rows()
    heights = [3000 * 30 / (30 + number) for number in range(5)]
    assert (pan["count"], rgb["count"]) == (5, 1)
    assert pan["mean"] == pytest.approx(np.mean(heights))
    assert pan["spread"] == pytest.approx(np.std(heights, ddof=1))
    assert pan["notice"] is None
    assert pan["tolerance"] is None
    assert rgb["mean"] == pytest.approx(1250)
    assert made.column("h_min", "HEIGHTS") == pytest.approx([*heights, 1250])
    assert made.results["GROUP_COUNT"] == 2


def test_bad_rows_are_told_and_cost_nothing_else() -> None:
    log = Log()
    made = run("minimumheight", log, OBSERVATIONS=table([(3000.0, 30.0), (None, 30.0), (3000.0, -1.0)]))
    assert made.column("count") == [1]
    assert [warning for warning in log.warnings if "Row 2 is left out: 'height' or 'grd' holds no number" in warning]
    assert [warning for warning in log.warnings if "Row 3 is left out" in warning and "positive" in warning]


def test_a_table_without_its_fields_or_rows() -> None:
    made = run("minimumheight", OBSERVATIONS=table([(3000.0,)], height="double"))
    assert "no field 'grd'" in str(made.complaint)
    assert "No row has a height" in str(run("minimumheight", OBSERVATIONS=table([])).complaint)


@pytest.mark.parametrize("demosaic", ["bilinear", "malvar", "edge_aware"])
@pytest.mark.parametrize("pattern", ["RGGB", "GBRG"])
def test_a_simulated_bayer_image(tmp_path: Path, pattern: str, demosaic: str) -> None:
    scene = orthoimage((40, 50))
    path = write_raster(tmp_path / "scene.tif", scene)
    made = run(
        "simulatebayer", RASTER=path, PATTERN=pattern, DEMOSAIC=demosaic, OUTPUT=str(tmp_path / f"{demosaic}.tif")
    )
    assert made.complaint is None
    seen = gdal.Open(made.results["OUTPUT"])
    assert seen.GetGeoTransform() == gdal.Open(path).GetGeoTransform()
    assert "UTM zone 33N" in seen.GetProjection()
    assert [seen.GetRasterBand(band).GetColorInterpretation() for band in (1, 2, 3)] == [
        gdal.GCI_RedBand, gdal.GCI_GreenBand, gdal.GCI_BlueBand
    ]
    assert np.array_equal(seen.ReadAsArray(), bayer.simulated(scene, pattern, demosaic))


def test_what_can_not_be_simulated_is_told(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    path = write_raster(tmp_path / "two.tif", orthoimage((30, 30))[:2])
    assert "no red, green and blue" in str(run("simulatebayer", RASTER=path).complaint)
    floats = write_raster(tmp_path / "floats.tif", orthoimage((30, 30), dtype=np.float32))
    assert "choose malvar or bilinear" in str(run("simulatebayer", RASTER=floats, DEMOSAIC="edge_aware").complaint)
    lost = run("simulatebayer", RASTER=floats, OUTPUT="/nowhere/there/seen.tif")
    assert "can't be written" in str(lost.complaint)
    monkeypatch.setattr(bayer, "find_spec", lambda name: None)
    assert_refused("simulatebayer", "needs OpenCV", RASTER=path, DEMOSAIC="edge_aware")
    assert_refused("simulatebayer", "does not exist", RASTER="/nowhere/scene.tif")
