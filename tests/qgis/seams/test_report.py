"""The report as QGIS writes it: one page that needs nothing else, and what stands in it."""
from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from osgeo import gdal

from tests.pages import Outline, outline
from tests.qgis.runs import Log, Run, run
from tests.qgis.scenes import BLURRED, SHARP, Scene, windows

PART = re.compile(r"clips of (\d+) px a side around x ([\d.]+), y ([\d.]+), at 2x")


@pytest.fixture(scope="module")
def inspected(provider: Any, scene: Scene) -> Iterator[Run]:
    """A sound window, a blurred one, one that is half blurred, and one that is too small."""
    words = ["", "visible", "visible", ""]
    drawn = windows(SHARP, BLURRED, (192, 0, 128, 128), (0, 0, 9, 9), observer=("string", words))
    made = run("inspectwindows", WINDOWS=drawn, MOSAIC=str(scene.mosaic), SOURCES=scene.sources)
    yield made
    made.close()


def report(inspected: Run, path: Path, log: Log | None = None, **parameters: Any) -> Run:
    given = {"WINDOWS": inspected.layer(), "CURVES": inspected.layer("CURVES"), "PAIRS": inspected.layer("PAIRS")}
    return run("report", log, **{**given, "OUTPUT": str(path), **parameters})


def read(outcome: Run) -> Outline:
    assert outcome.complaint is None
    return outline(Path(outcome.results["OUTPUT"]).read_text(encoding="utf-8"))


def decoded(jpeg: bytes) -> np.ndarray:
    """(rows, columns, 3) of a JPEG file, by GDAL."""
    gdal.FileFromMemBuffer("/vsimem/part.jpg", jpeg)
    pixels = np.moveaxis(np.atleast_3d(gdal.Open("/vsimem/part.jpg").ReadAsArray()), 0, 2)
    gdal.Unlink("/vsimem/part.jpg")
    return pixels


def test_all_that_was_found_stands_in_the_page(inspected: Run, scene: Scene, tmp_path: Path) -> None:
    page = read(report(inspected, tmp_path / "report.html", MOSAIC=str(scene.mosaic), SOURCES=scene.sources))
    assert page.words.count("Seam inspection: mosaic.tif") == 2
    verdicts = inspected.column("verdict")
    counts = [verdicts.count(word) for word in ("significant", "reduced", "preserved", "not_comparable")]
    assert ["mosaic.tif", "4", *map(str, counts), "2", "0"] in [row[:8] for row in page.rows]
    assert "Windows: 4, flagged: 2" in page.words
    assert page.anchors == ["window-2", "window-3"]  # significant, and reduced but seen
    assert set(page.links) == {"#window-2", "#window-3"}
    assert "needs at least 64 px" in page.words  # why the fourth is not comparable
    shares: dict[tuple[int, str], list[str]] = {}
    for row in inspected.rows("CURVES"):
        if row["band"] == "luminance":
            shares.setdefault((row["window_id"], row["raster"]), []).append(f"{row['relative_variance']:.3f}")
    rows = [row[-5:] for row in page.rows]
    assert len(shares) == 12  # of three windows: the mosaic, two sources, their composite
    for (_, name), values in shares.items():
        assert ["hard-cut composite" if name == "composite" else name, *values] in rows
    blurred = inspected.rows()[1]
    assert f"{100 * blurred['sharpness_1']:.0f} % of the sharpness of its sources" in page.words
    assert f"By the paper's rule: {blurred['paper_verdict']}, ratio 1: {blurred['ratio_1']:.2f}." in page.words
    assert "Observer: visible." in page.words
    assert len(page.pictures("svg+xml")) == 2
    assert page.captions.count("mosaic.tif (mosaic)") == 2
    assert page.captions.count("west.tif") == page.captions.count("east.tif") == 2


def test_the_clips_are_the_rasters_pixels(inspected: Run, scene: Scene, tmp_path: Path) -> None:
    page = read(report(inspected, tmp_path / "report.html", MOSAIC=str(scene.mosaic), SOURCES=scene.sources))
    pictures = page.pictures("jpeg")[1:]  # the first is the map
    places = PART.findall(page.words)
    assert len(places) == 2
    assert len(pictures) == 8  # of either window where it lost detail, and three clips
    dataset = gdal.Open(str(scene.mosaic))
    left, width, _, top, _, height = dataset.GetGeoTransform()
    for (side, x, y), jpeg in zip(places, pictures[1::4]):
        column = round((float(x) - left) / width - int(side) / 2)
        row = round((float(y) - top) / height - int(side) / 2)
        clip = np.moveaxis(dataset.ReadAsArray(column, row, int(side), int(side)), 0, 2).astype(float)
        shown = decoded(jpeg).astype(float)
        assert shown.shape == clip.shape
        assert np.corrcoef(clip.ravel(), shown.ravel())[0, 1] > 0.97  # stretched, and through JPEG
    assert int(places[0][0]) == 128  # all of a window that is smaller than a part


def test_without_tables_and_rasters_there_are_the_windows(inspected: Run, tmp_path: Path) -> None:
    page = read(run("report", WINDOWS=inspected.layer(), OUTPUT=str(tmp_path / "report.html")))
    assert len(page.addresses) == 1  # the map
    assert page.anchors == ["window-2", "window-3"]
    for row in inspected.rows():
        if row["ratio_1"] is not None:
            assert [f"{row[name]:.2f}" for name in ("ratio_1", "ratio_2", "ratio_3", "background_ratio")] in [
                cells[-4:] for cells in page.rows
            ]


def test_a_source_that_can_not_be_read_leaves_the_others(inspected: Run, scene: Scene, tmp_path: Path) -> None:
    given = [str(tmp_path / "gone.tif"), *scene.sources]
    outcome = report(inspected, tmp_path / "report.html", MOSAIC=str(scene.mosaic), SOURCES=given)
    assert any("gone.tif" in warning for warning in outcome.log.warnings)
    assert read(outcome).captions.count("east.tif") == 2


class _Impatient(Log):
    def isCanceled(self) -> bool:
        return True


def test_cancelled_it_leaves_the_older_report(inspected: Run, tmp_path: Path) -> None:
    path = tmp_path / "report.html"
    path.write_text("older", encoding="utf-8")
    outcome = report(inspected, path, _Impatient())
    assert "OUTPUT" not in outcome.results
    assert [file.name for file in tmp_path.iterdir()] == ["report.html"]
    assert path.read_text(encoding="utf-8") == "older"


# --- many windows ----------------------------------------------------------------------------------------------


def test_of_more_windows_the_worst_are_shown(inspected: Run, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("seam_inspector.plugin.seams.report.inspection_report.MAX_REPORT_DETAILS", 1)
    outcome = report(inspected, tmp_path / "report.html")
    assert read(outcome).anchors == ["window-2"]
    assert "2 windows are flagged" in " ".join(outcome.log.warnings + outcome.log.infos)
