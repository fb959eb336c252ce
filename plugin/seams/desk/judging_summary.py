"""What an operator's verdicts come to once the last window is judged."""
from __future__ import annotations

from collections.abc import Sequence

from ...imagery.statistics import DECIDED, INVISIBLE, UNSURE, VISIBLE, Operator
from ...toolkit.translation import filled, tr
from ..measure.window_records import WindowRecord
from ..words import CLAIMS


def counts_words(windows: Sequence[WindowRecord], operator: Operator) -> str:
    """How many were judged, and what was said of them."""
    said = [getattr(row, operator.observer) for row in windows]
    shares = {word: said.count(word) for word in (VISIBLE, INVISIBLE, UNSURE)}
    text = tr("All windows are judged: {visible} visible, {invisible} invisible, {unsure} not sure.")
    return filled(text, visible=shares[VISIBLE], invisible=shares[INVISIBLE], unsure=shares[UNSURE])


def tool_words(windows: Sequence[WindowRecord], operator: Operator) -> str:
    """How often the tool says so too; empty where both said something of none."""
    pairs = [
        (getattr(row, operator.observer) == VISIBLE, row.verdict == "significant") for row in windows
        if getattr(row, operator.observer) in DECIDED and row.verdict in CLAIMS
    ]  # fmt: skip
    same, vain = sum(seen == found for seen, found in pairs), sum(found and not seen for seen, found in pairs)
    text = tr("The tool agrees on {same} of {count}.")
    if same < len(pairs):
        text = tr("The tool agrees on {same} of {count}. Called significant and not seen: {vain}; seen and not called "
                  "so: {missed}.")
    missed = len(pairs) - same - vain
    return filled(text, same=same, count=len(pairs), vain=vain, missed=missed) if pairs else ""
