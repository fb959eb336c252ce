"""What both operators' verdicts say of each other, in a window of its own."""
from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING

from qgis.PyQt.QtWidgets import QMessageBox, QWidget

from ....imagery.statistics import Agreement, agreement
from ....toolkit.translation import filled, percent, shown_number, tr

if TYPE_CHECKING:
    from ...measure.window_records import WindowRecord

_BANDS = ((0.2, "slight"), (0.4, "fair"), (0.6, "moderate"), (0.8, "substantial"))
"""Landis and Koch 1977 (Biometrics 33, 159-174): up to each kappa."""


def agreement_of(windows: Iterable[WindowRecord]) -> Agreement:
    """Of both operators."""
    return agreement([(row.observer, row.observer_2) for row in windows])


def agreement_sentences(found: Agreement) -> list[str]:
    """How often they agreed, and how much of that is not chance."""
    if not found.count:
        return [tr("No window was judged by both operators yet; who is not sure did not judge.")]
    share = percent(found.agreed / found.count)
    said = [
        filled(tr("Both judged {count} windows and said the same of {agreed} ({percent} %)."),
            count=found.count, agreed=found.agreed, percent=share
        ),
        filled(tr("Only the first saw a loss: {first}. Only the second: {second}."),
            first=found.first_alone, second=found.second_alone
        ),
    ]
    if found.kappa is None:
        return [*said, tr("One of them said one word only, so agreement can't be told from chance.")]
    kappa = tr("Cohen's kappa: {value} ({low} to {high} by 95 %), {word}.")
    values = (shown_number(value) for value in (found.kappa.value, found.kappa.low, found.kappa.high))
    value, low, high = values
    return [*said, filled(kappa, value=value, low=low, high=high, word=_strength(found.kappa.value))]


def _strength(kappa: float) -> str:
    words = {
        "slight": tr("slight agreement"), "fair": tr("fair agreement"), "moderate": tr("moderate agreement"),
        "substantial": tr("substantial agreement"),
    }  # fmt: skip
    if kappa <= 0:
        return tr("no more than chance")
    return next((words[word] for most, word in _BANDS if kappa <= most), tr("almost perfect agreement"))


def ask_for_disagreements(found: Agreement, parent: QWidget) -> bool:
    """Tell the agreement; whether the operator wants to see the windows where they disagree."""
    box = QMessageBox(QMessageBox.Icon.Information, tr("Agreement of both operators"), "", parent=parent)
    box.setText("\n\n".join(agreement_sentences(found)))
    show = None
    if found.count > found.agreed:
        show = box.addButton(tr("Show where they differ"), QMessageBox.ButtonRole.ActionRole)
    box.addButton(QMessageBox.StandardButton.Close)
    box.exec()
    return show is not None and box.clickedButton() is show
