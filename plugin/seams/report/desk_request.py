"""What the desk knows of its windows -> the request of a report."""
from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from dataclasses import replace
from pathlib import Path

from qgis.core import QgsCoordinateReferenceSystem, QgsProject

from ...imagery.limits import judged_band
from ...toolkit import layers as layers
from ...toolkit.background_tasks import Cancelled, Job
from ..measure.inspection import Block
from ..measure.window.window_result import WindowResult
from ..measure.window_records import CurveRecord, PairRecord, ProfileRecord, WindowRecord
from .inspection_report import ReportRequest, write_report


def report_request(
    rows: Iterable[WindowRecord],
    result: Callable[[int], WindowResult | None],
    crs: QgsCoordinateReferenceSystem,
    block: Block | None,
    max_ratio: float,
    min_kept: float,
    project: QgsProject,
) -> ReportRequest:
    """Of the inspected windows among some; ``result`` gives what was measured in one, by its feature id.

    ``crs`` is that of the rows' extents. Raises WindowError when they can't be transformed to the mosaic's.
    """
    target = layers.mosaic_crs(block.mosaic) if block is not None else crs
    inspected = [row for row in rows if row.verdict]
    measured = {row.window_id: found for row in inspected if (found := result(row.fid)) is not None}
    return ReportRequest(
        tuple(_on_mosaic(row, measured.get(row.window_id), crs, target, project) for row in inspected),
        curves={number: _curves(found) for number, found in measured.items() if found.clips},
        pairs={number: _pairs(found) for number, found in measured.items() if found.pairs},
        profiles={number: _profile(found) for number, found in measured.items() if found.profile is not None},
        losses={number: found.loss for number, found in measured.items() if found.loss is not None},
        block=block,
        wkt=layers.system_wkt(target),
        max_ratio=max_ratio,
        min_kept=min_kept,
    )


def report_job(path: Path, request: ReportRequest) -> Job:
    """Writes the report; yields the messages about what it could not show."""

    def job(cancelled: Cancelled) -> Iterator[tuple[float, object]]:
        notices = write_report(path, request, cancelled=cancelled)
        if notices is not None:
            yield 1.0, notices

    return job


def _on_mosaic(
    row: WindowRecord,
    found: WindowResult | None,
    crs: QgsCoordinateReferenceSystem,
    target: QgsCoordinateReferenceSystem,
    project: QgsProject,
) -> WindowRecord:
    """With its extent in another system, and all that was measured of its composite."""
    row = replace(row, extent=row.extent and layers.transformed_extent(row.extent, crs, target, project))
    why = found.explanation if found is not None else None
    if why is None:
        return row
    ratios = next(iter(why.ratios.values())).detail
    return replace(row, composite_ratios=ratios, expected_ratios=why.expected, unclear_share=why.unclear_share)


def _curves(found: WindowResult) -> list[CurveRecord]:
    """In the judged band."""
    band = judged_band(found.clips[0].curves)
    clips = (clip for clip in found.with_composite if band in clip.curves)
    return [
        CurveRecord(clip.raster, clip.role, clip.curves[band].detail, clip.curves[band].background) for clip in clips
    ]


def _profile(found: WindowResult) -> list[ProfileRecord]:
    pixel_m, bins = found.ground_sample_distance, found.profile.bins if found.profile is not None else ()
    return [
        ProfileRecord(one.level, pixel_m * one.middle_px, one.kept, one.low, one.high, one.mixture) for one in bins
    ]


def _pairs(found: WindowResult) -> list[PairRecord]:
    return [
        PairRecord(pair.source, pair.band, pair.ratios.detail[0], pair.change.contrast[0] if pair.change else None)
        for pair in (*found.pairs, *found.composite_pairs)
    ]
