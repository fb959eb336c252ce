"""REPORT: the decision on paper, which an officer signs. One HTML page that prints on A4."""
from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np
from matplotlib.figure import Figure

from ...imagery.rasters import Raster
from ...imagery.seam_totals import PieceState
from ...toolkit.charts.chart_style import PAPER
from ...toolkit.charts.figure_files import new_figure, svg_text
from ...toolkit.pages.templates import save_page
from ...toolkit.pictures import encoded
from ...toolkit.translation import band_title, filled, formatted, sentence, shown_number, tr
from ..measure.acceptance_rules import KEPT, LONGEST_FAILURE
from ..measure.decision import AcceptanceOutcome, Decision, Defect, MetreFigures, Unmeasured
from ..measure.delivery import DeliveredPiece
from ..measure.seen_ground import SeenGround, place_words
from .decision_map import MAP_PX, STATE_COLOURS, decision_map
from .defect_files import CUT_PANEL, MOSAIC_PANEL, DefectPicture
from .inspection_record import InspectionRecord, file_name, how_measured
from .paper_head import head_rows
from .words import (
    CHECKS,
    NOTHING,
    QUALITY_STANDARDS,
    SHEET_COLOURS,
    failing_sentence,
    jnd_words,
    metres,
    outcome_limit,
    outcome_title,
    outcome_value,
    outcome_word,
    share,
    share_beside,
    sheet_word,
)

MOST_ROWS = 300  # most rows of the table of failures, the longest first
MOST_FILES = 1000  # listed with their dates or digests: some 25 pages
_PROOF_QUALITY = 95  # of a JPEG: what is shown is the finest detail
OUTCOME_STATES = {
    AcceptanceOutcome.ACCEPTED: "good", AcceptanceOutcome.REJECTED: "bad", AcceptanceOutcome.UNDECIDED: "open",
}  # fmt: skip
"""How the decision looks on the page."""
_PALE = "59"  # opacity of a sheet's colour
_PROFILE_INCHES = (2.2, 1.75)  # beside the pictures of a failure
_BAND_KEPT = 0.9  # the scan's band: less is kept in it
_WIDEST = 39.9  # of the judged strip: the widest feather that a scan tells
_MOST_KEPT = 1.3  # beyond it nothing is of interest


def save_acceptance_report(path: Path, record: InspectionRecord, pictures: Mapping[int, DefectPicture]) -> None:
    """Write the page; ``pictures`` by the failures' numbers. Raises SettingsError where no file can be."""
    decision, defects = record.decision, record.defects
    sources = list(dict.fromkeys([decision.rules.kept_source, *(outcome.source for outcome in decision.outcomes)]))
    sheet_words = [sheet_word(outcome, figures) for figures, outcome in zip(decision.sheets, decision.sheet_outcomes)]
    parts = [*_parts(decision)]
    texts = [_defect_text(defect, decision.rules.least_kept) for defect in defects[:MOST_ROWS]]
    is_undecided = decision.outcome is AcceptanceOutcome.UNDECIDED
    save_page(
        path,
        "acceptance",
        how_measured(record),
        title=record.title,
        decided=decision,
        head=[*head_rows(record.head)],
        verdict=_verdict(decision, parts),
        advice=sentence(decision.sentences[1]) if is_undecided else "",
        failing=failing_sentence(decision),
        judged=_judged_bands(record.mosaics),
        parts=parts,
        sentences=[sentence(words) for words in decision.sentences[1 + is_undecided :]],
        rules=[*_rule_rows(decision, sources)],
        sources=sources,
        sheets=[_sheet_row(*row) for row in zip(decision.sheets, sheet_words)],
        is_each_judged=all(sheet_words),
        whole=_sheet_row(decision.whole, "") if len(decision.sheets) > 1 else None,
        map=decision_map(decision, defects[:MOST_ROWS]),
        map_px=MAP_PX,
        map_legend=_legend(decision),
        defects=texts,
        unknown=[*_unknown_rows(decision)],
        has={name for name in ("words", "images", "band", "visibility") if any(text[name] for text in texts)},
        pictures=[*_pictures(texts, defects, pictures, decision.rules.least_kept)],
        layers=record.seams,
        images=record.images,
        most_files=MOST_FILES,
        standards=[*([] if decision.plan is None else [decision.plan.plan.standard]), *QUALITY_STANDARDS],
    )  # fmt: skip


