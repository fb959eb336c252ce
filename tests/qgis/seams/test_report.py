"""The report as QGIS writes it: one page that needs nothing else, and what stands in it."""
from __future__ import annotations

import re
import shutil
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from osgeo import gdal
from qgis.core import QgsVectorLayer
from seam_inspector.plugin.imagery.grids import PixelWindow
from seam_inspector.plugin.imagery.open_raster import describe, describe_mosaic
from seam_inspector.plugin.imagery.rasters import RasterRef
from seam_inspector.plugin.seams.measure.source_images import Source
from seam_inspector.plugin.seams.measure.window.inspection import Block
from seam_inspector.plugin.seams.measure.window_records import CurveRecord, PairRecord, WindowRecord
from seam_inspector.plugin.seams.report import flagged_windows, inspection_report
from seam_inspector.plugin.seams.report.inspection_report import write_report
from seam_inspector.plugin.seams.report.report_request import ReportRequest

from tests.numbers.synthetic import write_raster
from tests.pages import Outline, outline
from tests.qgis.runs import Log, Run, assert_refused, run
from tests.qgis.scenes import BLURRED, SHARP, Scene, layer, windows

EVIL = "<b>Łódź & \"co\" 'x'</b>"
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


def test_it_needs_no_network(inspected: Run, scene: Scene, tmp_path: Path) -> None:
    path = tmp_path / "report.html"
    page = read(report(inspected, path, MOSAIC=str(scene.mosaic), SOURCES=scene.sources))
    assert all(address.startswith("data:image/") for address in page.addresses)
    names = re.findall(r"(?:src|href|url|@import)\W{1,3}https?:", path.read_text(encoding="utf-8"))
    assert names == []
    for svg in page.pictures("svg+xml"):
        assert not re.findall(rb"(?:href|src)=.http", svg)
    assert "script" not in path.read_text(encoding="utf-8").lower()


def test_the_clips_are_the_rasters_pixels(inspected: Run, scene: Scene, tmp_path: Path) -> None:
    page = read(report(inspected, tmp_path / "report.html", MOSAIC=str(scene.mosaic), SOURCES=scene.sources))
    pictures = page.pictures("jpeg")[1:]  # the first lies below the sketch
    places = PART.findall(page.words)
    assert len(places) == 2
    assert len(pictures) == 8  # of either window where it lost detail, and three clips
    dataset = gdal.Open(str(scene.mosaic))
    left, width, _, top, _, height = dataset.GetGeoTransform()
    for (side, x, y), jpeg in zip(places, pictures[1::4]):
        column = round((float(x) - left) / width - int(side) / 2)
        row = round((float(y) - top) / height - int(side) / 2)
        own = np.moveaxis(dataset.ReadAsArray(column, row, int(side), int(side)), 0, 2).astype(float)
        shown = decoded(jpeg).astype(float)
        assert shown.shape == own.shape
        assert np.corrcoef(own.ravel(), shown.ravel())[0, 1] > 0.97  # stretched, and through JPEG
    assert int(places[0][0]) == 128  # all of a window that is smaller than a part


def test_names_are_never_markup(scene: Scene, inspected: Run, tmp_path: Path) -> None:
    name = tmp_path / "a&b <i>'.tif"
    shutil.copy(scene.mosaic, name)
    drawn = windows(BLURRED, observer=("string", ["visible"]))
    found = run("inspectwindows", WINDOWS=drawn, MOSAIC=str(name), SOURCES=scene.sources)
    outcome = report(found, tmp_path / "report.html", MOSAIC=str(name), SOURCES=scene.sources, TITLE=EVIL)
    page = read(outcome)
    assert page.words.count(EVIL) == 2
    assert page.words.count(name.name) >= 4
    text = Path(outcome.results["OUTPUT"]).read_text(encoding="utf-8")
    assert "<i>" not in text
    assert EVIL not in text


