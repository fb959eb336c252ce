"""What the algorithms on lists of rasters share: their parameters, and the rasters and windows behind them."""
from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING

from qgis.core import QgsProcessing, QgsProcessingParameterFeatureSource, QgsProcessingParameterMultipleLayers

from ...imagery import messages as imagery_messages
from ...imagery.errors import SettingsError
from .. import messages
from ..translation import tr
from .base import SeamInspectorAlgorithm
from .run import Run
from .window_features import WindowFeatures

if TYPE_CHECKING:
    from ...imagery.clips import DrawnWindow

RASTERS, WINDOWS = "RASTERS", "WINDOWS"


class RasterListAlgorithm(SeamInspectorAlgorithm):
    """An algorithm that measures single images, each for itself, on windows or as a whole."""

    RASTER_LISTS: tuple[str, ...] = (RASTERS,)

    def check(self, run: Run) -> None:
        if not run.raster_values(RASTERS):
            raise SettingsError(messages.NO_RASTERS())

    def prepare(self, run: Run) -> None:
        given = {name: run.raster_refs(name) for name in self.RASTER_LISTS}
        self.refs = {name: refs for name, (refs, _) in given.items()}
        """The rasters by parameter."""
        self.left_out = [why for _, left_out in given.values() for why in left_out]
        """About rasters that can't be used at all."""

    def addRasters(self, name: str, title: str, description: str, optional: bool = False) -> None:
        """Add a parameter of several rasters."""
        rasters = QgsProcessingParameterMultipleLayers(
            name, title, QgsProcessing.SourceType.TypeRaster, optional=optional
        )
        self.addDescribed(rasters, description)

    def addWindows(self, description: str) -> None:
        """Add the parameter WINDOWS."""
        polygon = QgsProcessing.SourceType.TypeVectorPolygon
        self.addDescribed(
            QgsProcessingParameterFeatureSource(WINDOWS, tr("Windows"), [polygon], optional=True), description
        )

    def require_rasters(self, usable: Iterable[object]) -> None:
        """Raise SettingsError, with the reasons, when no raster is left."""
        from ...imagery import limits as imagery_limits

        if not list(usable):
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
        self.window_values: dict[int, dict[str, str | None]] = {}
        """Of each window's carried fields."""
        features = WindowFeatures(source, source.sourceCrs(), run, carried)
        for window in features.windows():
            self.window_values[window.window_id] = features.taken(window.window_id)[1]
            if window.extent is not None:
                windows.append(DrawnWindow(window.window_id, window.extent, wkt))
            elif window.reason is not None:
                run.tell(imagery_messages.ABOUT(what=window.window_id, why=window.reason).as_warning())
        if not windows:
            raise SettingsError(messages.NO_WINDOWS())
        return windows
