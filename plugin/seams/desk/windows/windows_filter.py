"""Windows filtered by words, or by numbers with QGIS's own expressions: ``kept < 0.7 and cause = 'feathering'``."""
from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Sequence
from functools import cache
from typing import TYPE_CHECKING, Any

from qgis.core import (
    QgsExpression,
    QgsExpressionContext,
    QgsExpressionContextUtils,
    QgsExpressionNode,
    QgsExpressionNodeBinaryOperator,
    QgsExpressionNodeColumnRef,
    QgsExpressionNodeLiteral,
    QgsExpressionNodeUnaryOperator,
    QgsFeature,
    QgsFields,
)

from ....imagery.errors import Message, SettingsError
from ....imagery.statistics import DECIDED, FIRST, UNSURE
from ....toolkit.version_differences import field
from ...measure import messages
from ...measure.judgement.causes import Cause
from ...measure.window.window_tables import in_filter
from ...words import VERDICTS, cause_word, observer_word, verdict_word
from .window_columns import JUDGING_COLUMNS, all_columns

if TYPE_CHECKING:
    from ...measure.window_records import WindowRecord

_Read = Callable[["WindowRecord"], Any]
_EXPRESSION = re.compile(r"[<>=()]|\bis\s+(not\s+)?null\b|\bi?like\b|\bbetween\b", re.IGNORECASE)
_FIELDS = in_filter()
_MOST = 2.0  # a share that is compared with more is meant in percent
_OPERATOR = QgsExpressionNodeBinaryOperator.BinaryOperator
_COMPARED = (_OPERATOR.boLT, _OPERATOR.boLE, _OPERATOR.boGT, _OPERATOR.boGE, _OPERATOR.boEQ, _OPERATOR.boNE)
_QUOTED = re.compile(r"""('[^']*'|"[^"]*")""")
_DECIMAL_COMMA = re.compile(r"\d,\d")


def window_filter(
    text: str, levels: int, own: frozenset[str] | None, windows: Sequence[WindowRecord]
) -> Callable[[WindowRecord], bool] | None:
    """Whether a window matches an expression, or all words of a text; None where the text asks for nothing.

    ``own``: the only fields that a text may ask for, while others are hidden. Raises SettingsError with a sentence for
    a text that asks for more, and for an expression that is wrong.
    """
    if not _EXPRESSION.search(text):
        words, told = _allowed_words(text, own), cache(_told)
        return (lambda row: all(_matches(row, word, own, told) for word in words)) if words else None
    test = window_test(text, levels, own)
    if windows:
        test(windows[0])  # what is wrong with its values shows only there

    def holds(row: WindowRecord) -> bool:
        try:
            return test(row)
        except SettingsError:  # it can't be said of this window
            return False

    return holds


def window_test(text: str, levels: int, own: frozenset[str] | None = None) -> Callable[[WindowRecord], bool]:
    """What an expression says of a window; ``own``: the only fields that it may ask for.

    The fields have their names in the layer and those in the table: ``kept`` is ``kept_1``, ``id`` is ``window_id``,
    ``ratio 1`` is ``ratio_1``. Words of verdicts and causes need no quotes. Raises SettingsError with a sentence for an
    expression that is wrong.
    """
    reads, words = _reads(levels), _words()
    headings = {heading: name for heading, name in _headings(levels).items() if heading not in reads}
    expression = _parsed(text, [name for name in headings if not name.isidentifier()])
    field_of = {**headings, **{called: one.name for called, one in _FIELDS.items()}}
    reads.update((heading, reads[name]) for heading, name in headings.items())
    known_fields = set(reads)
    if own is not None:
        reads = {name: read for name, read in reads.items() if field_of.get(name, name) in own}
    hidden = {name.lower() for name in known_fields.difference(reads)}
    asked = [name for name in expression.referencedColumns() if name != "#!allattributes!#"]
    known = {name.lower(): name for name in (*reads, *words)}
    for name in asked:
        if name.lower() in hidden:
            raise SettingsError(_hidden_message(name, own))
        if name.lower() not in known:
            raise SettingsError(messages.FILTER_FIELD_UNKNOWN(name=name, known=", ".join(_examples(reads))))
    _check_shares(expression.rootNode(), headings)
    fields = QgsFields()
    for name in reads:
        fields.append(field(name, "text" if _is_text(field_of.get(name, name)) else "real"))
    for word in words:
        fields.append(field(word, "text"))
    context = QgsExpressionContext(QgsExpressionContextUtils.globalProjectLayerScopes(None))
    context.setFields(fields)
    expression.prepare(context)
    constants = list(words.values())
    wanted = {name.lower() for name in asked}
    used = [read if name.lower() in wanted else None for name, read in reads.items()]

    def holds(row: WindowRecord) -> bool:
        feature = QgsFeature(fields)
        feature.setAttributes([None if read is None else _value(read(row)) for read in used] + constants)
        context.setFeature(feature)
        found = expression.evaluate(context)
        if expression.hasEvalError():
            raise SettingsError(messages.FILTER_NOT_UNDERSTOOD(error=_first_line(expression.evalErrorString())))
        return bool(found)

    return holds


def _allowed_words(text: str, own: frozenset[str] | None) -> list[str]:
    """Raises SettingsError for one that can be found only in what is hidden."""
    words = text.casefold().split()
    if own is not None:
        spoken = " ".join(map(observer_word, (*DECIDED, UNSURE))).casefold().split()
        for word in words:
            if not word.isdigit() and not any(one.startswith(word) for one in spoken):
                raise SettingsError(_hidden_message(word, own))
    return words