def test_without_tables_and_rasters_there_are_the_windows(inspected: Run, tmp_path: Path) -> None:
    page = read(run("report", WINDOWS=inspected.layer(), OUTPUT=str(tmp_path / "report.html")))
    assert page.addresses == []
    assert page.anchors == ["window-2", "window-3"]
    for row in inspected.rows():
        if row["ratio_1"] is not None:
            assert [f"{row[name]:.2f}" for name in ("ratio_1", "ratio_2", "ratio_3", "background_ratio")] in [
                cells[-4:] for cells in page.rows
            ]


def test_what_later_tables_hold_is_told(inspected: Run, tmp_path: Path) -> None:
    source = inspected.layer()
    more = layer(
        "Polygon",
        [one.geometry() for one in source.getFeatures()][:3],
        window_id=("integer", [1, 2, 3]),
        verdict=("string", ["preserved", "significant", "reduced"]),
        ratio_1=("double", [1.1, 0.4, 0.8]),
        composite_ratio_1=("double", [0.99, 0.38, 0.77]),
        expected_ratio_1=("double", [0.66, 0.55, 0.44]),
        unclear_share=("double", [0.01, 0.25, 0.5]),
        cause=("string", ["none", "blur", "colour shift"]),
        observer=("string", ["", "invisible", "visible"]),
    )
    pairs = layer(
        "None", [None] * 2, window_id=("integer", [2, 2]), source=("string", ["west.tif", "composite"]),
        band=("string", ["luminance"] * 2), ratio_1=("double", [0.4, 0.38]), contrast_1=("double", [0.9, 0.31]),
    )
    rows = [
        (2, "mosaic.tif", "mosaic", [0.02, 0.08, 0.9]), (2, "west.tif", "source", [0.05, 0.1, 0.85]),
        (2, "", "composite", [0.04, 0.09, 0.87]), (3, "other.tif", "mosaic", [0.1, 0.2, 0.7]),
    ]
    places = [("detail", 1), ("detail", 2), ("background", 2)]
    columns = list(zip(*(
        (number, name, role, "luminance", *place, share)
        for number, name, role, shares in rows for place, share in zip(places, shares)
    )))
    fields = ("window_id", "raster", "role", "band", "component", "level", "relative_variance")
    kinds = ("integer", "string", "string", "string", "string", "integer", "double")
    curves = layer("None", [None] * len(columns[0]), **{
        name: (kind, list(values)) for name, kind, values in zip(fields, kinds, columns)
    })
    page = read(run("report", WINDOWS=more, PAIRS=pairs, CURVES=curves, OUTPUT=str(tmp_path / "report.html")))
    assert "Significant loss. Detail at level 1 is 40 % of the sources'; the mosaic is blurred." in page.words
    assert "Absolute contrast at level 1: 31 %." in page.words
    assert "no source wins clearly: 25 %" in page.words
    assert ["against the hard-cut composite", "0.38"] in page.rows
    assert ["expected of a 50:50 feather", "0.55"] in page.rows
    assert ["hard-cut composite", "0.040", "0.090", "0.870"] in [row[-4:] for row in page.rows]
    assert [row[0] for row in page.rows if len(row) == 11] == ["made", "mosaic.tif", "other.tif"]  # by mosaic
    assert len(page.pictures("svg+xml")) == 2
    meaning = "The channels were corrected one by one, so the colours shifted."
    found = [row for row in page.rows if "colour shift" in row]
    assert found == [["other.tif", "colour shift", "1", "1", "1", meaning]]


