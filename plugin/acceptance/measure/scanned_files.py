"""Whether the files that were scanned are those that are given, or there, now: a decision is on these and no others.

A file is known by its content, wherever it lies; one that lies where it was scanned also by the time of its change. The
files of a mosaic that is a VRT are those that it names, and the VRT itself.
"""
from __future__ import annotations

import os
from collections.abc import Iterable, Sequence
from operator import itemgetter

from ...imagery.file_identity import FileState, PlacedState, known_states, local_state, states_in
from ...imagery.gdal_paths import is_remote
from ...imagery.seam_totals import MOSAIC_FILES, SOURCE_FILES
from .delivery import Delivery, FileDoubts
from .orthoimage_cover import seam_cover


def file_doubts(delivery: Delivery, mosaics: Sequence[str], sources: Sequence[str]) -> FileDoubts:
    """``mosaics`` and ``sources``: the rasters that are given."""
    layers = delivery.layers
    scans = [(layer.name, layer.settings) for layer in layers if MOSAIC_FILES in layer.settings]
    if not scans:
        return FileDoubts()
    by_layer = {name: states_in(settings[MOSAIC_FILES]) for name, settings in scans}
    of_mosaic, of_sources = (
        _Scanned([file for _, settings in scans for file in states_in(settings.get(role, ""))])
        for role in (MOSAIC_FILES, SOURCE_FILES)
    )
    not_scanned: list[str] = []
    for path in mosaics:
        name = of_mosaic.stranger(path)
        not_scanned += [name] if name else []
    for path in sources:
        names = of_sources.names
        not_scanned += [
            os.path.basename(part) for part, state in of_sources.give(path).items()
            if os.path.basename(part) in names and not of_sources.knows(part, state)
        ]
    gone, changed = of_mosaic.lost()
    gone_sources, changed_sources = of_sources.lost()
    strange = dict.fromkeys(not_scanned)
    changed = [name for name in dict.fromkeys([*changed, *changed_sources]) if name not in strange]
    others = [
        name for name, files in by_layer.items() if mosaics and not (strange or changed or gone)
        and not all(of_mosaic.is_given(*file) for file in files if not file[1].is_vrt)
    ]
    by_mosaic: dict[frozenset[object], dict[str, str]] = {}
    for layer in (layer for layer in layers if layer.name in by_layer):
        by_mosaic.setdefault(frozenset(map(_known_by, by_layer[layer.name])), {})[layer.digest] = layer.name
    return FileDoubts(
        tuple(strange), tuple(changed), tuple(gone), tuple(gone_sources), tuple(others),
        tuple(name for scanned in by_mosaic.values() if len(scanned) > 1 for name in scanned.values()),
        0 if mosaics else len(by_mosaic),
        seam_cover(
            [piece for piece in delivery.pieces if piece.has_detail], delivery.wkt,
            of_mosaic.places_of(of_mosaic.files), of_sources.places_of(of_sources.files), delivery.not_given,
        ),
    )


class _Scanned:
    """The files of all scans in one role, beside those that are given for them."""

    def __init__(self, files: Iterable[PlacedState]) -> None:
        self.files = list(dict.fromkeys(files))
        self.names = {os.path.basename(path) for path, _ in self.files}
        self._contents = {state.content for _, state in self.files}
        self._times: dict[str, set[int]] = {}
        for path, state in self.files:
            self._times.setdefault(path, set()).add(state.time_ns)
        self._asks = all(state.digest for path, state in self.files if is_remote(path))
        self._given: dict[tuple[int, str] | str, str] = {}

    def knows(self, path: str, state: FileState) -> bool:
        """Whether a file was scanned, and was not written since."""
        if not state.digest:  # of the path alone something is known
            return path in self._times
        return state.content in self._contents and state.time_ns in self._times.get(path, (state.time_ns,))

    def give(self, path: str) -> dict[str, FileState]:
        """What a raster that is given is read from."""
        files = known_states([path], self._asks)
        self._given.update((_known_by(file), file[0]) for file in files.items() if self.knows(*file))
        return files

    def is_given(self, path: str, state: FileState) -> bool:
        """Whether a file that was scanned is given, wherever it lies now."""
        return _known_by((path, state)) in self._given

    def stranger(self, path: str) -> str:
        """The name of the first file of a mosaic that was not scanned; empty where all were.

        A VRT over sheets that were scanned one by one is theirs.
        """
        files = self.give(path)
        by_sheets = not any(state.is_vrt for _, state in self.files)
        strange = [
            (state.is_vrt, os.path.basename(part)) for part, state in files.items()
            if not (self.knows(part, state) or (by_sheets and state.is_vrt))
        ]
        return min(strange, default=(False, ""), key=itemgetter(0))[1]  # a part first

    def lost(self) -> tuple[list[str], list[str]]:
        """Names of the files that are gone, and of those that were changed; none that are given."""
        gone, changed = [], []
        for path, state in self.files:
            if not state.digest or state.content in self._given:
                continue
            now = None if is_remote(path) else local_state(path)  # no server is asked that only a layer names
            if now is None:
                gone.append(os.path.basename(path))
            elif now.content != state.content or now.time_ns != state.time_ns:
                changed.append(os.path.basename(path))
        return gone, changed

    def places_of(self, files: Iterable[PlacedState]) -> list[str]:
        """Paths of files as they are given, else as they were scanned, none on servers; but for VRTs, whose parts are
        files, too."""
        paths = (self._given.get(_known_by(file), file[0]) for file in files if not file[1].is_vrt)
        return [path for path in paths if not is_remote(path)]


def _known_by(file: PlacedState) -> tuple[int, str] | str:
    """What a file is known by: its content, or its path where no more is known of it."""
    path, state = file
    return state.content if state.digest else path
