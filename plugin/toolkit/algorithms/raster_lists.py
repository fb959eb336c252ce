"""The windows of a layer, read one by one, each with its own number; what algorithms on lists of rasters share."""
from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

from qgis.core import QgsCoordinateReferenceSystem, QgsFeature, QgsGeometry, QgsProcessingFeatureSource

from ...imagery import messages as imagery_messages
from ...imagery.errors import Message, RasterError, SettingsError, WindowError
from ...imagery.grids import NumberedWindow
from .. import messages
from ..table_fields import text, whole_number
from .base import SeamInspectorAlgorithm
from .run import Run

if TYPE_CHECKING:
    from ...imagery.clips import DrawnWindow
    from ...imagery.rasters import Raster, RasterRef

_LARGEST_NUMBER = 2_000_000_000  # of a window: the outputs' integers have 32 bits, and new numbers come above it
_LEAST_FILLED = 0.9  # of the rectangle around a window; one drawn in another reference system is turned a little


@dataclass(frozen=True)
class WindowFeature(NumberedWindow):
    """One feature that is to be measured."""

    reason: Message | None = None  # why it can't be


class WindowFeatures:
    """The windows of a layer; what a result needs of a window is kept until it is taken."""

    def __init__(
        self, source: QgsProcessingFeatureSource, crs: QgsCoordinateReferenceSystem, run: Run,
        carried: Sequence[str] = (),
    ) -> None:  # fmt: skip
        """``carried``: fields whose values go over into the results, as far as the layer has them."""
        from .. import layers

        self.count = source.featureCount()
        self._renumbered = self._reshaped = 0
        self._source = source
        self._transform = run.transform(source, crs)
        names = set(source.fields().names())
        self.carried = tuple(name for name in carried if name in names)  # names of these fields
        self._has_numbers = "window_id" in names
        self._waiting: dict[int, tuple[QgsGeometry | None, dict[str, str | None]]] = {}
        numbers = map(self._given_number, layers.features(source))
        self._numbers = {number for number in numbers if number is not None}
        """Numbers that are given and not taken yet; of several windows the first has it."""
        self._last = max(self._numbers, default=0)

    def windows(self) -> Iterator[WindowFeature]:
        """A window for each feature, in the layer's order."""
        from .. import layers

        for feature in layers.features(self._source):
            number = self._given_number(feature)
            if number is None or number not in self._numbers:
                self._renumbered += self._has_numbers
                self._last = number = self._last + 1
            self._numbers.discard(number)
            geometry: QgsGeometry | None = None
            try:
                outline = layers.window_geometry(feature, self._transform)
                extent = layers.extent(outline)
                geometry = layers.rectangle(extent)
                self._reshaped += outline.area() < _LEAST_FILLED * geometry.area()
                window = WindowFeature(number, extent)
            except WindowError as error:
                window = WindowFeature(number, None, error.message)
            self._waiting[number] = geometry, {name: text(feature[name]) or None for name in self.carried}
            yield window

    def taken(self, window_id: int) -> tuple[QgsGeometry | None, dict[str, str | None]]:
        """The rectangle as drawn and the carried values, as text, of a window whose result has come."""
        return self._waiting.pop(window_id)

    def notices(self) -> list[Message]:
        """Messages on what was done to the windows that were read."""
        counts = {messages.WINDOWS_RENUMBERED: self._renumbered, messages.WINDOWS_RESHAPED: self._reshaped}
        return [what(count=count) for what, count in counts.items() if count]

    def _given_number(self, feature: QgsFeature) -> int | None:
        return whole_number(feature["window_id"], _LARGEST_NUMBER) if self._has_numbers else None


RASTERS, WINDOWS = "RASTERS", "WINDOWS"


class RasterListAlgorithm(SeamInspectorAlgorithm):
    """An algorithm that measures single images, each for itself, on windows or as a whole."""

    RASTER_LISTS: tuple[str, ...] = (RASTERS,)

    def check(self, run: Run) -> None:
        if not run.raster_values(RASTERS):
            raise SettingsError(messages.NO_RASTERS())

    def prepare_run(self, run: Run) -> None:
        given = {name: run.raster_refs(name) for name in self.RASTER_LISTS}
        self.refs = {name: refs for name, (refs, _) in given.items()}  # the rasters by parameter
        self.left_out = [why for _, left_out in given.values() for why in left_out]
        """Messages on rasters that can't be used at all."""

    def opened(self, refs: Iterable[RasterRef]) -> list[Raster]:
        """The rasters that can be opened; ``left_out`` tells of the others."""
        from ...imagery.open_raster import describe

        rasters = []
        for ref in dict.fromkeys(refs):
            try:
                rasters.append(describe(ref))
                self.left_out += rasters[-1].notices
            except RasterError as error:
                self.left_out.append(imagery_messages.SOURCE_LEFT_OUT(name=ref.name, why=error.message))
        return rasters

    def require_rasters(self, usable: Sequence[object]) -> None:
        """Raise SettingsError, with the reasons, when no raster is left."""
        from ...imagery import limits as imagery_limits

        if not usable:
            why = tuple(self.left_out[: imagery_limits.MAX_REASONS])
            raise SettingsError(messages.NO_RASTER_USABLE(why=why) if why else messages.NO_RASTERS())

    def drawn_windows(self, run: Run, carried: Sequence[str] = ()) -> list[DrawnWindow] | None:
        """The windows that were given, those without a usable outline named in the log; None when none were.

        ``carried``: fields whose values ``window_values`` then has, as text.
        """
        from ...imagery.clips import DrawnWindow
        from .. import layers

        if not run.parameters.get(WINDOWS):
            return None
        source = run.source(WINDOWS)
        wkt = layers.system_wkt(source.sourceCrs())
        windows = []
        self.window_values: dict[int, dict[str, str | None]] = {}  # values of the carried fields, by window number
        features = WindowFeatures(source, source.sourceCrs(), run, carried)
        for window in features.windows():
            self.window_values[window.window_id] = features.taken(window.window_id)[1]
            if window.extent is not None:
                windows.append(DrawnWindow(window.window_id, window.extent, wkt))
            elif window.reason is not None:
                run.tell(imagery_messages.ABOUT(what=window.window_id, why=window.reason).as_warning())
        if not windows:
            raise SettingsError(messages.NO_WINDOWS())
        run.tell(*features.notices())
        return windows
