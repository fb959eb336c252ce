"""Loads matplotlib beside the interface, which would stand still for a second when the first curve appears."""
from __future__ import annotations

import importlib
from contextlib import suppress
from threading import Thread

from ..translation import tr


class ChartLoader(Thread):
    """Loads none of our own modules: one that comes when the plugin is disabled already would stay."""

    def __init__(self) -> None:
        super().__init__(name="seam-inspector-chart-loader", daemon=True)

    def run(self) -> None:
        with suppress(ImportError):  # the panel says so when it needs it
            for name in ("figure", "font_manager", "backends.backend_agg"):
                importlib.import_module(f"matplotlib.{name}")


def chart_missing() -> str:
    """What to do where matplotlib can't be loaded."""
    return tr(
        "The chart needs the Python package matplotlib: install python3-matplotlib with apt on Debian and "
        "Ubuntu, or run 'python -m pip install matplotlib' in the OSGeo4W shell on Windows."
    )
