"""The rules that come with the plugin, in the user's language."""
from __future__ import annotations

from dataclasses import fields, is_dataclass, replace
from typing import Any, TypeVar

from qgis.PyQt.QtCore import QT_TRANSLATE_NOOP

from ..translation import tr

Rules = TypeVar("Rules")
_OWN = QT_TRANSLATE_NOOP("@default", "Seam Inspector's own")
"""The source of limits that no contract states."""
_WORDS = ("name", "source", "kept_source")
"""The fields that people read: what rules are called, and where their limits come from."""


def in_users_language(rules: Rules) -> Rules:
    """Names and sources of rules translated, those of the rules in them too; what is none of ours stays."""
    known = {one.name: getattr(rules, one.name) for one in fields(rules)}  # type: ignore[arg-type]
    changed = {name: tr(value) if name in _WORDS else _translated(value) for name, value in known.items()}
    return replace(rules, **changed)  # type: ignore[type-var]


def _translated(value: Any) -> Any:
    if isinstance(value, tuple):
        return tuple(map(_translated, value))
    return in_users_language(value) if is_dataclass(value) and any(hasattr(value, word) for word in _WORDS) else value
