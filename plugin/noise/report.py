"""The report of a noise check, one HTML page."""
from __future__ import annotations

from collections.abc import Iterable, Sequence
from pathlib import Path

from ..imagery.message import Message
from ..toolkit.charts.figure_files import svg_text
from ..toolkit.pages.how_measured import HowMeasured, each_raster
from ..toolkit.pages.templates import save_page, sentences_once
from ..toolkit.translation import sentence, tr
from .charts import noise_figure
from .measure.group_noise import ClipNoise
from .measure.noise_requests import GroupedImage
from .noise_summary import VERDICT_WORDS, judged_noise, verdict_counts, verdict_of


def save_noise_report(
    path: Path, results: Sequence[ClipNoise], notices: Iterable[Message], wavelet: str, levels: int
) -> None:
    """Write the report. Raises SettingsError where no file can be."""
    counts, figure = verdict_counts(results), noise_figure(results)
    headings, windows = _windows(results, levels)
    save_page(
        path,
        "random_noise",
        HowMeasured(
            [(tr("wavelet"), wavelet), (tr("levels"), str(levels))],
            each_raster(tr("image"), (result.part.member.image for result in results)),
        ),
        counts=", ".join(f"{tr(word)}: {counts[one]}" for one, word in VERDICT_WORDS.items() if counts[one]),
        notices=sentences_once(notices),
        chart=None if figure is None else svg_text(figure),
        verdicts=[tr(words) for words in VERDICT_WORDS.values()],
        rasters=_rasters(results),
        headings=headings,
        windows=windows,
        wavelet=wavelet,
        levels=levels,
    )


def _rasters(results: Sequence[ClipNoise]) -> list[list[object]]:
    """A row for each image of each group."""
    by_image: dict[GroupedImage, list[ClipNoise]] = {}
    for result in results:
        by_image.setdefault(result.part.member, []).append(result)
    rows: list[list[object]] = []
    for member, own in by_image.items():
        counts = verdict_counts(own)
        sigmas = [judged.sigma for result in own if (judged := judged_noise(result)) and judged.sigma is not None]
        size = member.ground_sample_distance
        rows.append([
            member.image.ref.name,
            member.group,
            "" if size is None else f"{size:.3g} m",
            *(counts[verdict] for verdict in VERDICT_WORDS),
            f"{min(sigmas):.2f}" if sigmas else "",
            f"{sum(sigmas) / len(sigmas):.2f}" if sigmas else "",
            f"{max(sigmas):.2f}" if sigmas else "",
        ])
    return rows


def _windows(results: Sequence[ClipNoise], levels: int) -> tuple[list[str], list[list[object]]]:
    """The judged band of every window, headings and rows; what could not be measured, and notes, in words."""
    rows = []
    for result in results:
        judged, window = judged_noise(result), result.part.window
        head = [result.window_id, result.part.member.image.ref.name, result.part.member.group]
        if judged is None or judged.sigma is None:
            figures = [""] * (levels + 2)
            reason = result.reason or (judged.note if judged else None)
        else:
            known = ("-" if kurtosis is None else f"{kurtosis:.1f}" for kurtosis in judged.kurtosis)
            figures = [f"{judged.sigma:.2f}", *(f"{share:.4f}" for share in judged.curve.detail)]
            figures.append("\u00a0\u00a0".join(known))
            reason = judged.note
        place = f"{window.column},\u00a0{window.row}"
        rows.append([*head, tr(VERDICT_WORDS[verdict_of(result)]), *figures, place, sentence(reason) if reason else ""])
    headings = [tr("window"), tr("raster"), tr("group"), tr("noise"), tr("sigma (DN)")]
    headings += [tr("detail {level}").format(level=level) for level in range(1, levels + 1)]
    headings += [tr("kurtosis by level"), tr("column, row"), tr("note")]
    group, note = 2, len(headings) - 1
    left_out = {group} if len({row[group] for row in rows}) < 2 else set()
    left_out |= set() if any(row[note] for row in rows) else {note}
    shown = [i for i in range(len(headings)) if i not in left_out]
    return [headings[i] for i in shown], [[row[i] for i in shown] for row in rows]