def _verdict(decision: Decision, parts: Sequence[tuple[str, str, str, bool]]) -> tuple[str, str, str, str]:
    """A state, what is decided, why, and what came of the other parts; green is a delivery without any finding."""
    seams = filled(tr("Seams: {verdict}"), verdict=outcome_title(decision.outcome))
    others = " ".join(f"{_capital(name)}: {word}." for name, word, _, _ in parts[-2:])
    has_findings = any(speaks_against for _, _, _, speaks_against in parts[1:])
    state = "open" if has_findings and decision.accepted else OUTCOME_STATES[decision.outcome]
    return state, seams, f"{_capital(sentence(decision.foremost))}.", others


def _capital(words: str) -> str:
    return words[:1].upper() + words[1:]


def _judged_bands(mosaics: Sequence[Raster]) -> str:
    """The bands whose luminance was judged, or the band, and those that were not; empty where no mosaic is given."""
    if not mosaics:
        return ""
    names = mosaics[0].band_names
    judged = [name for name in ("red", "green", "blue") if name in names] if mosaics[0].has_luminance else names[:1]
    others = [band_title(name) for name in names if name not in judged]
    words = tr("Judged in the luminance of the bands {bands}") if len(judged) > 1 else tr("Judged in the band {bands}")
    words = filled(words, bands=", ".join(map(band_title, judged)))
    return words + (filled(tr("; not judged: {bands}"), bands=", ".join(others)) if others else "") + "."


def _parts(decision: Decision) -> Iterator[tuple[str, str, str, bool]]:
    """What of the delivery was checked, what came of it, in figures, and whether it speaks against the delivery; the
    files and radiometry last."""
    count, faulty, whole = len(decision.sheets), len(decision.delivery.findings), decision.whole
    words = tr("failed: {failed} of {length} that were measured")
    if whole.failed_unclear_m:
        words += tr(", of which {near} surely lost detail, and more than allowed by the best estimate")
    words += tr("; failures: {count}, in sheets: {sheets} of {all}") if whole.failed_m else ""
    failures = filled(words, failed=metres(whole.failed_m), length=metres(whole.measured_m), count=len(decision.runs),
        all=count, near=metres(whole.failed_unclear_m), sheets=sum(sheet.failed_count > 0 for sheet in decision.sheets))
    if alone := decision.sheet_outcomes.count(AcceptanceOutcome.REJECTED):
        failures += filled(tr("; sheets rejected by themselves: {count}"), count=alone)
    if decision.accepted and (alone := decision.sheet_outcomes.count(AcceptanceOutcome.UNDECIDED)):
        failures += filled(tr("; sheets undecided by themselves: {count}"), count=alone)
    yield tr("seams"), outcome_title(decision.outcome), failures, decision.accepted is not True
    if whole.not_measured_m:
        yield tr("seams that were not measured"), metres(whole.not_measured_m), _unmeasured(decision), False
    yield _cover_part(decision)
    yield from _ground_parts(decision)
    name = tr("completeness and form of the files")
    if decision.delivery.is_checked:
        words = filled(tr("sheets with findings: {count} of {all}"), count=faulty, all=count)
        result = filled(tr("{count} {count:finding|findings}"), count=faulty) if faulty else tr("No findings")
        yield name, result, words, faulty > 0
    else:
        yield name, tr("Not checked"), tr("'Check a delivery' checks it"), False
    yield tr("radiometry"), tr("Not checked"), tr("'Check radiometry' checks it"), False


def _unmeasured(decision: Decision) -> str:
    """Why pieces were not measured, those of most metres first."""
    words = {
        Unmeasured.ROUGH: tr("what is kept is known too roughly"),
        Unmeasured.UNCOVERED: tr("an orthoimage ends there, or was not given"),
        Unmeasured.UNEXPLAINED: tr("the orthoimages do not explain the mosaic: changed, others, or too little texture"),
        Unmeasured.SHORT: tr("too short to be measured"),
        Unmeasured.OTHER: tr("not enough to measure it without orthoimages, or these can't be read any more"),
    }  # fmt: skip
    lengths = {why: math.fsum(decided.piece.length_m for decided in decision.pieces if decided.unmeasured is why)
               for why in words}
    reasons = sorted(filter(lengths.get, words), key=lambda why: -lengths[why])
    return "; ".join(f"{metres(lengths[why])}: {words[why]}" for why in reasons)


