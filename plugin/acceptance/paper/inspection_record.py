"""What stands on paper beside a decision: what it was made of, by whom and when."""
from __future__ import annotations

import os
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from datetime import datetime, timezone

from ...imagery.documents import json_document
from ...imagery.open_raster import OpenRaster
from ...imagery.rasters import Raster, RasterRef
from ..measure.decision import Decision, Defect, defects_of
from ..measure.delivery import in_words
from .digests import Digest
from .paper_head import PaperHead
from .rated_images import RatedImage

_SETTINGS_DOMAIN = "SEAM_INSPECTOR"  # as the scan writes it
_LISTS = ("mosaic", "sources")  # of the settings: paths as JSON


@dataclass(frozen=True)
class ListedImage:
    """An orthoimage that the delivery was made from."""

    name: str
    """Of its file, or as the seams call it."""
    path: str
    """Empty where nobody gave it."""
    date: str
    """When it was taken, where the seams say so."""
    size: int | None
    """Bytes; None where there is no such file."""


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
    known = {_stem(one.name) for one in given}
    named = [ListedImage(name, "", day, None) for name, day in dates.items() if _stem(name) not in known]
    return tuple(sorted([*given, *named], key=lambda one: (in_words(one.name), one.path)))


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
    seams: tuple[tuple[str, str], ...] = ()
    """Sheets and what their layers of seams were read from."""
    windows: str = ""
    """What the layer of inspected windows was read from; empty without."""
    rules: str = ""
    """The file of rules; empty for ready ones."""
    mosaics: tuple[Raster, ...] = ()
    """What the pictures of failures are cut from."""
    loss: Raster | None = None
    """The picture of losses of the scan."""
    scan: Mapping[str, str] = field(default_factory=dict)
    """How the seams were measured: ``scan_settings`` of the picture of losses."""
    loss_bands: tuple[str, ...] = ()
    """What the picture of losses holds: ``described_bands`` of it."""
    head: PaperHead = field(default_factory=PaperHead)
    """Of which delivery it is, under which contract."""
    images: tuple[ListedImage, ...] = ()
    """The orthoimages, by name."""
    digests: tuple[Digest, ...] = ()
    """Of what was decided on; none where they were not wanted."""
    radiometry: tuple[RatedImage, ...] = ()
    """The images whose radiometry was checked; none where it was not."""
    report: str = ""
    """The page that is written beside the XML; empty for none."""
    made_at: datetime = field(default_factory=lambda: datetime.now(timezone.utc).replace(microsecond=0))

    @property
    def defects(self) -> tuple[Defect, ...]:
        """The longest failure first."""
        return defects_of(self.decision)


def scan_settings(loss: RasterRef) -> dict[str, str]:
    """What a scan wrote into its picture of losses: ``wavelet``, ``levels``, ``density``, ``piece_m``, ``corridor_m``,
    as ``seams`` whether these were ``given`` or ``found``, and as ``unexplained`` the
    share of the mosaic that follows no orthoimage.

    Empty where it is another raster's. Raises RasterError when it can't be opened.
    """
    found = OpenRaster(loss).dataset.GetMetadata(_SETTINGS_DOMAIN)
    return {name: value for name, value in found.items() if name not in _LISTS}


def scanned_sources(loss: RasterRef) -> list[str]:
    """The paths of the orthoimages that a scan was made from; none where its picture of losses doesn't say.

    Raises RasterError when it can't be opened.
    """
    written = OpenRaster(loss).dataset.GetMetadata(_SETTINGS_DOMAIN).get("sources", "")
    try:
        found = json_document(written or "[]")
    except ValueError:
        return []
    return [one for one in found if isinstance(one, str)] if isinstance(found, list) else []


def described_bands(raster: RasterRef) -> tuple[str, ...]:
    """What a raster's bands are called in its file, not by their colours; those without a name by their number.

    Raises RasterError when it can't be opened.
    """
    dataset = OpenRaster(raster).dataset
    return tuple(dataset.GetRasterBand(one).GetDescription() or str(one) for one in range(1, dataset.RasterCount + 1))
