"""The features of a layer or file of seams: lines and polygons with what is written beside them, and in which fields
producers of mosaics write from which orthoimage a part of them is, and when that was taken."""
from __future__ import annotations

import os
import re
from collections.abc import Collection, Iterable, Mapping, Sequence
from dataclasses import dataclass, field

import numpy as np
from osgeo import ogr

from ....imagery import lines as seamlines
from ....imagery import messages as imagery_messages
from ....imagery.errors import Message, RasterError, SeamlineError, SeamsElsewhereError, SettingsError
from ....imagery.gdal_calls import gdal_silenced
from ....imagery.gdal_paths import FEATURES, check_raster_path, is_there, open_dataset
from ....imagery.grids import Extent, Grid, extents_meet
from ....imagery.rasters import Raster
from ....imagery.reference_systems import geometry_on
from .. import messages
from ..seam_cells import Cell, meant_sources

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


_MOST_NAMED = 3  # names that a notice tells


def source_numbers(
    names: Iterable[str], images: Sequence[Sequence[str]]
) -> tuple[dict[str, int], Message | None]:
    """For each name that a layer of seams holds the place of its orthoimage in ``images``, the paths of each; and which
    ones have none.

    Endings and capitals don't count. Folders do where files are of one name: a name with its folders means the file
    whose path ends so. A name that is a part of one file's name only, as image numbers are, means that file.
    """
    meant = meant_sources(names, images)
    numbers = {name: next(iter(places)) for name, places in meant.items() if len(places) == 1}
    missing = sorted(name for name, places in meant.items() if not places)
    if not missing or not images:
        return numbers, None
    return numbers, messages.SEAM_SOURCES_MISSING(count=len(missing), names=", ".join(missing[:_MOST_NAMED]))


SeamFeature = tuple[Attributes, "bytes | None"]
"""Attributes by field, and WKB in the mosaic's reference system."""
_UNNAMED = "\x1f"


@dataclass
class GatheredLines:
    """What the features of a layer hold on the mosaic."""

    lines: list[tuple[np.ndarray, tuple[str, str]]] = field(default_factory=list)
    """(n,) complex each, map units, and what lies left and right of it, empty where nothing is said."""
    rings: list[tuple[np.ndarray, str]] = field(default_factory=list)
    """(n,) complex each, map units, the interior on their left, and the source that it belongs to, else the feature;
    ``owner_name`` says what that is called."""
    cells: list[Cell] = field(default_factory=list)
    """Polygons that name their source."""
    dates: dict[str, set[str]] = field(default_factory=dict)
    """When each source was taken, as far as anything says."""
    repaired: int = 0
    """Polygons that crossed themselves."""
    broken: int = 0
    """Features that can't be read."""
    elsewhere: int = 0
    """Features that don't lie on the mosaic."""


def gathered(
    features: Sequence[SeamFeature], fields: SeamFields, grid: Grid, ambiguous: Collection[str] = ()
) -> GatheredLines:
    """The lines and polygons of a layer that lie on the mosaic.

    ``ambiguous``: names that fit several sources, which are as good as none. Raises SeamlineError when there is none.
    """
    lines = GatheredLines()
    # A pixel wider: a line along the mosaic's edge has no width.
    xmin, ymin, xmax, ymax = grid.extent
    widened = xmin - grid.pixel_width, ymin - grid.pixel_height, xmax + grid.pixel_width, ymax + grid.pixel_height
    for number, (attributes, wkb) in enumerate(features, start=1):
        if not wkb:
            continue
        try:
            with gdal_silenced():
                geometry = seamlines.read_geometry(wkb, number)
            if geometry.IsEmpty():
                continue
            if extents_meet(_extent(geometry), widened):
                words = {key: said(attributes.get(name)) if name else "" for key, name in vars(fields).items()}
                # What is ambiguous names nothing.
                words = {key: "" if word in ambiguous and "date" not in key else word for key, word in words.items()}
                _gather(lines, geometry, number, words, fields.names_by_date)
            else:
                lines.elsewhere += 1
        except SeamlineError:
            lines.broken += 1
    if lines.lines or lines.rings:
        return lines
    if lines.elsewhere:
        raise SeamsElsewhereError(messages.SEAMS_ELSEWHERE(count=lines.elsewhere))
    if lines.broken:
        raise SeamlineError(messages.SEAM_FEATURES_BROKEN(count=lines.broken))
    raise SeamlineError(imagery_messages.SEAMLINES_NO_LINES())


