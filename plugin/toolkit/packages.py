"""Python packages that QGIS does not bring along everywhere, and how to get them. Nothing is installed from here."""
from __future__ import annotations

import shutil
import sys
from collections.abc import Iterable
from importlib.util import find_spec

from .translation import tr

_MEASUREMENT = {"numpy": "numpy", "pywt": "PyWavelets", "scipy": "scipy"}
_DESK = {**_MEASUREMENT, "matplotlib": "matplotlib"}
_DEBIAN = {
    "numpy": "python3-numpy",
    "PyWavelets": "python3-pywt",
    "scipy": "python3-scipy",
    "matplotlib": "python3-matplotlib",
}


def missing_packages(desk: bool = False) -> list[str]:
    """Names, as one would install them, of the packages that the measurement, or the desk too, lacks here."""
    needed = _DESK if desk else _MEASUREMENT
    return [name for module, name in needed.items() if find_spec(module) is None]


def missing_packages_sentence(desk: bool = False) -> str:
    """What is missing and how to get it on this system; empty when nothing is."""
    missing = missing_packages(desk)
    if not missing:
        return ""
    needs = tr("Seam Inspector needs the Python package(s) {packages}.").format(packages=", ".join(missing))
    return f"{needs} {_remedy(missing)}"


def broken_package_sentence(error: ImportError) -> str:
    """What is there but can't be loaded, and how to mend it; empty when it is no package that we need."""
    package = _DESK.get((error.name or "").split(".")[0])
    if package is None:
        return ""
    broken = tr("The Python package {package} can't be loaded ({error}).").format(package=package, error=error)
    return f"{broken} {_remedy([package])}"


def _remedy(packages: Iterable[str]) -> str:
    pip = "python -m pip install " + " ".join(packages)
    if sys.platform == "win32":
        how = tr("Run '{command}' in the OSGeo4W shell, then restart QGIS.")
    elif shutil.which("apt"):
        pip = "sudo apt install " + " ".join(_DEBIAN[name] for name in packages)
        how = tr("Run '{command}' in a terminal, then restart QGIS.")
    else:
        how = tr(
            "Run '{command}' with the Python that QGIS uses, or install what requirements.txt in the plugin's folder "
            "names, then restart QGIS."
        )
    return how.format(command=pip)
