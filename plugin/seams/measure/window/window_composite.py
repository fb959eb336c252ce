"""The hard-cut composite of a window as pixels: what the mosaic would look like had its sources been cut, not mixed."""
from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ....imagery.errors import Message
from .. import messages
from ..following.hard_cut import cut_hard
from .explained_window import known_labels
from .measured_window import measure_window
from .window_request import WindowRequest


@dataclass(frozen=True, eq=False)
class WindowComposite:
    """The cut that the inspection compares the mosaic with, in the mosaic's grey values."""

    names: tuple[str, ...]
    """Bands that the mosaic and all its sources have."""
    bands: np.ndarray
    """(bands, rows, columns) in the mosaic's data type; the mosaic's own pixels where no source explains them."""


def window_composite(request: WindowRequest) -> WindowComposite | Message:
    """Each pixel from the source that the mosaic follows there; why there is none where none explains it."""
    measured = measure_window(request)
    if measured is None or isinstance(measured, Message):
        return measured or messages.COMPOSITE_UNCLEAR()
    if not measured.is_explicable:
        return measured.paper.reason or messages.COMPOSITE_UNCLEAR()
    cut = cut_hard(measured.mosaic, measured.judged, request.settings.levels, known_labels(request, measured.judged))
    if cut.is_unclear:
        return messages.COMPOSITE_UNCLEAR()
    kind, levelled = cut.mosaic.bands.dtype, cut.composite.levelled / measured.mosaic.grey_factor
    if kind.kind != "f":
        ends = np.iinfo(kind)
        levelled = np.clip(np.rint(levelled), ends.min, ends.max)
    return WindowComposite(cut.mosaic.names, levelled.astype(kind))
