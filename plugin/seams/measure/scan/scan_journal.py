"""What a scan has measured so far, on disk: one that was stopped in any way goes on where it was.

As long as what decides on its result is the same, which a fingerprint tells.
"""
from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from functools import cached_property
from hashlib import blake2b
from itertools import chain
from pathlib import Path
from typing import Any, TypeVar

import numpy as np

from ....imagery import messages as imagery_messages
from ....imagery.atomic_files import drop_unfinished
from ....imagery.documents import plugin_version
from ....imagery.errors import Message, SettingsError
from ....imagery.file_identity import FileState, known_states, local_states, states_text
from ....imagery.gdal_paths import is_remote
from ....imagery.messages import system_reason
from ....imagery.rasters import Raster
from ....imagery.records import NotUnderstoodError, RecordFiles, RecordFolder, sentences_of, value_of
from ....imagery.seam_totals import MOSAIC_FILES, SOURCE_FILES
from .. import messages
from ..source_images import Source

MOST_ASKED = 20  # remote sources whose server is asked for size and date; more would take seconds before a scan starts
_Kept = TypeVar("_Kept")


@dataclass(frozen=True, eq=False)
class ScanInputs:
    """The files of a mosaic and of its orthoimages, as they are before they are read.

    Local files by path, size, time of change and bytes, those that a VRT or an archive is made of too; no remote source
    is opened. The remote mosaic, and up to ``MOST_ASKED`` remote sources, by what their server says of them;
    more by their names.
    """

    mosaic: Raster
    sources: Sequence[Source]

    @property
    def _paths(self) -> tuple[tuple[str, ...], tuple[str, ...]]:
        return self.mosaic.ref.paths, tuple(path for source in self.sources for path in source.ref.paths)

    @cached_property
    def _states(self) -> tuple[Mapping[str, FileState], Mapping[str, FileState]]:
        of_mosaic, of_sources = self._paths
        return known_states(of_mosaic), known_states(of_sources, sum(map(is_remote, of_sources)) <= MOST_ASKED)

    def fingerprint(self, settings: Any, seams: Iterable[object] = ()) -> str:
        """Fingerprint that is the same as long as the result of a scan would be: a digest of all its inputs.

        ``settings``: a dataclass of numbers and texts; ``seams``: arrays, texts, numbers or bytes.
        """
        ref, files = self.mosaic.ref, zip(self._paths, self._states)
        return _digest((
            plugin_version(), *((paths, *states.items()) for paths, states in files),
            ref.wkt, ref.nodata, self.mosaic.geotransform, self.mosaic.wkt,
            *((source.ref.wkt, source.ref.nodata, source.extent) for source in self.sources), settings, *seams,
        ))

    def check(self) -> None:
        """Raise SettingsError where a raster has changed meanwhile."""
        now = local_states(chain(*self._paths))
        for path, state in chain(*(states.items() for states in self._states)):
            if now.get(path, state) != state:  # of one that is gone blocks have told
                raise SettingsError(messages.SCAN_INPUT_CHANGED(name=Path(path).name))

    @property
    def told(self) -> dict[str, str]:
        """What layers say of them."""
        of_mosaic, of_sources = self._states
        return {MOSAIC_FILES: states_text(of_mosaic.items()), SOURCE_FILES: states_text(of_sources.items())}


def _digest(items: Iterable[object]) -> str:
    """Digest of arrays, and of values whose text does not depend on the process."""
    digest = blake2b(digest_size=12)
    for item in items:
        parts = [repr(item).encode()]
        if isinstance(item, np.ndarray):
            parts = [f"{item.dtype.str} {item.shape}".encode(), np.ascontiguousarray(item).tobytes()]
        for part in parts:
            digest.update(f"{len(part)}:".encode() + part)
    return digest.hexdigest()


_KIND = "Seam Inspector: journal of a scan"


@contextmanager
def journal_beside(output: Path, ending: str, fingerprint: str) -> Iterator[tuple[ScanJournal, Message | None]]:
    """The journal beside an output, for this run alone, and what became of an earlier run. What was killed while it
    wrote the output leaves nothing.

    Raises SettingsError as ``open_journal`` does.
    """
    journal, notice = open_journal(output.with_name(output.name + ending), fingerprint)
    try:
        drop_unfinished(output)
        yield journal, notice
    finally:
        journal.close()


def open_journal(path: Path, fingerprint: str) -> tuple[ScanJournal, Message | None]:
    """The journal in a folder, for this scan alone, and what the user should know of an earlier one there.

    An earlier scan of the same ``fingerprint`` goes on. Of another fingerprint nothing is kept.

    Raises SettingsError where no folder can be, another scan has it, or it is something else.
    """
    try:
        journal = ScanJournal(path, _KIND, fingerprint)
    except OSError as error:
        raise SettingsError(imagery_messages.FILE_NOT_WRITTEN(path=path, error=system_reason(error))) from None
    except SettingsError as error:
        if error.message.template == imagery_messages.RECORDS_IN_USE.template:
            raise SettingsError(messages.SCAN_JOURNAL_IN_USE(path=path)) from None
        raise SettingsError(messages.SCAN_JOURNAL_FOREIGN(path=path)) from None
    if journal.was_of is not None and journal.was_of != fingerprint:
        return journal, messages.SCAN_ANEW()
    done = len(journal.files.names)
    return journal, messages.SCAN_GOES_ON(done=done) if done else None


class ScanJournal(RecordFolder):
    """What a scan is of, and what it has measured so far.

    What is measured outlives the process; what was written last may be lost with the power, and is measured again.
    """

    is_shared = True
    """Whether all who measure see the files."""


def save(files: RecordFiles, name: str, payload: bytes) -> None:
    """Keep something. Raises SettingsError on a full disk; what was saved stays."""
    try:
        files.save(name, payload)
    except OSError as error:
        raise not_saved(files, system_reason(error)) from None


def not_saved(files: RecordFiles, reason: Message | str) -> SettingsError:
    """Why something could not be kept."""
    return SettingsError(messages.SCAN_JOURNAL_NOT_SAVED(path=files.folder, error=reason, done=len(files.names)))


def loaded(files: RecordFiles, name: str, kind: type[_Kept]) -> _Kept | None:
    """The instance of a class that was kept; None where nothing was. Raises SettingsError where it can't be read any
    more; it is then forgotten, and measured again when the scan is started again."""
    try:
        record = files.load(name)
        return None if record is None else value_of(kind, record, sentences_of(imagery_messages, messages))
    except (OSError, NotUnderstoodError) as error:
        files.forget(name)
        why = system_reason(error) if isinstance(error, OSError) else str(error)
        raise SettingsError(messages.SCAN_JOURNAL_NOT_READ(path=files.folder, error=why)) from None
