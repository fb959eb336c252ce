"""A raster to be swiped as a layer of our own: never in the project, and looking as the mosaic does."""
from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace

from qgis.core import QgsMapLayer, QgsProject, QgsRasterLayer, QgsRasterMinMaxOrigin
from qgis.PyQt.QtCore import QCoreApplication
from qgis.PyQt.QtXml import QDomDocument

from ....imagery import messages as imagery_messages
from ....imagery.errors import Message, RasterError
from ....imagery.gdal_calls import drop_from_memory, gdal_call
from ....imagery.open_raster import OpenRaster
from ....imagery.raster_writer import WrittenBands, raster_writer
from ....imagery.rasters import RasterRef
from ....toolkit.background_tasks import Cancelled, Job
from ....toolkit.layers import layer_ref
from ....toolkit.reference_systems import reference_system
from ...measure.window.explained_window import WindowComposite, window_composite
from ...measure.window.window_request import WindowRequest


@dataclass(frozen=True)
class SwipeChoice:
    """What the mosaic can be compared with."""

    title: str
    """What it is called on the map."""
    ref: RasterRef | None = None
    """A source; None: the hard-cut composite."""
    request: WindowRequest | None = None
    """The window that the composite is of."""


def opening_job(ref: RasterRef) -> Job:
    """Opens a raster in the task's thread, since that may take long; yields its QgsRasterLayer, or the Message why
    it can't be."""

    def job(_cancelled: Cancelled) -> Iterator[tuple[float, object]]:
        layer = private_layer(ref)
        yield 1.0, layer if layer.isValid() else imagery_messages.NOT_READABLE(name=ref.name)

    return job


def private_layer(ref: RasterRef) -> QgsRasterLayer:
    """Opened in whatever thread, to be used in that of the interface."""
    options = QgsRasterLayer.LayerOptions()
    options.skipCrsValidation = True  # that would ask the user
    layer = QgsRasterLayer(ref.path, ref.name, "gdal", options)
    if ref.wkt and not layer.crs().isValid():
        layer.setCrs(reference_system(ref.wkt))
    layer.moveToThread(QCoreApplication.instance().thread())
    return layer


def looks_alike(layer: QgsRasterLayer, mosaic: QgsRasterLayer) -> bool:
    """Give a layer the mosaic's style, stretch and all, where it has the same kind of bands; else leave its own.

    With two stretches the eye would compare these, and not the detail.
    """
    own, other = layer.dataProvider(), mosaic.dataProvider()
    if mosaic.renderer() is None or own is None or other is None:
        return False
    for band in mosaic.renderer().usesBands():
        if band > own.bandCount() or own.dataType(band) != other.dataType(band):
            return False
    style = QDomDocument()
    mosaic.exportNamedStyle(style)
    layer.importNamedStyle(style)
    renderer = layer.renderer()
    renderer.setMinMaxOrigin(QgsRasterMinMaxOrigin())  # no stretch of its own when the map is moved
    if renderer.alphaBand() > own.bandCount():
        renderer.setAlphaBand(-1)
    return True


def exchanged(
    shown: list[QgsMapLayer], mosaic: QgsRasterLayer, hidden: set[str], instead: list[QgsMapLayer]
) -> list[QgsMapLayer]:
    """The map's layers with others in the mosaic's place; layers with ``hidden`` ids, its sources, are left out."""
    place = next((i for i, layer in enumerate(shown) if layer is mosaic), None)
    if place is None:  # not on the map: above the first raster
        place = next((i for i, layer in enumerate(shown) if isinstance(layer, QgsRasterLayer)), len(shown))
    above, below = ([one for one in part if one.id() not in hidden and one is not mosaic]
                    for part in (shown[:place], shown[place:]))
    return [*above, *instead, *below]


def is_on_top(shown: list[QgsMapLayer], mosaic: QgsRasterLayer, hidden: set[str]) -> bool:
    """Whether the map shows the mosaic, and not a source above it."""
    above = shown[: shown.index(mosaic)] if mosaic in shown else None
    return above is not None and not any(layer.id() in hidden for layer in above)


def source_layers(project: QgsProject, refs: set[str]) -> set[str]:
    """Ids of the project's layers of these files."""
    return {
        layer.id() for layer in project.mapLayers().values()
        if isinstance(layer, QgsRasterLayer) and layer.source().split("|")[0] in refs
    }  # fmt: skip


def mended_mosaics(project: QgsProject, mosaic: QgsRasterLayer, refs: set[str]) -> list[SwipeChoice]:
    """The project's virtual rasters on just the mosaic's pixels, as a mended one is. ``refs``: files of the sources."""
    others = {mosaic.id(), *source_layers(project, refs)}
    return [
        SwipeChoice(layer.name(), layer_ref(layer)) for layer in project.mapLayers().values()
        if isinstance(layer, QgsRasterLayer) and layer.id() not in others and layer.source().lower().endswith(".vrt")
        and layer.extent() == mosaic.extent() and layer.width() == mosaic.width() and layer.height() == mosaic.height()
    ]  # fmt: skip


def composite_job(request: WindowRequest, path: str) -> Job:
    """Cuts the composite and writes it to ``path``; yields its QgsRasterLayer, or the Message why there is none."""

    def made() -> object:
        found = window_composite(request)
        if isinstance(found, Message):
            return found
        try:
            write_composite(found, request, path)
        except RasterError as error:
            return error.message
        return private_layer(RasterRef(path, request.mosaic.wkt))

    def job(cancelled: Cancelled) -> Iterator[tuple[float, object]]:
        layer = made()
        if cancelled():  # who asked for it dropped the file before it was written
            del layer
            drop_from_memory(path)
            return
        yield 1.0, layer

    return job


def write_composite(composite: WindowComposite, request: WindowRequest, path: str) -> None:
    """Write a composite as a raster that differs from the mosaic's window in the composite's pixels only.

    Raises RasterError when the mosaic can't be read.
    """
    window, mosaic = request.window, OpenRaster(request.mosaic.ref)
    assert window is not None
    pixels = composite.bands
    if mosaic.roles.palette is None:
        place = window.column, window.row, window.width, window.height
        failure = imagery_messages.NOT_READABLE(name=mosaic.ref.name)
        pixels = gdal_call(lambda: mosaic.dataset.ReadAsArray(*place), failure).reshape(-1, window.height, window.width)
        for name, band in zip(composite.names, composite.bands):
            pixels[mosaic.roles.indices[mosaic.roles.names.index(name)]] = band
    grid = request.mosaic.grid
    left, _, _, top = grid.window_extent(window)
    like = replace(
        request.mosaic, columns=window.width, rows=window.height,
        geotransform=(left, grid.pixel_width, 0.0, top, 0.0, -grid.pixel_height),
    )  # fmt: skip
    with raster_writer(path, like, WrittenBands(len(pixels), pixels.dtype, nodata=mosaic.nodata)) as writer:
        writer.write(0, pixels)
