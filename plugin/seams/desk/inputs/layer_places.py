"""Where the layers of the inputs come from, so that one that was removed is found when it is added again."""
from __future__ import annotations

from dataclasses import replace
from functools import lru_cache

from qgis.core import QgsMapLayer, QgsProject, QgsProviderRegistry

from ....toolkit.project_settings import load_settings, save_settings
from .project_inputs import Inputs

_KEY = "places"
_SINGLE = ("mosaic", "source_index", "seamlines", "windows", "cells")

Place = tuple[str, str]
"""File or database, and the layer in it; empty where it is not named."""


class LayerPlaces:
    """By layer id, remembered in the project."""

    def __init__(self, project: QgsProject) -> None:
        self._project = project
        self._places: dict[str, Place] = {}

    def load(self) -> None:
        """Another project."""
        self._places = {
            name: (place[0], place[1])
            for name, place in load_settings(self._project, _KEY).items()
            if isinstance(place, list) and len(place) == 2 and all(isinstance(part, str) for part in place)
        }

    def note(self, inputs: Inputs) -> None:
        """Remember where the layers of the inputs are, as far as they are there."""
        found = {}
        for name in _ids(inputs):
            layer = self._project.mapLayer(name)
            place = _place(layer) if layer is not None else self._places.get(name)
            if place is not None:
                found[name] = place
        if found != self._places:
            self._places = found
            save_settings(self._project, _KEY, found)

    def found_again(self, inputs: Inputs) -> Inputs:
        """The inputs, with layers of the same place instead of those that are not in the project any more."""
        lost = {name for name in _ids(inputs) if self._project.mapLayer(name) is None and name in self._places}
        if not lost:
            return inputs
        taken = _ids(inputs) - lost
        others = {name: _place(layer) for name, layer in self._project.mapLayers().items() if name not in taken}
        instead: dict[str, str] = {}
        for name in lost:
            place = self._places[name]
            match = next((other for other, there in others.items() if there is not None and _same(place, there)), None)
            if match is not None:
                instead[name] = match
        if not instead:
            return inputs
        single = {field: instead.get(value := getattr(inputs, field), value) for field in _SINGLE}
        return replace(inputs, **single, sources=tuple(instead.get(name, name) for name in inputs.sources))


def _ids(inputs: Inputs) -> set[str]:
    return {*inputs.sources, *(getattr(inputs, field) for field in _SINGLE)} - {""}


def _place(layer: QgsMapLayer) -> Place | None:
    """None for a layer in memory, which is gone when it is removed."""
    provider = layer.providerType()
    return None if provider == "memory" else _decoded(provider, layer.source())


@lru_cache(4096)
def _decoded(provider: str, source: str) -> Place:
    """Found once for each source, since projects of hundreds of layers ask again and again."""
    parts = QgsProviderRegistry.instance().decodeUri(provider, source)
    path = parts.get("path")
    return (str(path), str(parts.get("layerName") or "")) if path else (source, "")


def _same(one: Place, other: Place) -> bool:
    return one[0] == other[0] and (one[1] == other[1] or "" in (one[1], other[1]))
