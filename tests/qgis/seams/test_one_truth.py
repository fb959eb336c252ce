"""Sentence, table, label, chart, picture and report of a window say one number, whatever was done to the mosaic."""
from __future__ import annotations

import re
import textwrap
from collections.abc import Callable
from dataclasses import replace

import numpy as np
import pytest
from qgis.core import QgsApplication
from scipy import ndimage
from seam_inspector.plugin.imagery.grids import PixelWindow
from seam_inspector.plugin.imagery.open_raster import describe_mosaic
from seam_inspector.plugin.imagery.rasters import RasterRef
from seam_inspector.plugin.seams.charts.profile_painter import ShownProfile, summary_words
from seam_inspector.plugin.seams.desk.windows.window_columns import COLUMNS
from seam_inspector.plugin.seams.measure.limits import MIN_MISREGISTRATION_PX
from seam_inspector.plugin.seams.measure.profile.seam_profile import Measure
from seam_inspector.plugin.seams.measure.window.window_result import WindowResult
from seam_inspector.plugin.seams.measure.window_records import WindowRecord
from seam_inspector.plugin.seams.report.flagged_windows import window_rows
from seam_inspector.plugin.seams.tables import window_layer
from seam_inspector.plugin.seams.window_summary import (
    judged_kept,
    loss_place,
    shown_area,
    window_sentence,
    window_why,
)
from seam_inspector.plugin.seams.words import LOSSES, loss_rgba, verdict_sentence
from seam_inspector.plugin.toolkit.translation import percent

from demo.block import make_block
from tests.numbers.seams.inspecting import block_of, inspect
from tests.numbers.seams.made_seams import SIDE, as_bytes, blended, inspected, three_images
from tests.numbers.synthetic import write_raster
from tests.qgis.scenes import windows
from tests.qgis.seams.written_results import write_results

Image = np.ndarray
BLOCK_SIDE = 320
LINE = 66  # letters, of a dock that breaks lines between words


def _sharpened(image: Image) -> Image:
    soft = ndimage.gaussian_filter(image.astype(float), (0, 1.0, 1.0))
    return as_bytes(image + 1.0 * (image - soft))


def _dodged(image: Image) -> Image:
    return as_bytes(image * np.linspace(0.7, 1.1, SIDE)[None, :, None])


MADE: dict[str, Callable[[list[Image]], Image]] = {
    "hard cut": lambda images: blended(images),
    "hard cut, dodged": lambda images: _dodged(blended(images)),
    "hard cut, blurred": lambda images: as_bytes(ndimage.gaussian_filter(blended(images).astype(float), (0, 0.6, 0.6))),
    "blurred badly": lambda images: as_bytes(ndimage.gaussian_filter(blended(images, 40).astype(float), (0, 1.5, 1.5))),
    "feathered": lambda images: blended(images, 40),
    "feathered, dodged": lambda images: _dodged(blended(images, 40)),
    "feathered, sharpened": lambda images: _sharpened(blended(images, 40)),
    "feathered, half a pixel off": lambda images: as_bytes(
        ndimage.shift(blended(images, 40).astype(float), (0, 0.5, 0.5), order=1, mode="nearest")),
    "averaged": lambda images: as_bytes((images[0].astype(float) + images[1]) / 2),
    "feathered over all of it": lambda images: blended(images, SIDE),
}


@pytest.fixture(scope="module")
def results(tmp_path_factory: pytest.TempPathFactory) -> dict[str, WindowResult]:
    """Results by what was done; those of a generated block, which tells of everything, by their places."""
    images, outcome = three_images(), {}
    for name, make in MADE.items():
        folder = tmp_path_factory.mktemp("made")
        outcome[name] = inspected(lambda file, *image, at=folder, **how: write_raster(at / file, *image, **how),
                                make(images), images[:2])
    made = make_block(tmp_path_factory.mktemp("block"), extent_m=(120.0, 100.0))
    block = block_of(describe_mosaic(RasterRef(str(made.mosaic))), *map(str, made.sources))
    grid = block.mosaic.grid
    for column in range(0, grid.columns - BLOCK_SIDE + 1, BLOCK_SIDE):
        for row in range(0, grid.rows - BLOCK_SIDE + 1, BLOCK_SIDE):
            outcome[f"block at {column}, {row}"] = inspect(block, PixelWindow(column, row, BLOCK_SIDE, BLOCK_SIDE))
    return {name: replace(result, window_id=number) for number, (name, result) in enumerate(outcome.items(), 1)}


@pytest.fixture(scope="module")
def rows(qgis_app: QgsApplication, results: dict[str, WindowResult]) -> dict[str, WindowRecord]:
    """Results as a window layer holds them."""
    layer = windows(*[(0, 0, 64, 64)] * len(results))
    write_results(layer, dict(zip(sorted(layer.allFeatureIds()), results.values())))
    read = {row.window_id: row for row in window_layer.read_layer(layer)}
    return {name: read[result.window_id] for name, result in results.items()}


def all_said(row: WindowRecord, result: WindowResult | None) -> str:
    return " ".join([window_sentence(row, result), *window_why(row, result)])


