"""Windows filtered by their kind, by words, or with QGIS's own expressions: ``kept < 0.7 and cause = 'feathering'``."""
from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from functools import cache, partial
from operator import attrgetter
from typing import Any

from qgis.core import QgsExpression, QgsExpressionContext, QgsExpressionContextUtils, QgsFeature, QgsFields
from qgis.PyQt.QtCore import Qt
from qgis.PyQt.QtWidgets import QComboBox, QSizePolicy, QWidget

from ....imagery.errors import SettingsError
from ....imagery.limits import MAX_LEVELS
from ....imagery.statistics import FIRST, UNSURE, VISIBLE
from ....toolkit.translation import tr
from ....toolkit.version_differences import field
from ...measure import messages
from ...measure.window.window_tables import WindowField, in_filter
from ...measure.window_records import WindowRecord
from ...words import CLAIMS, VERDICTS, cause_word, observer_word, verdict_word
from .window_columns import verdict_chip

Test = Callable[[WindowRecord], bool]
_EXPRESSION = re.compile(r"[<>=()]|\bis\s+(not\s+)?null\b|\bi?like\b|\bbetween\b", re.IGNORECASE)
_FIELDS = in_filter()
_EXAMPLES = ("id", "verdict", "kept", "ratio", "cause", "observer", "confidence", "sources")


def window_filter(
    text: str, allowed: frozenset[str] | None, windows: Sequence[WindowRecord]
) -> Test | None:
    """Whether a window matches an expression, or all words of a text; None where the text asks for nothing.

    ``allowed``: the only fields that a text is about, while others are hidden. Raises SettingsError with a sentence for
    an expression that is wrong, or asks for more.
    """
    if not _EXPRESSION.search(text):
        words, words_of = text.casefold().split(), cache(_shown_words)
        return (lambda row: all(_matches(row, word, allowed, words_of) for word in words)) if words else None
    test = _expression_test(text, allowed)
    if windows:
        test(windows[0])  # what is wrong with its values shows only there

    def holds(row: WindowRecord) -> bool:
        try:
            return test(row)
        except SettingsError:  # it can't be said of this window
            return False

    return holds


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


def _expression_test(text: str, allowed: frozenset[str] | None) -> Test:
    """What an expression says of a window. Fields have their names in the layer, and short ones: ``kept`` is
    ``kept_1``, ``id`` is ``window_id``. Raises SettingsError, as its answer does."""
    expression, reads = QgsExpression(text), _reads()
    if expression.hasParserError():
        raise _not_understood(expression.parserErrorString())
    if expression.needsGeometry():
        raise SettingsError(messages.FILTER_GEOMETRY())
    asked = {name.lower() for name in expression.referencedColumns()} - {"#!allattributes!#"}
    for name in sorted(asked):
        if name not in reads:
            known = ", ".join(example for example in _EXAMPLES if example in reads)
            raise SettingsError(messages.FILTER_FIELD_UNKNOWN(name=name, known=known))
        if allowed is not None and (name not in _FIELDS or _FIELDS[name].name not in allowed):
            known = ", ".join(sorted(allowed, key=list(_FIELDS).index))
            raise SettingsError(messages.FILTER_HIDDEN(word=name, known=known))
    fields, used = QgsFields(), [(name, read) for name, read in reads.items() if name in asked]
    for name, _ in used:
        fields.append(field(name, "text" if name in _FIELDS and _FIELDS[name].kind == "text" else "real"))
    context = QgsExpressionContext(QgsExpressionContextUtils.globalProjectLayerScopes(None))
    context.setFields(fields)
    expression.prepare(context)

    def holds(row: WindowRecord) -> bool:
        feature = QgsFeature(fields)
        feature.setAttributes([None if (value := read(row)) == "" else value for _, read in used])
        context.setFeature(feature)
        answer = expression.evaluate(context)
        if expression.hasEvalError():
            raise _not_understood(expression.evalErrorString())
        return bool(answer)

    return holds


def _not_understood(error: str) -> SettingsError:
    first = next((line.strip().rstrip(".") for line in error.splitlines() if line.strip()), "")
    return SettingsError(messages.FILTER_NOT_UNDERSTOOD(error=first))


def _reads() -> dict[str, Callable[[WindowRecord], Any]]:
    """How each field is read from a record, by all names it has."""
    reads: dict[str, Callable[[WindowRecord], Any]] = {}
    for called, column in _FIELDS.items():
        reads[called] = partial(_value, column, 1)
        if column.by_level:
            reads.update((f"{called}_{level}", partial(_value, column, level)) for level in range(1, MAX_LEVELS + 1))
    return reads


def _value(column: WindowField, level: int, row: WindowRecord) -> Any:
    if not column.by_level:
        return row.read(column.read_as)
    values = getattr(row, column.read_as)
    return values[level - 1] if level <= len(values) else None


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
