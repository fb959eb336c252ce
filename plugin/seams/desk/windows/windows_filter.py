"""Windows filtered by their kind, by words, or by QGIS's expressions: ``kept_1 < 0.7 and cause = 'feathering'``."""
from __future__ import annotations

import re
from collections.abc import Callable
from functools import cache, partial
from operator import attrgetter

from qgis.core import (
    QgsExpression,
    QgsExpressionContext,
    QgsExpressionContextUtils,
    QgsFeatureRequest,
    QgsVectorLayer,
)
from qgis.PyQt.QtCore import Qt
from qgis.PyQt.QtWidgets import QComboBox, QSizePolicy, QWidget

from ....imagery.errors import SettingsError
from ....imagery.statistics import FIRST, UNSURE, VISIBLE
from ....toolkit.translation import tr
from ...measure import messages
from ...measure.window_records import WindowRecord
from ...words import CLAIMS, VERDICTS, cause_word, observer_word, verdict_word
from .window_columns import verdict_chip

Test = Callable[[WindowRecord], bool]
_EXPRESSION = re.compile(r"[<>=()]|\bis\s+(not\s+)?null\b|\bi?like\b|\bbetween\b", re.IGNORECASE)
_EXAMPLES = ("window_id", "verdict", "kept_1", "loss", "ratio_1", "cause", "observer", "confidence")


def is_expression(text: str) -> bool:
    """Whether a text is an expression, and no words."""
    return _EXPRESSION.search(text) is not None


def window_filter(text: str, layer: QgsVectorLayer | None, allowed: frozenset[str] | None) -> Test | None:
    """Whether a window matches an expression on the layer as it is now, or all words of a text; None where the text
    asks for nothing.

    ``allowed``: the only fields that a text is about, while others are hidden. Raises SettingsError with a sentence for
    an expression that is wrong, or asks for more.
    """
    if is_expression(text):
        fids = matching_windows(text, layer, allowed) if layer is not None else set[int]()
        return lambda row: row.fid in fids
    words, words_of = text.casefold().split(), cache(_shown_words)
    return (lambda row: all(_matches(row, word, allowed, words_of) for word in words)) if words else None


def matching_windows(text: str, layer: QgsVectorLayer, allowed: frozenset[str] | None) -> set[int]:
    """Feature ids of the windows for which an expression holds. Raises SettingsError."""
    expression, names = QgsExpression(text), {name.lower(): name for name in layer.fields().names()}
    if expression.hasParserError():
        raise _not_understood(expression.parserErrorString())
    for name in sorted(map(str.lower, expression.referencedColumns())):
        if allowed is not None and names.get(name) not in allowed:
            raise SettingsError(messages.FILTER_HIDDEN(word=name, known=", ".join(sorted(allowed))))
        if name not in names and name != QgsFeatureRequest.ALL_ATTRIBUTES.lower():
            known = ", ".join(example for example in _EXAMPLES if example in names)
            raise SettingsError(messages.FILTER_FIELD_UNKNOWN(name=name, known=known))
    context = QgsExpressionContext(QgsExpressionContextUtils.globalProjectLayerScopes(layer))
    expression.prepare(context)
    if (first := next(layer.getFeatures(), None)) is not None:  # what is wrong with values shows only there
        context.setFeature(first)
        expression.evaluate(context)
        if expression.hasEvalError():
            raise _not_understood(expression.evalErrorString())
    request = QgsFeatureRequest(expression, context)
    return {feature.id() for feature in layer.getFeatures(request)}


def _matches(row: WindowRecord, word: str, allowed: frozenset[str] | None, words_of: Callable[..., list[str]]) -> bool:
    """Whether a word begins the number, a word of verdict, cause or observer ("visible" is not "invisible"), or is
    anywhere in the reason, which names files. A number is a window's."""
    if word.isdigit():
        return str(row.window_id).startswith(word)
    if allowed is not None:
        said = row.observer if FIRST.observer in allowed else row.observer_2
        return any(part.startswith(word) for part in observer_word(said).casefold().split())
    words = words_of(row.verdict, row.cause, row.observer)
    return any(part.startswith(word) for part in words) or word in row.reason.casefold()


