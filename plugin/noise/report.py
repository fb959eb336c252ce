"""The report of a noise check, one HTML page."""
from __future__ import annotations

from collections.abc import Iterable, Sequence

from ..imagery.message import Message
from ..toolkit.charts.figure_files import svg_text
from ..toolkit.pages import html_page
from ..toolkit.pages.html_page import Html
from ..toolkit.translation import sentence, tr
from .charts import noise_figure
from .measure.group_noise import ClipNoise
from .measure.noise_requests import GroupedImage
from .noise_summary import WORDS, judged_noise, verdict_counts, verdict_of


def noise_page(results: Sequence[ClipNoise], notices: Iterable[Message], wavelet: str, levels: int) -> str:
    """The whole report."""
    parts: list[Html] = [html_page.paragraph(_overview(results))]
    parts += [html_page.paragraph(words, "warning") for words in dict.fromkeys(map(sentence, notices))]
    figure = noise_figure(results)
    if figure is not None:
        parts.append(html_page.together([html_page.drawing(svg_text(figure), _caption())]))
    parts += [html_page.heading(tr("Rasters")), _rasters(results)]
    parts += [html_page.heading(tr("Windows")), _windows(results, levels)]
    parts += [html_page.heading(tr("How it is measured")), *map(html_page.paragraph, _method(wavelet, levels))]
    return html_page.page(tr("Random noise"), parts)


def _overview(results: Sequence[ClipNoise]) -> str:
    counts = verdict_counts(results)
    said = ", ".join(f"{tr(words)}: {counts[verdict]}" for verdict, words in WORDS.items() if counts[verdict])
    return tr("Windows by their random noise: {counts}.").format(counts=said)


def _caption() -> str:
    return tr(
        "Relative variance of the details by level, 1 the finest. It rises from level to level in an image with little "
        "random noise; noise lifts level 1 above level 2 and, where it is strong, level 2 above level 3."
    )


def _rasters(results: Sequence[ClipNoise]) -> Html:
    by_image: dict[GroupedImage, list[ClipNoise]] = {}
    for result in results:
        by_image.setdefault(result.part.member, []).append(result)
    rows = []
    for member, own in by_image.items():
        counts = verdict_counts(own)
        sigmas = [judged.sigma for result in own if (judged := judged_noise(result)) and judged.sigma is not None]
        size = member.image.ground_sample_distance
        rows.append([
            member.image.ref.name,
            member.group,
            "" if size is None else f"{size:.3g} m",
            *(counts[verdict] for verdict in WORDS),
            f"{min(sigmas):.2f}" if sigmas else "",
            f"{sum(sigmas) / len(sigmas):.2f}" if sigmas else "",
            f"{max(sigmas):.2f}" if sigmas else "",
        ])
    headings = [tr("raster"), tr("group"), tr("pixel"), *(tr(words) for words in WORDS.values())]
    headings += [tr("least sigma (DN)"), tr("mean"), tr("largest")]
    return html_page.table(headings, rows)


def _windows(results: Sequence[ClipNoise], levels: int) -> Html:
    """The judged band of every window; what could not be measured, and notes, in words."""
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
        rows.append([*head, tr(WORDS[verdict_of(result)]), *figures, place, sentence(reason) if reason else ""])
    headings = [tr("window"), tr("raster"), tr("group"), tr("noise"), tr("sigma (DN)")]
    headings += [tr("detail {level}").format(level=level) for level in range(1, levels + 1)]
    headings += [tr("kurtosis by level"), tr("column, row"), tr("note")]
    group, note = 2, len(headings) - 1
    left_out = {group} if len({row[group] for row in rows}) < 2 else set()
    left_out |= set() if any(row[note] for row in rows) else {note}
    shown = [i for i in range(len(headings)) if i not in left_out]
    return html_page.table([headings[i] for i in shown], [[row[i] for i in shown] for row in rows])


def _method(wavelet: str, levels: int) -> list[str]:
    return [
        tr(
            "Each window is decomposed by the wavelet {wavelet} on {levels} levels; a level's detail is the share of "
            "the window's variance in its three detail components. Judged is the luminance, or the only band (Pyka "
            "2009)."
        ).format(wavelet=wavelet, levels=levels),
        tr(
            "Sigma is the median absolute value of the finest diagonal component divided by 0.6745, in DN. Fine "
            "texture adds to it, so compare it between images of the same ground."
        ),
        tr(
            "Kurtosis is the fourth moment of a level's details over their squared variance: 3 for Gaussian noise, "
            "more where edges stand out of a quiet ground."
        ),
    ]