def _cover_part(decision: Decision) -> tuple[str, str, str, bool]:
    """Whether the orthoimages are given, show both sides of the seams and hold no mosaic, as far as that is known."""
    name, is_reason = tr("orthoimages along the seams"), decision.accepted is not True
    ground = SeenGround.of_delivery(decision.delivery)
    if mixed_m := ground.total("mixed_metres"):
        words = filled(tr("the mosaic is mixed into them along {metres} of seam, such as at {place}"),
            metres=metres(mixed_m), place=ground.place("mixed_at", "mixed_metres"))
        return name, tr("With findings"), words, is_reason
    if hidden := [decided for decided in decision.pieces if decided.blank_m]:
        words = filled(tr("missing, without pixels or not explaining the mosaic along {metres} of seam, such as at "
            "{place}; to be given by the producer"), metres=metres(sum(decided.blank_m for decided in hidden)),
            place=place_words(max(hidden, key=lambda decided: decided.blank_m).piece.middle))
        return name, tr("With findings"), words, is_reason
    if names := ", ".join(decision.delivery.not_given):
        return name, tr("With findings"), filled(tr("not given: {names}"), names=names), is_reason
    lacks = not decision.delivery.files.cover or any(piece.unmeasured is Unmeasured.OTHER for piece in decision.pieces)
    return (name, tr("No findings"), "", False) if not lacks else (
        name, tr("Not checked"), tr("none were given, or their files can't be read"), False)


def _ground_parts(decision: Decision) -> Iterator[tuple[str, str, str, bool]]:
    """What the scans saw of the ground, beside the seams that are judged."""
    ground, judged = SeenGround.of_delivery(decision.delivery), decision.whole.total_m
    names = (
        tr("seams given and found"), tr("ground that matches no orthoimage"), tr("no data within the mosaic's outline"),
    )  # fmt: skip
    if not ground.is_known or decision.delivery.is_part:
        for name in names:
            yield name, tr("Not checked"), tr("not stated in the layers of seams"), False
        return
    unseen, unchanged = ground.total("unseen_metres"), ground.total("unchanged_metres")
    unexplained, nodata = ground.most("unexplained"), ground.most("nodata_inside")
    is_given = any("given" in scan.get("seams", "") for scan in ground.scans)
    words = filled(tr("given: {judged}") if is_given else tr("found: {judged}"), judged=metres(judged))
    if apart := unseen + unchanged:
        words += filled(tr("; found and not given: {unseen}, given and not found: {unchanged}") if is_given else (
            tr("; borders without a measured seam: {unseen}")
        ), unseen=metres(unseen), unchanged=metres(unchanged))
    for name, figure, figures, place in (
        (names[0], apart, words, ground.place("unseen_at", "unseen_longest")),
        (names[1], unexplained, filled(tr("{share} of the ground with texture"), share=share(unexplained, 1)),
         ground.place("unexplained_at", "unexplained")),
        (names[2], nodata, share(nodata, 1), ground.place("nodata_at", "nodata_inside")),
    ):
        where = filled(tr("; most of it around {place}"), place=place) if place else ""
        is_reason = decision.accepted is not True and figure > 0 and name in names[not is_given : 2]
        yield name, tr("With findings") if figure > 0 else tr("No findings"), figures + where, is_reason