def _matches(row: WindowRecord, word: str, own: frozenset[str] | None, told: Callable[..., list[str]]) -> bool:
    """Whether a word begins the number, a word of verdict, cause or observer ("visible" is not "invisible"), or is
    anywhere in the reason, which names files. A number is a window's."""
    if word.isdigit():
        return str(row.window_id).startswith(word)
    if own is not None:
        said = row.observer if FIRST.observer in own else row.observer_2
        return any(one.startswith(word) for one in observer_word(said).casefold().split())
    words = told(row.verdict, row.cause, row.observer)
    return any(one.startswith(word) for one in words) or word in row.reason.casefold()


def _told(verdict: str, cause: str, observer: str) -> list[str]:
    """The words that the table says for these."""
    return " ".join((verdict_word(verdict), cause_word(cause), observer_word(observer))).casefold().split()


def _hidden_message(word: str, own: Iterable[str] | None) -> Message:
    """That the filter asks for what is hidden, and what it may ask for."""
    return messages.FILTER_HIDDEN(word=word, known=", ".join(sorted(own or (), key=list(_FIELDS).index)))


def _is_text(name: str) -> bool:
    return name in _FIELDS and _FIELDS[name].kind == "text"


def _is_share(name: str) -> bool:
    """Whether a field is a share, by level or not."""
    found = _FIELDS.get(name) or _FIELDS.get(name.rpartition("_")[0])
    return found is not None and found.is_share


def _headings(levels: int) -> dict[str, str]:
    """The field behind each heading of the table, in small letters; a mere number is none."""
    judging = frozenset(column.name for column in JUDGING_COLUMNS)
    columns = all_columns(levels, judging)
    shown = ((title, column.field) for column in columns for title in (column.title(), column.title(short=True)))
    return {
        name.lower(): field_name
        for title, field_name in shown for name in (title, title.rstrip(".")) if not title.isdigit()
    }  # fmt: skip


def _parsed(text: str, quoted: list[str]) -> QgsExpression:
    """``quoted``: names that need quotes and may come without. Raises SettingsError for what can't be understood."""
    expression = QgsExpression(_with_quotes(text, quoted))
    if expression.hasParserError():
        if any(_DECIMAL_COMMA.search(part) for part in _QUOTED.split(text)[::2]):
            raise SettingsError(messages.FILTER_DECIMALS())
        raise SettingsError(messages.FILTER_NOT_UNDERSTOOD(error=_first_line(expression.parserErrorString())))
    if expression.needsGeometry():
        raise SettingsError(messages.FILTER_GEOMETRY())
    return expression


def _with_quotes(text: str, names: list[str]) -> str:
    """The text with quotes around names that have a blank or a dot, where it has none yet."""
    any_name = "|".join(map(re.escape, sorted(names, key=len, reverse=True)))
    name = re.compile(rf"(?<![\w.])({any_name})(?!\w)", re.IGNORECASE)
    parts = _QUOTED.split(text)  # every other one is quoted
    parts[::2] = [name.sub(r'"\1"', part) for part in parts[::2]]
    return "".join(parts)


def _check_shares(node: QgsExpressionNode | None, headings: dict[str, str]) -> None:
    """Raise SettingsError where a share is compared with what must be percent, as the table shows it."""
    if isinstance(node, QgsExpressionNodeUnaryOperator):
        _check_shares(node.operand(), headings)
    if not isinstance(node, QgsExpressionNodeBinaryOperator):
        return
    sides = node.opLeft(), node.opRight()
    for side, other in (sides, sides[::-1]):
        _check_shares(side, headings)
        if node.op() in _COMPARED and isinstance(side, QgsExpressionNodeColumnRef):
            name = side.name().lower()
            value = other.value() if isinstance(other, QgsExpressionNodeLiteral) else None
            is_share = _is_share(headings.get(name, name))
            if is_share and isinstance(value, (int, float)) and value > _MOST:
                raise SettingsError(messages.FILTER_SHARE(name=side.name(), share=value / 100, percent=value))


def _reads(levels: int) -> dict[str, _Read]:
    """How each field is read from a record, by all names it has."""
    reads: dict[str, _Read] = {}
    for called, one in _FIELDS.items():
        name = one.read_as
        if one.by_level:
            reads.update((f"{called}_{level}", _at_level(name, level)) for level in range(1, levels + 1))
        reads[called] = _at_level(name, 1) if one.by_level else _attribute(name)
    return reads


def _attribute(name: str) -> _Read:
    return lambda row: row.read(name)


def _at_level(name: str, level: int) -> _Read:
    def read(row: WindowRecord) -> float | None:
        values = getattr(row, name)
        return values[level - 1] if level <= len(values) else None

    return read


def _words() -> dict[str, str]:
    """Words that may stand without quotes, those in the operator's language too, and what tables hold for them."""
    told = {verdict: verdict_word(verdict) for verdict in VERDICTS if verdict}
    told |= {cause.value: cause_word(cause.value) for cause in Cause}
    told |= {word: observer_word(word) for word in ("visible", "invisible", "unsure")}
    return {word: value for value, shown in told.items() for word in (value, shown) if word.isidentifier()}


def _value(value: Any) -> Any:
    return None if value == "" else value


def _examples(reads: dict[str, _Read]) -> list[str]:
    return [name for name in ("id", "verdict", "kept", "ratio", "cause", "observer", "confidence", "sources")
            if name in reads]  # fmt: skip


def _first_line(text: str) -> str:
    return next((line.strip().rstrip(".") for line in text.splitlines() if line.strip()), "")
