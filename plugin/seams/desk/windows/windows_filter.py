"""Windows filtered by words, or by numbers with QGIS's own expressions: ``kept < 0.7 and cause = 'feathering'``."""
from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Sequence
from functools import cache
from typing import TYPE_CHECKING, Any

from qgis.core import QgsExpression, QgsExpressionContext, QgsExpressionContextUtils, QgsFeature, QgsFields

from ....imagery.errors import Message, SettingsError
from ....imagery.statistics import DECIDED, FIRST, UNSURE
from ....toolkit.version_differences import field
from ...measure import messages
from ...measure.window.window_tables import in_filter
from ...words import cause_word, observer_word, verdict_word

if TYPE_CHECKING:
    from ...measure.window_records import WindowRecord

_Read = Callable[["WindowRecord"], Any]
_EXPRESSION = re.compile(r"[<>=()]|\bis\s+(not\s+)?null\b|\bi?like\b|\bbetween\b", re.IGNORECASE)
_FIELDS = in_filter()
_EXAMPLES = ("id", "verdict", "kept", "ratio", "cause", "observer", "confidence", "sources")


def window_filter(
    text: str, levels: int, allowed: frozenset[str] | None, windows: Sequence[WindowRecord]
) -> Callable[[WindowRecord], bool] | None:
    """Whether a window matches an expression, or all words of a text; None where the text asks for nothing.

    ``allowed``: the only fields that a text may ask for, while others are hidden. Raises SettingsError with a sentence
    for a text that asks for more, and for an expression that is wrong.
    """
    if not _EXPRESSION.search(text):
        words, words_of = _allowed_words(text, allowed), cache(_shown_words)
        return (lambda row: all(_matches(row, word, allowed, words_of) for word in words)) if words else None
    test = window_test(text, levels, allowed)
    if windows:
        test(windows[0])  # what is wrong with its values shows only there

    def holds(row: WindowRecord) -> bool:
        try:
            return test(row)
        except SettingsError:  # it can't be said of this window
            return False

    return holds


def window_test(text: str, levels: int, allowed: frozenset[str] | None = None) -> Callable[[WindowRecord], bool]:
    """What an expression says of a window; ``allowed``: the only fields that it may ask for.

    Fields have their names in the layer, and short ones: ``kept`` is ``kept_1``, ``id`` is ``window_id``. Raises
    SettingsError with a sentence for an expression that is wrong.
    """
    reads = _reads(levels)
    expression = _parsed(text)
    asked = {name.lower() for name in expression.referencedColumns()} - {"#!allattributes!#"}
    for name in sorted(asked):
        if name not in reads:
            known = ", ".join(example for example in _EXAMPLES if example in reads)
            raise SettingsError(messages.FILTER_FIELD_UNKNOWN(name=name, known=known))
        if allowed is not None and (name not in _FIELDS or _FIELDS[name].name not in allowed):
            raise SettingsError(_hidden_message(name, allowed))
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
            raise SettingsError(messages.FILTER_NOT_UNDERSTOOD(error=_first_line(expression.evalErrorString())))
        return bool(answer)

    return holds


def _allowed_words(text: str, allowed: frozenset[str] | None) -> list[str]:
    """Raises SettingsError for one that can be found only in what is hidden."""
    words = text.casefold().split()
    if allowed is not None:
        spoken = " ".join(map(observer_word, (*DECIDED, UNSURE))).casefold().split()
        for word in words:
            if not word.isdigit() and not any(known.startswith(word) for known in spoken):
                raise SettingsError(_hidden_message(word, allowed))
    return words


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


def _hidden_message(word: str, allowed: Iterable[str] | None) -> Message:
    """That the filter asks for what is hidden, and what it may ask for."""
    return messages.FILTER_HIDDEN(word=word, known=", ".join(sorted(allowed or (), key=list(_FIELDS).index)))


def _parsed(text: str) -> QgsExpression:
    """Raises SettingsError for what can't be understood."""
    expression = QgsExpression(text)
    if expression.hasParserError():
        raise SettingsError(messages.FILTER_NOT_UNDERSTOOD(error=_first_line(expression.parserErrorString())))
    if expression.needsGeometry():
        raise SettingsError(messages.FILTER_GEOMETRY())
    return expression


def _reads(levels: int) -> dict[str, _Read]:
    """How each field is read from a record, by all names it has."""
    reads: dict[str, _Read] = {}
    for called, column in _FIELDS.items():
        name = column.read_as
        if column.by_level:
            reads.update((f"{called}_{level}", _at_level(name, level)) for level in range(1, levels + 1))
        reads[called] = _at_level(name, 1) if column.by_level else _attribute(name)
    return reads


def _attribute(name: str) -> _Read:
    return lambda row: row.read(name)


def _at_level(name: str, level: int) -> _Read:
    def read(row: WindowRecord) -> float | None:
        values = getattr(row, name)
        return values[level - 1] if level <= len(values) else None

    return read


def _first_line(text: str) -> str:
    return next((line.strip().rstrip(".") for line in text.splitlines() if line.strip()), "")