def _gather(
    lines: GatheredLines, geometry: ogr.Geometry, number: int, words: Mapping[str, str], named_by_date: bool
) -> None:
    """Take in one feature. Raises SeamlineError when it can't be read or repaired."""
    source, date, sides = words["source"], words["date"], (words["left"], words["right"])
    # Without a name each is a part of its own: two images of one day meet in a seam too.
    owner = source or f"{_UNNAMED}{number}{_UNNAMED}{date if named_by_date else ''}"
    days = date, words["left_date"], words["right_date"]
    for name, day in zip((owner_name(owner), *sides), days):
        if name and day:
            lines.dates.setdefault(name, set()).add(day)
    for part in seamlines.simple_parts(geometry):
        if seamlines.is_polygon(part):
            rings = [(_finite(ring), owner) for ring in seamlines.polygon_rings(part, number)]
            with gdal_silenced():
                is_valid = part.IsValid()
                polygon = part if is_valid else part.MakeValid()
            lines.repaired += not is_valid
            lines.rings += rings
            if source:
                lines.cells.append(Cell(source, bytes(polygon.ExportToWkb(ogr.wkbNDR)), _extent(polygon)))
        elif part.GetPointCount() > 1:
            lines.lines.append((_finite(seamlines.line_points(part)), sides))


def _finite(points: np.ndarray) -> np.ndarray:
    if not np.isfinite(points).all():
        raise SeamlineError(imagery_messages.SEAMLINES_NOT_FINITE())
    return points


def owner_name(owner: str) -> str:
    """The name of an owner: a source, else a date, else nothing."""
    return owner.split(_UNNAMED)[2] if owner.startswith(_UNNAMED) else owner


def _extent(geometry: ogr.Geometry) -> Extent:
    xmin, xmax, ymin, ymax = geometry.GetEnvelope()
    return xmin, ymin, xmax, ymax


_LAYER = "|layername="  # as QGIS writes which layer of a file is meant
_UNDEFINED = "Undefined"  # geographic or Cartesian system: what a GeoPackage names where it has none
_DATES = (ogr.OFTDate, ogr.OFTDateTime)


def read_seam_features(path: str, wkt: str) -> tuple[list[SeamFeature], list[Message]]:
    """Attributes and outlines of a vector file in a reference system, and what is to be told of that.

    ``path`` is ``file`` or ``file|layername=name``; without a name the first layer counts. Raises SeamlineError when
    there is no such layer, RasterError for a path that must not be opened.
    """
    file, _, name = path.partition(_LAYER)
    with gdal_silenced():
        check_raster_path(file, os.path.basename(file))
        dataset = open_dataset(file, FEATURES)
        layer = None if dataset is None else (dataset.GetLayerByName(name) if name else dataset.GetLayer(0))
        if layer is None:
            if is_there(file):
                raise SeamlineError(messages.SEAM_FILE_NOT_READ(path=path))
            raise SeamlineError(imagery_messages.NOT_FOUND(path=file))
        system = layer.GetSpatialRef()
        has_system = system is not None and not system.GetName().startswith(_UNDEFINED)
        own_wkt = str(system.ExportToWkt()) if has_system else wkt
        features: list[SeamFeature] = []
        lost = 0
        for feature in layer:
            geometry = feature.GetGeometryRef()
            try:
                placed = None if geometry is None else geometry_on(geometry, own_wkt, wkt)
            except RasterError:
                lost += 1
                continue
            kinds = [feature.GetFieldDefnRef(number) for number in range(feature.GetFieldCount())]
            attributes = {kind.GetName(): _value(feature, number, kind.GetType()) for number, kind in enumerate(kinds)}
            features.append((attributes, None if placed is None else bytes(placed.ExportToWkb(ogr.wkbNDR))))
    notices = [None if has_system else messages.SEAMS_WITHOUT_SYSTEM(path=path), lost_features(lost, features)]
    return features, [notice for notice in notices if notice is not None]


def lost_features(lost: int, others: Sequence[SeamFeature]) -> Message | None:
    """What to tell of so many that can't be transformed. Raises SeamlineError where there are no others."""
    if lost and not others:
        raise SeamlineError(messages.SEAMS_ELSEWHERE(count=lost))
    return messages.SEAM_FEATURES_NOT_TRANSFORMED(count=lost) if lost else None


def read_cells(path: str, mosaic: Raster) -> tuple[Cell, ...]:
    """The polygons of a vector file that name their source. Raises SeamlineError when none lies on the mosaic."""
    features, _ = read_seam_features(path, mosaic.wkt)
    cells = gathered(features, seam_fields([attributes for attributes, _ in features]), mosaic.grid).cells
    if not cells:
        raise SeamlineError(messages.NO_CELLS(path=path))
    return tuple(cells)


def _value(feature: ogr.Feature, number: int, kind: int) -> object:
    """Dates as 2019-07-04, lists of elements that a file repeats parted by commas."""
    value = feature.GetField(number)
    if kind in _DATES and isinstance(value, str):
        return value.replace("/", "-")
    return ", ".join(map(str, value)) if isinstance(value, (list, tuple)) else value
