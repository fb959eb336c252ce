"""QUALITY: what was measured and decided, as ISO 19157:2013 names it, in the XML of ISO/TS 19157-2:2016.

A record of ISO 19115-3 (``MD_Metadata``) carries it, as catalogues read it. The template is ``quality.xml.j2``; a test
holds its structure against that of the published schemas.
"""
from __future__ import annotations

import re
import uuid
from collections.abc import Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path

from ...imagery.atomic_files import save_text
from ...imagery.errors import RasterError
from ...imagery.grids import Extent
from ...imagery.reference_systems import extent_on
from ...toolkit.layers import box_extent, reference_system
from ...toolkit.pages.templates import environment, whole_path
from ...toolkit.translation import filled, language, sentence, tr
from ..measure import acceptance_rules as rules
from ..measure.decision import Decision, RuleOutcome
from ..measure.inspection_plan import plan_sentence
from .inspection_record import InspectionRecord, how_measured
from .paper_head import head_rows
from .sheet_layer import extent_of_all
from .words import CHECKS, failing_sentence

_UCUM = "http://www.opengis.net/def/uom/UCUM/"
METRES, PER_CENT, ONE = f"{_UCUM}m", f"{_UCUM}%25", f"{_UCUM}1"
"""Units of measure by their address; ``ONE`` for counts and fractions of 1."""

ACCURACY, USABILITY = "DQ_QuantitativeAttributeAccuracy", "DQ_UsabilityElement"
REPRESENTATIVITY, OMISSION = "DQ_Representativity", "DQ_CompletenessOmission"
"""Classes of the standard. Grey values are a coverage's attributes, and lost detail an error of theirs; whether a
delivery keeps to its rules is usability; how much was looked at is metaquality."""

FULL, SAMPLE, DERIVED = "DQ_FullInspection", "DQ_SampleBasedInspection", "DQ_AggregationDerivation"
"""How a figure was found."""
_SAMPLING = "Sampling procedures for inspection by attributes"
_PROCEDURE = (
    "K. Pyka: The use of wavelets for evaluation of loss in radiometric quality in the orthophoto mosaicking process, "
    "2010; Seam Inspector: The seam profile"
)


@dataclass(frozen=True)
class Evaluation:
    """How a figure was found."""

    kind: str
    description: str
    reference: str = ""  # the document that it follows; empty for none
    sample: tuple[str, str, str] | None = None  # scheme, lot and ratio of sampling, in words


Conformance = tuple[str, str, "bool | None"]
"""What was asked for, an explanation, and whether it is met."""
Quantity = tuple[float, str, str]
"""A result in numbers, its unit, and the sheet that it is of; empty for all."""


@dataclass(frozen=True)
class QualityElement:
    """One report of the document."""

    kind: str
    code: str  # code of the measure; the element is known by it within the document
    name: str
    description: str
    evaluation: Evaluation
    conformance: Conformance | None
    quantities: Sequence[Quantity] = ()


def quality_elements(decision: Decision) -> Iterator[QualityElement]:
    """The decision first, then the figures it rests on, then the files where they were checked."""
    yield QualityElement(
        USABILITY, "acceptance", tr("acceptance of the delivery"), tr("Whether the delivery meets the rules."),
        Evaluation(DERIVED, tr("All rules together: the delivery is accepted if none of them fails.")),
        (decision.rules.name, " ".join(map(sentence, decision.sentences)), decision.accepted),
    )
    outcomes = {outcome.check: outcome for outcome in decision.outcomes}
    kinds = {rules.MEASURED_SHARE: REPRESENTATIVITY, rules.SAMPLING: USABILITY}
    for code, check in CHECKS.items():
        outcome, quantities = outcomes.get(code), [*_quantities(decision, code)]
        if quantities or outcome is not None:
            yield QualityElement(
                kinds.get(code, ACCURACY), code, tr(check.title), tr(check.description), _evaluation(code, decision),
                None if outcome is None else _conformance(outcome), quantities,
            )
    if lacking := sum(decided.blank_m for decided in decision.pieces):
        yield QualityElement(
            OMISSION, "uncovered", tr("orthoimages along the seams"),
            tr("Length of seam along which orthoimages are missing, without pixels or do not explain the mosaic."),
            Evaluation(FULL, tr("Each piece of seam on ground with detail.")), None, [(lacking, METRES, "")],
        )
    if decision.delivery.is_checked:
        yield _files(decision.delivery.findings)


