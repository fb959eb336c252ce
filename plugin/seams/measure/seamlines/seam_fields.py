"""In which field producers of mosaics write from which orthoimage a part of them is, and when that was taken."""
from __future__ import annotations

import re
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass

from ....imagery.errors import Message, SettingsError
from .. import messages
from ..seam_cells import meant_sources

SOURCE_FIELDS = tuple(
    "source src source_image source_name source_id image_source_reference cliche nom_cliche num_cliche "
    "photo photo_id photo_name photo_no frame frame_id image image_id image_name image_no image_number img img_id "
    "img_name exposure exposure_id ortho orthoimage ortho_name orthophoto file_name file location raster raster_name "
    "bild bildnummer bildname bild_nr zdjecie nr_zdjecia nazwa_pliku ortoobraz local_id raster_id name".split()
)
"""Fields of polygons that name their orthoimage, first the ones to be preferred; capitals, blanks and underlines make
no difference, nor does what a shapefile cuts off."""
_SIDES = "left right", "l r", "gauche droite", "links rechts", "lewy prawy"
_OF_SIDE = (
    "{}_source {}_src {}_image {}_img {}_photo {}_ortho {}_name {}_file {}_id {}_cliche source_{} src_{} image_{} "
    "img_{} photo_{} ortho_{} cliche_{} {}".split()
)
SIDE_FIELDS = tuple(
    (pattern.format(left), pattern.format(right)) for left, right in map(str.split, _SIDES) for pattern in _OF_SIDE
)
"""Fields of lines that name the orthoimages on both sides, in pairs."""
DATE_FIELDS = tuple(
    "phenomenon_time begin_position acquisition_date acq_date image_date img_date idate sdate srcdate source_date "
    "shot_date photo_date flight_date flown_date capture_date date_vol data_nalotu bildflug date".split()
)
"""Fields of polygons, when they were taken. Where they name no orthoimage parts of another day are of another one."""
DATE_SIDE_FIELDS = tuple(
    (pattern.format(left), pattern.format(right)) for left, right in map(str.split, _SIDES)
    for pattern in ("{}_date", "date_{}", "{}_acq_date", "{}_data", "data_{}", "{}_datum")
)
"""Fields of lines that say when both sides were taken, in pairs."""
_DBASE_LETTERS = 10  # of a field's name in a shapefile, which is a dBASE table: what is longer is cut

Attributes = Mapping[str, object]


@dataclass(frozen=True)
class SeamFields:
    """The fields of a layer that say what lies where; empty where none does."""

    source: str = ""
    """Field of a polygon: what its part of the mosaic was made from."""
    left: str = ""
    """Field of a line: what lies on its left hand."""
    right: str = ""
    """Field of a line: what lies on its right hand."""
    date: str = ""
    """Field of a polygon: when its part was taken."""
    left_date: str = ""
    """Field of a line: when what lies on its left hand was taken."""
    right_date: str = ""
    """Field of a line: when what lies on its right hand was taken."""

    @property
    def names_by_date(self) -> bool:
        """Whether nothing but dates says what a part of the mosaic was made from."""
        return bool(self.date) and not self.source

    @property
    def naming(self) -> tuple[str, ...]:
        """Fields that name orthoimages."""
        return tuple(filter(None, (self.source, self.left, self.right)))


def seam_fields(rows: Sequence[Attributes], given: str = "") -> SeamFields:
    """The fields of a layer by their names and by whether anything is written in them.

    ``given``: the field to be taken for that of a polygon's source, or two for those of a line's left and right,
    parted by a comma. Raises SettingsError when the layer has no such field.
    """
    names = list(dict.fromkeys(name for row in rows for name in row))
    filled = {name for row in rows for name in row if said(row[name])}
    # GDAL makes names of nested elements: ``phenomenonTime|TimePeriod|beginPosition``.
    parts = [(part, name) for name in reversed(names) if name in filled for part in (re.split(r"[|.]", name)[-1], name)]
    known = {_bare(part): name for part, name in parts}
    (date, *_), (left_date, right_date) = _first(zip(DATE_FIELDS), known), _first(DATE_SIDE_FIELDS, known)
    if given.strip():
        chosen = [part.strip() for part in given.split(",")]
        for name in chosen:
            if name not in names:
                raise SettingsError(messages.SEAM_FIELD_MISSING(field=name, known=", ".join(names)))
        if len(chosen) == 2:
            return SeamFields("", chosen[0], chosen[1], date, left_date, right_date)
        return SeamFields(given.strip(), "", "", date)
    (source, *_), (left, right) = _first(zip(SOURCE_FIELDS), known), _first(SIDE_FIELDS, known)
    return SeamFields(source, left, right, date, left_date, right_date)


def said(value: object) -> str:
    """What an attribute says: a name, a number or a date as text, empty where there is none."""
    if value is None:
        return ""
    if isinstance(value, float) and value.is_integer():
        return str(int(value))
    return str(value).strip()


def _first(wanted: Iterable[tuple[str, ...]], known: Mapping[str, str]) -> tuple[str, ...]:
    """The layer's fields of the first tuple of names that it has all of, each whole or as a shapefile cuts it; empty
    ones where it has none. ``known``: its fields by their bare names."""
    fields = (tuple(_field(_bare(name), known) for name in names) for names in wanted)
    return next(filter(all, fields), ("", ""))


def _field(bare: str, known: Mapping[str, str]) -> str:
    cut = (name for key, name in known.items() if len(name) == _DBASE_LETTERS and bare.startswith(key))
    return known.get(bare) or next(cut, "")


def _bare(name: str) -> str:
    return re.sub(r"[\W_]", "", name.lower())


_TOLD = 3  # names that a notice tells


def source_numbers(
    names: Iterable[str], paths: Sequence[str], images: Sequence[int] | None = None
) -> tuple[dict[str, int], Message | None]:
    """For each name that a layer of seams holds the place of its orthoimage in ``paths``; and which ones have none.

    Endings and capitals don't count. Folders do where files are of one name: a name with its folders means the file
    whose path ends so. A name that is a part of one file's name only, as image numbers are, means that file.
    ``images``: what is found instead of places, where several files may be one image.
    """
    meant = meant_sources(names, paths, images)
    found = {name: next(iter(places)) for name, places in meant.items() if len(places) == 1}
    missing = sorted(name for name, places in meant.items() if not places)
    if not missing or not paths:
        return found, None
    return found, messages.SEAM_SOURCES_MISSING(count=len(missing), names=", ".join(missing[:_TOLD]))
