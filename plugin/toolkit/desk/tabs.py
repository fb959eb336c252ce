"""What a tab of the inspection desk is, and what it sees of the desk."""
from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, Callable, Protocol

from qgis.core import QgsVectorLayer
from qgis.PyQt.QtWidgets import QWidget

from ...imagery.errors import Message
from ...imagery.grids import PixelWindow
from ...imagery.rasters import Raster, RasterRef


class SourceUnderWindow(Protocol):
    """An orthoimage that may cover a window."""

    @property
    def ref(self) -> RasterRef: ...


class WindowOnRasters(Protocol):
    """A window and the rasters it is measured on."""

    @property
    def window_id(self) -> int: ...
    @property
    def mosaic(self) -> Raster: ...
    @property
    def sources(self) -> Sequence[SourceUnderWindow]: ...
    @property
    def window(self) -> PixelWindow | None:
        """On the mosaic's grid; None when the drawn rectangle can't be measured."""
    @property
    def reason(self) -> Message | None:
        """Why there is no window."""


class InspectedWindows(Protocol):
    """The desk's model as a tab sees it."""

    selectionChanged: Any
    windowsChanged: Any
    inputsChanged: Any

    def selected(self) -> Sequence[int]:
        """Feature ids of the selected windows."""

    def request(self, fid: int) -> WindowOnRasters | None:
        """What is measured in a window; None while the inputs make no job."""

    def window_layer(self) -> QgsVectorLayer | None:
        """The layer that holds the windows."""

    def problem(self) -> Message | None:
        """What keeps the inputs from making a job."""


@dataclass(frozen=True)
class DeskTab:
    """A tab of the inspection desk. Title and tooltip are marked for translation, not translated."""

    name: str
    """Name by which scripts and tests find it."""
    title: str
    tooltip: str
    make: Callable[[Any], QWidget]
    """From the desk's model, an ``InspectedWindows``, to the tab's panel."""
    tells_verdict: bool = False
    """Whether it shows what was found, which is hidden while somebody judges blind."""
