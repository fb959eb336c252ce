"""The ground resolved distance of a target as one HTML page."""
from __future__ import annotations

from pathlib import Path

from ..imagery.rasters import Raster
from ..toolkit.band_titles import band_title
from ..toolkit.charts.figure_files import svg_text
from ..toolkit.pages.how_measured import HowMeasured, measured_raster
from ..toolkit.pages.templates import save_page, sentences_once
from ..toolkit.translation import filled, percent, sentence, tr
from .charts import direction_title, group_chart, target_picture, verdict_of, verdict_word
from .measure.bar_groups import GroupResult, TargetResolution
from .measure.target import DIRECTIONS, Target


def save_resolution_report(path: Path, raster: Raster, resolution: TargetResolution, target: Target) -> None:
    """Write distances, the target with its lines, every group's profiles, and a table of all that was measured.

    Raises SettingsError where no file can be.
    """
    results = resolution.results
    picture = target_picture(raster, results)
    save_page(
        path,
        "resolution",
        HowMeasured(_settings(target), [measured_raster(tr("image"), raster)]),
        name=raster.ref.name,
        summary=_summary(resolution),
        notices=sentences_once(resolution.notices),
        distances=[
            (direction_title(direction), band_title(band), tr("none") if grd is None else f"{grd:.2f}")
            for (direction, band), grd in sorted(resolution.grd_cm.items())
        ],
        picture=None if picture is None else svg_text(picture),
        chart=svg_text(group_chart(results, target.criterion)),
        criterion=target.criterion,
        measurements=[_row(result) for result in results],
        reasons=[(*_names(result), sentence(result.reason)) for result in results if result.reason is not None],
    )


def _summary(resolution: TargetResolution) -> str:
    words = []
    for direction in DIRECTIONS:
        grd = resolution.worst(direction)
        if grd is not None:
            words.append(filled(tr("{direction}: {grd:.2f} cm"), direction=direction_title(direction), grd=grd))
    if resolution.mean is not None:
        words.append(filled(tr("geometric mean: {grd:.2f} cm"), grd=resolution.mean))
    return "; ".join(words) + "." if words else tr("No group is resolved in every band.")


def _settings(target: Target) -> list[tuple[str, str]]:
    coarser = tr("higher") if target.reversed else tr("lower")
    words = tr("group {group} is {grd:.2f} cm wide, the next {coarser} number {step:.3f} times as wide")
    return [
        (tr("bars in each group"), str(target.bars)),
        (tr("widths"), filled(words, group=target.reference_group, grd=target.reference_grd_cm, coarser=coarser,
                              step=target.step)),
        (tr("criterion"), f"{percent(target.criterion)} %"),
    ]  # fmt: skip


def _row(result: GroupResult) -> tuple[object, ...]:
    reading = result.reading

    def rounded(value: float | None, digits: int) -> str:
        return "" if value is None else f"{value:.{digits}f}"

    return (
        *_names(result),
        rounded(result.grd_cm, 2),
        "" if reading is None else len(reading.bars),
        rounded(None if reading is None else reading.amplitude, 1),
        rounded(None if reading is None else reading.full_amplitude, 1),
        rounded(None if reading is None else reading.modulation, 3),
        rounded(result.measured.shifts.get(result.band), 2),
        verdict_word(verdict_of([result])),
    )


def _names(result: GroupResult) -> tuple[object, str, str]:
    """Group, direction and band."""
    line = result.measured.line
    group = "" if line.group is None else line.group
    return group, line.direction, band_title(result.band) if result.band else ""
