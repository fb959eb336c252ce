"""Reference systems as QGIS has them, of the texts that rasters and results hold."""
from __future__ import annotations

from qgis.core import QgsCoordinateReferenceSystem


def reference_system(wkt: str) -> QgsCoordinateReferenceSystem:
    """What a text tells, by its authority's code where it has one; an invalid one for no text."""
    found = QgsCoordinateReferenceSystem.fromWkt(wkt) if wkt else QgsCoordinateReferenceSystem()
    if wkt and not found.isValid():
        # QGIS keeps its answer for good; asked anew, it may know.
        QgsCoordinateReferenceSystem.invalidateCache()
        found = QgsCoordinateReferenceSystem.fromWkt(wkt)
    if wkt and not found.isValid():
        from ..imagery.reference_systems import authority_code  # with numpy, which is not loaded when QGIS starts

        found = QgsCoordinateReferenceSystem(authority_code(wkt))
    return found
