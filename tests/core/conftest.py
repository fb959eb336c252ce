"""The numbers work without QGIS and Qt: an import of either fails in this run."""
from __future__ import annotations

import sys

for name in ("qgis", "PyQt5", "PyQt6"):
    sys.modules.setdefault(name, None)  # type: ignore[arg-type]
