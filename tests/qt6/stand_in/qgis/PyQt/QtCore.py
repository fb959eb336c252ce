"""``qgis.PyQt.QtCore`` of QGIS 4 without the old names of flags that it brings back: the plugin needs none."""
from typing import Any

from PyQt6.QtCore import *  # noqa: F403

NULL: Any = None
