"""Python packages that QGIS does not bring along everywhere."""
from __future__ import annotations

from importlib.util import find_spec

from .text import tr

_MEASUREMENT = {"numpy": "numpy", "pywt": "PyWavelets"}
_DESK = {**_MEASUREMENT, "matplotlib": "matplotlib"}


def missing_packages(desk: bool = False) -> list[str]:
    """Names, as one would install them, of the packages that the measurement, or the desk too, lacks here."""
    needed = _DESK if desk else _MEASUREMENT
    return [name for module, name in needed.items() if find_spec(module) is None]


def missing_packages_sentence(desk: bool = False) -> str:
    """What is missing and how to get it; empty when nothing is."""
    missing = missing_packages(desk)
    if not missing:
        return ""
    return tr(
        "Seam Inspector needs the Python package(s) {packages}. On Debian and Ubuntu install {debian} with "
        "apt; on Windows run 'python -m pip install {packages}' in the OSGeo4W shell. Then restart QGIS."
    ).format(packages=" ".join(missing), debian=" ".join(_DEBIAN[name] for name in missing))


_DEBIAN = {"numpy": "python3-numpy", "PyWavelets": "python3-pywt", "matplotlib": "python3-matplotlib"}
