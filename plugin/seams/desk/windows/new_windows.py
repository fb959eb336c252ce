"""Windows come into being: drawn, placed along the seams or found by a scan, and the file that holds them."""
from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import partial
from pathlib import Path
from typing import Any

from qgis.core import QgsGeometry, QgsProject, QgsVectorLayer
from qgis.PyQt.QtCore import QObject, pyqtSignal

from ....imagery.errors import SeamInspectorError, WindowLayerError
from ....imagery.grids import Extent, PixelWindow
from ....imagery.open_raster import OpenRaster
from ....toolkit import layers
from ....toolkit.background_tasks import BackgroundTasks
from ....toolkit.desk.tool_dock import write_log
from ....toolkit.translation import filled, tr
from ... import jobs
from ...measure import messages
from ...measure.planning.window_placing import Placement
from ...measure.window.inspection import Block
from ...measure.window_records import WindowRecord
from ...tables import window_file, window_layer
from ...words import shown_side
from .. import messages as keeping_messages
from ..inputs.block_cache import BlockCache
from ..window_home import WindowHome
from .window_results import WindowSteps
from .window_watch import WindowWatch

_PLACING = "placing"
DRAWN, PLACED, SCAN = "drawn", "placed", "scan"
"""The field ``origin`` of a window."""
_SAME_PLACE = 0.5  # of a place: more of it was looked at than not, its middle included, when a window was judged
_SAME = 0.999  # of the larger of two: coordinates are rounded where files and reference systems change


Place = tuple[QgsGeometry, Mapping[str, object]]
"""The outline of a window, in the reference system of the window layer, and what is known of it by fields' names."""


