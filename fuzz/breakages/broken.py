"""What a breakage is given and gives, and the registry of all of them."""
from __future__ import annotations

import random
import shutil
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Callable

RASTERS = (".tif", ".jpg", ".png", ".bmp", ".vrt")
LAYERS = (".gpkg", ".shp", ".geojson")
DOCUMENTS = (".json", ".xml", ".yaml", ".csv", ".points", ".rpb", ".txt", ".qgs")
RECORDS = (".scan",)
"""Folders of what a scan keeps beside a picture."""
TEXTS = (*DOCUMENTS, ".geojson", ".vrt")
FILES = (*RASTERS, *LAYERS, *DOCUMENTS, *RECORDS)


def kind_of(path: Path) -> str:
    """The ending by which a file is chosen: its own, or that of the folder of records that it lies in."""
    return (path.parent if path.parent.suffix in RECORDS else path).suffix.lower()


@dataclass
class Broken:
    """A sound input file, copied with all that lies beside it into a folder of its own, to be broken there."""

    path: Path
    samples: Path
    """The folder of all sound files; to be read only."""
    random: random.Random
    """The only source of chance: the same case breaks the same way again."""
    outside: Path
    """A file that nothing may read into a result, and nobody may change."""
    scale: int = 1
    """Scale of what grows: times as many bytes."""

    @property
    def folder(self) -> Path:
        return self.path.parent

    def beside(self) -> list[Path]:
        """The file's own companions and itself, such as the parts of a shapefile."""
        return sorted(one for one in self.folder.iterdir() if one.is_file() and one.name.startswith(self.path.stem))

    def other(self, endings: tuple[str, ...]) -> Path:
        """Some sound file of other kinds."""
        found = sorted(one for one in self.samples.rglob("*") if one.suffix.lower() in endings)
        return self.random.choice(found)

    def renamed(self, name: str) -> Path:
        """A path beside the file."""
        return self.folder / name


Breakage = Callable[[Broken], Any]
"""Breaks the file or makes another one; returns what the algorithm is given instead, None for the file's own path."""


@dataclass(frozen=True)
class Registered:
    """A breakage and the files it can break."""

    name: str
    endings: tuple[str, ...]
    breaks: Breakage
    grows: bool = False
    """Whether it makes something as long as ``Broken.scale`` says."""


BREAKAGES: dict[str, Registered] = {}


def breakage(*endings: str, grows: bool = False) -> Callable[[Breakage], Breakage]:
    """Add a function to the registry, for files with these endings."""

    def register(function: Breakage) -> Breakage:
        name = function.__name__
        assert name not in BREAKAGES, name
        BREAKAGES[name] = Registered(name, endings, function, grows)
        return function

    return register


def copied(path: Path, folder: Path) -> Path:
    """A copy of a file, or of a folder, with all that lies beside it under its name."""
    folder.mkdir(parents=True, exist_ok=True)
    if path.is_dir():
        return Path(shutil.copytree(path, folder / path.name))
    for one in path.parent.iterdir():
        if one.is_file() and (one.stem == path.stem or one.name.startswith(path.name + ".")):
            shutil.copy(one, folder / one.name)
    return folder / path.name
