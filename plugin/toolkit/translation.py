"""Texts, messages and numbers in the user's language."""
from __future__ import annotations

import os

from qgis.core import QgsApplication
from qgis.PyQt.QtCore import QCoreApplication, QLocale, QTranslator

from ..imagery.message import Message
from .resources import translations_path


def tr(text: str) -> str:
    """The text in the user's language."""
    return QCoreApplication.translate("@default", text)


def language() -> str:
    """The language that texts come in: the interface's where they are translated into it, else English."""
    wanted = QgsApplication.locale()[:2]
    return wanted if os.path.exists(os.path.join(translations_path(), f"seam_inspector_{wanted}.qm")) else "en"


def shown_number(value: float, decimals: int = 2) -> str:
    """A number as the user writes it."""
    return QLocale().toString(value, "f", decimals)


def percent(ratio: float) -> str:
    """Whole per cents; one decimal where they would hide that a ratio is not 1, or is small."""
    decimals = 1 if 0 < ratio < 0.1 or (0.99 < ratio < 1.01 and ratio != 1) else 0
    return shown_number(min(100 * ratio, 99.9) if ratio < 1 else 100 * ratio, decimals)


def sentence(message: Message) -> str:
    """A message in the user's language."""
    return message.worded(tr)


class Translation:
    """Our translations of the interface language, in force from construction to ``remove``."""

    def __init__(self) -> None:
        self._translator = QTranslator()
        if self._translator.load(f"seam_inspector_{QgsApplication.locale()[:2]}", translations_path()):
            QCoreApplication.installTranslator(self._translator)

    def remove(self) -> None:
        QCoreApplication.removeTranslator(self._translator)
