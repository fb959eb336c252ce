"""What stands at the head of a decision on paper: which delivery it is of, under which contract, by whom, for whom."""
from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from datetime import datetime

from qgis.PyQt.QtCore import QT_TR_NOOP

from ...imagery.errors import Message, SettingsError
from ...toolkit.algorithms.base import SeamInspectorAlgorithm
from ...toolkit.algorithms.remembered import remember, remembered_text
from ...toolkit.algorithms.run import Run
from ...toolkit.translation import tr
from ..measure import messages

TITLE, CONTRACT, PRODUCER, CLIENT = "TITLE", "CONTRACT", "PRODUCER", "CLIENT"
DELIVERY, DELIVERY_DATE = "DELIVERY", "DELIVERY_DATE"
_DATES = "%Y-%m-%d", "%d.%m.%Y"

_TEXTS = {
    TITLE: (QT_TR_NOOP("Title"), QT_TR_NOOP("Of the report; empty: Acceptance of an orthophoto mosaic.")),
    CONTRACT: (QT_TR_NOOP("Contract"), QT_TR_NOOP("Number of the order or contract that the delivery belongs to.")),
    PRODUCER: (QT_TR_NOOP("Producer"), QT_TR_NOOP("Who made the delivery.")),
    CLIENT: (QT_TR_NOOP("Client"), QT_TR_NOOP("Who ordered the delivery and decides on it.")),
    DELIVERY: (QT_TR_NOOP("Delivery"), QT_TR_NOOP("What the delivery is called.")),
    DELIVERY_DATE: (
        QT_TR_NOOP("Date of the delivery"),
        QT_TR_NOOP("As it should appear in the report: 2026-11-23 or 23.11.2026."),
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
        values = self.contract, self.client, self.producer, self.delivery, self.delivery_date
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
    if value and not any(_is_date(value, form) for form in _DATES):
        yield messages.DATE_IS_NONE(parameter=DELIVERY_DATE, value=value)


def _is_date(value: str, form: str) -> bool:
    try:
        datetime.strptime(value, form)
    except ValueError:
        return False
    return True


def stated_head(run: Run) -> PaperHead:
    """What the run was given, which the form offers again the next time. A model's steps are not checked before they
    run: what is wrong is told then, and costs nothing that was measured."""
    run.tell(*(fault.as_warning() for fault in _faults(run)))
    remember(run, _TEXTS)
    return PaperHead(*(run.text(name).strip() for name in _TEXTS))
