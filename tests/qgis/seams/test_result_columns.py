"""Each table of an inspection has one list of columns, which writes its rows and reads them again."""
from __future__ import annotations

from dataclasses import fields, replace
from typing import Any

import pytest
from seam_inspector.plugin.seams.measure.judgement.verdicts import Judgement, Ratios, Verdict
from seam_inspector.plugin.seams.measure.window import window_tables
from seam_inspector.plugin.seams.measure.window.window_result import WindowResult
from seam_inspector.plugin.seams.measure.window_records import WindowRecord
from seam_inspector.plugin.seams.tables import record_tables, window_layer
from seam_inspector.plugin.toolkit.table_fields import column_features, column_fields

from tests.qgis.scenes import BLURRED, SHARP, layer, outline, windows
from tests.qgis.seams.test_window_summary import result
from tests.qgis.seams.written_results import write_results


def record_of(result: WindowResult) -> WindowRecord:
    """What is read of a window whose result was written into a window layer."""
    drawn = layer("Polygon", [outline(SHARP)])
    write_results(drawn, {1: result}, observer="visible")
    (record,) = window_layer.read_layer(drawn)
    return record


def test_a_record_has_what_the_fields_hold(project: object) -> None:
    """What a field has no place of its own for is among the others."""
    known = {item.read_as for item in window_tables.WINDOW_FIELDS}
    assert {field.name for field in fields(WindowRecord)} <= known | {"extent", "fid", "stale", "others", "impossible"}


def test_what_is_written_of_a_window_is_read_again(project: object) -> None:
    actual = result("blur")
    assert actual.explanation is not None
    record = record_of(actual)
    explanation = actual.explanation
    assert replace(record, others={}) == WindowRecord(
        actual.window_id,
        record.extent,
        "significant",
        sources=actual.source_count,
        ratios=actual.judgement.ratios.detail,
        background_ratio=actual.judgement.ratios.background,
        observer="visible",
        composite_ratios=explanation.ratios["luminance"].detail,
        expected_ratios=explanation.expected,
        unclear_share=explanation.unclear_share,
        cause="blur",
        causes="blur",
        reference="seam",
        paper_verdict="reduced",
        kept=(0.56, 0.81, 0.97),
        kept_low=0.51,
        kept_high=0.62,
        band_width=2.0,
        feather_width=1.5,
        visibility=1.4,
        misfit=1.4,
        contrast=0.43,
        sharpness=0.69,
        added=0.04,
        explained=0.83,
        fid=1,
    )
    assert (record.ratio, record.composite_ratio, record.is_compared) == (0.38, 0.38, True)


def test_the_profile_has_a_row_for_each_level_and_distance(project: object) -> None:
    bins = window_tables.bins_of(result("feathering"))
    rows = [row.attributes() for row in column_features(window_tables.PROFILE_COLUMNS, bins)]
    assert rows == [
        [1, 1, pytest.approx(0.1), 0.56, 0.5, 0.63, pytest.approx(12.0), 0.48],
        [1, 1, pytest.approx(25.6), 1.0, 0.9, 1.1, pytest.approx(500.0), None],
    ]  # fmt: skip
    names = ["window_id", "level", "distance", "kept", "low", "high", "area", "mixture"]
    assert column_fields(window_tables.PROFILE_COLUMNS).names() == names
    unknown = Judgement(Verdict.NOT_COMPARABLE, Ratios((None,), None))
    assert not list(window_tables.bins_of(WindowResult(5, None, unknown, Verdict.NOT_COMPARABLE)))


def test_what_the_seam_kept_is_read_where_it_is_known(project: object) -> None:
    values: dict[str, tuple[str, list[Any]]] = {
        "kept_2": ("double", [0.9, None]), "kept_1": ("string", ["0.62", ""]), "contrast_1": ("double", [0.81, None]),
    }  # fmt: skip
    drawn = windows(SHARP, BLURRED, **values)
    known, unknown = record_tables.read_windows(drawn.getFeatures(), drawn.fields().names())
    assert (known.kept, known.kept_1, known.contrast) == ((0.62, 0.9), 0.62, 0.81)
    assert (unknown.kept, unknown.kept_1, unknown.contrast) == ((None, None), None, None)
    earlier = windows(SHARP, window_id=("integer", [1]))
    (old,) = record_tables.read_windows(earlier.getFeatures(), earlier.fields().names())
    assert (old.kept, old.kept_1, old.contrast) == ((), None, None)
