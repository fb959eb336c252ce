"""The features of a layer or file of seams: lines and polygons with what is written beside them."""
from __future__ import annotations

import os
from collections.abc import Collection, Sequence
from dataclasses import dataclass, field

import numpy as np
from osgeo import gdal, ogr

from .....imagery import lines as seamlines
from .....imagery import messages as imagery_messages
from .....imagery.errors import Message, RasterError, SeamlineError
from .....imagery.gdal_calls import gdal_silenced
from .....imagery.gdal_paths import FEATURES, check_raster_path, open_dataset
from .....imagery.grids import Extent, Grid, extents_meet
from .....imagery.rasters import Raster
from .....imagery.reference_systems import geometry_on
from ...seam_cells import Cell
from .. import messages
from .seam_fields import Attributes, SeamFields, said, seam_fields

SeamFeature = tuple[Attributes, "bytes | None"]
"""Attributes by field, and WKB in the mosaic's reference system."""
_UNNAMED = "\x1f"


@dataclass
class GatheredLines:
    """What the features of a layer hold on the mosaic."""

    lines: list[np.ndarray] = field(default_factory=list)
    """(n,) complex each, map units."""
    line_sides: list[tuple[str, str]] = field(default_factory=list)
    """What lies left and right of each, empty where nothing is said."""
    rings: list[np.ndarray] = field(default_factory=list)
    """(n,) complex each, map units, the interior on their left."""
    ring_owners: list[str] = field(default_factory=list)
    """The source that each belongs to, else the feature; ``told`` says what it is called."""
    cells: list[Cell] = field(default_factory=list)
    """Polygons that name their source."""
    dates: dict[str, set[str]] = field(default_factory=dict)
    """When each source was taken, as far as anything says."""
    polygons: list[tuple[str, ogr.Geometry]] = field(default_factory=list)
    """All of them, repaired, with what they are called."""
    repaired: int = 0
    """Polygons that crossed themselves."""
    crossing: int = 0
    """Lines that cross themselves."""
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
    found = GatheredLines()
    empty = True
    for number, (attributes, wkb) in enumerate(features, start=1):
        if wkb:
            try:
                empty &= not _gather(found, wkb, number, attributes, fields, grid, ambiguous)
            except SeamlineError:
                empty = False
                found.broken += 1
    if empty:
        raise SeamlineError(imagery_messages.SEAMLINES_EMPTY())
    if found.lines or found.rings:
        return found
    if found.elsewhere:
        raise SeamlineError(messages.SEAMS_ELSEWHERE(count=found.elsewhere))
    if found.broken:
        raise SeamlineError(messages.SEAM_FEATURES_ALL_BROKEN())
    raise SeamlineError(imagery_messages.SEAMLINES_NO_LINES())


def _gather(
    found: GatheredLines, wkb: bytes, number: int, attributes: Attributes, fields: SeamFields, grid: Grid,
    ambiguous: Collection[str],
) -> bool:
    """One feature; whether it has a geometry. Raises SeamlineError when it can't be read or repaired."""
    with gdal_silenced():
        geometry = seamlines.read_geometry(wkb, number)
    if geometry.IsEmpty():
        return False
    if not extents_meet(_extent(geometry), _widened(grid)):
        found.elsewhere += 1
        return True
    source = _said_in(attributes, fields.source)
    source = "" if source in ambiguous else source
    # Without a name each is a part of its own: two images of one day meet in a seam too.
    date = _said_in(attributes, fields.date)
    owner = source or f"{_UNNAMED}{number}{_UNNAMED}{date if fields.names_by_date else ''}"
    left, right = _said_in(attributes, fields.left), _said_in(attributes, fields.right)
    sides = "" if left in ambiguous else left, "" if right in ambiguous else right
    side_dates = _said_in(attributes, fields.left_date), _said_in(attributes, fields.right_date)
    for name, day in ((told(owner), date), *zip(sides, side_dates)):
        if name and day:
            found.dates.setdefault(name, set()).add(day)
    for part in seamlines.simple_parts(geometry):
        if seamlines.is_polygon(part):
            _gather_polygon(found, part, number, owner)
            if source:
                valid = found.polygons[-1][1]
                found.cells.append(Cell(source, bytes(valid.ExportToWkb(ogr.wkbNDR)), _extent(valid)))
        elif part.GetPointCount() > 1:
            found.lines.append(_finite(seamlines.line_points(part)))
            found.line_sides.append(sides)
            with gdal_silenced():
                found.crossing += not part.IsSimple()
    return True


