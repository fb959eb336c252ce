"""In which field producers of mosaics write from which orthoimage a part of them is."""
from __future__ import annotations

import re
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass

from .....imagery.errors import SettingsError
from .. import messages

SOURCE_FIELDS = tuple(
    "source src source_image source_name source_id image_source_reference cliche nom_cliche num_cliche "
    "photo photo_id photo_name photo_no frame frame_id image image_id image_name image_no image_number img img_id "
    "img_name exposure exposure_id ortho orthoimage ortho_name orthophoto file_name file location raster raster_name "
    "bild bildnummer bildname bild_nr zdjecie nr_zdjecia nazwa_pliku ortoobraz local_id raster_id name".split()
)
"""Of polygons, first the ones to be preferred; capitals, blanks and underlines make no difference."""
_SIDES = "left right", "l r", "gauche droite", "links rechts", "lewy prawy"
_OF_SIDE = (
    "{}_source {}_src {}_image {}_img {}_photo {}_ortho {}_name {}_file {}_id {}_cliche source_{} src_{} image_{} "
    "img_{} photo_{} ortho_{} cliche_{} {}".split()
)
SIDE_FIELDS = tuple(
    (pattern.format(left), pattern.format(right)) for left, right in map(str.split, _SIDES) for pattern in _OF_SIDE
)
"""Of lines, in pairs."""
DATE_FIELDS = tuple(
    "phenomenon_time begin_position acquisition_date acq_date image_date img_date idate sdate srcdate source_date "
    "shot_date photo_date flight_date flown_date capture_date date_vol data_nalotu bildflug date".split()
)
"""Of polygons that name no orthoimage: parts of another day are of another one."""

Attributes = Mapping[str, object]


@dataclass(frozen=True)
class SeamFields:
    """Which fields of a layer say what lies where; empty where none does."""

    source: str = ""
    """Of a polygon: what its part of the mosaic was made from."""
    left: str = ""
    """Of a line: what lies on its left hand."""
    right: str = ""
    """Of a line: what lies on its right hand."""
    date: str = ""
    """Of a polygon: when its part was taken; looked for where ``source`` is empty only."""


def seam_fields(rows: Sequence[Attributes], given: str = "") -> SeamFields:
    """The fields of a layer by their names and by whether anything is written in them.

    ``given``: the field to be taken for that of a polygon's source, or two for those of a line's left and right,
    parted by a comma. Raises SettingsError when the layer has no such field.
    """
    names = list(dict.fromkeys(name for row in rows for name in row))
    filled = {name for row in rows for name in row if said(row[name])}
    if given.strip():
        chosen = [part.strip() for part in given.split(",")]
        for name in chosen:
            if name not in names:
                raise SettingsError(messages.SEAM_FIELD_MISSING(field=name, known=", ".join(names)))
        if len(chosen) == 2:
            return SeamFields(left=chosen[0], right=chosen[1])
        return SeamFields(source=given.strip())
    known = {_bare(part): name for name in reversed(names) if name in filled for part in (_last(name), name)}
    pairs = ((_bare(one), _bare(other)) for one, other in SIDE_FIELDS)
    both = ((known[one], known[other]) for one, other in pairs if one in known and other in known)
    left, right = next(both, ("", ""))
    source = _first(SOURCE_FIELDS, known)
    return SeamFields(source, left, right, "" if source else _first(DATE_FIELDS, known))


def said(value: object) -> str:
    """What an attribute says: a name, a number or a date as text, empty where there is none."""
    if value is None:
        return ""
    if isinstance(value, float) and value.is_integer():
        return str(int(value))
    return str(value).strip()


def _first(fields: Iterable[str], known: Mapping[str, str]) -> str:
    return next((known[_bare(field)] for field in fields if _bare(field) in known), "")


def _bare(name: str) -> str:
    return re.sub(r"[\W_]", "", name.lower())


def _last(name: str) -> str:
    """The last part of a name that GDAL made of nested elements: ``phenomenonTime|TimePeriod|beginPosition``."""
    return re.split(r"[|.]", name)[-1]
