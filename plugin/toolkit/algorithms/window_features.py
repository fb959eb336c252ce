"""The features of a window layer, read one by one, each with a number of its own."""
from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from qgis.core import QgsCoordinateReferenceSystem, QgsFeature, QgsGeometry, QgsProcessingFeatureSource

from ...imagery.errors import Message, WindowError
from ...imagery.grids import NumberedWindow
from ..attribute_values import text, whole_number
from .run import Run

_LARGEST_NUMBER = 2_000_000_000  # of a window: the outputs' integers have 32 bits, and new numbers come above it


@dataclass(frozen=True)
class WindowFeature(NumberedWindow):
    """One feature that is to be measured."""

    reason: Message | None = None
    """Why it can't be."""


class WindowFeatures:
    """All of them; what a result needs of a window is kept until it is taken."""

    def __init__(
        self,
        source: QgsProcessingFeatureSource,
        crs: QgsCoordinateReferenceSystem,
        run: Run,
        carried: Sequence[str] = (),
    ) -> None:
        """``carried``: fields whose values go over into the results, as far as the layer has them."""
        self.count = source.featureCount()
        self.renumbered = 0
        """How many windows had no number of their own."""
        self._source = source
        self._transform = run.transform(source, crs)
        self._names = set(source.fields().names())
        self.carried = tuple(name for name in carried if name in self._names)
        """The fields that do."""
        self._waiting: dict[int, tuple[QgsGeometry | None, dict[str, str | None]]] = {}
        self._numbers = self._given_numbers()
        self._last = max(self._numbers, default=0)

    def windows(self) -> Iterator[WindowFeature]:
        """One per feature, in the layer's order."""
        from .. import layers

        for feature in layers.features(self._source):
            number = self._number(feature)
            geometry: QgsGeometry | None = None
            try:
                extent = layers.extent(layers.window_geometry(feature, self._transform))
                geometry = layers.rectangle(extent)
                window = WindowFeature(number, extent)
            except WindowError as error:
                window = WindowFeature(number, None, error.message)
            self._waiting[number] = geometry, {name: text(feature[name]) or None for name in self.carried}
            yield window

    def taken(self, window_id: int) -> tuple[QgsGeometry | None, dict[str, str | None]]:
        """The rectangle as drawn and the carried values, as text, of a window whose result has come."""
        return self._waiting.pop(window_id)

    def _given_numbers(self) -> set[int]:
        from .. import layers

        if "window_id" not in self._names:
            return set()
        numbers = map(_own_number, layers.features(self._source))
        return {number for number in numbers if number is not None}

    def _number(self, feature: QgsFeature) -> int:
        """The feature's own number when it is the first to have it, else the next free one."""
        own = _own_number(feature) if "window_id" in self._names else None
        if own is not None and own in self._numbers:
            self._numbers.remove(own)
            return own
        self.renumbered += "window_id" in self._names
        self._last += 1
        return self._last


def _own_number(feature: QgsFeature) -> int | None:
    return whole_number(feature["window_id"], _LARGEST_NUMBER)
