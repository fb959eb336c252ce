"""What a report of an inspection tells, in plain data; and how the desk's windows become that."""
from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from datetime import date

from qgis.core import QgsCoordinateReferenceSystem, QgsProject

from ...imagery import limits as imagery_limits
from ...imagery.limits import judged_band
from ...toolkit import layers
from ..measure import limits
from ..measure.window.inspection import Block
from ..measure.window.window_result import WindowResult
from ..measure.window_records import CurveRecord, PairRecord, ProfileRecord, WindowRecord
from ..window_summary import in_users_language


@dataclass(frozen=True)
class ReportRequest:
    """What a report tells, in plain data that can cross threads."""

    records: tuple[WindowRecord, ...]
    """The windows; their extents in the mosaic's reference system where there is a block."""
    curves: Mapping[int, Sequence[CurveRecord]] = field(default_factory=dict)
    """Curves by window, in the judged band."""
    pairs: Mapping[int, Sequence[PairRecord]] = field(default_factory=dict)  # pairs by window
    block: Block | None = None  # mosaic and sources whose clips are shown; None for none
    wkt: str = ""  # reference system of the extents; empty when it is unknown
    title: str = ""  # heading of the page; empty for the mosaics' names
    name: str = ""  # what the mosaic is called where neither the block nor the curves say it
    max_ratio: float = imagery_limits.MAX_SIGNIFICANT_RATIO  # the limit drawn into the charts of curves
    min_kept: float = limits.MAX_SIGNIFICANT_KEPT  # the limit drawn into the charts of what is kept
    profiles: Mapping[int, Sequence[ProfileRecord]] = field(default_factory=dict)  # profiles by window
    results: Mapping[int, WindowResult] = field(default_factory=dict)
    """All that was measured in windows, as far as it is known; lost detail of others is measured again where there is a
    block."""
    made_on: date = field(default_factory=date.today)


def report_request(
    rows: Iterable[WindowRecord],
    result: Callable[[int], WindowResult | None],
    crs: QgsCoordinateReferenceSystem,
    block: Block | None,
    max_ratio: float,
    min_kept: float,
    project: QgsProject,
) -> ReportRequest:
    """Request for the inspected windows among some; ``result`` gives what was measured in one, by its feature id.

    ``crs`` is that of the rows' extents. Raises WindowError when they can't be transformed to the mosaic's.
    """
    target = layers.mosaic_crs(block.mosaic) if block is not None else crs
    inspected = [row for row in rows if row.verdict]
    measured = {row.window_id: measured_window for row in inspected if (measured_window := result(row.fid)) is not None}
    return ReportRequest(
        tuple(_on_mosaic(row, measured.get(row.window_id), crs, target, project) for row in inspected),
        curves={number: _curves(window) for number, window in measured.items() if window.clips},
        pairs={number: _pairs(window) for number, window in measured.items() if window.pairs},
        results=measured,
        block=block,
        wkt=layers.system_wkt(target),
        max_ratio=max_ratio,
        min_kept=min_kept,
    )


def _on_mosaic(
    row: WindowRecord,
    result: WindowResult | None,
    crs: QgsCoordinateReferenceSystem,
    target: QgsCoordinateReferenceSystem,
    project: QgsProject,
) -> WindowRecord:
    """With its extent in another system, and all that was measured of its composite."""
    row = in_users_language(row, result)
    row = replace(row, extent=row.extent and layers.transformed_extent(row.extent, crs, target, project))
    why = result.explanation if result is not None else None
    if why is None:
        return row
    ratios = next(iter(why.ratios.values())).detail
    return replace(row, composite_ratios=ratios, expected_ratios=why.expected, unclear_share=why.unclear_share)


def _curves(result: WindowResult) -> list[CurveRecord]:
    """In the judged band."""
    band = judged_band(result.clips[0].curves)
    clips = (clip for clip in result.with_composite if band in clip.curves)
    return [
        CurveRecord(clip.raster, clip.role, clip.curves[band].detail, clip.curves[band].background) for clip in clips
    ]


def _pairs(result: WindowResult) -> list[PairRecord]:
    return [
        PairRecord(pair.source, pair.band, pair.ratios.detail[0], pair.change.contrast[0] if pair.change else None)
        for pair in (*result.pairs, *result.composite_pairs)
    ]
