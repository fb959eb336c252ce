"""What the inspection desk works on, remembered in the project."""
from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import asdict, dataclass, fields, replace
from types import MappingProxyType
from typing import Any, TypeVar

from qgis.core import QgsMapLayer, QgsProject, QgsVectorLayer
from qgis.PyQt.QtCore import QObject, pyqtSignal

from ....imagery import limits as imagery_limits
from ....toolkit.desk.widgets import single_shot
from ....toolkit.project_settings import load_settings, save_settings
from ...measure import limits
from ...measure.limits import DENSITIES
from ...measure.planning.window_placing import PlacingSettings
from ...measure.window_records import REFERENCES

_KEY = "inputs"
_WORDS = {"reference": REFERENCES, "density": DENSITIES}


@dataclass(frozen=True)
class Inputs:
    """What is inspected and how. Layers are named by their ids, so that one that vanished does no harm."""

    mosaic: str = ""  # raster layer
    sources: tuple[str, ...] = ()  # raster layers
    source_index: str = ""  # polygon layer with a field ``location``
    seamlines: str = ""  # line or polygon layer
    windows: str = ""  # the window layer; empty while there is none
    side_m: float = imagery_limits.STANDARD_SIDE_M  # metres that a standard window spans at least
    spacing_m: float = limits.STANDARD_SPACING_M  # metres along the seam between placed windows
    wavelet: str = imagery_limits.DEFAULT_WAVELET
    levels: int = imagery_limits.DEFAULT_LEVELS
    max_ratio: float = imagery_limits.MAX_SIGNIFICANT_RATIO
    min_kept: float = limits.MAX_SIGNIFICANT_KEPT
    reference: str = REFERENCES[0]  # what the verdict is taken by, one of ``REFERENCES``
    cells: str = ""
    """Polygon layer with a field ``source``: which source the mosaic was cut from, where that is known."""
    density: str = DENSITIES[0]  # what a scan measures, one of ``DENSITIES``
    piece_m: float = limits.STANDARD_PIECE_M  # metres of seam that a scan judges as one
    corridor_m: float = 0.0  # metres that a scan reads on either side of the seamlines; 0: the whole mosaic

    @property
    def placing(self) -> PlacingSettings:
        """How windows are placed."""
        return PlacingSettings(self.side_m, self.spacing_m, self.levels)

    def with_ids(self, others: Mapping[str, str]) -> Inputs:
        """With other layers for some, by their ids."""
        named: dict[str, Any] = {name: others[value] for name, value in vars(self).items() if value in others}
        return replace(self, **named, sources=tuple(others.get(source, source) for source in self.sources))


def load_inputs(project: QgsProject) -> Inputs:
    """The project's inputs; the defaults where it has none or they can't be understood."""
    return read_settings(Inputs, load_settings(project, _KEY), _WORDS)


def save_inputs(project: QgsProject, inputs: Inputs) -> None:
    """Write the inputs into the project, which is saved by its user."""
    save_settings(project, _KEY, asdict(inputs))


Settings = TypeVar("Settings")
_LARGEST = 2**31 - 1


def read_settings(
    kind: type[Settings], stored: Mapping[str, Any], words: Mapping[str, Sequence[str]] = MappingProxyType({})
) -> Settings:
    """A dataclass of plain values as JSON holds them; what is another kind of thing than its default is left out, and
    numbers that no box of a form can show.

    ``words``: the only values that some fields can have.
    """
    values = {}
    for setting in fields(kind):  # type: ignore[arg-type]
        value: Any = stored.get(setting.name)
        wanted = type(setting.default)
        if type(value) in (int, float) and not abs(value) <= _LARGEST:
            continue
        if setting.type == "float" and type(value) in (int, float):
            value, wanted = float(value), float
        elif wanted is tuple and isinstance(value, list):
            value = tuple(text for text in value if isinstance(text, str))
        if type(value) is wanted and (setting.name not in words or value in words[setting.name]):
            values[setting.name] = value
    return kind(**values)


_EDITS_MS = 500  # edits that come within this time are one


class InputsWatch(QObject):
    """Tells what may have changed; whether it really has is for others to find out."""

    layersChanged = pyqtSignal()
    """A layer has another data source or reference system, of the windows only that; or seamlines, source index or seam
    cells have other features."""

    def __init__(self, project: QgsProject, parent: QObject) -> None:
        super().__init__(parent)
        self._project = project
        self._followed: tuple[Inputs, dict[str, QgsMapLayer]] = Inputs(), {}
        self._timer = single_shot(self, self.layersChanged, _EDITS_MS)

    def follow(self, inputs: Inputs) -> None:
        """Follow the layers of these inputs that are there, and no others."""
        ids = (inputs.mosaic, *inputs.sources, inputs.source_index, inputs.seamlines, inputs.windows, inputs.cells)
        layers = {layer_id: layer for layer_id in ids if (layer := self._project.mapLayer(layer_id)) is not None}
        self._let_go()
        self._followed = inputs, layers
        for signal, slot in self._signals():
            signal.connect(slot)

    def leave(self, ids: Iterable[str]) -> None:
        """These layers are about to be deleted."""
        if not self._followed[1].keys().isdisjoint(ids):
            self._let_go()

    def close(self) -> None:
        """Let go of all layers and tell nothing more."""
        self._let_go()
        self._timer.stop()

    def _let_go(self) -> None:
        for signal, slot in self._signals():
            signal.disconnect(slot)
        self._followed = Inputs(), {}

    def _signals(self) -> list[tuple[Any, Any]]:
        """Made anew each time: a signal that is kept crashes once its layer is deleted."""
        inputs, layers = self._followed
        edited = [layers.get(layer_id) for layer_id in (inputs.source_index, inputs.cells, inputs.seamlines)]
        return [
            *((layer.dataSourceChanged, self._changed) for name, layer in layers.items() if name != inputs.windows),
            *((layer.crsChanged, self._changed) for layer in layers.values()),
            *(pair for layer in edited for pair in _edits(layer, self._edited)),
        ]

    def _changed(self, *_: object) -> None:
        self.layersChanged.emit()

    def _edited(self, *_: object) -> None:
        self._timer.start()


def _edits(layer: QgsMapLayer | None, slot: Any) -> list[tuple[Any, Any]]:
    """All that can change a layer's features; the edit buffer counts."""
    if not isinstance(layer, QgsVectorLayer):
        return []
    signals = (
        layer.featureAdded, layer.featureDeleted, layer.geometryChanged, layer.attributeValueChanged,
        layer.afterCommitChanges, layer.afterRollBack, layer.dataChanged, layer.subsetStringChanged,
    )  # fmt: skip
    return [(signal, slot) for signal in signals]