def _rule_rows(decision: Decision, sources: Sequence[str]) -> Iterator[tuple[str, str, str, int, str, bool, str]]:
    """The limit of a piece first, then the rules that decide: name, value, limit, which of the notes tells where that
    comes from, result, whether it is a reason not to accept the delivery, and why it can't be told."""
    limit = decision.rules.least_kept
    yield (
        tr(CHECKS[KEPT].title), share_beside(decision.whole.least_kept, limit),
        filled(tr("at least {least} in each piece"), least=share_beside(limit, limit)),
        1 + sources.index(decision.rules.kept_source), tr("says which pieces fail"), False, "",
    )
    joined_m = max((run.joined_m for run in decision.runs), default=0.0)
    for outcome in decision.outcomes:
        value = outcome_value(outcome)
        if outcome.check == LONGEST_FAILURE and outcome.value and metres(joined_m) != metres(outcome.value):
            value += filled(tr("; with those that meet {joined}"), joined=metres(joined_m))
        yield (
            tr(CHECKS[outcome.check].title), value, outcome_limit(outcome),
            1 + sources.index(outcome.source), outcome_word(outcome), outcome.passed is not True,
            _capital(sentence(outcome.sentence)) if outcome.passed is None and outcome.low != outcome.high and (
                outcome.sentence != decision.foremost) else "",
        )  # fmt: skip
    for check in map(CHECKS.__getitem__, decision.rules.unlimited):
        figure = check.figure(decision.whole)
        value = NOTHING if figure is None else formatted(check.scale * figure, f".{check.decimals}f") + check.unit
        yield tr(check.title), value, tr("no limit"), 0, tr("does not decide"), False, ""


def _sheet_row(figures: MetreFigures, word: str) -> list[str]:
    if not figures.piece_count:
        return [figures.name, word, metres(0.0), *[NOTHING] * 6]
    return [
        figures.name or tr("all"), word, metres(figures.total_m), share(figures.measured_share, 1),
        metres(figures.failed_m), share(figures.failed_share), metres(figures.longest_failure_m),
        f"{figures.failed_count} / {figures.piece_count}", metres(figures.unclear_m),
    ]  # fmt: skip


def _legend(decision: Decision) -> list[tuple[str, str]]:
    words = {
        PieceState.FAILED: tr("pieces that failed"), PieceState.PASSED: tr("pieces that passed"),
        PieceState.NOT_MEASURED: tr("pieces not measured"), PieceState.NO_DETAIL: tr("ground without detail"),
    }  # fmt: skip
    present = {decided.state for decided in decision.pieces}
    entries = [(STATE_COLOURS[state], word) for state, word in words.items() if state in present]
    if len(decision.sheets) > 1:
        sheets = zip(decision.sheets, decision.sheet_outcomes)
        colours = {sheet_word(outcome, figures): SHEET_COLOURS[outcome] for figures, outcome in sheets}
        entries += [
            (colour + _PALE, filled(tr("sheet: {verdict}"), verdict=word)) for word, colour in colours.items() if word
        ]
    return entries


def _defect_text(defect: Defect, least_kept: float) -> dict[str, Any]:
    """A failure in words: ``images`` are the two orthoimages, each with its date; ``pieces`` what each of its pieces
    kept, as the decision took it."""
    piece = defect.worst.piece
    kept = share_beside(piece.kept_1, least_kept)
    if piece.kept_low is not None and piece.kept_high is not None:
        kept += f" ({shown_number(100 * piece.kept_low, 0)} - {shown_number(100 * piece.kept_high, 0)})"
    sides = ((piece.left_source, piece.left_date), (piece.right_source, piece.right_date))
    across, up = np.subtract(defect.pieces[-1].piece.middle, defect.pieces[0].piece.middle)
    ends = {"west": across, "east": -across, "south": up, "north": -up}
    unclear_m = math.fsum(decided.piece.length_m for decided in defect.pieces if decided.is_unclear)
    cause, remark = tr(defect.cause) if defect.cause else "", "; ".join(defect.remarks)
    return {
        "number": defect.run.number,
        "sheets": ", ".join(defect.run.sheets),
        "length": metres(defect.run.length_m),
        "kept": kept,
        "begins": max(ends, key=ends.__getitem__) if len(defect.pieces) > 1 else "",
        "pieces": ", ".join(share_beside(decided.piece.kept_1, least_kept) for decided in defect.pieces),
        "unclear": filled(tr("{length} unclear"), length=metres(unclear_m)) if unclear_m else "",
        "band": _band_words(piece),
        "visibility": jnd_words(piece.visibility),
        "words": "; ".join(filter(None, (cause, remark))),
        "images": [(file_name(name) or day, day if name != day else "") for name, day in sides if name or day],
        "place": [formatted(along, ".1f") for along in defect.run.place],
    }


