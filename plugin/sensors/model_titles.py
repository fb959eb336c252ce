"""What each sensor model is, in words for people."""
from __future__ import annotations

from qgis.PyQt.QtCore import QT_TRANSLATE_NOOP

MODEL_TITLES = {
    "polynomial_2d": QT_TRANSLATE_NOOP("@default", "polynomials of the plane, as in a georeferencer, without heights"),
    "polynomial_3d": QT_TRANSLATE_NOOP("@default", "polynomials of space, without physics"),
    "rational": QT_TRANSLATE_NOOP("@default", "quotients of polynomials as in an RPC, without physics"),
    "rational_terms": QT_TRANSLATE_NOOP(
        "@default", "quotients of order 2 at most, with the terms left out that the points do not speak for"
    ),
    "dlt": QT_TRANSLATE_NOOP("@default", "the direct linear transformation, without physics"),
    "pushbroom": QT_TRANSLATE_NOOP("@default", "the parametric model of a line scanner"),
    "rpc_bias": QT_TRANSLATE_NOOP("@default", "the RPC that came with the image, corrected"),
}
"""By the model's name in the registry; a test looks that every model has its entry."""
