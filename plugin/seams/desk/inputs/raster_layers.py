"""The project's rasters, and what their headers say of them beside a mosaic."""
from __future__ import annotations

from collections.abc import Sequence

from qgis.core import (
    Qgis,
    QgsCoordinateReferenceSystem,
    QgsMapLayer,
    QgsProject,
    QgsRasterLayer,
)

from ....imagery.errors import SeamInspectorError
from ....imagery.grids import Extent
from ....toolkit.layers import box_extent, transformed_extent
from ....toolkit.translation import filled, tr
from ....toolkit.version_differences import ALPHA, PALETTE, band_roles
from ...measure.inputs.raster_facts import COLOURS, RasterFacts
from ...tables.scan_layers import is_picture

_MOST_BANDS = 16  # whose roles are asked for


def file_rasters() -> list[QgsRasterLayer]:
    """The project's rasters that GDAL reads from files, by name; pictures of losses are none of them."""
    found = filter(_is_file, QgsProject.instance().mapLayers().values())
    return sorted(found, key=lambda layer: (layer.name().casefold(), layer.id()))


def _is_file(layer: QgsMapLayer) -> bool:
    is_raster = isinstance(layer, QgsRasterLayer) and layer.isValid() and layer.providerType() == "gdal"
    return is_raster and not is_picture(layer)


def facts_of(layers: Sequence[QgsRasterLayer], mosaic: QgsRasterLayer) -> list[RasterFacts]:
    """Of some layers, seen from the mosaic; no file is opened for it."""
    crs = mosaic.crs()
    known: dict[str, bool] = {}
    return [_facts(layer, mosaic, crs, known) for layer in layers]


def _facts(
    layer: QgsRasterLayer, mosaic: QgsRasterLayer, crs: QgsCoordinateReferenceSystem, known: dict[str, bool]
) -> RasterFacts:
    own = layer.crs()
    name = own.authid() or own.toWkt()
    same = known.setdefault(name, own == crs)
    extent = box_extent(layer.extent()) if same else _extent_on(layer, crs)
    size = 0.0
    if extent is not None and layer.width() and layer.height():
        size = ((extent[2] - extent[0]) * (extent[3] - extent[1]) / (layer.width() * layer.height())) ** 0.5
    return RasterFacts(
        layer.id(), layer.name(), extent if size > 0 else None, size or 1.0, _bands(layer), _pixel_type(layer), same,
        layer.id() == mosaic.id() or layer.source() == mosaic.source(),
    )


def _extent_on(layer: QgsRasterLayer, crs: QgsCoordinateReferenceSystem) -> Extent | None:
    if not layer.crs().isValid() or not crs.isValid():
        return None
    try:
        return transformed_extent(box_extent(layer.extent()), layer.crs(), crs, QgsProject.instance())
    except SeamInspectorError:
        return None


def _bands(layer: QgsRasterLayer) -> int:
    """Those that hold measurements."""
    roles = band_roles(layer, _MOST_BANDS)
    if roles == [PALETTE] and layer.dataProvider().colorTable(1):
        return COLOURS
    return int(layer.bandCount()) - roles.count(ALPHA)


def _pixel_type(layer: QgsRasterLayer) -> str:
    provider = layer.dataProvider()
    kind, bits = provider.dataType(1), 8 * provider.dataTypeSize(1)
    is_float = kind in (Qgis.DataType.Float32, Qgis.DataType.Float64)
    return tr("floating point") if is_float else filled(tr("{bits} bit"), bits=bits)
