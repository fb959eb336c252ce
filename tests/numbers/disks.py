"""Disks that are full, and files that have several names."""
from __future__ import annotations

import os
import resource
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path


@contextmanager
def full_disk(most_bytes: int) -> Iterator[None]:
    """No file can grow beyond so many bytes, and what tries is refused as on a disk that is full."""
    soft, hard = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (most_bytes, hard))
    try:
        yield
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, (soft, hard))


def names_of(path: Path) -> Iterator[str]:
    """Other names of a file, and of files that are parts of a raster by their name."""
    yield str(path)
    yield os.path.relpath(path)
    yield f"{path.parent}/../{path.parent.name}/./{path.name}"
    link, hard, folder = (path.parent / name for name in ("link.tif", "hard.tif", "folder"))
    link.symlink_to(path)
    yield str(link)
    os.link(path, hard)
    yield str(hard)
    folder.symlink_to(path.parent, target_is_directory=True)
    yield str(folder / path.name)
    for alias in (link, hard, folder):
        alias.unlink()
