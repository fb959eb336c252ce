"""What stands on paper beside a decision: what it was made of, with digests so that nobody can say later that it was
something else, what 'Check radiometry' found, by whom and when.
"""
from __future__ import annotations

import hashlib
import os
from collections.abc import Iterable, Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, field
from datetime import datetime, timezone
from statistics import median
from typing import Callable

from ...imagery.errors import CancelledError, SettingsError
from ...imagery.file_identity import states_in
from ...imagery.open_raster import OpenRaster, placed
from ...imagery.rasters import Raster, RasterRef
from ...imagery.seam_totals import SOURCE_FILES, TOTALS_DOMAIN
from ...toolkit.algorithms.run import Run
from ...toolkit.layers import features
from ...toolkit.pages.templates import HowMeasured, each_raster, system_name
from ...toolkit.resources import plugin_commit
from ...toolkit.table_fields import attributes, text, whole_number
from ...toolkit.translation import filled, tr
from ..measure import messages
from ..measure.decision import AcceptanceOutcome, Decision, Defect, defects_of
from ..measure.delivered_rows import united_settings
from ..measure.delivery import in_words
from .paper_head import RADIOMETRY, TITLE
from .words import failing_sentence, metres


@dataclass(frozen=True)
class ListedImage:
    """An orthoimage that the delivery was made from."""

    name: str  # name of its file, or as the seams call it
    path: str  # empty where nobody gave it
    date: str  # when it was taken, where the seams say so
    size: int | None  # bytes; None where there is no such file


def listed_images(decision: Decision, paths: Iterable[str]) -> tuple[ListedImage, ...]:
    """All that were given, and those that the seams name beside these, with their dates; in order of names."""
    dates: dict[str, str] = {}
    for piece in decision.delivery.pieces:
        for name, day in ((piece.left_source, piece.left_date), (piece.right_source, piece.right_date)):
            if name and (day or name not in dates):
                dates[name] = day
    of_stem = {_stem(name): day for name, day in dates.items()}
    given = [
        ListedImage(file_name(path), path, of_stem.get(_stem(path), ""), _size(path)) for path in dict.fromkeys(paths)
    ]
    known = {_stem(image.name) for image in given}
    named = [ListedImage(name, "", day, None) for name, day in dates.items() if _stem(name) not in known]
    return tuple(sorted([*given, *named], key=lambda image: (in_words(image.name), image.path)))


def scanned_images(decision: Decision) -> list[str]:
    """Paths of the orthoimages that were scanned, lie beside a seam and are still there."""
    pieces = decision.delivery.pieces
    names = {file_name(name) for piece in pieces for name in (piece.left_source, piece.right_source)}
    files = states_in(united_settings(decision.delivery.layers).get(SOURCE_FILES, ""))
    return [path for path, _ in files if file_name(path) in names and os.path.isfile(path)]


def file_name(path: str) -> str:
    """Seamlines may name files with their folders, of any system."""
    return path.replace("\\", "/").rstrip("/").rpartition("/")[2]


def _stem(path: str) -> str:
    name = file_name(path)
    return (name.rpartition(".")[0] or name).lower()


def _size(path: str) -> int | None:
    return os.path.getsize(path) if os.path.isfile(path) else None


@dataclass(frozen=True, eq=False)
class InspectionRecord:
    """A decision with what it was made of."""

    decision: Decision
    seams: tuple[tuple[str, str], ...] = ()  # sheets and what their layers of seams were read from
    windows: str = ""  # what the layer of inspected windows was read from; empty without
    rules: str = ""  # the file of rules; empty for ready ones
    mosaics: tuple[Raster, ...] = ()  # what the pictures of failures are cut from
    loss: ScannedLoss | None = None  # the picture of losses, where there is one for all
    head: Mapping[str, str] = field(default_factory=dict)  # which delivery it is of, under which contract: stated_head
    images: tuple[ListedImage, ...] = ()  # the orthoimages, by name
    digests: tuple[Digest, ...] = ()  # digests of what was decided on; none where they were not wanted
    radiometry: tuple[RatedImage, ...] = ()  # the images whose radiometry was checked; none where it was not
    report: str = ""  # the page that is written beside the XML; empty for none
    made_at: datetime = field(default_factory=lambda: datetime.now(timezone.utc).replace(microsecond=0))

    @property
    def title(self) -> str:
        return self.head.get(TITLE) or tr("Acceptance of an orthophoto mosaic")

    @property
    def defects(self) -> tuple[Defect, ...]:
        return defects_of(self.decision)

    @property
    def faults(self) -> list[tuple[str, str]]:
        """Sheets with what was found wrong with their files."""
        return [(sheet.name, "; ".join(sheet.findings)) for sheet in self.decision.delivery.outlines if sheet.findings]

    def rated(self, outcome: AcceptanceOutcome) -> list[RatedImage]:
        """The images whose radiometry came out so."""
        return [image for image in self.radiometry if image.outcome is outcome]