def _said_in(attributes: Attributes, name: str) -> str:
    return said(attributes.get(name)) if name else ""


def _gather_polygon(found: GatheredLines, polygon: ogr.Geometry, number: int, owner: str) -> None:
    with gdal_silenced():
        is_valid = polygon.IsValid()
    rings = [_finite(ring) for ring in seamlines.polygon_rings(polygon, number)]
    found.repaired += not is_valid
    found.rings += rings
    found.ring_owners += [owner] * len(rings)
    with gdal_silenced():
        found.polygons.append((told(owner), polygon.Clone() if is_valid else polygon.MakeValid()))


def _finite(points: np.ndarray) -> np.ndarray:
    if not np.isfinite(points).all():
        raise SeamlineError(imagery_messages.SEAMLINES_NOT_FINITE())
    return points


def told(owner: str) -> str:
    """The name of an owner: a source, else a date, else nothing."""
    return owner.split(_UNNAMED)[2] if owner.startswith(_UNNAMED) else owner


def _extent(geometry: ogr.Geometry) -> Extent:
    xmin, xmax, ymin, ymax = geometry.GetEnvelope()
    return xmin, ymin, xmax, ymax


def _widened(grid: Grid) -> Extent:
    """The mosaic with a pixel around it: a line along its edge has no width."""
    xmin, ymin, xmax, ymax = grid.extent
    return xmin - grid.pixel_width, ymin - grid.pixel_height, xmax + grid.pixel_width, ymax + grid.pixel_height


_LAYER = "|layername="  # as QGIS writes which layer of a file is meant
_DATES = (ogr.OFTDate, ogr.OFTDateTime)


def read_seam_features(path: str, wkt: str) -> tuple[list[SeamFeature], Message | None]:
    """Attributes and outlines of a vector file in a reference system, and how many can't be transformed.

    ``path`` is ``file`` or ``file|layername=name``; without a name the first layer counts. Raises SeamlineError when
    there is no such layer, RasterError for a path that must not be opened.
    """
    file, _, name = path.partition(_LAYER)
    with gdal_silenced():
        dataset = _opened(file)
        layer = None if dataset is None else (dataset.GetLayerByName(name) if name else dataset.GetLayer(0))
        if layer is None:
            if os.path.exists(file) or file.startswith("/vsi"):
                raise SeamlineError(messages.SEAM_FILE_NOT_READ(path=path))
            raise SeamlineError(imagery_messages.NOT_FOUND(path=file))
        system = layer.GetSpatialRef()
        own_wkt = wkt if system is None else str(system.ExportToWkt())
        features: list[SeamFeature] = []
        lost = 0
        for feature in layer:
            geometry = feature.GetGeometryRef()
            try:
                placed = None if geometry is None else geometry_on(geometry, own_wkt, wkt)
            except RasterError:
                lost += 1
                continue
            features.append((_attributes(feature), None if placed is None else bytes(placed.ExportToWkb(ogr.wkbNDR))))
    return features, messages.SEAM_FEATURES_NOT_TRANSFORMED(count=lost) if lost else None


def read_cells(path: str, mosaic: Raster) -> tuple[Cell, ...]:
    """The polygons of a vector file that name their source. Raises SeamlineError when none lies on the mosaic."""
    features, _ = read_seam_features(path, mosaic.wkt)
    return tuple(gathered(features, seam_fields([attributes for attributes, _ in features]), mosaic.grid).cells)


def _opened(file: str) -> gdal.Dataset | None:
    check_raster_path(file, os.path.basename(file))
    return open_dataset(file, FEATURES)


def _attributes(feature: ogr.Feature) -> dict[str, object]:
    definitions = [feature.GetFieldDefnRef(number) for number in range(feature.GetFieldCount())]
    return {one.GetName(): _value(feature, number, one.GetType()) for number, one in enumerate(definitions)}


def _value(feature: ogr.Feature, number: int, kind: int) -> object:
    """Dates as 2019-07-04, lists of elements that a file repeats parted by commas."""
    value = feature.GetField(number)
    if kind in _DATES and isinstance(value, str):
        return value.replace("/", "-")
    return ", ".join(map(str, value)) if isinstance(value, (list, tuple)) else value
