"""What stands on paper beside a decision: what it was made of, by whom and when."""
from __future__ import annotations

import os
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from datetime import datetime, timezone
from pathlib import PureWindowsPath

from ...imagery.file_identity import states_in
from ...imagery.rasters import Raster
from ...imagery.seam_totals import SOURCE_FILES
from ...toolkit.pages.templates import HowMeasured, each_raster, system_name
from ...toolkit.translation import local_digits, tr
from ..measure.decision import Decision, Defect, defects_of
from ..measure.delivered_rows import united_settings
from ..measure.delivery import in_words, typical_m
from ..measure.orthoimage_cover import file_stem
from .paper_head import TITLE
from .words import failing_sentence, metres


def listed_images(decision: Decision, paths: Iterable[str]) -> tuple[tuple[str, str], ...]:
    """The orthoimages with their dates: paths that were given, and what the seams call others; in order of names."""
    dates: dict[str, str] = {}
    for piece in decision.delivery.pieces:
        for name, day in ((piece.left_source, piece.left_date), (piece.right_source, piece.right_date)):
            if name and (day or name not in dates):
                dates[name] = day
    of_stem = {file_stem(name): day for name, day in dates.items()}
    images = {path: of_stem.get(file_stem(path), "") for path in paths}
    known = set(map(file_stem, images))
    images.update({name: day for name, day in dates.items() if file_stem(name) not in known})
    return tuple(sorted(images.items(), key=lambda image: (in_words(file_name(image[0])), image[0])))


def scanned_images(decision: Decision) -> list[str]:
    """Paths of the orthoimages that were scanned, lie beside a seam and are still there."""
    pieces = decision.delivery.pieces
    names = {file_name(name) for piece in pieces for name in (piece.left_source, piece.right_source)}
    files = states_in(united_settings(decision.delivery.layers).get(SOURCE_FILES, ""))
    return [path for path, _ in files if file_name(path) in names and os.path.isfile(path)]


def file_name(path: str) -> str:
    """Seamlines may name files with their folders, of any system."""
    return PureWindowsPath(path).name


@dataclass(frozen=True, eq=False)
class InspectionRecord:
    """A decision with what it was made of."""

    decision: Decision
    seams: tuple[tuple[str, str, str], ...] = ()  # sheets, what their layers of seams were read from, their digests
    windows: str = ""  # what the layer of inspected windows was read from; empty without
    rules: str = ""  # the file of rules; empty for ready ones
    mosaics: tuple[Raster, ...] = ()  # what the pictures of failures are cut from
    head: Mapping[str, str] = field(default_factory=dict)  # which delivery it is of, under which contract: stated_head
    images: tuple[tuple[str, str], ...] = ()  # the orthoimages and their dates, by name
    report: str = ""  # the page that is written beside the XML; empty for none
    made_at: datetime = field(default_factory=lambda: datetime.now(timezone.utc).replace(microsecond=0))

    @property
    def title(self) -> str:
        return self.head.get(TITLE) or tr("Acceptance of an orthophoto mosaic")

    @property
    def defects(self) -> tuple[Defect, ...]:
        return defects_of(self.decision)


def how_measured(record: InspectionRecord) -> HowMeasured:
    """The settings and rasters that a decision rests on."""
    decision = record.decision
    scan = united_settings(decision.delivery.layers)
    names = {
        "wavelet": tr("wavelet"), "levels": tr("levels"), "density": tr("density"),
        "piece_m": tr("length of a piece of seam (m)"), "corridor_m": tr("corridor (m)"),
    }  # fmt: skip
    words = {"seams": tr("along the seams"), "full": tr("every pixel")}
    settings = [
        (tr("rules"), decision.rules.name),
        (tr("file of the rules"), record.rules),
        (tr("which pieces fail"), failing_sentence(decision)),
        (tr("typical length of the pieces"), metres(typical_m(decided.piece for decided in decision.pieces))),
        *((title, words.get(scan[name], local_digits(scan[name]))) for name, title in names.items() if name in scan),
        (tr("layer of windows"), record.windows),
        (tr("reference system"), system_name(decision.delivery.wkt)),
    ]
    return HowMeasured(settings, each_raster(tr("mosaic"), record.mosaics), record.made_at.date())
