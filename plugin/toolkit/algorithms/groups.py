"""The groups of our algorithms in the toolbox; each name, not translated, is its group's id too."""
from __future__ import annotations

from qgis.PyQt.QtCore import QT_TRANSLATE_NOOP

SEAM_INSPECTION = QT_TRANSLATE_NOOP("@default", "Seam inspection")
IMAGE_QUALITY = QT_TRANSLATE_NOOP("@default", "Image quality")
GROUND_RESOLUTION = QT_TRANSLATE_NOOP("@default", "Ground resolution")
PHOTOS = QT_TRANSLATE_NOOP("@default", "Interior orientation of photos")
SATELLITE_IMAGES = QT_TRANSLATE_NOOP("@default", "Satellite images")