def test_a_window_judged_by_its_seam_is_told_by_its_seam(qgis_app: object, tmp_path: Path) -> None:
    feathered = WindowRecord(
        1, (0, 0, 50, 50), "significant", ratios=(1.35, 1.1), kept=(0.56, 0.81), kept_low=0.51, kept_high=0.62,
        band_width=2.0, sharpness=0.99, cause="feathering", causes="feathering; compressed", reference="seam",
        paper_verdict="preserved", explained=0.83, visibility=1.42, loss=44.0,
    )  # fmt: skip
    worse = WindowRecord(
        2, (50, 0, 100, 50), "significant", ratios=(1.5, 1.2), kept=(0.3, 0.5), kept_low=0.2, kept_high=0.4,
        sharpness=1.0, cause="feathering", causes="feathering", reference="seam", paper_verdict="preserved",
        loss=70.0,
    )  # fmt: skip
    by_paper = WindowRecord(3, (0, 50, 50, 100), "significant", ratios=(0.45, 0.6), reference="sources")
    write_report(tmp_path / "report.html", ReportRequest((feathered, worse, by_paper)))
    page = outline((tmp_path / "report.html").read_text(encoding="utf-8"))
    assert page.anchors == ["window-2", "window-1", "window-3"]  # the greatest loss first
    assert "44 % of detail lost in 2.0 m along the seam (44 m²): feathered." in page.words
    assert "between 38 and 49 % (95 % interval). It is 1.4 times what an eye just sees at 2x." in page.words
    assert "just noticeable differences of contrast" in page.words
    assert "The window is as sharp as its sources. " in page.words
    assert "are feathered over 2.0 m; the mosaic was compressed with loss." in page.words
    assert "17 % of the pixels match none of the given sources" in page.words
    assert "By the paper's rule it is preserved, with 135 % of the detail" in page.words
    assert "By the paper's rule: preserved" not in page.words  # said once is enough
    assert ["kept along the seam (level 1: 0.51 to 0.62)", "0.56", "0.81"] in page.rows
    (found,) = (row for row in page.rows if row[0] == "1" and len(row) > 4)
    for words in (
        "significant, loss: 44 m², kept 1: 0.56 (0.51 to 0.62)", "by the paper's rule: preserved, ratio 1: 1.35",
        "cause: feathering, compressed; visibility at 2x (JND): 1.4",
    ):  # fmt: skip
        assert words in found[1]
    assert ["feathering", "2", "2", "2"] in [row[:4] for row in page.rows]
    assert ["compressed", "0", "1", "1"] in [row[:4] for row in page.rows]


def test_a_source_that_can_not_be_read_leaves_the_others(inspected: Run, scene: Scene, tmp_path: Path) -> None:
    given = [str(tmp_path / "gone.tif"), *scene.sources]
    outcome = report(inspected, tmp_path / "report.html", MOSAIC=str(scene.mosaic), SOURCES=given)
    assert any("gone.tif" in warning for warning in outcome.log.warnings)
    assert read(outcome).captions.count("east.tif") == 2


def test_a_mosaic_that_is_elsewhere_is_told_by_window(inspected: Run, tmp_path: Path) -> None:
    other = write_raster(tmp_path / "other.tif", np.full((3, 100, 100), 9, np.uint8), origin=(0.0, 0.0))
    outcome = report(inspected, tmp_path / "report.html", MOSAIC=other)
    assert any("Window 2: The window lies outside the mosaic" in warning for warning in outcome.log.warnings)
    assert len(read(outcome).pictures("svg+xml")) == 2


class _Impatient(Log):
    def isCanceled(self) -> bool:
        return True


def test_cancelled_it_leaves_the_older_report(inspected: Run, tmp_path: Path) -> None:
    path = tmp_path / "report.html"
    path.write_text("older", encoding="utf-8")
    outcome = report(inspected, path, _Impatient())
    assert "OUTPUT" not in outcome.results
    assert [one.name for one in tmp_path.iterdir()] == ["report.html"]
    assert path.read_text(encoding="utf-8") == "older"


def test_bad_input_is_told(inspected: Run, tmp_path: Path) -> None:
    good = {"WINDOWS": inspected.layer(), "OUTPUT": str(tmp_path / "report.html")}
    bare = windows(SHARP, window_id=("integer", [1]))
    for words, parameters in {
        "window layer has no field 'ratio_1'": {**good, "WINDOWS": bare},
        "window layer is empty": {**good, "WINDOWS": QgsVectorLayer("Polygon?field=ratio_1:double", "x", "memory")},
        "table CURVES has no field": {**good, "CURVES": bare},
        "table PAIRS has no field": {**good, "PAIRS": bare},
        "does not exist": {**good, "MOSAIC": str(tmp_path / "gone.tif")},
        "can't be written": {**good, "OUTPUT": str(tmp_path / "none" / "report.html")},
    }.items():
        assert_refused("report", words, **parameters)
    assert not (tmp_path / "report.html").exists()