def how_measured(record: InspectionRecord) -> HowMeasured:
    """The settings and rasters that a decision rests on."""
    decision = record.decision
    scan = united_settings(decision.delivery.layers)
    names = {
        "wavelet": tr("wavelet"), "levels": tr("levels"), "density": tr("density"),
        "piece_m": tr("length of a piece of seam (m)"), "corridor_m": tr("corridor (m)"),
    }  # fmt: skip
    settings = [
        (tr("commit of the plugin"), plugin_commit()),
        (tr("rules"), decision.rules.name),
        (tr("file of the rules"), record.rules),
        (tr("which pieces fail"), failing_sentence(decision)),
        (tr("median length of the pieces"), metres(median(decided.piece.length_m for decided in decision.pieces))),
        *((title, scan[name]) for name, title in names.items() if name in scan),
        (tr("layer of windows"), record.windows),
        (tr("reference system"), system_name(decision.delivery.wkt)),
    ]
    rasters = each_raster(tr("mosaic"), record.mosaics)
    rasters += each_raster(tr("picture of losses"), [record.loss.raster] if record.loss else [])
    return HowMeasured(settings, rasters, record.made_at.date())


@dataclass(frozen=True, eq=False)
class ScannedLoss:
    """A scan's picture of losses."""

    raster: Raster
    bands: tuple[str, ...]  # their names


def loss_picture(ref: RasterRef) -> ScannedLoss | None:
    """None for another raster. Raises RasterError when it can't be opened."""
    opened = OpenRaster(ref)
    if not opened.dataset.GetMetadata(TOTALS_DOMAIN):
        return None
    bands = (opened.dataset.GetRasterBand(number + 1) for number in range(opened.dataset.RasterCount))
    names = tuple(band.GetDescription() or str(number) for number, band in enumerate(bands, 1))
    return ScannedLoss(placed(opened.raster), names)


_AT_ONCE = 1 << 22  # bytes


@dataclass(frozen=True)
class Digest:
    """What was digested, and what came of it."""

    path: str  # path of a file; what it is, in words, where there is none
    size: int | None  # bytes; None of what is no file
    sha256: str  # hexadecimal, 64 digits


def file_digests(paths: Sequence[str], goes_on: Callable[[float], bool]) -> Iterator[Digest]:
    """SHA-256 of each file as ``sha256sum`` prints it; a file that can't be read has none.

    ``goes_on``: told the share of the bytes that is done, 0 to 1; where it says no a CancelledError is raised.
    """
    sizes = {path: os.path.getsize(path) for path in paths if os.path.isfile(path)}
    total, done = max(sum(sizes.values()), 1), 0
    for path, size in sizes.items():
        digest = hashlib.sha256()
        with suppress(OSError):
            with open(path, "rb") as file:
                while block := file.read(_AT_ONCE):
                    if not goes_on(min(done / total, 1.0)):
                        raise CancelledError(messages.PAPER_STOPPED())
                    digest.update(block)
                    done += len(block)
            yield Digest(path, size, digest.hexdigest())


def list_digest(images: Iterable[ListedImage]) -> Digest:
    """Digest of the list of orthoimages: a line for each, its cells between tabs, in UTF-8."""
    cells = ((image.name, image.path, image.date, image.size) for image in images)
    lines = ("\t".join("" if cell is None else str(cell) for cell in row) for row in cells)
    content = "".join(f"{line}\n" for line in lines).encode()
    return Digest(tr("list of orthoimages"), len(content), hashlib.sha256(content).hexdigest())


@dataclass(frozen=True)
class RatedImage:
    """An image, or a window of it."""

    name: str
    outcome: AcceptanceOutcome
    failed_by: tuple[str, ...]  # where the limits come from that it does not keep, each once


def rated_images(run: Run) -> tuple[RatedImage, ...]:
    """In the order of the table; none where none is given. Raises SettingsError for another table."""
    if not run.parameters.get(RADIOMETRY):
        return ()
    source = run.source(RADIOMETRY)
    names = source.fields().names()
    if not {"raster", "window_id", "passed", "source", "decision"} <= set(names):
        raise SettingsError(messages.RADIOMETRY_NO_TABLE(name=source.sourceName()))
    images: dict[str, tuple[str, dict[str, None]]] = {}
    for row in attributes(features(source), names):
        name, window = text(row["raster"]), whole_number(row["window_id"])
        if window is not None:
            name = filled(tr("{name}, window {window}"), name=name, window=window)
        _, failed_by = images.setdefault(name, (text(row["decision"]), {}))
        if whole_number(row["passed"]) == 0:
            failed_by[text(row["source"])] = None
    words = {outcome.value: outcome for outcome in AcceptanceOutcome}
    return tuple(
        RatedImage(name, words.get(decision, AcceptanceOutcome.UNDECIDED), tuple(failed_by))
        for name, (decision, failed_by) in images.items()
    )
