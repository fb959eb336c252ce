"""What of a decision is written, and what stands on paper beside it: the parameters for it."""
from __future__ import annotations

from ..toolkit.algorithms import parameters as common
from ..toolkit.algorithms.base import SeamInspectorAlgorithm
from ..toolkit.translation import filled, tr
from .paper.paper_head import add_head

MOST_PICTURES = 100  # of a delivery, of the longest failures: some 12 MB of report
LOSS, RADIOMETRY, DIGESTS = "LOSS", "RADIOMETRY", "DIGESTS"
DEFECTS, SHEETS_OUT, REPORT, QUALITY = "DEFECTS", "SHEETS_OUT", common.REPORT, "QUALITY"


def add_paper(algorithm: SeamInspectorAlgorithm) -> None:
    """What is shown beside the decision, and what is written."""
    add_head(algorithm)
    algorithm.addDescribed(common.layers(common.MOSAIC, tr("Mosaic"), optional=True), tr(
        "The mosaic or its sheets: pictures of the failures are cut from them, for the layer and the report."
    ))
    algorithm.addDescribed(common.layers(common.SOURCES, tr("Sources"), optional=True), tr(
        "The orthoimages: the report shows each failure beside the two that meet there and their cut. Empty: those "
        "that the scan wrote into its picture of losses."
    ))
    algorithm.addDescribed(*common.source_index())
    algorithm.addDescribed(common.layers(LOSS, tr("Picture of losses"), optional=True), tr(
        "As the scan wrote it, one for each sheet where these were scanned apart, in the order of SEAMS: the XML "
        "refers to it. It also says from which orthoimages the seams were measured, and how, where their layer does "
        "not."
    ), advanced=True)
    algorithm.addDescribed(common.features(RADIOMETRY, tr("Radiometry"), common.TABLE, optional=True), tr(
        "The table that 'Check radiometry' made of the sheets: its result stands on the cover beside the decision, "
        "which it does not change."
    ))
    algorithm.addDescribed(common.flag(DIGESTS, tr("Digests of the files"), True), tr(
        "SHA-256 of the mosaic's files, the seams, the rules and the list of orthoimages, for the report and the XML. "
        "It takes as long as reading the files once."
    ), advanced=True)
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
        "{most}, the plan's risk. Opens in a browser and prints on A4."
    ), most=MOST_PICTURES), by_default=True))
    algorithm.addDescribed(
        common.made_file(QUALITY, tr("Quality record (ISO 19157)"), "XML (*.xml)", optional=True, by_default=False),
        tr("The figures and the decision for a metadata catalogue: ISO 19157:2013 in the XML of ISO/TS 19157-2:2016."),
    )

