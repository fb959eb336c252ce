"""The relative variances of all windows, as table 1 of Pyka 2010 gives them."""
from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence, Set

from ...toolkit.pages import html_page
from ...toolkit.pages.html_page import Group, Heading, Html, Markup
from ...toolkit.translation import tr
from ..measure.window_records import COMPOSITE, CurveRecord, WindowRecord
from ..verdict_words import cause_word, observer_word, verdict_colour, verdict_word
from .flagged_windows import anchor

_ROLES = ("mosaic", "source", COMPOSITE)


def variance_table(
    findings: Sequence[WindowRecord], curves: Mapping[int, Sequence[CurveRecord]], linked: Set[int]
) -> Html:
    """Window, its character, and mosaic and sources with their shares by level; ``linked`` windows lead to theirs."""
    levels = max((len(curve.detail) for rows in curves.values() for curve in rows), default=0)
    windows = [tr("window"), tr("verdict, cause, observer")]
    if not levels:
        ratio_levels = max((len(one.ratios) for one in findings), default=0)
        headings: list[list[Heading]] = [[(words, 1, 1) for words in windows]]
        headings[0] += [(tr("ratio {level}").format(level=level), 1, 1) for level in range(1, ratio_levels + 1)]
        headings[0].append((tr("background"), 1, 1))
        groups: list[Group] = [
            (_leading(one, linked), [[*map(_two_digits, one.ratios), _two_digits(one.background_ratio)]])
            for one in findings
        ]
        return html_page.together([html_page.heading(tr("Windows")), html_page.grouped_table(headings, groups, 2)])
    headings = [
        [*((words, 1, 3) for words in windows), (tr("raster"), 1, 3), (tr("relative variance"), levels + 1, 1)],
        [(tr("detail, level"), levels, 1), (tr("background"), 1, 1)],
        [*((str(level), 1, 1) for level in range(1, levels + 1)), (str(levels), 1, 1)],
    ]
    rows = [
        (_leading(one, linked), list(_curve_rows(curves.get(one.window_id, ()), levels)) or [[""] * (levels + 2)])
        for one in findings
    ]
    return Html(html_page.heading(tr("Relative variances")) + html_page.grouped_table(headings, rows, 3))


def _leading(finding: WindowRecord, linked: Set[int]) -> list[object]:
    number = str(finding.window_id)
    return [html_page.link(number, anchor(finding.window_id)) if finding.window_id in linked else number,
            _character(finding)]


def _character(finding: WindowRecord) -> Markup:
    """What was found in a window, in two or three lines."""
    ratios = [
        template.format(ratio=ratios[0])
        for template, ratios in (
            (tr("ratio 1: {ratio:.2f}"), finding.ratios),
            (tr("composite: {ratio:.2f}"), finding.composite_ratios),
        )
        if ratios and ratios[0] is not None
    ]
    chip = html_page.chip(verdict_colour(finding.verdict), ", ".join([verdict_word(finding.verdict), *ratios]))
    known = []
    if finding.cause:
        known.append(tr("cause: {cause}").format(cause=cause_word(finding.cause)))
    if finding.observer:
        known.append(tr("observer: {word}").format(word=observer_word(finding.observer)))
    return html_page.lines(*filter(None, [chip, finding.reason, "; ".join(known)]))


def _curve_rows(curves: Sequence[CurveRecord], levels: int) -> Iterator[list[object]]:
    """Mosaic, sources, composite; shallower curves leave their last levels empty."""
    for role in _ROLES:
        for curve in curves:
            if curve.role == role:
                name: object = tr("hard-cut composite") if role == COMPOSITE else curve.raster
                if role == "mosaic":
                    name = Markup(f"<b>{html_page.text(curve.raster)}</b>")
                detail = [*map(_share, curve.detail), *[""] * (levels - len(curve.detail))]
                yield [html_page.lines(name), *detail, _share(curve.background)]


def _share(value: float) -> str:
    """Three decimals, as in the paper; two digits where they would all be 0."""
    if value != value:
        return ""
    return f"{value:.3f}" if value >= 0.001 or value == 0 else f"{value:.1e}"


def _two_digits(value: float | None) -> str:
    return "" if value is None else f"{value:.2f}"
