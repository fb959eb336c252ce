"""``planpoints`` as it is run: a table per number of points, and one sentence where nothing can be planned."""
from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from seam_inspector.plugin.sensors.measure.rpc import write_rpc

from tests.numbers.sensors.sensor_scenes import made_rational
from tests.numbers.synthetic import write_raster
from tests.qgis.runs import Log, assert_refused, run

pytestmark = pytest.mark.usefixtures("provider", "project")


def test_a_row_per_number_of_points_from_the_fewest_on() -> None:
    log = Log()
    outcome = run("planpoints", log, MODEL="polynomial_3d 1", COUNTS="12; 6 12", SIGMA=0.3)
    assert outcome.complaint is None
    rows = outcome.rows("OUTPUT")
    assert [row["control_count"] for row in rows] == [6, 12]
    assert rows[0]["image_50"] > rows[1]["image_50"]
    assert all(row["image_50"] <= row["image_90"] and row["model"] == "polynomial_3d 1" for row in rows)


def test_an_rpc_is_planned_by(tmp_path: Path) -> None:
    path = tmp_path / "image_RPC.TXT"
    write_rpc(made_rational(3, 2), path)
    given = {"MODEL": "rpc_bias shift", "COUNTS": "1,9", "SIGMA": 0, "IMAGE_RPC": str(path),
             "LOWEST": 100, "HIGHEST": 900}  # fmt: skip
    few, many = run("planpoints", **given).rows("OUTPUT")
    assert few["image_50"] / many["image_50"] == pytest.approx(3, rel=0.35)


def test_what_can_not_be_planned_is_told(tmp_path: Path) -> None:
    plain = write_raster(tmp_path / "plain.tif", np.full((8, 8), 9, np.uint8))
    for counts in ("", "ten", "0", "5.5", "-3", "99999"):
        assert_refused("planpoints", "give whole numbers from 1 to 1000", COUNTS=counts or " ")
    assert_refused("planpoints", "needs at least", COUNTS="5", MODEL="rational 3")
    assert_refused("planpoints", "no RPC", COUNTS="5", MODEL="rpc_bias shift")
    assert_refused("planpoints", "no RPC to plan by", COUNTS="5", IMAGE=str(plain))
    assert_refused("planpoints", "give metres, the lowest first", COUNTS="5", LOWEST=400)
    assert_refused("planpoints", "give metres, the lowest first", COUNTS="5", HIGHEST=90000)
