"""Documents that others wrote, read with care: files of moderate size, XML without entities, JSON, rules of acceptance.

A file of rules is a JSON object with a ``name`` and a list of ``rules``, each of them an object with the limits
``least`` and ``most`` (both inclusive) and a ``source`` that says in words where they come from. What else stands in
it, each subject says; whatever nobody knows is refused, so that no limit is overlooked for a slip of the pen.
"""
from __future__ import annotations

import errno
import json
import math
import re
from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import count
from pathlib import Path
from typing import Any, Callable, TypeVar
from xml.etree.ElementTree import Element, ParseError, TreeBuilder
from xml.parsers import expat

from . import messages
from .errors import Message, SettingsError
from .gdal_paths import is_endless
from .messages import system_reason

MOST_BYTES = 100_000_000  # a hundred times the largest table of points or rules anybody has
_MOST_DIGITS = 308  # each whole number of so many is a float, too


def document_bytes(path: Path) -> bytes:
    """The content of a file. Raises OSError for one that can't be read, is none (a device, a pipe), or is too large."""
    if is_endless(str(path)):
        raise OSError(errno.EINVAL, "a device or a pipe")
    with open(path, "rb") as file:
        content = file.read(MOST_BYTES + 1)
    if len(content) > MOST_BYTES:
        raise OSError(errno.EFBIG, f"larger than {MOST_BYTES // 1_000_000} MB")
    return content


def json_document(text: str | bytes, pairs: Callable[[Sequence[tuple[str, Any]]], Any] | None = None) -> Any:
    """What a JSON text says; ``pairs`` makes the objects.

    Raises JSONDecodeError for what is none, nested too deeply, or holds whole numbers that are longer than any is.
    """
    try:
        return json.loads(text, object_pairs_hook=pairs, parse_int=_whole)
    except json.JSONDecodeError:
        raise
    except (RecursionError, ValueError) as error:  # ValueError of an encoding that is not kept to, too
        why = "nested too deeply" if isinstance(error, RecursionError) else str(error)
        raise json.JSONDecodeError(why, "", 0) from None


def _whole(digits: str) -> int:
    if len(digits) > _MOST_DIGITS:  # the time that they take grows with the square of their number
        raise ValueError("a number of too many digits")
    return int(digits)


def looks_like_xml(content: bytes) -> bool:
    """Whether a file's content begins as XML does, in any encoding."""
    return content.lstrip(b"\xef\xbb\xbf\xfe\xff\0 \t\r\n").startswith(b"<")


def xml_root(content: bytes) -> Element:
    """The root of a document, all names without their namespaces.

    Raises ParseError for what is no XML and for a document type of its own: no data need one, and its entities can
    name other files or grow beyond all memory.
    """
    builder, parser = TreeBuilder(), expat.ParserCreate(namespace_separator="}")
    parser.buffer_text = True
    parser.StartDoctypeDeclHandler = _refuse_document_type
    parser.StartElementHandler = lambda tag, attributes: builder.start(tag.rpartition("}")[2], attributes)
    parser.EndElementHandler = lambda tag: builder.end(tag.rpartition("}")[2])
    parser.CharacterDataHandler = builder.data
    try:
        parser.Parse(content, True)
    except (expat.ExpatError, ValueError, LookupError) as error:  # the last two of an encoding
        raise ParseError(str(error)) from None
    return builder.close()


def _refuse_document_type(*declared: object) -> None:
    raise ParseError("document types are refused")


_READY = Path(__file__).parents[2] / "resources" / "rules"

Made = TypeVar("Made")


