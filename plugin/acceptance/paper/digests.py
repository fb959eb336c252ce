"""Digests of what was decided on, so that nobody can say later that it was something else."""
from __future__ import annotations

import hashlib
import os
from collections.abc import Iterable, Sequence
from contextlib import suppress
from dataclasses import dataclass
from typing import Callable

from ...imagery.errors import RasterError
from ...imagery.open_raster import OpenRaster
from ...imagery.rasters import RasterRef

_AT_ONCE = 1 << 22  # bytes


@dataclass(frozen=True)
class Digest:
    """What was digested, and what came of it."""

    path: str
    """Of a file; what it is, in words, where there is none."""
    size: int | None
    """Bytes; None of what is no file."""
    sha256: str
    """Hexadecimal, 64 digits."""


def mosaic_files(refs: Iterable[RasterRef]) -> list[str]:
    """The files that rasters are read from, those that a VRT names too, each once; what a server has is left out.

    Statistics that GDAL writes beside a raster are no part of it.
    """
    found: dict[str, None] = {}
    for ref in refs:
        names: Sequence[str] = ()
        with suppress(RasterError):
            names = OpenRaster(ref).dataset.GetFileList() or ()
        found.update(dict.fromkeys(os.path.abspath(name) for name in names if not name.endswith(".aux.xml")))
    return [path for path in found if os.path.isfile(path)]


def file_digests(paths: Sequence[str], goes_on: Callable[[float], bool]) -> list[Digest] | None:
    """SHA-256 of each file as ``sha256sum`` prints it; None when it is not wanted any more.

    ``goes_on``: told the share of the bytes that is done, 0 to 1. A file that can't be read has no digest.
    """
    sizes = {path: os.path.getsize(path) for path in paths if os.path.isfile(path)}
    total, done = max(sum(sizes.values()), 1), 0
    found = []
    for path, size in sizes.items():
        digest = hashlib.sha256()
        with suppress(OSError):
            with open(path, "rb") as file:
                while block := file.read(_AT_ONCE):
                    if not goes_on(min(done / total, 1.0)):
                        return None
                    digest.update(block)
                    done += len(block)
            found.append(Digest(path, size, digest.hexdigest()))
    return found


def text_digest(name: str, lines: Iterable[str]) -> Digest:
    """Of lines of text, each ended by a line feed, in UTF-8."""
    content = "".join(f"{line}\n" for line in lines).encode()
    return Digest(name, len(content), hashlib.sha256(content).hexdigest())
