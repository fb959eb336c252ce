"""What the mosaic is compared with as a layer: a source, or the hard cut of all in a window. Never in the project, and
in the mosaic's look: with two stretches the eye would compare these, and not the detail."""
from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from uuid import uuid4

from qgis.core import QgsRasterLayer, QgsRasterMinMaxOrigin
from qgis.PyQt.QtCore import QCoreApplication, QObject, pyqtSignal
from qgis.PyQt.QtXml import QDomDocument

from ....imagery import messages as imagery_messages
from ....imagery.errors import Message, RasterError
from ....imagery.gdal_calls import drop_from_memory, gdal_call
from ....imagery.open_raster import OpenRaster
from ....imagery.raster_writer import WrittenBands, raster_writer
from ....imagery.rasters import RasterRef
from ....toolkit.background_tasks import BackgroundTasks, Cancelled, Job
from ....toolkit.reference_systems import keep_system, reference_system
from ....toolkit.translation import tr
from ...measure.window.explained_window import WindowComposite, window_composite
from ...measure.window.window_request import WindowRequest


@dataclass(frozen=True)
class Compared:
    """What the mosaic is compared with in a window."""

    request: WindowRequest
    source: RasterRef | None = None  # none: the hard cut of the window's sources


class ComparedLayer(QObject):
    """One at a time, opened in the background, since that may take long."""

    changed = pyqtSignal()  # ``layer`` is another one
    failed = pyqtSignal(object)  # the Message why there is none

    def __init__(self, parent: QObject) -> None:
        super().__init__(parent)
        self._background = BackgroundTasks(self)
        self._background.failed.connect(self.failed)
        self._compared: Compared | None = None
        self._file = ""  # of the hard cut, in memory
        self.layer: QgsRasterLayer | None = None  # none until it is there
        self.why_not: Message | None = None  # why it can't be had

    def ask(self, compared: Compared | None) -> None:
        """This one from now on; None: nothing."""
        if compared == self._compared:
            return
        self.close()
        self._compared = compared
        if compared is None:
            return
        if compared.source is not None:
            job, title = opening_job(compared.source), tr("Open a source")
        else:
            self._file = f"/vsimem/seam_inspector_composite_{uuid4().hex}.tif"
            job, title = composite_job(compared.request, self._file), tr("Cut the composite")
        self._background.start(title, job, self._take)

    def close(self) -> None:
        """No layer, and none to come. What is still being drawn keeps its file open."""
        self._background.abandon()
        self._compared, had_layer, self.layer, self.why_not = None, self.layer is not None, None, None
        file, self._file = self._file, ""
        if file:
            drop_from_memory(file)
        if had_layer:
            self.changed.emit()

    def _take(self, layer: object) -> None:
        if isinstance(layer, QgsRasterLayer):
            keep_system(layer)
            self.layer = layer
            self.changed.emit()
        elif isinstance(layer, Message):
            self.why_not = layer
            self.failed.emit(layer)


def opening_job(ref: RasterRef) -> Job:
    """Opens a raster; yields its QgsRasterLayer, or the Message why it can't be."""

    def job(_cancelled: Cancelled) -> Iterator[tuple[float, object]]:
        layer = private_layer(ref)
        yield 1.0, layer if layer.isValid() else imagery_messages.NOT_READABLE(name=ref.name)

    return job


def private_layer(ref: RasterRef) -> QgsRasterLayer:
    """Opened in whatever thread, to be used in that of the interface."""
    options = QgsRasterLayer.LayerOptions()
    options.skipCrsValidation = True  # that would ask the user
    layer = QgsRasterLayer(ref.path, ref.name, "gdal", options)
    if ref.wkt:
        layer.setCrs(reference_system(ref.wkt))
    layer.moveToThread(QCoreApplication.instance().thread())
    return layer


def looks_alike(layer: QgsRasterLayer, mosaic: QgsRasterLayer) -> bool:
    """Give a layer the mosaic's style, stretch and all, where it has the same kind of bands; else leave its own."""
    bands, other = layer.dataProvider(), mosaic.dataProvider()
    if mosaic.renderer() is None or bands is None or other is None:
        return False
    for band in mosaic.renderer().usesBands():
        if band > bands.bandCount() or bands.dataType(band) != other.dataType(band):
            return False
    style = QDomDocument()
    mosaic.exportNamedStyle(style)
    layer.importNamedStyle(style)
    renderer = layer.renderer()
    renderer.setMinMaxOrigin(QgsRasterMinMaxOrigin())  # no stretch of its own when the map is moved
    if renderer.alphaBand() > bands.bandCount():
        renderer.setAlphaBand(-1)
    return True


def composite_job(request: WindowRequest, path: str) -> Job:
    """Cuts the composite and writes it to ``path``; yields its QgsRasterLayer, or the Message why there is none."""

    def made() -> object:
        composite = window_composite(request)
        if isinstance(composite, Message):
            return composite
        try:
            write_composite(composite, request, path)
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