@dataclass(frozen=True)
class RuleObject:
    """An object of a rules file, and where it stands; what it is asked for is right, or raises SettingsError."""

    content: Mapping[str, Any]
    file: str
    """Name of the file."""
    place: Message
    """Place of the object in it."""
    worded: Callable[[str], str] = str
    """Words of ready files in the user's language."""

    def allow(self, known: Collection[str]) -> None:
        """Refuse every other key."""
        for key in self.content:
            if key not in known:
                raise SettingsError(
                    messages.RULES_KEY_UNKNOWN(place=self.place, name=self.file, key=key, known=", ".join(known))
                )

    def number(self, key: str, least: float = 0) -> float | None:
        """Number of ``least`` or more; None when it is left out."""
        value = self.content.get(key)
        if value is None:
            return None
        if not (is_number(value) and value >= least):
            raise SettingsError(messages.RULES_LIMIT_BAD(place=self.place, name=self.file, key=key, least=least))
        return float(value)

    def limits(self) -> tuple[float | None, float | None]:
        """``least`` and ``most``."""
        least, most = self.number("least"), self.number("most")
        if least is not None and most is not None and least > most:
            raise SettingsError(messages.RULES_LIMITS_CROSSED(place=self.place, name=self.file))
        return least, most

    def whole(self, key: str, default: int) -> int:
        """A whole number of 1 or more."""
        value = self.content.get(key, default)
        if not isinstance(value, int) or isinstance(value, bool) or value < 1:
            raise SettingsError(messages.RULES_WHOLE_BAD(place=self.place, name=self.file, key=key))
        return value

    def flag(self, key: str, default: bool) -> bool:
        """True or false."""
        value = self.content.get(key, default)
        if not isinstance(value, bool):
            raise SettingsError(messages.RULES_FLAG_BAD(place=self.place, name=self.file, key=key))
        return value

    def word(self, key: str, known: Collection[str]) -> str:
        """One of some words."""
        value = self.content.get(key)
        if not isinstance(value, str) or value not in known:
            raise SettingsError(messages.RULES_WORD_UNKNOWN(
                place=self.place, name=self.file, key=key, value=value, known=", ".join(known)
            ))  # fmt: skip
        return value

    def source(self) -> str:
        """Origin of the limits."""
        source = self.content.get("source")
        if not isinstance(source, str) or not source.strip():
            raise SettingsError(messages.RULES_SOURCE_MISSING(place=self.place, name=self.file))
        return self.worded(source)

    def name(self) -> str:
        """What its maker calls it; else the file's name."""
        return self.worded(str(self.content.get("name") or self.file))


def read_rules(
    path: Path, make: Callable[[RuleObject, list[RuleObject]], Made], worded: Callable[[str], str] = str
) -> Made:
    """What ``make`` makes of a file's object and of its rules, the words of ready ones in the user's language.

    Raises SettingsError, also by ``make``, that says what is wrong with the file, and where.
    """
    try:
        text = document_bytes(path)
    except OSError as error:
        raise SettingsError(messages.RULES_NOT_READABLE(name=path.name, error=system_reason(error))) from None
    try:
        content = json_document(text, lambda pairs: _object(path.name, pairs))
    except json.JSONDecodeError as error:
        raise SettingsError(messages.RULES_NOT_JSON(name=path.name, line=error.lineno)) from None
    rules = content.get("rules") if isinstance(content, dict) else None
    if not isinstance(rules, list) or not rules or not all(isinstance(rule, dict) for rule in rules):
        raise SettingsError(messages.RULES_NO_OBJECT(name=path.name))
    whole = RuleObject(content, path.name, messages.RULES_PLACE(), worded)
    places = (messages.RULE_PLACE(number=number) for number in count(1))
    return make(whole, [replace(whole, content=rule, place=place) for rule, place in zip(rules, places)])


def ready_rules(subject: str) -> dict[str, Path]:
    """The ready files of a subject by their names."""
    return {path.stem: path for path in sorted((_READY / subject).glob("*.json"))}


def _object(name: str, pairs: Sequence[tuple[str, Any]]) -> dict[str, Any]:
    """An object of a file; raises SettingsError where a key stands in it twice: which of the two is meant?"""
    made: dict[str, Any] = {}
    for key, value in pairs:
        if key in made:
            raise SettingsError(messages.RULES_KEY_TWICE(name=name, key=key))
        made[key] = value
    return made


def is_number(value: Any) -> bool:
    """Whether it is a finite number."""
    return isinstance(value, (int, float)) and not isinstance(value, bool) and math.isfinite(value)


def plugin_version() -> str:
    """The plugin's version; that of what measures is the package's, wherever it is installed."""
    metadata = Path(__file__).parents[2] / "metadata.txt"
    line = re.search(r"^version=(.*)$", metadata.read_text(encoding="utf-8"), re.M) if metadata.is_file() else None
    return line[1].strip() if line else ""
