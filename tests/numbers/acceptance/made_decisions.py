"""Decisions whose every figure is known, made by hand: what stands on paper is held against them."""
from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from seam_inspector.plugin.acceptance.measure import acceptance_rules as rules
from seam_inspector.plugin.acceptance.measure.decision import (
    DecidedPiece,
    Decision,
    FailureRun,
    MetreFigures,
    Observers,
    PieceState,
    PlanOutcome,
    RuleOutcome,
)
from seam_inspector.plugin.acceptance.measure.delivery import DeliveredPiece, Delivery, SeenWindow
from seam_inspector.plugin.imagery.message import INFO, Message
from seam_inspector.plugin.imagery.statistics.agreement import agreement
from seam_inspector.plugin.imagery.statistics.intervals import Interval

UTM = (
    'PROJCS["WGS 84 / UTM zone 33N",GEOGCS["WGS 84",DATUM["WGS_1984",SPHEROID["WGS 84",6378137,298.257223563]],'
    'PRIMEM["Greenwich",0],UNIT["degree",0.0174532925199433],AUTHORITY["EPSG","4326"]],'
    'PROJECTION["Transverse_Mercator"],PARAMETER["latitude_of_origin",0],PARAMETER["central_meridian",15],'
    'PARAMETER["scale_factor",0.9996],PARAMETER["false_easting",500000],PARAMETER["false_northing",0],UNIT["metre",1],'
    'AUTHORITY["EPSG","32633"]]'
)
PIECE_M = 25.0
SAID = Message("{words}", INFO)
LEFT, RIGHT = "0412_ortho.tif", "0413_ortho.tif"


def delivered(
    sheets: Sequence[str] = ("sheet_1",), pieces: int = 40, failed: Sequence[tuple[int, int]] = (), names: str = "",
) -> Decision:
    """Sheets side by side, each with one seam of ``pieces`` pieces of 25 m from south to north; ``failed``: sheet and
    piece by their numbers, in any order; what follows each other is one failure."""
    made = []
    for number, sheet in enumerate(sheets):
        for place in range(pieces):
            x, y = 500000.0 + 100 * number, 5500000.0 + PIECE_M * place
            ys = y + np.linspace(0, PIECE_M, 6)
            line = np.column_stack([x + 4 * np.sin(ys / 20), ys])
            has_failed = (number, place) in failed
            made.append(DeliveredPiece(
                len(made), sheet, "1", PIECE_M * place, PIECE_M, 0.45 if has_failed else 0.97,
                0.4 if has_failed else 0.9, 0.5 if has_failed else 1.04, 2.5 if has_failed else 0.0,
                "significant" if has_failed else "preserved", "", line, names or LEFT, RIGHT, "2019-07-04",
                "2019-08-11",
            ))  # fmt: skip
    return decided(made, [number * pieces + place for number, place in failed])


def decided(
    pieces: Sequence[DeliveredPiece], failed: Sequence[int], windows: Sequence[SeenWindow] = (),
    plan: PlanOutcome | None = None, observers: Observers | None = None,
) -> Decision:
    """The decision by a share of 2 % and a run of 50 m; ``failed``: the pieces' numbers."""
    runs = _runs(sorted(failed), pieces)
    of_run = {number: run.number for run in runs for number in run.pieces}
    own = tuple(
        DecidedPiece(
            one, PieceState.FAILED if one.number in of_run else PieceState.PASSED, False, of_run.get(one.number), True,
            tuple(windows) if one.number in of_run else (),
        )
        for one in pieces
    )
    delivery = Delivery(tuple(pieces), UTM, 1.0, tuple(windows))
    whole = _figures("", own, runs)
    sheets = tuple(_figures(name, [one for one in own if one.piece.sheet == name], runs) for name in delivery.sheets)
    share, run = whole.failed_share or 0.0, runs[0].length_m if runs else 0.0
    outcomes = (
        RuleOutcome(rules.FAILED_SHARE, share, 0.02, False, share <= 0.02, "Contract 12/2026, § 7",
                    SAID(words=f"{100 * share:.2f} % of the metres failed.")),
        RuleOutcome(rules.LONGEST_FAILURE, run, 50.0, False, run <= 50, "Contract 12/2026, § 7",
                    SAID(words=f"The longest failure has {run:.0f} m.")),
        RuleOutcome(rules.MEASURED_SHARE, 1.0, 0.9, True, True, "Seam Inspector", SAID(words="All was measured.")),
    )  # fmt: skip
    accepted = all(one.passed for one in outcomes)
    return Decision(
        accepted, (SAID(words=f"The delivery is {'accepted' if accepted else 'rejected'}."),
                   *(one.sentence for one in outcomes)),
        rules.AcceptanceRules("share and run", 0.7, "Pyka 2010", ()), delivery, outcomes, whole, sheets,
        Interval(share, max(share - 0.01, 0), share + 0.01), own, runs, plan, observers,
    )  # fmt: skip


def seen_by_two() -> Observers:
    """Eight of ten alike."""
    words = [("visible", "visible")] * 4 + [("invisible", "invisible")] * 4 + [("visible", "invisible")] * 2
    return Observers(agreement(words), agreement(words[:8]))


def _runs(failed: Sequence[int], pieces: Sequence[DeliveredPiece]) -> tuple[FailureRun, ...]:
    groups: list[list[int]] = []
    for number in failed:
        follows = groups and groups[-1][-1] == number - 1 and pieces[number].sheet == pieces[number - 1].sheet
        if follows:
            groups[-1].append(number)
        else:
            groups.append([number])
    groups.sort(key=lambda group: -sum(pieces[number].length_m for number in group))
    return tuple(
        FailureRun(
            place, sum(pieces[number].length_m for number in group), tuple(group),
            tuple(dict.fromkeys(pieces[number].sheet for number in group)), pieces[group[len(group) // 2]].middle,
        )
        for place, group in enumerate(groups, 1)
    )  # fmt: skip


def _figures(name: str, pieces: Sequence[DecidedPiece], runs: Sequence[FailureRun]) -> MetreFigures:
    total = sum(one.piece.length_m for one in pieces)
    failed = [one for one in pieces if one.state is PieceState.FAILED]
    own = [run.length_m for run in runs if any(one.run == run.number for one in pieces)]
    lost = sum(one.piece.length_m for one in failed)
    return MetreFigures(name, len(pieces), len(failed), total, total, lost, 0.0, max(own, default=0.0))
