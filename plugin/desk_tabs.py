"""The tabs of the inspection desk, in their order. A new one is an entry here."""

from __future__ import annotations

from qgis.PyQt.QtCore import QT_TR_NOOP

from .noise.desk.noise_panel import NoisePanel
from .seams.desk.charts.profile_panel import CurvesAndProfile
from .seams.desk.images.images_panel import ImagesPanel
from .toolkit.desk.tabs import DeskTab

TABS = (
    DeskTab(
        "curves",
        QT_TR_NOOP("Curves"),
        QT_TR_NOOP(
            "How the variance of the selected windows spreads over the levels of detail, and how much detail is "
            "kept by the distance from the seam"
        ),
        CurvesAndProfile,
        tells_verdict=True,
    ),
    DeskTab(
        "images",
        QT_TR_NOOP("Images"),
        QT_TR_NOOP("The clips of the selected window side by side, to judge the loss by eye"),
        ImagesPanel,
    ),
    DeskTab(
        "noise",
        QT_TR_NOOP("Noise"),
        QT_TR_NOOP("How much random noise the mosaic, or a source, has in the selected window"),
        NoisePanel,
    ),
)
