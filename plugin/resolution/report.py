"""The ground resolved distance of a target as one HTML page."""
from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from ..imagery.rasters import Raster
from ..toolkit.charts.figure_files import svg_text
from ..toolkit.pages.templates import HowMeasured, measured_raster, save_page, sentences_once
from ..toolkit.translation import band_title, filled, percent, sentence, shown_number, tr
from .band_colours import band_colour
from .charts import VERDICT_COLOURS, lines_of, profile_rows, verdict_of, verdict_word
from .distance_words import direction_title, distance_number, distance_text, target_distances
from .measure.bar_groups import GroupResult, TargetResolution
from .measure.target import BAR, COARSEST, DIRECTIONS, Target
from .target_picture import target_picture


def save_resolution_report(path: Path, raster: Raster, resolution: TargetResolution, target: Target) -> None:
    """Write distances, the target with its lines, every group's profiles, and a table of all that was measured.

    Raises SettingsError where no file can be.
    """
    results = resolution.results
    picture, verdicts = target_picture(raster, results), {verdict_of(line) for line in lines_of(results)}
    save_page(
        path,
        "resolution",
        HowMeasured(_settings(target), [measured_raster(tr("image"), raster)]),
        name=raster.ref.name,
        summary=_summary(resolution, target),
        figures=[(distance_text(grd, error), words) for words, grd, error in target_distances(resolution)],
        notices=sentences_once(resolution.notices),
        **_distances(resolution),
        contrasts=[(band_title(band), f"{shown_number(value, 1)} : 1") for band, value in resolution.contrasts.items()],
        observers=_observers(resolution),
        picture=None if picture is None else svg_text(picture),
        verdicts=[(colour, verdict_word(name)) for name, colour in VERDICT_COLOURS.items() if name in verdicts],
        profiles=map(svg_text, profile_rows(results, target.criterion)),
        bands=_bands(results),
        criterion=target.criterion,
        measurements=[_row(result) for result in results],
        reasons=_reasons(results),
    )


def _distances(resolution: TargetResolution) -> dict[str, object]:
    known = resolution.grd_cm
    bands = list(dict.fromkeys(band for _, band in known))

    def word(key: tuple[str, str]) -> str:
        grd = known.get(key)
        if grd is None:
            return tr("none") if key in known else ""
        return distance_number(grd, resolution.grd_error_cm.get(key))

    rows = [
        [direction_title(direction), *(word((direction, band)) for band in bands)]
        for direction in DIRECTIONS if any(where == direction for where, _ in known)
    ]  # fmt: skip
    return {"distance_bands": [band_title(band) for band in bands], "distances": rows}


def _reasons(results: Sequence[GroupResult]) -> list[tuple[str, str, str, str]]:
    """Direction, band, reason, and the groups that it is true of: each sentence is said once."""
    groups: dict[tuple[str, str, str], list[str]] = {}
    for result in results:
        if result.reason is not None:
            group, direction, band = _names(result)
            groups.setdefault((direction, band, sentence(result.reason)), []).append(str(group))
    return [(*known, ", ".join(filter(None, numbers))) for known, numbers in groups.items()]


def _bands(results: Sequence[GroupResult]) -> list[tuple[str, str]]:
    """Colours and names of the bands that were measured; empty for a single one."""
    names = list(dict.fromkeys(result.band for result in results if result.band))
    if len(names) < 2:
        return []
    return [(band_colour(name, place, len(names)), band_title(name)) for place, name in enumerate(names)]


def _observers(resolution: TargetResolution) -> list[tuple[str, ...]]:
    """Each observer's distances along and across the flight, and those that all agree on."""
    if not resolution.observers:
        return []

    def distances(observer: str | None) -> list[str]:
        distances = [resolution.seen(direction, observer) for direction in DIRECTIONS]
        return ["" if grd is None else shown_number(grd) for grd in distances]

    rows = [(name, *distances(name)) for name in resolution.observers]
    return [*rows, (tr("all of them"), *distances(None))]


def _summary(resolution: TargetResolution, target: Target) -> str:
    if not target_distances(resolution):
        return tr("No group is resolved in every band.")
    if target.grd_of == BAR:
        return tr("Ground resolved distance: one bar of the finest group that is resolved in every band.")
    return tr("Ground resolved distance: one bar and one gap of the finest group that is resolved in every band.")


def _settings(target: Target) -> list[tuple[str, str]]:
    coarser = tr("higher") if target.reversed else tr("lower")
    of_group, coarsest = tr("the group's own bars against plain gaps"), tr("that of the coarsest group")
    full = coarsest if target.full_amplitude == COARSEST else of_group
    words = tr("group {group} is {grd:.2f} cm wide, the next {coarser} number {step:.3f} times as wide")
    return [
        (tr("bars in each group"), str(target.bars)),
        (tr("widths"), filled(words, group=target.reference_group, grd=target.reference_grd_cm, coarser=coarser,
                              step=target.step)),
        (tr("widths are of"), tr("one bar") if target.grd_of == BAR else tr("a bar and a gap together")),
        (tr("criterion"), f"{percent(target.criterion)} %"),
        (tr("full amplitude"), full),
    ]  # fmt: skip


def _row(result: GroupResult) -> tuple[object, ...]:
    reading = result.reading

    def rounded(value: float | None, digits: int) -> str:
        return "" if value is None else shown_number(value, digits)

    bars: tuple[object, ...] = ("",) * 5
    if reading is not None:
        amplitudes = reading.amplitude, reading.amplitude_error, reading.full_amplitude
        bars = len(reading.bars), *(rounded(value, 1) for value in amplitudes), rounded(reading.modulation, 3)
    shift, verdict = result.measured.shifts.get(result.band), verdict_of([result])
    distance = rounded(result.grd_cm, 2), rounded(result.grd_error_cm, 2)
    return (*_names(result), *distance, *bars, rounded(shift, 2), verdict_word(verdict))


def _names(result: GroupResult) -> tuple[object, str, str]:
    line = result.measured.line
    group = "" if line.group is None else line.group
    return group, tr(line.direction), band_title(result.band) if result.band else ""
