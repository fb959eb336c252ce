"""What the inspection desk works on, remembered in the project."""
from __future__ import annotations

from dataclasses import asdict, dataclass
from functools import partial
from typing import Any, Callable

from qgis.core import QgsProject

from ....imagery import limits as imagery_limits
from ....toolkit.picture_stretch import Stretch
from ....toolkit.project_settings import load_settings, save_settings
from ...measure import limits
from ...measure.scan.scan_settings import DENSITIES
from ...measure.window_records import REFERENCES

_KEY = "inputs"


@dataclass(frozen=True)
class Inputs:
    """What is inspected and how. Layers are named by their ids, so that one that vanished does no harm."""

    mosaic: str = ""
    """Raster layer."""
    sources: tuple[str, ...] = ()
    """Raster layers."""
    source_index: str = ""
    """Polygon layer with a field ``location``."""
    seamlines: str = ""
    """Line or polygon layer."""
    windows: str = ""
    """The window layer; empty while there is none."""
    side_m: float = imagery_limits.STANDARD_SIDE_M
    """Metres that a standard window spans at least."""
    spacing_m: float = limits.STANDARD_SPACING_M
    """Metres along the seam between placed windows."""
    wavelet: str = imagery_limits.DEFAULT_WAVELET
    levels: int = imagery_limits.DEFAULT_LEVELS
    max_ratio: float = imagery_limits.MAX_SIGNIFICANT_RATIO
    min_kept: float = limits.MAX_SIGNIFICANT_KEPT
    reference: str = REFERENCES[0]
    """What the verdict is taken by, one of ``REFERENCES``."""
    cells: str = ""
    """Polygon layer with a field ``source``: which source the mosaic was cut from, where that is known."""
    density: str = DENSITIES[0]
    """What a scan measures, one of ``DENSITIES``."""
    piece_m: float = limits.STANDARD_PIECE_M
    """Metres of seam that a scan judges as one."""
    corridor_m: float = 0.0
    """Metres that a scan reads on either side of the seamlines; 0: the whole mosaic."""
    stretch: str = Stretch.DELIVERED.value
    """How pictures of windows are shown, the value of a ``Stretch``; no result depends on it."""


def load_inputs(project: QgsProject) -> Inputs:
    """The project's inputs; the defaults where it has none or they can't be understood."""
    stored = load_settings(project, _KEY)
    return Inputs(**{name: value for name, read in _READERS.items() if (value := read(stored.get(name))) is not None})


def save_inputs(project: QgsProject, inputs: Inputs) -> None:
    """Write the inputs into the project, which is saved by its user."""
    save_settings(project, _KEY, asdict(inputs))


def _text(value: object) -> str | None:
    return value if isinstance(value, str) else None


def _texts(value: object) -> tuple[str, ...] | None:
    return tuple(text for text in value if isinstance(text, str)) if isinstance(value, list) else None


def _number(value: object) -> float | None:
    return float(value) if isinstance(value, (int, float)) and not isinstance(value, bool) else None


def _whole(value: object) -> int | None:
    return value if isinstance(value, int) and not isinstance(value, bool) else None


def _word(known: tuple[str, ...], value: object) -> str | None:
    return value if isinstance(value, str) and value in known else None


_READERS: dict[str, Callable[[object], Any]] = {
    **dict.fromkeys(("mosaic", "source_index", "seamlines", "windows", "wavelet", "cells"), _text),
    **dict.fromkeys(("side_m", "spacing_m", "max_ratio", "min_kept", "piece_m", "corridor_m"), _number),
    "sources": _texts,
    "levels": _whole,
    "reference": partial(_word, REFERENCES),
    "density": partial(_word, DENSITIES),
    "stretch": partial(_word, tuple(stretch.value for stretch in Stretch)),
}
"""How each value is understood; what is another kind of thing is left out."""
