"""The colours of lost detail: one fixed scale for the windows' pictures, the map and the scan, so that all compare."""
from __future__ import annotations

from typing import TYPE_CHECKING

from qgis.PyQt.QtCore import QT_TRANSLATE_NOOP

from ..toolkit.translation import tr

if TYPE_CHECKING:
    import numpy as np

Rgba = tuple[int, int, int, int]

LOSS_CLASSES: tuple[tuple[float, Rgba, str], ...] = (
    (0.5, (163, 0, 38, 255), QT_TRANSLATE_NOOP("@default", "50 % kept, or less")),
    (0.6, (220, 47, 28, 255), QT_TRANSLATE_NOOP("@default", "50 to 60 %")),
    (0.7, (244, 109, 31, 255), QT_TRANSLATE_NOOP("@default", "60 to 70 %")),
    (0.8, (253, 174, 51, 235), QT_TRANSLATE_NOOP("@default", "70 to 80 %")),
    (0.9, (255, 225, 77, 215), QT_TRANSLATE_NOOP("@default", "80 to 90 %")),
)
"""Share of the detail that is kept at most, its colour, its words, as in ``resources/styles/loss.qml``. What keeps more
is even ground and has none."""
LOSS_OPACITY = 0.6
"""With which pictures of lost detail are painted: what lies beneath is what is judged."""
_NO_COLOUR = (0, 0, 0, 0)


def loss_rgba(kept: np.ndarray) -> np.ndarray:
    """The colours of shares that are kept, (rows, columns) -> (rows, columns, 4) uint8, alpha not multiplied in;
    transparent where the ground is even or nothing can be told (NaN)."""
    import numpy as np  # not when QGIS starts

    colours = np.array([*(colour for _, colour, _ in LOSS_CLASSES), _NO_COLOUR], np.uint8)
    return np.asarray(colours[np.searchsorted([limit for limit, _, _ in LOSS_CLASSES], kept)])  # NaN after all limits


def loss_legend() -> list[tuple[str, Rgba]]:
    """Words and colour of each class, the greatest loss first."""
    return [(tr(words), colour) for _, colour, words in LOSS_CLASSES]
