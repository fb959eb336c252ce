"""Which orthoimage a producer means: names, paths, addresses and image numbers against the files that are given."""
from __future__ import annotations

import re
from collections.abc import Iterable, Sequence

from .....imagery.errors import Message
from ...seam_cells import source_stem
from .. import messages

_TOLD = 3  # names that a notice tells


def source_numbers(names: Iterable[str], files: Sequence[str]) -> tuple[dict[str, int], Message | None]:
    """For each name that a layer of seams holds the place of its orthoimage in ``files``; and which ones have none.

    The folder, the ending and capitals don't count. A name that is a part of one file's name only, as image numbers
    are, means that file.
    """
    stems = [source_stem(file) for file in files]
    places = {stem: place for place, stem in reversed(list(enumerate(stems)))}
    parts: dict[str, set[int]] = {}
    for place, stem in enumerate(stems):
        for part in _runs(stem):
            parts.setdefault(part, set()).add(place)
    found, missing = {}, []
    for name in sorted(set(names)):
        stem = source_stem(name)
        meant = {places[stem]} if stem in places else parts.get("_".join(_words(stem)), set())
        if len(meant) == 1:
            found[name] = next(iter(meant))
        else:
            missing.append(name)
    if not missing or not files:
        return found, None
    return found, messages.SEAM_SOURCES_MISSING(count=len(missing), names=", ".join(missing[:_TOLD]))


def _words(stem: str) -> list[str]:
    return re.findall(r"[^\W_]+", stem)


def _runs(stem: str) -> set[str]:
    """All runs of the words of a name."""
    words = _words(stem)
    return {"_".join(words[i:j]) for i in range(len(words)) for j in range(i + 1, len(words) + 1)}