def _shown_words(verdict: str, cause: str, observer: str) -> list[str]:
    """The words that the table says for these."""
    return " ".join((verdict_word(verdict), cause_word(cause), observer_word(observer))).casefold().split()


def _not_understood(error: str) -> SettingsError:
    first = next((line.strip().rstrip(".") for line in error.splitlines() if line.strip()), "")
    return SettingsError(messages.FILTER_NOT_UNDERSTOOD(error=first))


_LETTERS = 8  # of the box


class KindBox(QComboBox):
    """All windows, or those of one kind, beside the search: its data is the test that they pass."""

    def __init__(self, parent: QWidget) -> None:
        super().__init__(parent)
        self.setToolTip(tr("Which windows are shown."))
        self.operator = FIRST  # whose verdicts are asked for
        self.addItem(tr("all"), None)
        for verdict in VERDICTS:
            self.addItem(verdict_chip(verdict), verdict_word(verdict), partial(_has_verdict, verdict))
        self._add(tr("not judged"), partial(self._is_said, ""), tr("Windows that no observer has judged."))
        self._add(tr("not sure"), partial(self._is_said, UNSURE), tr("Windows where the observer was not sure."))
        self._add(tr("changed"), attrgetter("stale"), tr("Windows to be inspected again."))
        differing = self.count()
        self._add(tr("tool differs"), tool_and_observer_disagree,
                  tr("Windows where the tool and an observer disagree."))
        self._add(tr("operators differ"), operators_disagree, tr("Windows where the two operators disagree."))
        self._telling = [*range(1, len(VERDICTS)), *range(differing, self.count())]  # what is hidden while blind
        self.setSizeAdjustPolicy(QComboBox.SizeAdjustPolicy.AdjustToMinimumContentsLengthWithIcon)
        self.setMinimumContentsLength(_LETTERS)  # the longest of its words would leave little room for the search
        self.setSizePolicy(QSizePolicy.Policy.Maximum, QSizePolicy.Policy.Fixed)
        self.view().setMinimumWidth(self.view().sizeHintForColumn(0) + 2 * self.fontMetrics().height())
        self.setMaxVisibleItems(self.count())

    def test(self) -> Test | None:
        """What the windows shown pass; None for all."""
        test: Test | None = self.currentData()
        return test

    def set_blind(self, is_blind: bool) -> None:
        """Whether what was found is hidden, and with it the kinds that tell it."""
        for place in self._telling:
            self.model().item(place).setEnabled(not is_blind)
        if is_blind and self.currentIndex() in self._telling:
            self.setCurrentIndex(0)

    def _add(self, text: str, test: Test, tip: str) -> None:
        self.addItem(text, test)
        self.setItemData(self.count() - 1, tip, Qt.ItemDataRole.ToolTipRole)

    def _is_said(self, word: str, row: WindowRecord) -> bool:
        """Whether a word was said of a window by the one whose verdicts are asked for."""
        return bool(getattr(row, self.operator.observer) == word)


def _has_verdict(verdict: str, row: WindowRecord) -> bool:
    return row.verdict == verdict


def tool_and_observer_disagree(row: WindowRecord) -> bool:
    """Whether the tool flags what an observer does not see, or the other way round."""
    flagged = row.verdict == "significant"
    words = [word for word in (row.observer, row.observer_2) if word in ("visible", "invisible")]
    return row.verdict in CLAIMS and any((word == VISIBLE) != flagged for word in words)


def operators_disagree(row: WindowRecord) -> bool:
    """Whether both looked and did not say the same."""
    return bool(row.observer and row.observer_2) and row.observer != row.observer_2
