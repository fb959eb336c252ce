"""What of a decision is written, and what stands at its head: which delivery it is of, by whom, for whom."""
from __future__ import annotations

from collections.abc import Iterator, Mapping

from qgis.PyQt.QtCore import QT_TR_NOOP

from ...toolkit.algorithms import parameters as common
from ...toolkit.algorithms.base import SeamInspectorAlgorithm
from ...toolkit.algorithms.run import Run
from ...toolkit.translation import filled, tr

TITLE, CONTRACT, PRODUCER, CLIENT = "TITLE", "CONTRACT", "PRODUCER", "CLIENT"
DELIVERY, DELIVERY_DATE = "DELIVERY", "DELIVERY_DATE"

_TEXTS = {
    TITLE: (QT_TR_NOOP("Title"), QT_TR_NOOP("Title of the report; empty: Acceptance of an orthophoto mosaic.")),
    CONTRACT: (QT_TR_NOOP("Contract"), QT_TR_NOOP("Number of the order or contract that the delivery belongs to.")),
    PRODUCER: (QT_TR_NOOP("Producer"), QT_TR_NOOP("Who made the delivery.")),
    CLIENT: (QT_TR_NOOP("Client"), QT_TR_NOOP("Who ordered the delivery and decides on it.")),
    DELIVERY: (QT_TR_NOOP("Delivery"), QT_TR_NOOP("What the delivery is called.")),
    DELIVERY_DATE: (QT_TR_NOOP("Date of the delivery"), QT_TR_NOOP("As it is to stand on paper: 2026-11-23.")),
}
"""Title and help of each parameter. Forms remember them, scripts and models don't."""


def head_rows(head: Mapping[str, str]) -> Iterator[tuple[str, str]]:
    """Names and values of the head of a paper but for its title; ``head``: by the parameters, empty is left out."""
    for name in (CONTRACT, CLIENT, PRODUCER, DELIVERY, DELIVERY_DATE):
        if value := head.get(name):
            yield tr(_TEXTS[name][0]), value


def add_head(algorithm: SeamInspectorAlgorithm) -> None:
    for name, (title, help_text) in _TEXTS.items():
        algorithm.addDescribed(common.with_last_value(common.words(name, tr(title))), tr(help_text))


def stated_head(run: Run) -> dict[str, str]:
    """What the run was given, which the form offers again the next time."""
    common.remember({name: run.text(name) for name in _TEXTS if name in run.parameters})
    return {name: run.text(name).strip() for name in _TEXTS}


MOST_PICTURES = 100  # of a delivery, of the longest failures: some 12 MB of report
DEFECTS, SHEETS_OUT, REPORT, QUALITY = "DEFECTS", "SHEETS_OUT", common.REPORT, "QUALITY"


def add_paper(algorithm: SeamInspectorAlgorithm) -> None:
    """What is shown beside the decision, and what is written."""
    add_head(algorithm)
    algorithm.addDescribed(common.layers(common.MOSAIC, tr("Mosaic"), optional=True), tr(
        "The mosaic or its sheets: pictures of the failures are cut from them, for the layer and the report."
    ))
    algorithm.addDescribed(common.layers(common.SOURCES, tr("Sources"), optional=True), tr(
        "The orthoimages: the report shows each failure beside the two that meet there and their cut. Empty: those "
        "that were scanned."
    ))
    algorithm.addDescribed(*common.source_index())
    algorithm.addDescribed(common.result(DEFECTS, tr("Failures"), common.LINE, optional=True), tr(
        "One feature for each failure without a break, for the producer: place, length, what is kept, the two "
        "orthoimages and their dates, remarks, and a picture in a folder beside the file. GeoPackage or CSV."
    ))
    algorithm.addDescribed(
        common.result(SHEETS_OUT, tr("Decided sheets"), common.POLYGON, optional=True, by_default=False),
        tr("One polygon for each sheet, with its verdict by the same limits and its metres."),
    )
    algorithm.addDescribed(*common.report(filled(tr(
        "The decision on paper, to be signed: rules, sheets, a map, the failures with pictures of the longest "
        "{most}. Opens in a browser and prints on A4."
    ), most=MOST_PICTURES), by_default=True))
    algorithm.addDescribed(
        common.made_file(QUALITY, tr("Quality record (ISO 19157)"), "XML (*.xml)", optional=True, by_default=False),
        tr("The figures and the decision for a metadata catalogue: ISO 19157:2013 in the XML of ISO/TS 19157-2:2016."),
    )
