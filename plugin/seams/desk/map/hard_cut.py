"""What the mosaic is compared with as a layer, and its hard cut in place of it on the map, by a key.

Such layers are never in the project, and in the mosaic's look: with two stretches the eye would compare these, and not
the detail.
"""
from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any
from uuid import uuid4

from qgis.core import QgsProject, QgsRasterLayer, QgsRasterMinMaxOrigin
from qgis.gui import QgsMapCanvas
from qgis.PyQt import sip
from qgis.PyQt.QtCore import QCoreApplication, QObject, Qt, pyqtSignal
from qgis.PyQt.QtWidgets import QLabel
from qgis.PyQt.QtXml import QDomDocument

from ....imagery import messages as imagery_messages
from ....imagery.errors import Message, RasterError
from ....imagery.gdal_calls import drop_from_memory, gdal_call
from ....imagery.open_raster import OpenRaster
from ....imagery.raster_writer import WrittenBands, raster_writer
from ....imagery.rasters import RasterRef
from ....toolkit.background_tasks import BackgroundTasks, Cancelled, Job
from ....toolkit.connections import Connections
from ....toolkit.desk.tool_dock import bar_level
from ....toolkit.desk.widgets import single_shot
from ....toolkit.project_settings import unmodified
from ....toolkit.reference_systems import keep_system, reference_system
from ....toolkit.translation import sentence, tr
from ...measure.window.explained_window import window_composite
from ...measure.window.measured_window import WindowRequest

if TYPE_CHECKING:
    from ..session import Session


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


def write_composite(composite: tuple[tuple[str, ...], Any], request: WindowRequest, path: str) -> None:
    """Write a composite, names and bands, as a raster that differs from the mosaic's window in its pixels only.

    Raises RasterError when the mosaic can't be read.
    """
    window, mosaic = request.window, OpenRaster(request.mosaic.ref)
    assert window is not None
    place = window.column, window.row, window.width, window.height
    failure = imagery_messages.NOT_READABLE(name=mosaic.ref.name)
    pixels = gdal_call(lambda: mosaic.dataset.ReadAsArray(*place), failure).reshape(-1, window.height, window.width)
    for name, band in zip(*composite):
        pixels[mosaic.roles.indices[mosaic.roles.names.index(name)]] = band
    grid = request.mosaic.grid
    left, _, _, top = grid.window_extent(window)
    like = replace(
        request.mosaic, columns=window.width, rows=window.height,
        geotransform=(left, grid.pixel_width, 0.0, top, 0.0, -grid.pixel_height),
    )  # fmt: skip
    with raster_writer(path, like, WrittenBands(len(pixels), pixels.dtype, nodata=mosaic.nodata)) as writer:
        writer.write(0, pixels)


_HELD_S = 0.3  # a key that is let go of sooner was tapped
_REST_MS = 400  # on a window, before its hard cut is made ready: those that are passed by are not waited for
_LABEL = "color: white; background: rgba(20, 20, 20, 220); border-radius: 4px; padding: 3px 6px;"


class Flicker(QObject):
    """Puts a layer of the hard cut above the map's rasters. QGIS keeps both drawn, so that one follows the other at
    once; once it was asked for, that of each window that is gone to lies ready."""

    notified = pyqtSignal(str, int)  # a sentence for the user, and its level in the message bar
    shown = pyqtSignal(bool)  # whether the map shows it from now on

    def __init__(self, canvas: QgsMapCanvas, session: Session, parent: QObject) -> None:
        super().__init__(parent)
        self._canvas, self._session = canvas, session
        self.is_shown = False  # whether it is to be seen, be it still being cut
        self._was_asked = False
        self.hard_cut = ComparedLayer(self)
        self.hard_cut.failed.connect(self._tell)
        self._on_map: QgsRasterLayer | None = None
        self._label = QLabel(canvas)
        self._label.setStyleSheet(_LABEL)
        self._label.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents)
        self._label.hide()
        self._preparer = single_shot(self, self._prepare, _REST_MS)
        self._placer = single_shot(self, self._place)  # never while QGIS takes layers off its map
        self._connections = Connections(
            (session.selectionChanged, self.hide), (session.inputsChanged, self._renew),
            (self.hard_cut.changed, self._place), (canvas.layersChanged, self._placer.start),
        )  # fmt: skip

    def close(self) -> None:
        """Leave nothing on the map."""
        self._preparer.stop()
        self._show(False)
        self._connections.close()
        self._placer.stop()
        self.hard_cut.close()
        if not sip.isdeleted(self._label):
            self._label.deleteLater()

    def press(self) -> bool:
        """Show it, or take it off where it stayed. Whether there is a window whose hard cut can be shown."""
        self._show(not self.is_shown)
        return self._prepare() if self.is_shown else True

    def release(self, seconds: float) -> None:
        """It stays where the key was but tapped."""
        if seconds >= _HELD_S:
            self._show(False)

    def hide(self, *_: object) -> None:
        """What is judged is the mosaic: another window begins with it."""
        self._show(False)
        if self._was_asked:
            self._preparer.start()

    def _renew(self) -> None:
        """There may be another mosaic, or none any more, as in a new project."""
        if self._was_asked:
            self._prepare()

    def _prepare(self) -> bool:
        selected = self._session.selected()
        request = self._session.request(selected[0]) if len(selected) == 1 else None
        self._was_asked = request is not None and request.window is not None and bool(request.sources)
        if not self._was_asked:
            self._show(False)
        self.hard_cut.ask(Compared(request) if request is not None and self._was_asked else None)
        return self._was_asked

    def _show(self, is_shown: bool) -> None:
        if is_shown != self.is_shown:
            self.is_shown = is_shown
            self._place()
            self.shown.emit(is_shown)

    def _place(self) -> None:
        """On the map where it belongs: QGIS sets the map's layers anew when one of them is made visible."""
        if sip.isdeleted(self._canvas):
            return
        cut, mosaic, now = self.hard_cut.layer, self._session.mosaic_layer(), self._canvas.layers()
        layers = [layer for layer in now if layer is not self._on_map]
        self._on_map = cut if self.is_shown else None
        if cut is not None and mosaic is not None and self.is_shown:
            place = next((i for i, layer in enumerate(layers) if isinstance(layer, QgsRasterLayer)), len(layers))
            layers.insert(place, cut)
            if cut not in now:
                looks_alike(cut, mosaic)
        if layers != now:
            with unmodified(QgsProject.instance()):
                self._canvas.setLayers(layers)
        self._label.setText(tr("hard cut of the sources") if cut is not None else tr("hard cut: reading ..."))
        self._label.adjustSize()
        gap = self._label.height() // 3
        self._label.move(gap, self._canvas.height() - self._label.height() - gap)
        self._label.setVisible(self.is_shown)

    def _tell(self, message: Message) -> None:
        was_asked = self.is_shown
        self._show(False)
        self.hard_cut.close()  # the next tap may have more luck
        if was_asked:
            self.notified.emit(sentence(message), bar_level(message))
