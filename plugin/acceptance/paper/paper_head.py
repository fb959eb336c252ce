"""What stands at the head of a decision on paper: which delivery it is of, under which contract, by whom, for whom."""
from __future__ import annotations

import re
from collections.abc import Iterator
from contextlib import suppress
from dataclasses import dataclass
from datetime import date, datetime

from qgis.PyQt.QtCore import QT_TR_NOOP

from ...imagery.errors import Message, SettingsError
from ...toolkit.algorithms.base import SeamInspectorAlgorithm
from ...toolkit.algorithms.remembered import remember, remembered_text
from ...toolkit.algorithms.run import Run
from ...toolkit.translation import tr
from ..measure import messages

TITLE, CONTRACT, PRODUCER, CLIENT = "TITLE", "CONTRACT", "PRODUCER", "CLIENT"
DELIVERY, DELIVERY_DATE = "DELIVERY", "DELIVERY_DATE"
_DATES = "%Y-%m-%d", "%d.%m.%Y", "%Y/%m/%d", "%Y:%m:%d", "%Y%m%d"
"""As people write dates, and layers of seams, with a time of day perhaps."""

_TEXTS = {
    TITLE: (QT_TR_NOOP("Title"), QT_TR_NOOP("Of the report; empty: Acceptance of an orthophoto mosaic.")),
    CONTRACT: (QT_TR_NOOP("Contract"), QT_TR_NOOP("Number of the order or contract that the delivery belongs to.")),
    PRODUCER: (QT_TR_NOOP("Producer"), QT_TR_NOOP("Who made the delivery.")),
    CLIENT: (QT_TR_NOOP("Client"), QT_TR_NOOP("Who ordered the delivery and decides on it.")),
    DELIVERY: (QT_TR_NOOP("Delivery"), QT_TR_NOOP("What the delivery is called.")),
    DELIVERY_DATE: (
        QT_TR_NOOP("Date of the delivery"),
        QT_TR_NOOP("2026-11-23 or 23.11.2026; the report writes the first."),
    ),
}
"""Title and help of each parameter. Forms remember them, scripts and models don't."""


@dataclass(frozen=True)
class PaperHead:
    """As it was given; empty is left out."""

    title: str = ""
    contract: str = ""
    producer: str = ""
    client: str = ""
    delivery: str = ""
    delivery_date: str = ""

    @property
    def rows(self) -> Iterator[tuple[str, str]]:
        """Names and values, but for the title."""
        values = self.contract, self.client, self.producer, self.delivery, iso_date(self.delivery_date)
        for name, value in zip((CONTRACT, CLIENT, PRODUCER, DELIVERY, DELIVERY_DATE), values):
            if value:
                yield tr(_TEXTS[name][0]), value


def add_head(algorithm: SeamInspectorAlgorithm) -> None:
    """The parameters, all optional."""
    for name, (title, help_text) in _TEXTS.items():
        algorithm.addDescribed(remembered_text(name, tr(title)), tr(help_text))


def check_head(run: Run) -> None:
    """Raise SettingsError for a date that is none."""
    for fault in _faults(run):
        raise SettingsError(fault)


def _faults(run: Run) -> Iterator[Message]:
    value = run.text(DELIVERY_DATE).strip()
    if value and _day(value) is None:
        yield messages.DATE_IS_NONE(parameter=DELIVERY_DATE, value=value)


def _day(value: str) -> date | None:
    for form in _DATES:
        with suppress(ValueError):
            return datetime.strptime(re.split("[T ]", value.strip())[0], form).date()
    return None


def iso_date(value: str) -> str:
    """As all dates on paper are written, 2026-11-23; what is no date as it is."""
    day = _day(value)
    return value if day is None else day.isoformat()


def stated_head(run: Run) -> PaperHead:
    """What the run was given, which the form offers again the next time. A model's steps are not checked before they
    run: what is wrong is told then, and costs nothing that was measured."""
    run.tell(*(fault.as_warning() for fault in _faults(run)))
    remember(run, _TEXTS)
    return PaperHead(*(run.text(name).strip() for name in _TEXTS))
