"""Python packages that QGIS does not bring along everywhere, and how to get them. Nothing is installed from here."""
from __future__ import annotations

import shlex
import shutil
import sys
from collections.abc import Iterable
from importlib.util import find_spec
from pathlib import Path

from .translation import filled, tr

_MEASUREMENT = {"numpy": "numpy", "pywt": "PyWavelets", "scipy": "scipy"}
_CHARTS = {"matplotlib": "matplotlib"}
_PAGES = {"jinja2": "Jinja2"}
_DEBIAN = {
    "numpy": "python3-numpy",
    "PyWavelets": "python3-pywt",
    "scipy": "python3-scipy",
    "matplotlib": "python3-matplotlib",
    "Jinja2": "python3-jinja2",
}


def missing_packages(charts: bool = False, pages: bool = False) -> list[str]:
    """Names, as one would install them, of the packages that are not here; charts and pages need more."""
    needed = {**_MEASUREMENT, **(_CHARTS if charts else {}), **(_PAGES if pages else {})}
    return [name for module, name in needed.items() if find_spec(module) is None]


def missing_packages_sentence(charts: bool = False, pages: bool = False) -> str:
    """What is missing and how to get it on this system; empty when nothing is."""
    missing = missing_packages(charts, pages)
    if not missing:
        return ""
    needs = filled(tr("Seam Inspector needs the Python package(s) {packages}."), packages=", ".join(missing))
    return f"{needs} {_remedy(missing)}"


def broken_package_sentence(error: ImportError) -> str:
    """What is there but can't be loaded, and how to mend it; empty when it is no package that we need."""
    package = {**_MEASUREMENT, **_CHARTS, **_PAGES}.get((error.name or "").split(".")[0])
    if package is None:
        return ""
    broken = filled(tr("The Python package {package} can't be loaded ({error})."), package=package, error=error)
    return f"{broken} {_remedy([package])}"


def _remedy(packages: Iterable[str]) -> str:
    """One command to copy, for this system."""
    pip = "python -m pip install " + " ".join(packages)
    terminal = tr("Run '{command}' in a terminal, then restart QGIS.")
    if (Path(sys.prefix) / "conda-meta").is_dir():
        conda = "conda install -c conda-forge " + " ".join(packages).lower()
        return filled(tr("Run '{command}' in QGIS's conda environment, then restart QGIS."), command=conda)
    if sys.platform != "win32" and shutil.which("apt"):
        return filled(terminal, command="sudo apt install " + " ".join(_DEBIAN[name] for name in packages))
    if sys.platform == "win32":
        how = filled(tr("Run '{command}' in the OSGeo4W shell, then restart QGIS."), command=pip)
    elif sys.platform == "darwin":
        how = filled(terminal, command=pip.replace("python", shlex.quote(_pythons_path()), 1))
    else:
        how = filled(tr("Run '{command}' with the Python that QGIS uses, then restart QGIS."), command=pip)
    other = tr("Or let the plugin QPIP install what requirements.txt in the plugin's folder names.")
    return f"{how} {other}"


def _pythons_path() -> str:
    """QGIS's own Python in its application, which no terminal finds by name; sys.executable is QGIS itself."""
    folders = (Path(sys.prefix) / "bin", Path(sys.executable).parent / "bin", Path(sys.executable).parent)
    return str(next((path for folder in folders if (path := folder / "python3").exists()), folders[0] / "python3"))
