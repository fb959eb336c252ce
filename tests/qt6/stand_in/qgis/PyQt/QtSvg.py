"""Stand-in for ``qgis.PyQt.QtSvg`` of QGIS 4."""
from PyQt6.QtSvg import *  # noqa: F403
