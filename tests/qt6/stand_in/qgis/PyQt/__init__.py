"""PyQt6 under the names of QGIS 4's ``qgis.PyQt``."""
