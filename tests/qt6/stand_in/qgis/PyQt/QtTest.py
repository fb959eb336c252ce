"""Stand-in for ``qgis.PyQt.QtTest`` of QGIS 4."""
from PyQt6.QtTest import *  # noqa: F403
