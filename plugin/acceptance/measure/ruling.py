"""Figures held against the rules: what keeps a rule, breaks it or leaves it open, and what would decide it then.

A rule is kept or broken where nothing that is not known could turn it round:

- Of metres that orthoimages hide nobody knows, nor of others that are more than the rules allow: a share is too large
  only with all of them sound, and kept with all of them lost. Those whose intervals are too wide to count fail as
  likely as these say. Ground without detail has nothing to lose and is no part of any share.
- Pieces count by what they kept, also those whose interval holds the limit, and failures by whole pieces, though they
  end inside of these. Where the limit of a sum lies within what that leaves open, it can't be told.
- A row of pieces that were not measured may be a failure: longer than one may be, it leaves that rule open. So does a
  piece that passed and is much longer than a failure may be: it can hold one and keep enough as a whole.
"""
from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Optional

from ...imagery.errors import Message, Stated
from ...imagery.seam_totals import PieceState
from . import messages
from .acceptance_rules import FAILED_SHARE, LONGEST_FAILURE, MEASURED_SHARE, AcceptanceRule, AcceptanceRules
from .decision import DecidedPiece, MetreFigures, RuleOutcome, Unmeasured
from .delivery import typical_m
from .measured_pieces import (
    ends_within,
    known_within,
    measured_with,
    roughly_failed_m,
    surely_failed_m,
)
from .seen_ground import place_words

MOST_AT_ENDS = 0.2
"""Share of the metres that may fail, which the ends of failures inside of pieces may leave open: with more the pieces
are too coarse, as nothing above 1.25 times the allowed share is to be accepted nor below 0.8 times rejected."""
MOST_OF_RUN = 1.5
"""Times the longest failure that is allowed: how long a piece of a scan with such a PIECE may be. A longer one averages
a failure with what is sound beside it. Where no piece may fail its length does not matter."""
_SPARE = 0.05  # of the metres, by which forecasts of what will be measured may be too large


