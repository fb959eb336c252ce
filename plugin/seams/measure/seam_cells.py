"""Seam cells: polygons that say which source a mosaic was cut from, where a producer hands them over."""
from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from itertools import combinations
from pathlib import PurePath

import numpy as np
from osgeo import ogr

from ...imagery.grids import Extent, Grid, PixelWindow
from ...imagery.lines import burnt

UNKNOWN = 255
"""The label of pixels that no cell covers, or one of a source that does not take part."""
NONE = -1
"""The label where sources have the numbers of a whole scan and none is followed, or nobody looked."""


@dataclass(frozen=True)
class Cell:
    """One polygon of the mosaic."""

    source: str
    """The source's file name, with or without folder and ending."""
    wkb: bytes
    """Polygon in the mosaic's reference system."""
    extent: Extent
    """Its bounding box."""


def cell_labels(
    cells: Sequence[Cell], images: Sequence[Sequence[str]], grid: Grid, window: PixelWindow
) -> np.ndarray:
    """Index of each pixel's source in ``images``, the paths of each, (rows, columns) uint8, ``UNKNOWN`` where no cell
    says which one."""
    meant = meant_sources({cell.source for cell in cells}, images)
    shapes = [
        (ogr.CreateGeometryFromWkb(cell.wkb), next(iter(meant[cell.source])))
        for cell in cells if len(meant[cell.source]) == 1
    ]
    return burnt(shapes, grid, window, UNKNOWN)


def is_one_of(labels: np.ndarray, numbers: Iterable[int]) -> np.ndarray:
    """Pixels with one of some labels, bool: of the few that a window has in a tenth of the time of ``np.isin``."""
    pixels = np.zeros(labels.shape, bool)
    for number in numbers:
        pixels |= labels == number
    return pixels


def present(labels: np.ndarray) -> list[int]:
    """The sources that any pixel follows."""
    count = int((labels.astype(np.uint8, copy=False) + np.uint8(1)).max(initial=0))  # which makes 0 of UNKNOWN
    return [number for number in range(count) if (labels == number).any()]


def source_stem(name: str) -> str:
    """What a source is compared by: its name without folder, ending and capitals; of a part of a file, such as
    GPKG:a.gpkg:table, the part counts."""
    path = PurePath(name.replace("\\", "/"))
    return (path.name if ":" in path.suffix else path.stem).lower()


def meant_sources(names: Iterable[str], images: Sequence[Sequence[str]]) -> dict[str, set[int]]:
    """For each name all places in ``images``, the paths of each, that it fits: whole file names, told apart by their
    folders where the name has some; else the one image of which a file has it as a part of its name."""
    by_stem: dict[str, set[int]] = {}
    parts: dict[str, set[int]] = {}
    files = [(path, image) for image, paths in enumerate(images) for path in paths]
    folders = [_folders(path) for path, _ in files]
    for place, (path, _) in enumerate(files):
        stem = source_stem(path)
        by_stem.setdefault(stem, set()).add(place)
        words = _words(stem)
        for first, last in combinations(range(len(words) + 1), 2):  # all runs of them
            parts.setdefault("_".join(words[first:last]), set()).add(place)
    meant = {}
    for name in set(names):
        stem = source_stem(name)
        places = by_stem.get(stem, set())
        if not places:
            some = parts.get("_".join(_words(stem)), set())
            places = some if len({files[place][1] for place in some}) == 1 else set()
        name_folders = _folders(name)
        # With a folder more of the name at a time, as long as some file still fits.
        for count in range(1, len(name_folders) + 1):
            places = {place for place in places if folders[place][-count:] == name_folders[-count:]} or places
        meant[name] = {files[place][1] for place in places}
    return meant


def _folders(path: str) -> list[str]:
    return [part.lower() for part in path.replace("\\", "/").split("/")[:-1] if part]


def _words(stem: str) -> list[str]:
    return re.findall(r"[^\W_]+", stem)


def names_apart(paths: Sequence[str]) -> list[str]:
    """The file names of paths; those of one name with as many of their folders as it takes to tell them apart."""
    parts = [path.replace("\\", "/").split("/") for path in paths]
    names = [part[-1] or path for part, path in zip(parts, paths)]
    for count in range(2, max(map(len, parts), default=0) + 1):
        same = {name for name, times in Counter(names).items() if times > 1}
        if not same:
            break
        names = ["/".join(part[-count:]) if name in same else name for part, name in zip(parts, names)]
    return names
