"""The few classes of ``qgis.core`` that parts of the plugin without a map need, and names of the others."""
from __future__ import annotations

from typing import Any

from qgis.PyQt.QtCore import NULL as NULL
from qgis.PyQt.QtCore import QObject, pyqtSignal
from qgis.PyQt.QtGui import QColor, QIcon, QPixmap
from qgis.PyQt.QtWidgets import QApplication

from .placeholders import NeedsQgis, placeholder


class Qgis:
    QGIS_VERSION = "4.0.0-stand-in"
    QGIS_VERSION_INT = 40000

    class MessageLevel:
        Info, Warning, Critical, Success, NoLevel = range(5)


class QgsApplication(QApplication):
    def __init__(self, arguments: list[str], is_shown: bool) -> None:
        super().__init__(arguments)

    @staticmethod
    def locale() -> str:
        return "en"

    @staticmethod
    def getThemeIcon(name: str) -> QIcon:
        pixels = QPixmap(24, 24)
        pixels.fill(QColor("steelblue"))
        return QIcon(pixels)


class QgsSettings:
    """Forgets everything when the process ends."""

    _values: dict[str, Any] = {}

    class Section:
        NoSection, Core, Gui, Server, Plugins, Auth, App = range(7)

    def value(self, key: str, default: Any = None, *_: object, **__: object) -> Any:
        return self._values.get(key, default)

    def setValue(self, key: str, value: Any, *_: object) -> None:
        self._values[key] = value

    def contains(self, key: str, *_: object) -> bool:
        return key in self._values

    def remove(self, key: str, *_: object) -> None:
        self._values.pop(key, None)


class QgsTask(QObject):
    taskCompleted, taskTerminated = pyqtSignal(), pyqtSignal()

    class Flag:
        CanCancel, CancelWithoutPrompt, Silent = 2, 4, 16


class QgsMapLayer(QObject):
    pass


class QgsProject(QObject):
    """Without layers; keeps what is written into it."""

    readProject, cleared, layersRemoved = pyqtSignal(), pyqtSignal(), pyqtSignal(list)
    _one: QgsProject | None = None

    def __init__(self) -> None:
        super().__init__()
        self._entries: dict[tuple[str, str], str] = {}

    @classmethod
    def instance(cls) -> QgsProject:
        cls._one = cls._one or cls()
        return cls._one

    def writeEntry(self, scope: str, key: str, value: str) -> bool:
        self._entries[scope, key] = value
        return True

    def removeEntry(self, scope: str, key: str) -> bool:
        return self._entries.pop((scope, key), None) is not None

    def readEntry(self, scope: str, key: str, default: str = "") -> tuple[str, bool]:
        return self._entries.get((scope, key), default), (scope, key) in self._entries

    def __getattr__(self, name: str) -> object:
        raise NeedsQgis(f"QgsProject.{name}")

    def clear(self) -> None:
        self._entries.clear()
        self.cleared.emit()


class QgsCsException(Exception):
    pass


class QgsProcessingException(Exception):
    pass


_BASES = {"QgsVectorLayer": QgsMapLayer, "QgsRasterLayer": QgsMapLayer, "QgsProcessingProvider": QObject}


def __getattr__(name: str) -> type:
    if not name.startswith("Qgs") and name != "edit":
        raise AttributeError(name)
    made = placeholder(name, _BASES.get(name, object))
    globals()[name] = made
    return made
