"""A desk whose numbers have decimal commas: tables and XML that programs read have points, and are read so."""
from __future__ import annotations

import csv
from pathlib import Path
from typing import Any

import pytest

from fuzz.running import outputs
from tests.qgis.runs import Run, run
from tests.qgis.scenes import BLURRED, SHARP, Scene, windows

pytestmark = pytest.mark.usefixtures("provider")


def calls(scene: Scene, given: dict[str, Any]) -> dict[str, dict[str, Any]]:
    return {
        "inspectwindows": {
            "WINDOWS": windows(SHARP, BLURRED), "MOSAIC": str(scene.mosaic), "SOURCES": scene.sources},
        "checkradiometry": {"RASTERS": [str(scene.mosaic)]},
        "fitsensormodel": {"GCPS": given["gcps"], "HEIGHTS": "ellipsoid", "MODEL": "polynomial_3d"},
        "interiororientation": {"PHOTO": given["photo"], "CALIBRATION": given["calibration"]},
    }  # fmt: skip


def written(name: str, folder: Path, values: dict[str, Any]) -> Run:
    """All outputs, tables as CSV."""
    folder.mkdir()
    files = {key: path.replace(".gpkg", ".csv") for key, path in outputs(name, folder).items()}
    ended = run(name, **{**{key: path for key, path in files.items() if not path.endswith(".tif")}, **values})
    assert ended.complaint is None
    return ended


def numbers(folder: Path) -> dict[str, list[list[str]]]:
    """Cells of CSV files that are numbers, whatever their decimal sign."""
    items = {}
    for path in sorted(folder.glob("*.csv")):
        with open(path, encoding="utf-8", newline="") as file:
            rows = list(csv.reader(file))
        items[path.name] = [[cell for cell in row if cell.replace(",", ".").lstrip("-").replace(".", "").isdigit()]
                            for row in rows]
    return items


@pytest.mark.parametrize("name", ["inspectwindows", "checkradiometry", "fitsensormodel", "interiororientation"])
def test_tables_have_points(
    name: str, scene: Scene, given: dict[str, Any], tmp_path: Path, request: pytest.FixtureRequest
) -> None:
    values = calls(scene, given)[name]
    written(name, tmp_path / "points", values).close()
    request.getfixturevalue("commas")
    written(name, tmp_path / "commas", values).close()
    expected = numbers(tmp_path / "points")
    assert any(map(len, expected.values()))
    assert numbers(tmp_path / "commas") == expected