def test_no_flagged_window_is_good_news(provider: Any, scene: Scene, tmp_path: Path) -> None:
    found = run("inspectwindows", WINDOWS=windows(SHARP), MOSAIC=str(scene.mosaic), SOURCES=scene.sources)
    page = read(report(found, tmp_path / "report.html", MOSAIC=str(scene.mosaic)))
    assert "None: no window has a significant loss" in page.words
    assert page.anchors == []


# --- many windows ----------------------------------------------------------------------------------------------


def noisy_block(folder: Path, side: int) -> Block:
    """A mosaic and two sources of noise: JPEG can't make them small."""
    random = np.random.default_rng(3)
    paths = []
    for name in ("mosaic.tif", "a.tif", "b.tif"):
        paths.append(write_raster(folder / name, random.integers(0, 256, (3, side, side)).astype(np.uint8), options=()))
    refs = [RasterRef(path) for path in paths]
    return Block(describe_mosaic(refs[0]), tuple(Source(ref, describe(ref).extent) for ref in refs[1:]))


def many(block: Block, count: int) -> ReportRequest:
    """Flagged windows, 256 px a side, all over the mosaic."""
    random = np.random.default_rng(4)
    records, curves, pairs = [], {}, {}
    for number in range(1, count + 1):
        column, row = random.integers(0, block.mosaic.grid.columns - 256, 2).tolist()
        extent = block.mosaic.grid.window_extent(PixelWindow(column, row, 256, 256))
        records.append(WindowRecord(number, extent, "significant", ratios=(0.3 + number / 1000, 0.5, 0.7)))
        shares = random.uniform(0.01, 0.2, (3, 3))
        roles = (("mosaic.tif", "mosaic"), ("a.tif", "source"), ("b.tif", "source"))
        curves[number] = [
            CurveRecord(name, role, tuple(detail.tolist()), float(1 - detail.sum()))
            for (name, role), detail in zip(roles, shares)
        ]
        pairs[number] = [PairRecord(name, "luminance", 0.3, 0.5) for name in ("a.tif", "b.tif")]
    return ReportRequest(tuple(records), curves, pairs, block, block.mosaic.wkt, "300")