class NewWindows(QObject):
    """Methods raise SeamInspectorError where inputs or layer do not allow what is asked."""

    layerMade = pyqtSignal(str)  # id of a new window layer in the project, to be followed from now on
    notified = pyqtSignal(object)  # a Message

    def __init__(
        self, home: WindowHome, block: BlockCache, watch: WindowWatch, steps: WindowSteps, background: BackgroundTasks,
        parent: QObject,
    ) -> None:
        super().__init__(parent)
        self._home = home
        self._project = QgsProject.instance()
        self._block = block
        self._watch = watch
        self._steps = steps
        self._background = background

    def draw(self, window: PixelWindow) -> list[int]:
        """Add one window, or take the one that is there already; the feature id, none where the mosaic lacks pixels."""
        if not OpenRaster(self._block.required().mosaic.ref).is_valid(window):
            self.notified.emit(keeping_messages.NO_PIXELS_THERE())
            return []
        block = self._with_layer()
        outlines = self._outlines(block, [window])
        there = [fid for fid in self._there(outlines, window.width) if fid is not None]
        words = filled(tr("drawing window {number}"), number=self._watch.next_number)
        return there or self._add([(outlines[0], {"origin": DRAWN})], words)

    def place(self) -> None:
        """Place windows along the seamlines; they are added when all are found."""
        block = self._block.required()
        lines = self._block.seamlines(block)
        if lines is None:
            raise SeamInspectorError(messages.NO_SEAMLINES())
        if self._background.is_under_way(_PLACING):
            return
        inputs = self._block.inputs
        job = jobs.placing_job(lines, block.mosaic, inputs.placing)
        self._background.start(tr("Place windows"), job, partial(self._take, inputs.mosaic), _PLACING, steps=1)

    def add_scanned(self, worst: QgsVectorLayer) -> list[int]:
        """Take the worst places of a scan; one of which most lies in a judged window is that. Feature ids, the worst
        first."""
        grid, layer = self._with_layer().mosaic.grid, self._watch.writable()
        assert layer is not None
        features = sorted(worst.getFeatures(), key=lambda feature: feature["window_id"])
        outlines = self._block.shapes(worst, [feature.id() for feature in features], layer.crs())
        rows = [row for row in self._watch.rows() if row.extent]
        there = [_same_place(rows, layers.extent(outline)) for outline in outlines]
        places = [
            (outline, {"origin": SCAN, "seam_id": feature["seam_id"], "station": feature["station"]})
            for feature, outline, fid in zip(features, outlines, there) if fid is None
        ]  # fmt: skip
        new = iter(self._add(places, filled(tr("adding {count} places of a scan"), count=len(places))))
        fids = [next(new) if fid is None else fid for fid in there]
        count = len(set(fids))
        widths = [feature.geometry().boundingBox().width() * grid.metres_x for feature in features] or [0.0]
        sides = " - ".join(dict.fromkeys(map(shown_side, (min(widths), max(widths)))))
        self.notified.emit(keeping_messages.PLACES_TAKEN(count=count, sides=sides, there=count - len(places)))
        return fids

    def copy_file(self) -> None:
        """Copy the windows of another format into a windows file, which is followed from then on."""
        layer, block = self._watch.layer, self._block.silent()
        if layer is None:
            return
        wkt = block.mosaic.wkt if block is not None else ""
        path = window_layer.copy_to_file(layer, self._block.inputs.levels, wkt, self._home.folder)
        if (node := self._project.layerTreeRoot().findLayer(layer.id())) is not None:
            node.setItemVisibilityChecked(False)  # both would be labelled
        self._open(path)
        rows, state = [row for row in self._watch.rows() if row.verdict], self._block.state()
        if rows and state is not None:  # what they say is taken for what is so
            self._watch.prepare([row.fid for row in rows], 0)
            marks = {row.window_id: window_file.fingerprint(row, state) for row in rows}
            window_file.add_fingerprints(path, marks)
            self._watch.note_fingerprints(marks)

    def _take(self, mosaic: str, placement: Any) -> None:
        try:
            self._add_placed(mosaic, placement)
        except SeamInspectorError as error:
            self.notified.emit(error.message)

    def _add_placed(self, mosaic: str, placement: Placement) -> None:
        if mosaic != self._block.inputs.mosaic:
            return
        placed = placement.windows
        new: list[Place] = []
        if placed:
            block = self._with_layer()
            outlines = self._outlines(block, [place.window for place in placed])
            there = self._there(outlines, placed[0].window.width)
            new = [
                (outline, {"origin": PLACED, "seam_id": place.seam_id, "station": place.station_m})
                for place, outline, fid in zip(placed, outlines, there) if fid is None
            ]  # fmt: skip
            self._add(new, filled(tr("placing {count} windows"), count=len(new)))
        write_log(placement.dropped)
        said = messages.WINDOWS_PLACED(count=len(new), there=len(placed) - len(new))
        if not placed:
            said = placement.dropped[0] if len(placement.dropped) == 1 else messages.NO_WINDOW_PLACED()
        self.notified.emit(said)

    def _with_layer(self) -> Block:
        """Make the window layer when there is none. Raises WindowLayerError when its file is missing: a second set of
        windows would begin with number 1."""
        block = self._block.required()
        if self._watch.writable() is None:
            missing = self._project.mapLayer(self._block.inputs.windows)
            if missing is not None and not missing.isValid():
                raise WindowLayerError(keeping_messages.WINDOWS_MISSING(path=layers.layer_path(missing)))
            fields = window_file.window_fields(self._block.inputs.levels)
            self._open(window_file.write_window_file(block.mosaic.wkt, self._home.folder, fields))
        return block

    def _open(self, path: Path) -> None:
        self._home.hold(path)
        made = self._project.addMapLayer(window_layer.open_window_layer(path))
        if not self._project.homePath():
            self.notified.emit(keeping_messages.WINDOWS_KEPT_MEANWHILE(path=path))
        self.layerMade.emit(made.id())

    def _there(self, outlines: Sequence[QgsGeometry], width: int) -> list[int | None]:
        """The layer's windows at the same places, None where there is none: nothing is doubled. ``width``: px of all.
        """
        places = [layers.extent(outline) for outline in outlines]
        pixel = min(places[0][2] - places[0][0], places[0][3] - places[0][1]) / width
        taken = {_in_pixels(row.extent, places[0], pixel): row.fid for row in self._watch.rows() if row.extent}
        return [taken.get(_in_pixels(place, places[0], pixel)) for place in places]

    def _outlines(self, block: Block, windows: Sequence[PixelWindow]) -> list[QgsGeometry]:
        """In the layer's reference system."""
        layer = self._watch.layer
        assert layer is not None
        return self._block.outlines(block, layer, windows)

    def _add(self, places: Sequence[Place], words: str) -> list[int]:
        """Add windows as one step of undo; their feature ids."""
        layer = self._watch.writable()
        if layer is None or not places:
            return []
        self._watch.prepare([], self._block.inputs.levels)
        outlines, known = zip(*places)
        numbers = self._steps.add(window_layer.new_windows(layer, outlines, self._watch.next_number, known), words)
        return [row.fid for row in map(self._watch.numbered, numbers) if row is not None]


def _in_pixels(extent: Extent, origin: Extent, pixel: float) -> tuple[int, ...]:
    """Offset of a window from another one on the same grid, to the next pixel: files round coordinates."""
    return tuple(round((edge - start) / pixel) for edge, start in zip(extent, origin))


def _same_place(rows: Sequence[WindowRecord], place: Extent) -> int | None:
    """The window that is at a place already: the same, or one that was judged and holds most of it; of several the one
    that holds most."""
    shares = {row.fid: share for row in rows if row.extent is not None and (share := _share(row, row.extent, place))}
    return max(shares, key=shares.__getitem__, default=None)


def _share(row: WindowRecord, extent: Extent, place: Extent) -> float:
    """How much of a place a window at an extent holds, 0 where it is not at that place."""
    width = min(extent[2], place[2]) - max(extent[0], place[0])
    height = min(extent[3], place[3]) - max(extent[1], place[1])
    is_judged = bool(row.observer or row.observer_2)
    share = max(width, 0.0) * max(height, 0.0) / (_area(place) if is_judged else max(_area(extent), _area(place)))
    return share if share > (_SAME_PLACE if is_judged else _SAME) else 0.0


def _area(extent: Extent) -> float:
    return (extent[2] - extent[0]) * (extent[3] - extent[1])