def test_what_is_made_and_what_is_said_differ(rows: dict[str, WindowRecord]) -> None:
    """Each kind of verdict and of place is among them."""
    verdicts = {name: row.verdict for name, row in rows.items()}
    assert verdicts["hard cut"] == verdicts["hard cut, dodged"] == "preserved"
    for name in ("feathered", "feathered, dodged", "feathered, sharpened", "averaged"):
        assert verdicts[name] in LOSSES, name
    assert verdicts["blurred badly"] == "significant"
    assert {loss_place(row).is_along for row in rows.values() if row.verdict in LOSSES} == {True, False}
    assert len({row.verdict for name, row in rows.items() if name.startswith("block")}) > 1


def test_a_loss_has_its_square_metres_and_nothing_else_has_any(
    rows: dict[str, WindowRecord], results: dict[str, WindowResult]
) -> None:
    for name, row in rows.items():
        window = results[name].window
        assert window is not None
        area = window.width * window.height * results[name].ground_sample_distance**2
        if row.verdict in LOSSES:
            assert 0 < (row.loss or 0.0) < area, name
        else:
            assert row.loss == {"preserved": 0.0, "not_comparable": None}[row.verdict], name


def test_sentence_table_label_and_report_say_the_same_number(
    rows: dict[str, WindowRecord], results: dict[str, WindowResult]
) -> None:
    columns = {column.name: column for column in COLUMNS}
    for name, row in rows.items():
        report = str(window_rows(row, (), 3, set())["found"])
        shown = columns["loss"].text(row)
        for said in (window_sentence(row), window_sentence(row, results[name])):
            assert len(textwrap.wrap(said, LINE)) <= 2, said
            if row.verdict in LOSSES:
                assert said.startswith(verdict_sentence(row.verdict))
                assert shown == shown_area(row.loss or 0.0)
                assert set(re.findall(r"[\d,.]+ m²", said)) <= {shown}
                assert f"loss: {shown}" in report
                at_seam = re.search(r"(?<!no more) (along|beside) the seam", said) is not None
                assert at_seam == loss_place(row).is_along, said
                assert "no more along the seam" not in said or (row.kept_1 or 0.0) >= 0.97, said
                along, whole = (percent(1 - (left or 0.0)) for left in (row.kept_1, (row.sharpness or 0.0) ** 2))
                if loss_place(row).is_along:
                    assert f"{along} % of detail lost" in said or f"{along} % of the rest along the seam" in said
                if " of the window's detail" in said:
                    assert f"{whole} % of the window's detail lost" in said
            else:
                assert "%" not in said or said == row.reason
        assert ("kept 1" in report) == (judged_kept(row) is not None), name


def test_the_profile_and_the_picture_show_a_loss_where_it_is_told(
    rows: dict[str, WindowRecord], results: dict[str, WindowResult]
) -> None:
    for name, row in rows.items():
        profile, picture = results[name].profile, results[name].loss
        if loss_place(row).is_along:
            assert profile is not None
            assert profile.kept[0] == pytest.approx(row.kept_1)
            near = [bin_.kept for bin_ in profile.bins if bin_.level == 1]
            assert min(near) <= (row.kept_1 or 0.0) < 1, name
            assert picture is None or loss_rgba(picture)[..., 3].any(), name  # without even ground there is none
        elif row.verdict == "preserved" and picture is not None:
            assert (loss_rgba(picture)[..., 3] > 0).mean() < 0.05, name


def test_a_loss_in_the_whole_window_is_in_its_picture_and_beside_its_profile(
    rows: dict[str, WindowRecord], results: dict[str, WindowResult]
) -> None:
    compared = 0
    for name, row in rows.items():
        result = results[name]
        if not re.search(" of the window's detail|In all ", window_sentence(row, result)) or result.loss is None:
            continue
        compared += 1
        whole, kept = 1 - (row.sharpness or 0.0) ** 2, np.nan_to_num(result.loss.kept, nan=1.0)
        assert 1 - np.minimum(kept, 1).mean() == pytest.approx(whole, abs=0.05), name  # by area and by energy
        if result.profile is not None and result.profile.measure is Measure.ENERGY:
            shown = ShownProfile(result.profile, 0.1, 0.7, ground_left=result.ground_left)
            assert f"{percent(result.ground_left)} %" in summary_words(shown)
    assert compared


def test_nothing_that_is_said_contradicts_the_verdict(
    rows: dict[str, WindowRecord], results: dict[str, WindowResult]
) -> None:
    for name, row in rows.items():
        said = all_said(row, results[name])
        if row.verdict in LOSSES:
            assert "as much of the finest detail" not in said, name
            kept = [float(text) for text in re.findall(r"Along the seam ([\d.]+) % is left", said)]
            assert not kept or not loss_place(row).is_along, name
        if row.kept_1 is not None:
            assert "no change from one source to another" not in said.lower(), name
        apart = [float(text) for text in re.findall(r"images ([\d.]+) px apart", said)]
        assert all(text >= MIN_MISREGISTRATION_PX for text in apart), name