def _evaluation(code: str, decision: Decision) -> Evaluation:
    if code == rules.MEASURED_SHARE:
        return Evaluation(DERIVED, tr("From the results of all pieces of seam."))
    if code == rules.SAMPLING and decision.plan is not None:
        plan = decision.plan.plan
        pieces = tr("{count} pieces of seam of {sheets} sheets")
        sample = (
            sentence(plan_sentence(plan)), filled(pieces, count=plan.lot_size, sheets=len(decision.sheets)),
            f"{plan.sample_size} / {plan.lot_size}",
        )
        return Evaluation(SAMPLE, tr("Each piece of seam of the sample."), f"{plan.standard}, {_SAMPLING}", sample)
    kept = tr(
        "Each piece of seam: the finest detail that is left in the strip along it, relative to the ground around it "
        "(wavelet decomposition)."
    )
    return Evaluation(FULL, f"{kept} {failing_sentence(decision)}", _PROCEDURE)


def _quantities(decision: Decision, code: str) -> Iterator[Quantity]:
    """A figure of all sheets together, then that of each sheet that has one."""
    if code == rules.SAMPLING and decision.plan is not None:
        yield decision.plan.nonconforming, ONE, ""
    scale, unit = {rules.KEPT: (1, ONE), rules.LONGEST_FAILURE: (1, METRES)}.get(code, (100, PER_CENT))
    for row in (decision.whole, *decision.sheets):
        if (value := CHECKS[code].figure(row)) is not None:
            yield scale * value, unit, row.name


def _files(findings: Mapping[str, str]) -> QualityElement:
    """What was found at the files, which does not change the decision."""
    words = " ".join(f"{name}: {finding}." for name, finding in findings.items())
    return QualityElement(
        USABILITY, "files", tr("completeness and form of the files"),
        tr("Sheets that are missing, incomplete, or differ from most sheets or from the order."),
        Evaluation(FULL, tr("The files of all sheets ('Check a delivery').")),
        (tr("form of the delivery"), words or tr("No findings"), not findings), [(len(findings), ONE, "")],
    )


def _conformance(outcome: RuleOutcome) -> Conformance:
    clause = sentence(outcome.sentence)
    return outcome.source, f"{clause[:1].upper()}{clause[1:].rstrip('.')}.", outcome.passed


_NO_XML = re.compile("[^\t\n\r\u0020-\ud7ff\ue000-\ufffd\U00010000-\U0010ffff]")
"""What XML 1.0 has no place for, escaped or not."""
_LANGUAGES = {"en": "eng", "pl": "pol"}
_DEGREES = "EPSG:4326"
_NAMED = 3  # sheets in the title


def save_quality_document(path: Path, record: InspectionRecord) -> None:
    """Write the XML. Raises SettingsError where no file can be."""
    save_text(quality_document(record), path)


def quality_document(record: InspectionRecord) -> str:
    decision, how = record.decision, how_measured(record)
    sheets = decision.delivery.sheets
    names = ", ".join(sheets[:_NAMED]) + (f" (+{len(sheets) - _NAMED})" if len(sheets) > _NAMED else "")
    text = environment().get_template("quality.xml.j2").render(
        identifier=str(uuid.uuid4()),
        language=_LANGUAGES.get(language(), "eng"),
        moment=record.made_at.isoformat(),
        sheets=sheets,
        title=f"{record.title}: {names}",
        head="; ".join(f"{name}: {value}" for name, value in head_rows(record.head)),
        sentences=[*map(sentence, decision.sentences)],
        system=reference_system(decision.delivery.wkt).authid(),
        extent=_in_degrees(decision),
        report=Path(record.report).name if record.report else "",
        elements=list(quality_elements(decision)),
        software=how.software,
        steps=[f"{name}: {value}" for name, value in how.settings if value],
        sources=_sources(record),
    )  # fmt: skip
    return _NO_XML.sub("\ufffd", text.lstrip())


def _in_degrees(decision: Decision) -> Extent | None:
    """The bounding box of all sheets and seams in longitude and latitude; None where that can't be told."""
    with suppress(RasterError):
        if decision.pieces and decision.delivery.wkt:
            return extent_on(box_extent(extent_of_all(decision.delivery)), decision.delivery.wkt, _DEGREES)
    return None


def _sources(record: InspectionRecord) -> list[str]:
    files = [f"{sheet}: {path}" + (f" (SHA-256 {digest})" if digest else "") for sheet, path, digest in record.seams]
    files += dict.fromkeys(whole_path(mosaic.ref.path) for mosaic in record.mosaics)
    files += [path for path in (record.windows, record.rules) if path]
    return files + [f"{path} ({date})" if date else path for path, date in record.images]
