"""What the report shows of a seam: its profile as a chart, and lost detail beside the clips."""
from __future__ import annotations

import math
import re
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
from qgis.PyQt.QtCore import QRectF
from scipy.ndimage import gaussian_filter
from seam_inspector.plugin.imagery.open_raster import describe, describe_mosaic
from seam_inspector.plugin.imagery.rasters import RasterRef
from seam_inspector.plugin.seams.charts.profile_painter import ProfilePainter, ShownProfile, level_colour, shown_profile
from seam_inspector.plugin.seams.measure.profile.window_detail import LossPicture
from seam_inspector.plugin.seams.measure.window.inspection import Block, Source
from seam_inspector.plugin.seams.measure.window_records import ProfileRecord, WindowRecord
from seam_inspector.plugin.seams.report.flagged_windows import PROFILE_PX, ProfilePicture, profile_picture
from seam_inspector.plugin.seams.report.inspection_report import write_report
from seam_inspector.plugin.seams.report.report_request import ReportRequest
from seam_inspector.plugin.toolkit.charts.chart_painter import paper_font
from seam_inspector.plugin.toolkit.charts.chart_style import PAPER

from tests.numbers.synthetic import texture, write_raster
from tests.pages import Outline, outline
from tests.qgis.runs import assert_refused, run
from tests.qgis.scenes import layer, windows

PIXEL = 0.1
MIDDLES = (1, 3, 5, 7, 10, 14, 20, 28, 40, 256)  # of the bins, px; the last one has no end
MIXTURES = (0.5, 0.45, 0.4, 0.3, 0.2, 0.1, 0.05, 0.0, 0.0, None)
FEATHERED = WindowRecord(1, (0, 0, 50, 50), "significant", kept=(0.5, 0.7), kept_low=0.4, kept_high=0.6, band_width=2.0)


def rows(level: int = 1, pixel: float = PIXEL) -> list[ProfileRecord]:
    """A strip in which half is kept, then all."""
    return [
        ProfileRecord(level, pixel * middle, 0.5 if middle < 8 else 1.0, 0.4, 1.1, mixture)
        for middle, mixture in zip(MIDDLES, MIXTURES)
    ]


# --- the chart -------------------------------------------------------------------------------------------------


def painter(shown: ShownProfile | None) -> ProfilePainter:
    """The chart in the report's size."""
    assert shown is not None
    return ProfilePainter(shown, QRectF(0, 0, *PROFILE_PX), PAPER, paper_font(11))


def lines(picture: ProfilePicture, colour: str) -> list[list[tuple[float, float]]]:
    """The points of the lines of a colour."""
    items = re.findall(f'<g [^>]*stroke="{colour}"[^>]*><polyline [^>]*points="([^"]*)"', picture.svg)
    return [[(float(x), float(y)) for x, y in (point.split(",") for point in line.split())] for line in items]


@pytest.mark.parametrize("known", [PIXEL, None])
def test_the_chart_shows_what_the_table_says(qgis_app: object, known: float | None) -> None:
    table = FEATHERED, [*rows(), *rows(2)], known, 0.7
    picture, chart = profile_picture(shown_profile(*table)), painter(shown_profile(*table))
    assert picture is not None
    assert [words for _, words in picture.legend] == ["level 1", "level 2"]
    (places,) = lines(picture, picture.legend[0][0])
    assert len(places) == 2 * len(MIDDLES)
    assert places[0][0] == pytest.approx(chart.axes.left())
    assert places[-1][0] == pytest.approx(chart.axes.right(), abs=0.1)
    assert sorted({y for _, y in places}) == pytest.approx([chart.y_of(1), chart.y_of(0.5)], abs=0.1)
    edge = next(x for x, y in places if y == places[-1][1])  # where all is kept again: 8 px from the seam
    ticks = {words: x for x, words in chart.distance_ticks()}
    assert next(x for words, x in ticks.items() if float(words) >= 1) > edge > ticks["0"]
    assert edge == pytest.approx(chart.axes.left() + chart.axes.width() * math.sqrt(8 / 400), abs=0.2)
    for words in ("100 %", "50 %", "limit 70 %", "share of the other image", "distance from the seam (m)", *ticks):
        assert f">{words}</text>" in picture.svg
    (limit,) = lines(picture, PAPER.limit)
    assert limit[0][1] == pytest.approx(chart.axes.bottom() - (chart.axes.bottom() - chart.y_of(1)) * 0.7, abs=0.1)
    assert picture.svg.count("<rect") == 1 + len(MIDDLES)  # the paper and the intervals


