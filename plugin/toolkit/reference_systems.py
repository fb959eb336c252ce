"""Reference systems as QGIS has them, and what leads from one to another.

QGIS hands the same object to everybody who asks for a system by the same text. What PROJ knows of it belongs to the
thread that asked first and goes when that thread ends: the object stays valid, but has no text any more, is written
into files as no system at all, and QGIS 3.22 crashes where it transforms from or to it. So every thread has systems of
its own here.
"""
from __future__ import annotations

from collections.abc import Callable
from functools import lru_cache
from threading import get_ident

from qgis.core import QgsCoordinateReferenceSystem, QgsCoordinateTransform, QgsCoordinateTransformContext, QgsMapLayer

from ..imagery import messages
from ..imagery.errors import WindowError

_UNDEFINED = "Undefined "  # how GeoPackage calls the system of a table that has none


def reference_system(wkt: str) -> QgsCoordinateReferenceSystem:
    """The system of a text, by its authority's code where it has one; an invalid one for no text."""
    if not wkt:
        return QgsCoordinateReferenceSystem()
    known = _of_this_thread(_code(wkt))
    return known if known.isValid() else _with_text(QgsCoordinateReferenceSystem.fromWkt, wkt)


def known_system(crs: QgsCoordinateReferenceSystem) -> QgsCoordinateReferenceSystem:
    """The system of a layer or the map as this thread can use it; an invalid one where it says nothing."""
    if not crs.isValid() or crs.description().startswith(_UNDEFINED):
        return QgsCoordinateReferenceSystem()
    known = _of_this_thread(crs.authid())
    if not known.isValid():
        return crs
    if crs.coordinateEpoch() == crs.coordinateEpoch():  # else NaN
        known.setCoordinateEpoch(crs.coordinateEpoch())
    return known


def keep_system(layer: QgsMapLayer) -> None:
    """Give a layer that may have been opened in another thread a system that stays when that thread ends."""
    layer.setCrs(known_system(layer.crs()))


def transformation(
    source: QgsCoordinateReferenceSystem, target: QgsCoordinateReferenceSystem, context: QgsCoordinateTransformContext
) -> QgsCoordinateTransform:
    """The transformation from one reference system to another as PROJ has it; what has no system stays as it is.

    Raises WindowError when PROJ has no way.
    """
    source, target = known_system(source), known_system(target)
    if not source.isValid() or not target.isValid() or source == target:
        return QgsCoordinateTransform()
    if not source.toWkt() or not target.toWkt():
        raise WindowError(messages.EXTENT_NOT_TRANSFORMED())
    made = QgsCoordinateTransform(source, target, context)
    if not made.sourceCrs().toWkt() or not made.destinationCrs().toWkt():  # one that QGIS keeps of an ended thread
        QgsCoordinateTransform.invalidateCache()
        made = QgsCoordinateTransform(source, target, context)
    if not made.isValid():
        raise WindowError(messages.EXTENT_NOT_TRANSFORMED())
    return made


def _of_this_thread(code: str) -> QgsCoordinateReferenceSystem:
    """An authority's system, asked for by a name that no other thread uses: the version in it means nothing to QGIS."""
    authority, _, number = code.partition(":")
    name = f"urn:ogc:def:crs:{authority}:{get_ident()}:{number}"
    return _with_text(QgsCoordinateReferenceSystem.fromOgcWmsCrs, name) if number else QgsCoordinateReferenceSystem()


def _with_text(ask: Callable[[str], QgsCoordinateReferenceSystem], name: str) -> QgsCoordinateReferenceSystem:
    """The system that QGIS answers with; where it still has that of a thread that ended, it is asked anew."""
    system = ask(name)
    if system.isValid() and not system.toWkt():  # asked for here, the text keeps the object for this thread, too
        QgsCoordinateReferenceSystem.invalidateCache()
        system = ask(name)
    return system


@lru_cache(256)
def _code(wkt: str) -> str:
    """The authority's code in a text that says the same as the authority; else empty."""
    from ..imagery.reference_systems import authority_code, same_system  # with numpy, not loaded when QGIS starts

    code = authority_code(wkt)
    return code if code and same_system(wkt, code) else ""
