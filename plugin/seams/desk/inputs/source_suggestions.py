"""Which of the project's rasters are suggested as sources of the mosaic, and why the others are not."""
from __future__ import annotations

from functools import partial
from typing import Any

from qgis.core import QgsProject, QgsRasterLayer
from qgis.PyQt.QtCore import QObject, pyqtSignal

from ....imagery.errors import SeamInspectorError
from ....imagery.rasters import RasterRef
from ....toolkit import layers as layers
from ....toolkit.background_tasks import BackgroundTasks
from ....toolkit.desk.widgets import single_shot
from ....toolkit.translation import tr
from ... import jobs
from ...measure.inputs.candidate_look import SourceCandidate
from ...measure.inputs.raster_facts import Standing, Suitability, suitable_by_header
from .raster_layers import facts_of, file_rasters

_TOGETHER_MS = 300  # layers that are added, and standings that are found, within this time are one change

Sources = tuple[str, ...]


class SourceSuggestions(QObject):
    """By the rasters' headers at once, then by a look at their pixels in the background."""

    changed = pyqtSignal()
    """Something was found by the pixels."""

    def __init__(self, parent: QObject) -> None:
        super().__init__(parent)
        self._background = BackgroundTasks(self)
        self._looker = single_shot(self, self._look, _TOGETHER_MS)
        self._teller = single_shot(self, self.changed, _TOGETHER_MS)
        self._mosaic: QgsRasterLayer | None = None
        self._key: object = None
        self._turn = 0
        self._by_header: dict[str, Suitability] = {}
        self._by_pixels: dict[str, Suitability] = {}

    @property
    def is_looking(self) -> bool:
        """Whether more may be found."""
        return self._looker.isActive() or self._teller.isActive() or self._background.is_under_way(self._turn)

    def follow(self, mosaic_id: str) -> None:
        """The mosaic is this one, and the project's rasters are what they are now."""
        mosaic = QgsProject.instance().mapLayer(mosaic_id)
        rasters = file_rasters() if isinstance(mosaic, QgsRasterLayer) else []
        key = mosaic_id, [(layer.id(), layer.source(), layer.crs().authid()) for layer in rasters]
        if key == self._key:
            return
        is_same = isinstance(self._key, tuple) and self._key[0] == mosaic_id
        self._key = key
        self._turn += 1
        self._background.cancel_others({self._turn})
        if mosaic_id not in {layer.id() for layer in rasters}:
            self._by_header, self._by_pixels = {}, {}
            return
        facts = {one.key: one for one in facts_of(rasters, mosaic)}
        others = [one for name, one in facts.items() if name != mosaic_id]
        self._by_header = suitable_by_header(facts[mosaic_id], others)
        self._by_pixels = {name: one for name, one in self._by_pixels.items() if is_same and name in self._by_header}
        self._looker.start()

    def standing(self, layer_id: str) -> Suitability | None:
        """Of one raster; None where nothing is known of it."""
        by_header = self._by_header.get(layer_id)
        if by_header is None or by_header.standing is Standing.LEFT_OUT:
            return by_header
        return self._by_pixels.get(layer_id, by_header)

    def suggested(self) -> Sources:
        """Layer ids of the suggested sources, by their names."""
        found = ((name, self.standing(name)) for name in self._by_header)
        return tuple(name for name, standing in found if standing is not None and standing.is_suggested)

    def followed(self) -> set[str]:
        """File names of those that the mosaic is like somewhere."""
        project = QgsProject.instance()
        refs = (_ref(project.mapLayer(name)) for name, one in self._by_pixels.items() if one.is_followed)
        return {ref.name for ref in refs if ref is not None}

    def close(self) -> None:
        """Look no more."""
        self._looker.stop()
        self._teller.stop()
        self._background.close()

    def _look(self) -> None:
        project, mosaic_id = QgsProject.instance(), self._key[0] if isinstance(self._key, tuple) else ""
        mosaic = _ref(project.mapLayer(mosaic_id))
        wanted = [name for name, one in self._by_header.items() if one.standing is not Standing.LEFT_OUT]
        found = ((name, project.mapLayer(name)) for name in wanted)
        candidates = [
            SourceCandidate(name, layer.name(), ref) for name, layer in found if (ref := _ref(layer)) is not None
        ]
        if mosaic is None or not candidates:
            return
        job = jobs.candidates_job(mosaic, candidates, set(self._by_pixels))
        self._background.start(tr("Look at the sources"), job, partial(self._take, self._turn), self._turn)

    def _take(self, turn: int, found: Any) -> None:
        name, standing = found
        if turn == self._turn and name in self._by_header and self._by_pixels.get(name) != standing:
            self._by_pixels[name] = standing
            if not self._teller.isActive():
                self._teller.start()


def _ref(layer: object) -> RasterRef | None:
    """The file of a raster layer; None where it has none."""
    if not isinstance(layer, QgsRasterLayer):
        return None
    try:
        return layers.layer_ref(layer)
    except SeamInspectorError:
        return None
