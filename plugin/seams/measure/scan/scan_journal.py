"""What a scan has measured so far, on disk: one that was stopped in any way goes on where it was.

As long as what decides on its result is the same, which a fingerprint tells.
"""
from __future__ import annotations

import os
import re
from collections.abc import Iterable, Iterator, Sequence
from contextlib import contextmanager
from hashlib import blake2b
from pathlib import Path
from typing import Any
from xml.etree.ElementTree import ParseError, tostring

import numpy as np

from ....imagery import messages as imagery_messages
from ....imagery.atomic_files import drop_unfinished
from ....imagery.documents import plugin_version, xml_root
from ....imagery.errors import Message, SettingsError
from ....imagery.file_identity import OF_NO_CONSEQUENCE, known_states, local_state
from ....imagery.gdal_paths import is_remote, local_file, with_parts
from ....imagery.messages import system_reason
from ....imagery.rasters import RasterRef
from ....imagery.records import RecordFiles, RecordFolder
from .. import messages
from ..source_images import Source

MOST_ASKED = 20  # remote sources whose server is asked for size and date; more would take seconds before a scan starts
_SAID = ".aux.xml"
"""Ending of the file that may say more of a raster, its nodata for instance."""
_MOST_SAID = 10_000_000  # bytes that are read
_PARTS = {
    "version": messages.SCAN_OF_ANOTHER_VERSION,
    "mosaic": messages.SCAN_OF_ANOTHER_MOSAIC,
    "sources": messages.SCAN_OF_OTHER_SOURCES,
    "places": messages.SCAN_OF_OTHER_PLACES,
    "settings": messages.SCAN_WITH_OTHER_SETTINGS,
    "seams": messages.SCAN_OF_OTHER_SEAMS,
}


def fingerprint_of(
    mosaic: RasterRef, sources: Sequence[Source], settings: Any, seams: Iterable[object] = (), place: object = None
) -> str:
    """Fingerprint that is the same as long as the result of a scan would be: a digest of each of its inputs.

    Local files by path, size, time of change and bytes, those that a VRT or an archive is made of too; no remote source
    is opened. The remote mosaic, and up to ``MOST_ASKED`` remote sources, by what their server says of them;
    more by their names. ``settings``: a dataclass of numbers and texts; ``seams``: arrays, texts, numbers or bytes;
    ``place``: where the mosaic lies.
    """
    asked = sum(is_remote(source.ref.path) for source in sources) <= MOST_ASKED
    parts = {
        "version": _digest([plugin_version()]),
        "mosaic": _digest(item for path in mosaic.paths for item in (path, *_states(path, ask=True))),
        "sources": _digest(
            item
            for source in sources
            for path in source.ref.paths
            for item in (path, *_states(path, asked))
        ),
        "places": _digest([
            mosaic.wkt, mosaic.nodata, place,
            *((source.ref.wkt, source.ref.nodata, source.extent) for source in sources),
        ]),
        "settings": _digest([settings]),
        "seams": _digest(seams),
    }
    return " ".join(f"{name}={digest}" for name, digest in parts.items())


def what_changed(older: str, newer: str) -> Message:
    """The first part in which two fingerprints differ, in words."""
    was, is_now = (dict(part.partition("=")[::2] for part in text.split()) for text in (older, newer))
    if was.keys() == is_now.keys():
        for name, message in _PARTS.items():
            if was.get(name) != is_now.get(name):
                return message
    return messages.SCAN_OF_ANOTHER_KIND


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


def _states(path: str, ask: bool) -> Iterator[str]:
    """What is known of a raster's files, those that say where it lies too, without reading its pixels."""
    for file, state in known_states([path], ask).items():
        yield f"{file} {state}"
    for part in with_parts(path):
        if not is_remote(part) and local_file(part) == part and (said := _said_beside(part + _SAID)):
            yield said


def _content(path: str) -> str:
    """Empty where there is no such file."""
    state = local_state(path)
    return "" if state is None else f"{state.size} {state.digest}"


def _said_beside(path: str) -> str:
    """What a file of auxiliary data says that may change how pixels are read; empty where there is no such thing."""
    try:
        if os.path.getsize(path) > _MOST_SAID:
            return _content(path)
        root = xml_root(Path(path).read_bytes())
    except OSError:
        return ""
    except ParseError:
        return _content(path)
    for parent in list(root.iter()):
        for child in [element for element in parent if element.tag in OF_NO_CONSEQUENCE]:
            parent.remove(child)
    kept = [band for band in root if len(band) or (band.text or "").strip()]
    return "".join(re.sub(r"\s+", " ", tostring(element, "unicode")) for element in kept)


_KIND = "Seam Inspector: journal of a scan"
INCOMPLETE = "again"
"""Begins the name of a block that lacks something; a later run measures it anew."""


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
        raise SettingsError(messages.SCAN_JOURNAL_NOT_OPENED(path=path, error=system_reason(error))) from None
    except SettingsError as error:
        if error.message.template == imagery_messages.RECORDS_IN_USE.template:
            raise SettingsError(messages.SCAN_JOURNAL_IN_USE(path=path)) from None
        raise SettingsError(messages.SCAN_JOURNAL_FOREIGN(path=path)) from None
    if journal.was_of is not None and journal.was_of != fingerprint:
        return journal, messages.SCAN_ANEW(what=what_changed(journal.was_of, fingerprint))
    done = sum(not name.startswith(INCOMPLETE) for name in journal.files.names)
    return journal, messages.SCAN_GOES_ON(done=done) if done else None


class ScanJournal(RecordFolder):
    """What a scan is of, and what it has measured so far.

    What is measured outlives the process; what was written last may be lost with the power, and is measured again.
    """

    is_shared = True
    """Whether all who measure see the files."""

    def save(self, name: str, payload: bytes) -> None:
        """Keep what somebody measured who could not. Raises SettingsError on a full disk; what was saved stays."""
        try:
            self.files.save(name, payload)
        except OSError as error:
            raise not_saved(self.files, system_reason(error)) from None


def not_saved(files: RecordFiles, reason: Message | str) -> SettingsError:
    """Why something could not be kept."""
    return SettingsError(messages.SCAN_JOURNAL_NOT_SAVED(path=files.folder, error=reason, done=len(files.names)))
