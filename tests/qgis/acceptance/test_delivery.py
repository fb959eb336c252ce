"""A delivery of twelve sheets, four of them spoilt in known ways, from rasters to a decision: two calls."""
from __future__ import annotations

import subprocess
from pathlib import Path

import pytest
from qgis.core import QgsVectorLayer

from demo.delivery import SPOILT, Delivery
from tests.made_once import the_delivery
from tests.qgis.qgis_processes import NEEDED, PROGRAM, environment

pytestmark = [pytest.mark.slow, pytest.mark.release, NEEDED]

CLOSE = 0.05  # tolerance, relative to what is known of the delivery


@pytest.fixture(scope="module")
def delivery(tmp_path_factory: pytest.TempPathFactory) -> Delivery:
    return the_delivery(tmp_path_factory)


@pytest.fixture(scope="module")
def decided(delivery: Delivery, repository: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The folder with the results of a scan and a decision."""
    folder = tmp_path_factory.mktemp("decided")
    variables = environment(repository, tmp_path_factory.mktemp("settings"))

    def call(*arguments: str) -> None:
        done = subprocess.run(
            [str(PROGRAM), *arguments], env=variables, capture_output=True, text=True, timeout=300, check=False
        )
        assert done.returncode == 0, done.stderr
        (folder / f"{arguments[1].partition(':')[2] or 'enable'}.log").write_text(done.stdout, encoding="utf-8")

    call("plugins", "enable", "seam_inspector")
    call(
        "run", "seaminspector:scanmosaic", f"--MOSAIC={delivery.mosaic}", f"--SEAMLINES={delivery.seamlines}",
        *(f"--SOURCES={source}" for source in delivery.sources), "--PIECE=10", f"--LOSS={folder / 'loss.tif'}",
        f"--SEAMS={folder / 'seams.gpkg'}", f"--CELLS={folder / 'cells.gpkg'}", f"--WORST={folder / 'worst.gpkg'}",
    )
    call(
        "run", "seaminspector:acceptmosaic", f"--SEAMS={folder / 'seams.gpkg'}", f"--SHEETS={delivery.index}",
        f"--MOSAIC={delivery.mosaic}", f"--REPORT={folder / 'decision.html'}", f"--QUALITY={folder / 'quality.xml'}",
        f"--DEFECTS={folder / 'defects.gpkg'}",
    )
    return folder


def number(decided: Path, algorithm: str, name: str) -> float:
    lines = (decided / f"{algorithm}.log").read_text(encoding="utf-8").splitlines()
    return float(next(line.partition(":")[2] for line in lines if line.startswith(f"{name}:")))


def test_the_decision_is_the_truth(decided: Path, delivery: Delivery) -> None:
    assert number(decided, "acceptmosaic", "ACCEPTED") == 0
    known = {
        "TOTAL_METRES": delivery.seam_metres, "FAILED_METRES": sum(delivery.spoilt_metres),
        "LONGEST_FAILURE": max(delivery.spoilt_metres),
        "FAILED_SHARE": 100 * sum(delivery.spoilt_metres) / delivery.seam_metres,
    }  # fmt: skip
    for name, value in known.items():
        assert number(decided, "acceptmosaic", name) == pytest.approx(value, rel=CLOSE), name


def test_what_goes_back_is_what_was_spoilt(decided: Path, delivery: Delivery) -> None:
    """Each failure in its sheet, as long as it is, with its picture."""
    rows = list(QgsVectorLayer(str(decided / "defects.gpkg"), "defects", "ogr").getFeatures())
    items = {row["sheet"]: row["length"] for row in rows}
    lengths = dict(zip(("sheet_1_2", "sheet_2_1", "sheet_2_4", "sheet_3_3"), delivery.spoilt_metres))
    assert len(SPOILT) == len(rows) == 4
    assert sorted(items) == sorted(lengths)
    for sheet, length in lengths.items():
        assert items[sheet] == pytest.approx(length, abs=11), sheet  # a piece has 10 m
    assert all((decided / row["picture"]).is_file() for row in rows)