# --- lost detail -----------------------------------------------------------------------------------------------


def blended_block(folder: Path) -> Block:
    """A mosaic whose left and right half meet in a feather of some 30 px in its middle."""
    left = np.clip(120 + 40 * texture((512, 512), 1.0), 0, 255)
    right = left[::-1, ::-1]  # two textures that have nothing in common
    share = gaussian_filter(np.repeat(np.arange(512)[np.newaxis] < 256, 512, axis=0).astype(float), 8)
    bands = {"mosaic": left * share + right * (1 - share), "left": left, "right": right}
    paths = {name: write_raster(folder / f"{name}.tif", np.rint(band[np.newaxis]).astype(np.uint8), gsd=PIXEL)
             for name, band in bands.items()}  # fmt: skip
    refs = [RasterRef(paths[name]) for name in ("left", "right")]
    return Block(describe_mosaic(RasterRef(paths["mosaic"])), tuple(Source(ref, describe(ref).extent) for ref in refs))


def page_of(path: Path, request: ReportRequest) -> Outline:
    assert write_report(path, request) == []
    return outline(path.read_text(encoding="utf-8"))


def test_the_clips_show_where_most_was_lost(qgis_app: object, tmp_path: Path) -> None:
    block = blended_block(tmp_path)
    record = WindowRecord(1, block.mosaic.extent, "significant", reference="seam")
    page = page_of(tmp_path / "report.html", ReportRequest((record,), block=block, wkt=block.mosaic.wkt))
    assert "lost detail over the mosaic; in the frame the clips" in page.captions
    match = re.search(r"clips of \d+ px a side around x ([\d.]+),", page.words)
    assert match is not None
    middle = (block.mosaic.extent[0] + block.mosaic.extent[2]) / 2
    assert float(match[1]) == pytest.approx(middle, abs=80 * PIXEL)
    picture = LossPicture(np.full((64, 64), 0.4, np.float32))
    known = SimpleNamespace(loss=picture, explanation=None, profile=None, longer_side_m=9, ground_sample_distance=PIXEL)
    given = ReportRequest((record,), block=block, wkt=block.mosaic.wkt, results={1: known})
    assert "lost detail over the mosaic; in the frame the clips" in page_of(tmp_path / "given.html", given).captions


# --- the algorithm ---------------------------------------------------------------------------------------------


def test_the_table_of_profiles_is_drawn(provider: Any, tmp_path: Path) -> None:
    block, path = blended_block(tmp_path), tmp_path / "report.html"
    inspected = run(
        "inspectwindows", WINDOWS=windows((0, 0, 512, 512)), MOSAIC=block.mosaic.ref.path,
        SOURCES=[source.ref.path for source in block.sources],
    )
    assert inspected.column("verdict") == ["significant"]
    given = {"WINDOWS": inspected.layer(), "PROFILES": inspected.layer("PROFILES"), "OUTPUT": str(path)}
    for parameters in ({}, {"MOSAIC": block.mosaic.ref.path, "MIN_KEPT": 0.65}):
        assert run("report", **given, **parameters).complaint is None
        page = path.read_text(encoding="utf-8")
        outline(page)
        charts = re.findall("<svg .*?</svg>", page, flags=re.DOTALL)
        (chart,) = (chart for chart in charts if "distance from the seam (m)" in chart)
        colours = [level_colour(level, PAPER) for level in (1, 2, 3)]
        for colour in (*colours, PAPER.quiet):  # three levels and the mixture
            assert f'stroke="{colour}"' in chart
        assert f"limit {65 if parameters else 70} %" in page
    other = layer("None", [None], window_id=("integer", [1]))
    assert_refused("report", "no field 'level'", **{**given, "PROFILES": other})
