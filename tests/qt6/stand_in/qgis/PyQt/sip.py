"""Stand-in for ``qgis.PyQt.sip`` of QGIS 4."""
from PyQt6.sip import *  # noqa: F403
