"""QUALITY: what was measured and decided, as ISO 19157:2013 names it, in the XML of ISO/TS 19157-2:2016.

A record of ISO 19115-3 (``MD_Metadata``) carries it, as catalogues read it. The template is ``quality.xml.j2``; a test
holds its structure against that of the published schemas.
"""
from __future__ import annotations

import re
import uuid
from collections.abc import Iterator
from contextlib import suppress
from pathlib import Path

import numpy as np

from ...imagery.atomic_files import save_text
from ...imagery.errors import RasterError
from ...imagery.grids import Extent
from ...imagery.reference_systems import extent_on
from ...toolkit.pages.how_measured import HowMeasured, system_code, whole_path
from ...toolkit.pages.templates import environment
from ...toolkit.translation import filled, language, sentence, tr
from ..measure.decision import Decision
from .inspection_record import InspectionRecord
from .quality_elements import quality_elements
from .words import failing_sentence

_NO_XML = re.compile("[^\t\n\r\u0020-\ud7ff\ue000-\ufffd\U00010000-\U0010ffff]")
"""What XML 1.0 has no place for, escaped or not."""
_LANGUAGES = {"en": "eng", "pl": "pol"}
_DEGREES = "EPSG:4326"
_NAMED = 3  # sheets in the title


def save_quality_document(path: Path, record: InspectionRecord) -> None:
    """Write the XML. Raises SettingsError where no file can be."""
    save_text(quality_document(record), path)


def quality_document(record: InspectionRecord) -> str:
    """The text of the XML."""
    decision = record.decision
    sheets = decision.delivery.sheets
    names = ", ".join(sheets[:_NAMED]) + (f" (+{len(sheets) - _NAMED})" if len(sheets) > _NAMED else "")
    text = environment().get_template("quality.xml.j2").render(
        identifier=str(uuid.uuid4()),
        language=_LANGUAGES.get(language(), "eng"),
        moment=record.made_at.isoformat(),
        sheets=sheets,
        title=filled(tr("Acceptance of an orthophoto mosaic: {names}"), names=names),
        sentences=[sentence(one) for one in decision.sentences],
        system=system_code(decision.delivery.wkt),
        extent=_in_degrees(decision),
        report=Path(record.report).name if record.report else "",
        elements=list(quality_elements(record)),
        loss=record.loss,
        loss_bands=record.loss_bands,
        loss_path=whole_path(record.loss.ref.path) if record.loss else "",
        software=HowMeasured().software,
        steps=list(_steps(record)),
        sources=_sources(record),
    )  # fmt: skip
    return _NO_XML.sub("\ufffd", text.lstrip())


def _in_degrees(decision: Decision) -> Extent | None:
    """The bounding box of all sheets and seams in longitude and latitude; None where that can't be told."""
    vertices = [one.vertices for one in decision.delivery.pieces]
    vertices += [ring for one in decision.delivery.outlines for ring in one.rings]
    if not vertices or not decision.delivery.wkt:
        return None
    xmin, ymin = np.min([one.min(axis=0) for one in vertices], axis=0).tolist()
    xmax, ymax = np.max([one.max(axis=0) for one in vertices], axis=0).tolist()
    with suppress(RasterError):
        return extent_on((xmin, ymin, xmax, ymax), decision.delivery.wkt, _DEGREES)
    return None


def _steps(record: InspectionRecord) -> Iterator[str]:
    """What was done, with its settings."""
    if record.scan:
        settings = ", ".join(f"{name} {value}" for name, value in record.scan.items())
        yield filled(tr("The seams were measured (scanmosaic): {settings}."), settings=settings)
    rules = record.decision.rules
    yield filled(tr("The delivery was decided on (acceptmosaic) by the rules '{rules}'."), rules=rules.name)
    yield failing_sentence(record.decision)


def _sources(record: InspectionRecord) -> list[str]:
    """What was read."""
    found = [f"{sheet}: {path}" for sheet, path in record.seams]
    found += [whole_path(one.ref.path) for one in record.mosaics]
    found += [one for one in (record.windows, record.rules) if one]
    return list(dict.fromkeys(found))