def _band_words(piece: DeliveredPiece) -> str:
    """Width of a piece's band; a lower bound where its curve, or its feather, does not end as far as it is known."""
    if piece.band_width_m is None:
        return ""
    strip_m = piece.profile[0].far_m if piece.profile else math.inf
    beyond = [step.kept for step in piece.profile[1:] if step.far_m > strip_m]
    is_open = (bool(beyond) and max(beyond) < _BAND_KEPT) or (piece.feather_width_m or 0.0) > _WIDEST * strip_m
    return filled(tr("at least {least}") if is_open else "{least}", least=metres(piece.band_width_m))


def _unknown_rows(decision: Decision) -> Iterator[list[str]]:
    """Rows of pieces that were not measured, with the places where they lie, the longest first."""
    for run in decision.unknown_runs[:MOST_ROWS]:
        pieces = [decision.pieces[number] for number in run.pieces]
        failed = sum(decided.piece.length_m for decided in pieces if decided.state is PieceState.FAILED)
        place = " ".join(formatted(along, ".1f") for along in run.place)
        yield [", ".join(run.sheets), metres(run.length_m), metres(failed), place]


def _pictures(
    texts: Sequence[Mapping[str, Any]], defects: Sequence[Defect], pictures: Mapping[int, DefectPicture],
    least_kept: float,
) -> Iterator[dict[str, Any]]:
    """The failures that are shown: where each lies, its worst piece pixel by pixel, and what that kept."""
    titles = {MOSAIC_PANEL: tr("The mosaic"), CUT_PANEL: tr("Its orthoimages, cut hard")}
    for text, defect in zip(texts, defects):
        piece = defect.worst.piece
        if (picture := pictures.get(text["number"])) is not None:
            dates, across = dict(text["images"]), metres(picture.side_m)
            yield {
                "text": text,
                "profile": svg_text(_profile_figure(piece, least_kept)) if piece.profile else "",
                "around": encoded(picture.around, "JPEG"),
                "columns": picture.around.shape[1],
                "kinds": [panel.kind for panel in picture.panels],
                "shown": filled(tr("{across} across") if picture.is_whole else tr("a part of it, {across} across"),
                    across=across),
                "panels": [
                    (encoded(panel.pixels, "JPEG", _PROOF_QUALITY), panel.pixels.shape[1],
                     titles.get(panel.kind) or _image_title(panel.name, dates))
                    for panel in picture.panels
                ],
            }  # fmt: skip


def _image_title(name: str, dates: Mapping[str, str]) -> str:
    day = dates.get(name) or dates.get(name.rpartition(".")[0], "")
    return filled(tr("Orthoimage {name}"), name=f"{name} ({day})" if day else name)


def _profile_figure(piece: DeliveredPiece, least_kept: float) -> Figure:
    """What a piece kept by distance from its seam, as its scan wrote it: the judged strip, the curve, the limit."""
    strip, *steps = piece.profile
    figure = new_figure(*_PROFILE_INCHES)
    axes = figure.add_subplot()
    axes.axvspan(0, strip.far_m, color=PAPER.grid, linewidth=0)
    axes.axhline(least_kept, color=PAPER.limit, linewidth=1)
    axes.plot(*np.array([(x, step.kept) for step in steps for x in (step.near_m, step.far_m)]).reshape(-1, 2).T,
              color=PAPER.sources[0], linewidth=1.2)
    axes.plot([0, strip.far_m], [strip.kept] * 2, color=PAPER.text, linewidth=2.5, solid_capstyle="butt")
    farthest = max((step.far_m for step in steps), default=strip.far_m)
    axes.set_xscale("function", functions=(lambda x: np.sqrt(np.maximum(x, 0)), np.square))  # narrow steps matter most
    axes.set_xlim(0, farthest)
    axes.set_xticks([strip.far_m, farthest / 4, farthest])
    axes.xaxis.set_major_formatter(lambda x, _: formatted(x, ".2g"))
    axes.minorticks_off()
    axes.set_ylim(0, max(_MOST_KEPT, *(step.kept for step in piece.profile)))
    axes.set_xlabel(tr("distance from the seam (m)"), fontsize=6.5)
    axes.tick_params(labelsize=6.5)
    axes.spines[["top", "right"]].set_visible(False)
    return figure