def test_300_windows_stay_below_30_megabytes(qgis_app: Any, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """A tenth of them is made, with a tenth of the bytes for their pictures. The sketch's background is there once."""
    assert inspection_report.MAX_REPORT_DETAILS == 300
    monkeypatch.setattr(flagged_windows, "REPORT_CLIPS_BYTES", flagged_windows.REPORT_CLIPS_BYTES / 10)
    request = many(noisy_block(tmp_path, 1024), 30)
    path = tmp_path / "report.html"
    told: list[float] = []
    with ThreadPoolExecutor(1) as worker:  # as the desk does it
        assert worker.submit(write_report, path, request, told.append).result() == []
    assert told == sorted(told)
    assert told[-1] == 1
    page = outline(path.read_text(encoding="utf-8"))
    assert len(page.anchors) == 30
    assert len(page.pictures("svg+xml")) == 30
    assert len(page.pictures("jpeg")) == 1 + 3 * 30
    assert decoded(page.pictures("jpeg")[1]).shape[0] >= 64
    background = len(page.pictures("jpeg")[0]) * 4 / 3  # as base64
    assert background + 10 * (path.stat().st_size - background) < 30e6


def test_each_window_is_on_disk_before_the_next_but_one_is_made(qgis_app: Any, tmp_path: Path) -> None:
    """So memory does not grow with their number. Python keeps back 128 KiB from 3.14 on, not all of two windows."""
    sizes: list[int] = []

    def told(share: float) -> None:
        (unfinished,) = tmp_path.rglob(".unfinished-*/report.html")
        sizes.append(unfinished.stat().st_size)

    request = many(noisy_block(tmp_path, 512), 6)
    assert write_report(tmp_path / "report.html", request, told) == []
    assert len(sizes) == 6
    assert np.subtract(sizes[2:], sizes[:-2]).min() > 10_000


def test_of_more_windows_the_worst_are_shown(qgis_app: Any, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("seam_inspector.plugin.seams.report.inspection_report.MAX_REPORT_DETAILS", 5)
    request = many(noisy_block(tmp_path, 512), 9)
    (notice,) = write_report(tmp_path / "report.html", request) or []
    assert "9 windows are flagged" in str(notice)
    page = outline((tmp_path / "report.html").read_text(encoding="utf-8"))
    assert page.anchors == [f"window-{number}" for number in range(1, 6)]
    assert str(notice) in page.words


def test_what_a_window_is_found_to_have_matches_its_verdict(tmp_path: Path) -> None:
    """A cause is one of a loss; where nothing was lost it is what was found, and nothing found is not listed."""
    lost = WindowRecord(
        1, (0, 0, 50, 50), "significant", ratios=(0.4,), cause="blur", causes="blur", reference="sources"
    )
    kept = WindowRecord(
        2, (50, 0, 100, 50), "preserved", ratios=(1.2,), cause="feathering", causes="feathering", reference="sources",
        observer="visible",
    )  # fmt: skip
    sound = WindowRecord(
        3, (0, 50, 50, 100), "preserved", ratios=(1.1,), cause="none", causes="none", observer="unsure"
    )
    write_report(tmp_path / "report.html", ReportRequest((lost, kept, sound)))
    page = outline((tmp_path / "report.html").read_text(encoding="utf-8"))
    assert page.words.count("Main cause in the whole window:") == 1
    assert "Main cause in the whole window: blur." in page.words
    assert "Found: feathering." in page.words
    found = {row[0]: row[1] for row in page.rows if row[0] in ("1", "2", "3") and len(row) == 4}
    assert "cause: blur" in found["1"]
    assert "found: feathering; observer: visible" in found["2"]
    assert "none" not in found["3"]
    assert "observer: not sure" in found["3"]
    assert not [row for row in page.rows if "none" in row]
    counts = next(row for row in page.rows if row[:2] == ["", "3"])
    assert counts[-5:-2] == ["1", "0", "1"]  # visible, invisible, not sure


def test_the_words_that_stand_in_a_report_are_explained(inspected: Run, scene: Scene, tmp_path: Path) -> None:
    rasters = {"MOSAIC": str(scene.mosaic), "SOURCES": scene.sources}
    page = read(report(inspected, tmp_path / "report.html", **rasters, MIN_KEPT=0.6))
    terms = dict(row for row in page.rows if len(row) == 2)
    assert terms["verdict"].startswith("Significant: by the best estimate 60 % or less of the finest detail is kept")
    for word in ("flagged", "kept 1", "sharpness 1", "ratio 1", "relative variance", "hard-cut composite", "clips"):
        assert word in page.words
        assert terms[word]
    assert "seam profile" not in terms  # without their table there is none
    bare = read(run("report", WINDOWS=inspected.layer(), OUTPUT=str(tmp_path / "bare.html")))
    assert not {"clips", "lost detail", "hard-cut composite"} & {row[0] for row in bare.rows}


@pytest.mark.usefixtures("provider")
def test_numbers_that_no_measurement_gives_are_left_out_and_told(tmp_path: Path) -> None:
    drawn = windows(
        SHARP, BLURRED, window_id=("integer", [1, 2]), verdict=("string", ["significant", "preserved"]),
        reference=("string", ["seam"] * 2), ratio_1=("double", [-3.5, 0.5]), kept_1=("double", [0.41, 1e308]),
        kept_2=("double", [0.5, -3.5]), contrast_1=("double", [1e308, float("inf")]),
    )  # fmt: skip
    outcome = run("report", WINDOWS=drawn, OUTPUT=str(tmp_path / "report.html"))
    page = read(outcome)
    for field in ("ratio_1", "kept_1", "kept_2", "contrast_1"):
        assert f"{field} of 1 windows is a number that no measurement gives; it is left out." in outcome.log.warnings
    assert "0.41" in page.words or "41 %" in page.words
    assert "0000000" not in page.words
