"""Classes of QGIS of which only the names are needed: to import, to derive from, to ask for an enum's member.

Whether the names are right is for mypy and QGIS's stubs (tools/qt6/check_types.py).
"""
from __future__ import annotations


class NeedsQgis(Exception):
    """Something was asked for that the stand-in has not."""


class _Named(type):
    def __getattr__(cls, name: str) -> type:
        if name.startswith("__"):
            raise AttributeError(name)
        made = placeholder(name)
        setattr(cls, name, made)
        return made

    def __or__(cls, other: object) -> _Named:  # type: ignore[override]
        return cls

    __ror__ = __or__

    def __call__(cls, *_: object, **__: object) -> object:
        raise NeedsQgis(cls.__name__)


def placeholder(name: str, base: type = object) -> type:
    """A class that is nothing but its name; its attributes are such classes too, and none can be made."""
    if base is object:
        return _Named(name, (), {})

    def refuse(*_: object, **__: object) -> None:
        raise NeedsQgis(name)

    return type(name, (base,), {"__init__": refuse})
