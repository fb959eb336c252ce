"""Names of bands for the user, and their order."""
from __future__ import annotations

from .translation import filled, tr

BAND_ORDER = ("luminance", "red", "green", "blue", "nir")


def band_title(name: str) -> str:
    """A band's name for the user."""
    titles = {
        "luminance": tr("luminance"),
        "red": tr("red"),
        "green": tr("green"),
        "blue": tr("blue"),
        "nir": tr("near infrared"),
    }
    return titles.get(name) or filled(tr("band {number}"), number=name[len("band_") :])
