"""Python packages that QGIS does not bring along everywhere."""
from __future__ import annotations

from importlib.util import find_spec

from .text import tr

_NEEDED = {"numpy": "numpy", "pywt": "PyWavelets"}


def missing_packages() -> list[str]:
    """Names, as one would install them, of the packages that the measurement needs and that are not there."""
    return [name for module, name in _NEEDED.items() if find_spec(module) is None]


def missing_packages_sentence() -> str:
    """What is missing and how to get it; empty when nothing is."""
    missing = missing_packages()
    if not missing:
        return ""
    return tr(
        "Seam Inspector needs the Python package(s) {packages}. On Debian and Ubuntu install python3-pywt with "
        "apt; on Windows run 'python -m pip install {packages}' in the OSGeo4W shell. Then restart QGIS."
    ).format(packages=" ".join(missing))
