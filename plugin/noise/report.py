"""The report of a noise check, one HTML page."""
from __future__ import annotations

from collections.abc import Iterable, Sequence
from pathlib import Path

from ..imagery.errors import Message
from ..toolkit.charts.figure_files import svg_text
from ..toolkit.pages.templates import HowMeasured, each_raster, save_page, sentences_once
from ..toolkit.translation import band_title, filled, formatted, sentence, shown_number, tr
from .charts import noise_figure
from .measure.band_noise import noisiest_band
from .measure.grain import Grain
from .measure.group_noise import ClipNoise
from .measure.noise_plan import GroupedImage
from .noise_summary import (
    AMOUNT_WORDS,
    VERDICT_WORDS,
    NoiseGroup,
    class_title,
    judged_noise,
    noise_groups,
    verdict_counts,
    verdict_of,
)


def save_noise_report(
    path: Path, results: Sequence[ClipNoise], notices: Iterable[Message], wavelet: str, levels: int, field: str = ""
) -> None:
    """Write the report. ``field``: what the windows are grouped by. Raises SettingsError where no file can be."""
    counts, figure = verdict_counts(results), noise_figure(results, field)
    groups = noise_groups(results)
    headings, windows, notes = _windows(results, levels, field)
    grouped_headings, grouped = _groups(groups, levels, field)
    save_page(
        path,
        "random_noise",
        HowMeasured(
            [(tr("wavelet"), wavelet), (tr("levels"), str(levels))],
            each_raster(tr("image"), (result.part.member.image for result in results)),
        ),
        counts=", ".join(f"{tr(word)}: {counts[key]}" for key, word in VERDICT_WORDS.items() if counts[key]),
        notices=sentences_once(notices),
        chart=None if figure is None else svg_text(figure),
        verdicts=[tr(words) for words in VERDICT_WORDS.values()],
        group_headings=grouped_headings,
        groups=grouped if len(groups) > 1 else [],
        rasters=_rasters(results),
        headings=headings,
        windows=windows,
        notes=notes,
        wavelet=wavelet,
        levels=levels,
    )


def _groups(groups: Sequence[NoiseGroup], levels: int, field: str) -> tuple[list[str], list[list[object]]]:
    """A row for each class of windows and group of images: what Pyka 2009 compares."""
    headings = [field] if field else []
    headings += [tr("group"), tr("windows"), *(tr(words) for words in VERDICT_WORDS.values())]
    headings += [filled(tr("mean detail {level}"), level=level) for level in range(1, levels + 1)]
    headings.append(tr("mean sigma (DN)"))
    rows: list[list[object]] = []
    for group in groups:
        counts, curves = verdict_counts(group.results), group.curves
        sigmas = _sigmas(group.results)
        means = [formatted(sum(shares) / len(curves), ".4f") for shares in zip(*curves)] if curves else [""] * levels
        rows.append([
            *([class_title(group.window_class)] if field else []),
            group.name,
            group.windows,
            *(counts[verdict] for verdict in VERDICT_WORDS),
            *means,
            shown_number(sum(sigmas) / len(sigmas)) if sigmas else "",
        ])
    return headings, rows


def _rasters(results: Sequence[ClipNoise]) -> list[list[object]]:
    """A row for each image of each group."""
    by_image: dict[GroupedImage, list[ClipNoise]] = {}
    for result in results:
        by_image.setdefault(result.part.member, []).append(result)
    rows: list[list[object]] = []
    for member, of_image in by_image.items():
        counts = verdict_counts(of_image)
        sigmas = _sigmas(of_image)
        size = member.ground_sample_distance
        rows.append([
            member.image.ref.name,
            member.group_name if len({other.group for other in by_image}) > 1 else "",
            "" if size is None else formatted(size, ".3g") + "\u00a0m",
            *(counts[verdict] for verdict in VERDICT_WORDS),
            *(map(shown_number, (min(sigmas), sum(sigmas) / len(sigmas), max(sigmas))) if sigmas else [""] * 3),
        ])
    return rows


def _sigmas(results: Iterable[ClipNoise]) -> list[float]:
    """Standard deviations of the noise of the noisiest bands, DN."""
    judged = map(judged_noise, results)
    return [noise.sigma for noise in judged if noise is not None and noise.sigma is not None]


def _grain(grain: Grain) -> str:
    return f"{shown_number(grain.sigma, 1)}; {shown_number(grain.size, 1)}\u00a0px"


def _windows(
    results: Sequence[ClipNoise], levels: int, field: str
) -> tuple[list[str], list[list[object]], list[str]]:
    """The noisiest band of every window, headings and rows, and the notes that rows have by number.

    They say why nothing could be measured, and what to take care of.
    """
    rows: list[list[object]] = []
    notes: dict[str, int] = {}
    for result in results:
        judged, window = judged_noise(result), result.part.window
        band = band_title(noisiest_band(result.bands)) if len(result.bands) > 1 else ""
        member = result.part.member
        head = [result.window_id, class_title(result.window_class), member.image.ref.name, member.group_name]
        if judged is None or judged.sigma is None:
            figures = [""] * (levels + 6)
            reason = result.reason or (judged.note if judged else None)
        else:
            known = ("-" if kurtosis is None else shown_number(kurtosis, 1) for kurtosis in judged.kurtosis)
            largest = "" if judged.largest_sigma is None else shown_number(judged.largest_sigma, 1)
            grain = "" if judged.grain is None else _grain(judged.grain)
            shares = (formatted(share, ".4f") for share in judged.curve.detail)
            ratio = "" if judged.signal_to_noise is None else shown_number(judged.signal_to_noise, 0)
            figures = [tr(AMOUNT_WORDS[judged.amount]), ratio, shown_number(judged.sigma), largest, grain, *shares]
            figures.append("\u00a0\u00a0".join(known))
            reason = judged.note
        place = f"{window.column},\u00a0{window.row}"
        note_number = str(notes.setdefault(sentence(reason), len(notes) + 1)) if reason else ""
        rows.append([*head, tr(VERDICT_WORDS[verdict_of(result)]), band, *figures, place, note_number])
    headings = [tr("window"), field, tr("raster"), tr("group"), tr("noise"), tr("band"), tr("amount")]
    headings += [tr("signal to noise"), tr("sigma (DN)"), tr("largest possible"), tr("grain (DN)")]
    headings += [filled(tr("detail {level}"), level=level) for level in range(1, levels + 1)]
    headings += [tr("kurtosis by level"), tr("column, row"), tr("note")]
    of_class, group, band_column, grain_column, note = 1, 3, 5, 10, len(headings) - 1
    left_out = set() if field else {of_class}
    left_out |= {group} if len({row[group] for row in rows}) < 2 else set()
    left_out |= {column for column in (band_column, grain_column, note) if not any(row[column] for row in rows)}
    shown = [i for i in range(len(headings)) if i not in left_out]
    return [headings[i] for i in shown], [[row[i] for i in shown] for row in rows], list(notes)
