"""Stand-in for ``qgis.PyQt.QtXml`` of QGIS 4."""
from PyQt6.QtXml import *  # noqa: F403
