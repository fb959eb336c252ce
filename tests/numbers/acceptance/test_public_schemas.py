"""The published schemas are there, and find what is wrong with a record."""
from __future__ import annotations

import pytest

from tests.numbers.acceptance.public_schemas import NAMESPACES, faults

RECORD = """<mdb:MD_Metadata {spaces}>
<mdb:contact gco:nilReason="missing"/>
<mdb:dateInfo><cit:CI_Date><cit:date><gco:DateTime>2026-11-22T10:00:00+00:00</gco:DateTime></cit:date><cit:dateType>
<cit:CI_DateTypeCode codeList="codelists.xml#CI_DateTypeCode" codeListValue="creation"/></cit:dateType></cit:CI_Date>
</mdb:dateInfo>
<mdb:identificationInfo><mri:MD_DataIdentification><mri:citation><cit:CI_Citation><cit:title>
<gco:CharacterString>t</gco:CharacterString></cit:title></cit:CI_Citation></mri:citation><mri:abstract>
<gco:CharacterString>a</gco:CharacterString></mri:abstract></mri:MD_DataIdentification></mdb:identificationInfo>
<mdb:dataQualityInfo><mdq:DQ_DataQuality><mdq:scope gco:nilReason="missing"/><mdq:report>
<mdq:DQ_UsabilityElement id="one">
<mdq:result><mdq:DQ_QuantitativeResult><mdq:value><gco:Record>2</gco:Record></mdq:value>
<mdq:valueUnit xlink:href="http://www.opengis.net/def/uom/UCUM/m"/></mdq:DQ_QuantitativeResult></mdq:result>
</mdq:DQ_UsabilityElement></mdq:report></mdq:DQ_DataQuality></mdb:dataQualityInfo>
</mdb:MD_Metadata>""".replace("{spaces}", " ".join(f'xmlns:{name}="{one}"' for name, one in NAMESPACES.items()))


def test_a_record_as_the_schemas_ask_has_no_fault() -> None:
    assert faults(RECORD) == []


@pytest.mark.parametrize(("old", "new"), [
    ('<mdb:contact gco:nilReason="missing"/>', ""),
    ("<mdq:value><gco:Record>2</gco:Record></mdq:value>\n", ""),
    ("<mri:abstract>\n<gco:CharacterString>a</gco:CharacterString></mri:abstract>", ""),
    ("2026-11-22T10:00:00+00:00", "22.11.2026"),
    ("<gco:Record>2</gco:Record>", "2"),
    ("<mdq:result>", '<mdq:result xlink:href="#two"/><mdq:result>'),
    ("<mdq:result>", "<mdq:measure/><mdq:measure/><mdq:result>"),
    ("mdq:DQ_UsabilityElement", "mdq:DQ_Seams"),
    ("<cit:title>", "<cit:edition><gco:CharacterString>1</gco:CharacterString></cit:edition><cit:title>"),
])  # fmt: skip
def test_faults_are_found(old: str, new: str) -> None:
    assert old in RECORD
    assert faults(RECORD.replace(old, new))
