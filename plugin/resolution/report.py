"""The ground resolved distance of a target as one HTML page."""
from __future__ import annotations

from ..imagery.rasters import Mosaic
from ..toolkit.band_titles import band_title
from ..toolkit.charts.figure_files import svg_text
from ..toolkit.pages import html_page
from ..toolkit.translation import sentence, tr
from .charts import direction_title, group_chart, target_picture, verdict_of, verdict_word
from .measure.bar_groups import GroupResult, Resolution
from .measure.target import DIRECTIONS, Target


def resolution_page(raster: Mosaic, resolution: Resolution, target: Target) -> str:
    """Distances, the target with its lines, every group's profiles, and a table of all that was measured."""
    title = tr("Ground resolved distance: {name}").format(name=raster.ref.name)
    parts = [html_page.paragraph(_summary(resolution))]
    parts += [html_page.paragraph(sentence(notice), "warning") for notice in resolution.notices]
    if resolution.grd_cm:
        rows = [
            (direction_title(direction), band_title(band), tr("none") if grd is None else f"{grd:.2f}")
            for (direction, band), grd in sorted(resolution.grd_cm.items())
        ]
        parts.append(html_page.table((tr("direction"), tr("band"), tr("distance, cm")), rows))
    picture = target_picture(raster, resolution.results)
    if picture is not None:
        parts += [html_page.heading(tr("The target")), html_page.drawing(svg_text(picture), width_mm=150)]
    words = tr(
        "Full circles are bars, empty ones the gaps between them. The gaps must lie beyond the dashed line, which is "
        "{criterion:.0%} of the full amplitude away from the weakest bar. Grey lines: the ends of the line as drawn."
    ).format(criterion=target.criterion)
    parts.append(html_page.heading(tr("Profiles")))
    parts.append(html_page.drawing(svg_text(group_chart(resolution.results, target.criterion)), words))
    parts.append(html_page.heading(tr("Measurements")))
    headings = (
        tr("group"), tr("direction"), tr("band"), tr("distance, cm"), tr("bars"), tr("amplitude, DN"),
        tr("full amplitude, DN"), tr("modulation"), tr("shift, px"), tr("verdict"),
    )
    parts.append(html_page.table(headings, [_row(result) for result in resolution.results]))
    reasons = [(*_names(result), sentence(result.reason)) for result in resolution.results if result.reason is not None]
    if reasons:
        parts.append(html_page.heading(tr("Reasons")))
        parts.append(html_page.table((tr("group"), tr("direction"), tr("band"), tr("reason")), reasons))
    return html_page.page(title, parts)


def _summary(resolution: Resolution) -> str:
    words = []
    for direction in DIRECTIONS:
        grd = resolution.worst(direction)
        if grd is not None:
            words.append(tr("{direction}: {grd:.2f} cm").format(direction=direction_title(direction), grd=grd))
    if resolution.mean is not None:
        words.append(tr("geometric mean: {grd:.2f} cm").format(grd=resolution.mean))
    return "; ".join(words) + "." if words else tr("No group is resolved in every band.")


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
