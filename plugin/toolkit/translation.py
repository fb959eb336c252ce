"""Texts, messages and numbers in the user's language."""
from __future__ import annotations

import os
import re
from collections.abc import Iterable, Sequence
from numbers import Integral, Real
from string import Formatter

from qgis.core import QgsApplication
from qgis.PyQt.QtCore import QCoreApplication, QLocale, QTranslator

from ..imagery.errors import Message
from .resources import TRANSLATIONS

_MOST_DECIMALS = 6
_LEAST_PERCENT = 0.001
_LONG = re.compile(r"-?\d{5,}")  # digits that are grouped, where spaces do it: 10 000


def tr(text: str) -> str:
    return QCoreApplication.translate("@default", text)


def language() -> str:
    """The language that texts come in: the interface's where they are translated into it, else English."""
    wanted = QgsApplication.locale()[:2]
    return wanted if os.path.exists(os.path.join(TRANSLATIONS, f"seam_inspector_{wanted}.qm")) else "en"


def shown_number(value: float, decimals: int = 2) -> str:
    """A number as the user writes it."""
    return QLocale().toString(float(value), "f", decimals)


def grouped_number(value: float, decimals: int = 0) -> str:
    """A number with its thousands apart, whatever QGIS is set to, as labels on the map have them."""
    locale = QLocale()
    locale.setNumberOptions(QLocale.NumberOption.DefaultNumberOptions)
    return locale.toString(float(value), "f", decimals)


def shown_metres(length: float) -> str:
    """Metres as the user writes them: tenths, or hundredths where tenths would be another length."""
    return shown_number(length, 1 if abs(length - round(length, 1)) < 0.005 else 2)


def formatted(value: float, spec: str) -> str:
    """A number in a format of Python's, as the user writes it."""
    return local_digits(format(value, spec))


def percent(ratio: float, *limits: float) -> str:
    """Whole per cents; decimals where they would hide that a ratio is not 1, small and not 0, or beyond a limit."""
    bounds, least = [100 * limit for limit in limits], 1 if 0.99 < ratio < 1.01 and ratio != 1 else 0
    shown = min(100 * ratio, 99.9) if ratio < 1 else 100 * ratio
    if 0 < ratio < 0.1:
        shown, bounds, least = max(100 * ratio, _LEAST_PERCENT), [0, *bounds], 1
    return shown_number(shown, decimals_beside(shown, bounds, least))


def decimals_beside(value: float, limits: Iterable[float], least: int = 0) -> int:
    """The number of decimals with which a number is still seen to lie below its limits, above them or on them."""
    known = [round(float(limit), 9) for limit in limits]

    def sides(seen: float) -> list[int]:
        return [(seen > limit) - (seen < limit) for limit in known]

    plain = float(value)  # numpy's own numbers compare to what can't be subtracted
    true = sides(round(plain, 9))
    return next((count for count in range(least, _MOST_DECIMALS) if sides(round(plain, count)) == true), _MOST_DECIMALS)


def filled(text: str, /, **values: object) -> str:
    """A text, translated already, with its values; its numbers with decimals as the user writes them."""
    return _LOCAL.vformat(text, (), values)


def sentence(message: Message) -> str:
    return message.worded(tr, filled)


class _LocalNumbers(Formatter):
    """``{share:.1%}`` as the user's locale has it; ``{count:window|windows}`` is the word's form for the count."""

    def format_field(self, value: object, format_spec: str) -> str:
        if "|" in format_spec:
            return counted(value, format_spec.split("|"))
        text = str(super().format_field(value, format_spec))
        is_decimal = isinstance(value, float) or (format_spec and isinstance(value, Real))
        return local_digits(text) if is_decimal else text


def local_digits(number: str) -> str:
    """A number that Python wrote, as the user writes it; a per cent sign stands off it, as in all texts."""
    locale = QLocale()
    if number.endswith("%"):
        number = f"{number[:-1]}\u00a0%"
    whole, point, rest = number.partition(".")
    if locale.groupSeparator().isspace() and (digits := _LONG.match(whole)):
        whole = f"{int(digits[0]):,}".replace(",", "\u00a0") + whole[digits.end():]
    return whole + (locale.decimalPoint() if point else "") + rest


def counted(count: object, forms: Sequence[str]) -> str:
    """The form of a word that goes with a count: for one, for many; in Polish for 1, for 2, for 5, in this order."""
    number = abs(int(count)) if isinstance(count, Integral) else 0
    if number == 1:
        return forms[0]
    few = number % 10 in (2, 3, 4) and number % 100 not in (12, 13, 14)
    return forms[1] if few else forms[-1]


_LOCAL = _LocalNumbers()


class Translation:
    """Our translations of the interface language, in force from construction to ``remove``."""

    def __init__(self) -> None:
        self._translator = QTranslator()
        if self._translator.load(f"seam_inspector_{QgsApplication.locale()[:2]}", TRANSLATIONS):
            QCoreApplication.installTranslator(self._translator)

    def remove(self) -> None:
        QCoreApplication.removeTranslator(self._translator)


def band_title(name: str) -> str:
    titles = {
        "luminance": tr("luminance"),
        "red": tr("red"),
        "green": tr("green"),
        "blue": tr("blue"),
        "nir": tr("near infrared"),
    }
    return titles.get(name) or filled(tr("band {number}"), number=name[len("band_") :])