@dataclass(frozen=True, eq=False)
class Ruling:
    """Figures that are held against the rules."""

    figures: MetreFigures
    pieces: Sequence[DecidedPiece]
    failures: Sequence[DecidedPiece]  # those of its failures, each in the order of its row
    rules: AcceptanceRules

    def outcomes(self) -> list[RuleOutcome]:
        """Outcomes of the rules in their order, those of sampling apart."""
        return [self._outcome(rule) for rule in self.rules.rules]

    def _outcome(self, rule: AcceptanceRule) -> RuleOutcome:
        figures = self.figures
        if not figures.measured_m:
            value = figures.measured_share if rule.check == MEASURED_SHARE else None
            nothing = messages.NOTHING_WAS_MEASURED()
            return RuleOutcome(rule.check, value, rule.limit, rule.is_least, None, rule.source, nothing)
        value = low = high = figures.measured_share
        if rule.check != MEASURED_SHARE:
            value, low, high = self._failed() if rule.check == FAILED_SHARE else self._longest()
        passes = {rule.passes(low), rule.passes(high)}
        passed = passes.pop() if len(passes) == 1 else None
        if rule.check == MEASURED_SHARE:  # with less the delivery is neither good nor bad
            passed = passed or None
        sentence = self._sentence(rule, passed, value, low, high)
        return RuleOutcome(rule.check, value, rule.limit, rule.is_least, passed, rule.source, sentence, low, high)

    def _failed(self) -> tuple[float, float, float]:
        """The share, and between what it may lie with all that is not known."""
        figures, least_kept = self.figures, self.rules.least_kept
        likely_m = figures.failed_m + roughly_failed_m(self.pieces, least_kept)
        within, blank_m = self._within, self._blank_m
        hidden_m = math.fsum(decided.blank_m for decided in self.pieces if decided.state is PieceState.PASSED)
        known_m = figures.measured_m - hidden_m + self._unmeasured_m(Unmeasured.ROUGH)
        low, high = max(likely_m - within, 0.0), min(likely_m + within, known_m) + blank_m
        value = figures.failed_m / figures.measured_m
        return value, min(low / (known_m + blank_m), value), max(high / (known_m + blank_m), value)

    def _unmeasured_m(self, *why: Unmeasured) -> float:
        return math.fsum(decided.piece.length_m for decided in self.pieces if decided.unmeasured in why)

    @cached_property
    def _blank_m(self) -> float:
        """Metres that were not measured and may all have failed: those that the producer's orthoimages hide, and the
        rest where that is more than the rules leave to chance."""
        least = self.rules.rule(MEASURED_SHARE)
        is_enough = least is None or least.passes(self.figures.measured_share)
        others = 0.0 if is_enough else self._unmeasured_m(Unmeasured.SHORT, Unmeasured.OTHER)
        return math.fsum(decided.blank_m for decided in self.pieces) + others

    @cached_property
    def _within(self) -> float:
        """Half the 95 % interval of the metres that failed, where something is known of them; m."""
        return math.hypot(known_within(self.pieces, self.rules.least_kept), self._open_ends)

    def _longest(self) -> tuple[float, float, float]:
        """What passed ends it, also where its interval holds the limit; what was not measured may be part of it."""
        longest, failures = self.figures.longest_failure_m or 0.0, dict[Optional[int], list[DecidedPiece]]()
        for decided in self.failures:
            failures.setdefault(decided.run, []).append(decided)
        sure = max((surely_failed_m(run, self.rules.least_kept) for run in failures.values()), default=0.0)
        return longest, min(sure, longest), max(longest, self.figures.longest_unknown_m, self._hiding_m)

    @cached_property
    def _hiding_m(self) -> float:
        """Length of the longest piece that passed, where it can hide a failure longer than one may be, else 0; m."""
        limit = self.rules.limit(LONGEST_FAILURE)
        passed = (decided.piece.length_m for decided in self.pieces if decided.state is PieceState.PASSED)
        longest = max(passed, default=0.0)
        return longest if limit is not None and 0 < MOST_OF_RUN * limit < longest else 0.0

    @cached_property
    def _open_ends(self) -> float:
        """What the ends of failures leave open, where that is much of what may fail; m."""
        within = ends_within(self.pieces)
        return within if within > MOST_AT_ENDS * self._allowed_m() else 0.0

    def _allowed_m(self) -> float:
        return (self.rules.limit(FAILED_SHARE) or 0.0) * self.figures.measured_m

    def _sentence(self, rule: AcceptanceRule, passed: bool | None, value: float, low: float, high: float) -> Message:
        limit, shown = Stated(rule.limit), Stated(value, rule.limit) if passed is False else value
        if rule.check == MEASURED_SHARE:
            return messages.MEASURED(value=value, limit=limit)
        if passed is not None:
            return messages.SHARE_FAILED(value=shown, limit=limit) if rule.check == FAILED_SHARE else (
                messages.RUN_FAILED(value=shown, limit=limit)
            )
        if rule.check == FAILED_SHARE and self._blank_m > self._within:
            return messages.SHARE_UNKNOWN(value=value, limit=limit, metres=self._blank_m, high=high)
        if rule.check == FAILED_SHARE:
            return messages.SHARE_OPEN(value=value, limit=limit, low=low, high=high)
        if not rule.passes(value):
            return messages.RUN_OPEN(value=value, limit=limit, low=low, high=high)
        return messages.RUN_IN_PIECE(value=value, limit=limit, metres=high) if high == self._hiding_m else (
            messages.RUN_UNKNOWN(value=value, limit=limit, metres=high)
        )

    def advice(self, outcomes: Sequence[RuleOutcome], is_part: bool, has_sources: bool) -> Message | None:
        """What would decide most of what is open; None for nothing. ``is_part``: whether the pieces are a sample;
        ``has_sources``: whether they were measured against orthoimages."""
        figures, is_open = self.figures, {outcome.check: outcome for outcome in outcomes if outcome.passed is None}
        if is_part and LONGEST_FAILURE in is_open:
            return messages.WOULD_GIVE_SCAN()
        if not figures.judged_m:
            return messages.WOULD_LOOK()
        longest = is_open.get(LONGEST_FAILURE)
        share = self.rules.rule(FAILED_SHARE) if FAILED_SHARE in is_open else None
        is_short = longest is not None and (longest.value or 0.0) <= longest.limit
        if MEASURED_SHARE not in is_open and longest is not None and is_short and self._hiding_m:
            return messages.WOULD_CUT(piece=Stated(longest.limit / 2))
        is_blank = share is not None and self._blank_m > self._within
        if is_blank or (figures.not_measured_m and (MEASURED_SHARE in is_open or not figures.measured_m or is_short)):
            return self._would_measure(has_sources, MEASURED_SHARE in is_open)
        within = self._open_ends
        if share is not None and within > known_within(self.pieces, self.rules.least_kept):
            piece = typical_m(decided.piece for decided in self.pieces)
            return messages.WOULD_SHORTEN(piece=piece, within=within, allowed=self._allowed_m())
        if (count := sum(decided.is_unclear for decided in self.pieces)) and is_open:
            return messages.WOULD_TELL_APART(count=count, metres=figures.unclear_m)
        return None

    def _would_measure(self, has_sources: bool, is_little: bool) -> Message:
        """The true orthoimages; else a length of pieces that would measure as much as is wanted and hides no failure,
        else what remains. ``is_little``: whether less was measured than the rules ask for."""
        least, lacking, blank_m = self.rules.limit(MEASURED_SHARE) or 0.0, self.figures.not_measured_m, self._blank_m
        run, failed, every_m = self.rules.rule(LONGEST_FAILURE), self.figures.failed_m, self.figures.judged_m
        may_fail = self.rules.limit(FAILED_SHARE) or 0.0
        wanted = max(least * every_m - self.figures.measured_m, blank_m - max(may_fail * every_m - failed, 0.0))
        needed = least + _SPARE if is_little else 1 - may_fail + (failed - lacking + blank_m) / every_m
        if run is not None and not run.passes(self.figures.longest_unknown_m):
            wanted, needed = lacking, max(needed, 1 - run.limit / every_m)  # no row of it may be a failure
        if not has_sources:
            return messages.WOULD_MEASURE_ALONE(wanted=wanted, lacking=lacking)
        hidden = [decided for decided in self.pieces if decided.blank_m]
        if hidden and 2 * (metres := math.fsum(decided.blank_m for decided in hidden)) >= wanted:
            return messages.WOULD_GIVE_COVER(metres=metres, place=place_words(hidden[0].piece.middle))
        typical, longest = typical_m(each.piece for each in self.pieces), (run.limit if run else 0.0) / 2 or math.inf
        for piece in (min(round(times * typical), longest) for times in (2, 4)):
            share = measured_with(self.pieces, self.rules.least_kept, piece)
            if piece > typical and share >= min(needed, 1.0):
                return messages.WOULD_MEASURE(piece=Stated(piece), share=share)
        return messages.WOULD_LOOK_THERE(wanted=wanted, lacking=lacking)
