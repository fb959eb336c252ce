"""Python packages that QGIS does not bring along everywhere, and how to get them. Nothing is installed from here."""
from __future__ import annotations

import shutil
import sys
from collections.abc import Iterable
from importlib.util import find_spec

from .translation import filled, tr

_NAMES = {"numpy": "numpy", "pywt": "PyWavelets", "scipy": "scipy", "matplotlib": "matplotlib", "jinja2": "Jinja2"}
"""Names to install them by, by the module; Debian's have ``python3-`` and the module."""


def missing_packages_sentence(charts: bool = False, pages: bool = False) -> str:
    """A sentence on packages that are missing and how to get them on this system; empty when none are. Charts and pages
    need more."""
    spared = {"matplotlib": not charts, "jinja2": not pages}
    missing = [name for module, name in _NAMES.items() if not spared.get(module) and find_spec(module) is None]
    if not missing:
        return ""
    needs = filled(tr("Seam Inspector needs the Python package(s) {packages}."), packages=", ".join(missing))
    return f"{needs} {_remedy(missing)}"


def broken_package_sentence(error: ImportError) -> str:
    """A sentence on a package that can't be loaded, and how to mend it; empty when it is none that we need."""
    package = _NAMES.get((error.name or "").split(".")[0])
    if package is None:
        return ""
    broken = filled(tr("The Python package {package} can't be loaded ({error})."), package=package, error=error)
    return f"{broken} {_remedy([package])}"


def _remedy(packages: Iterable[str]) -> str:
    """A command for this system, to be copied."""
    if sys.platform != "win32" and shutil.which("apt"):
        wanted = " ".join(f"python3-{module}" for name in packages for module in _NAMES if _NAMES[module] == name)
        return filled(tr("Run '{command}' in a terminal, then restart QGIS."), command=f"sudo apt install {wanted}")
    how = tr(
        "Run '{command}' with the Python that QGIS uses (on Windows in the OSGeo4W shell), then restart QGIS. Or let "
        "the plugin QPIP install the packages in requirements.txt in the plugin's folder."
    )
    return filled(how, command="python -m pip install " + " ".join(packages))
