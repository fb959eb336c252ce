"""The structure that the published XML schemas ask of a quality record, as far as ours goes: what may stand in each
element, in which order, how often.

From the schemas of ISO/TS 19157-2:2016 (mdq 1.0: dataQualityElement.xsd, dataQualityEvaluation.xsd,
dataQualityResult.xsd, dataQualityImagery.xsd, metaquality.xsd) and ISO 19115-3 (mdb 2.0 metadataBase.xsd, cit 2.0
citation.xsd, mcc 1.0 commonClasses.xsd, mrl 2.0 lineage.xsd, msr 2.0 spatialRepresentation.xsd, mrc 2.0 content.xsd,
gex 1.0 extent.xsd, lan 1.0 language.xsd, gco 1.0 baseTypes2014.xsd, gcx 1.0 extendedTypes.xsd), https://schemas.isotc211.org
and https://github.com/ISO-TC211/XML. They import GML and each other by the dozen, so they are not carried along.
"""
from __future__ import annotations

import re
from collections.abc import Iterator
from xml.etree.ElementTree import Element, fromstring

_ISO = "http://standards.iso.org/iso"
NAMESPACES = {
    **{name: f"{_ISO}/19115/-3/{name}/1.0" for name in ("gco", "gcx", "gex", "lan", "mcc", "mrd", "mri", "mrs")},
    **{name: f"{_ISO}/19115/-3/{name}/2.0" for name in ("cit", "mdb", "mrc", "mrl", "msr")},
    "mdq": f"{_ISO}/19157/-2/mdq/1.0",
    "xlink": "http://www.w3.org/1999/xlink",
    "xsi": "http://www.w3.org/2001/XMLSchema-instance",
}
_PREFIXES = {address: name for name, address in NAMESPACES.items()}

TEXT, NUMBER, WHOLE, YES_NO, MOMENT, FREE = "text", "number", "whole", "yes_no", "moment", "free"
_CONTENT = {
    TEXT: r".*", NUMBER: r"-?\d+(\.\d+)?([eE][-+]?\d+)?", WHOLE: r"\d+", YES_NO: "true|false|0|1",
    MOMENT: r"\d{4}-\d\d-\d\dT\d\d:\d\d:\d\d(\.\d+)?(Z|[-+]\d\d:\d\d)?", FREE: r".*",
}  # fmt: skip

_STRING, _MOMENT, _CITATION, _SCOPE = (
    ("gco:CharacterString",), ("gco:DateTime",), ("cit:CI_Citation",), ("mcc:MD_Scope",)
)  # fmt: skip
_RESULT = "dateTime? resultScope?"
_EVALUATION = "dateTime* evaluationMethodDescription? evaluationProcedure? referenceDoc* evaluationMethodType?"
_ELEMENT = "standaloneQualityReportDetails? measure? evaluationMethod? result+ derivedElement*"
_ELEMENTS = ("mdq:DQ_QuantitativeAttributeAccuracy", "mdq:DQ_UsabilityElement")
_METAQUALITY = ("mdq:DQ_Confidence", "mdq:DQ_Representativity", "mdq:DQ_Homogeneity")
_METHODS = ("mdq:DQ_FullInspection", "mdq:DQ_SampleBasedInspection", "mdq:DQ_AggregationDerivation")

CHILDREN = {
    "mdb:MD_Metadata": "metadataIdentifier? defaultLocale? parentMetadata? metadataScope* contact+ dateInfo+ "
    "metadataStandard* metadataProfile* alternativeMetadataReference* otherLocale* metadataLinkage* "
    "spatialRepresentationInfo* referenceSystemInfo* metadataExtensionInfo* identificationInfo+ contentInfo* "
    "distributionInfo* dataQualityInfo* resourceLineage* portrayalCatalogueInfo* metadataConstraints* "
    "applicationSchemaInfo* metadataMaintenance? describes* acquisitionInformation*",
    "mdb:MD_MetadataScope": "resourceScope name?",
    "mcc:MD_Identifier": "authority? code codeSpace? version? description?",
    "mcc:MD_Scope": "level extent* levelDescription*",
    "mcc:MD_ScopeDescription": "dataset",
    "lan:PT_Locale": "language country? characterEncoding",
    "cit:CI_Date": "date dateType",
    "cit:CI_Citation": "title alternateTitle* date* edition? editionDate? identifier* citedResponsibleParty* "
    "presentationForm* series? otherCitationDetails* ISBN? ISSN? onlineResource* graphic*",
    "mrs:MD_ReferenceSystem": "referenceSystemIdentifier? referenceSystemType?",
    "mri:MD_DataIdentification": "citation abstract",
    "gex:EX_Extent": "description? geographicElement* temporalElement* verticalElement*",
    "gex:EX_GeographicBoundingBox": "extentTypeCode? westBoundLongitude eastBoundLongitude southBoundLatitude "
    "northBoundLatitude",
    "mdq:DQ_DataQuality": "scope standaloneQualityReport? report+",
    "mdq:DQ_StandaloneQualityReportInformation": "reportReference abstract elementReport*",
    **dict.fromkeys(_ELEMENTS, _ELEMENT),
    **dict.fromkeys(_METAQUALITY, f"{_ELEMENT} relatedElement*"),
    "mdq:DQ_MeasureReference": "measureIdentification? nameOfMeasure* measureDescription?",
    **dict.fromkeys(_METHODS, _EVALUATION),
    "mdq:DQ_SampleBasedInspection": f"{_EVALUATION} samplingScheme lotDescription samplingRatio",
    "mdq:DQ_QuantitativeResult": f"{_RESULT} value+ valueUnit? valueRecordType?",
    "mdq:DQ_ConformanceResult": f"{_RESULT} specification explanation? pass",
    "mdq:QE_CoverageResult": f"{_RESULT} spatialRepresentationType resultFile resultSpatialRepresentation "
    "resultContentDescription resultFormat",
    "mdq:QualityResultFile": "fileName fileType fileDescription fileFormat",
    "mrd:MD_Format": "formatSpecificationCitation amendmentNumber? fileDecompressionTechnique? medium* "
    "formatDistributor*",
    "msr:MD_GridSpatialRepresentation": "scope? numberOfDimensions axisDimensionProperties* cellGeometry "
    "transformationParameterAvailability",
    "msr:MD_Dimension": "dimensionName dimensionSize resolution? dimensionTitle? dimensionDescription?",
    "mrc:MD_CoverageDescription": "attributeDescription processingLevelCode? attributeGroup*",
    "mrc:MD_AttributeGroup": "contentType+ attribute*",
    "mrl:LI_Lineage": "statement? scope? additionalDocumentation* source* processStep*",
    "mrl:LI_Source": "description? sourceSpatialResolution? sourceReferenceSystem? sourceCitation? sourceMetadata* "
    "scope? sourceStep*",
    "mrl:LI_ProcessStep": "description rationale? stepDateTime? processor* reference* scope? source*",
}
"""Of each class its properties, as a regular expression of their names; they are of the class's own namespace."""

VALUES = {
    "metadataIdentifier": ("mcc:MD_Identifier",), "defaultLocale": ("lan:PT_Locale",),
    "metadataScope": ("mdb:MD_MetadataScope",), "contact": ("cit:CI_Responsibility",), "dateInfo": ("cit:CI_Date",),
    "metadataStandard": _CITATION, "referenceSystemInfo": ("mrs:MD_ReferenceSystem",),
    "identificationInfo": ("mri:MD_DataIdentification",), "dataQualityInfo": ("mdq:DQ_DataQuality",),
    "resourceLineage": ("mrl:LI_Lineage",), "resourceScope": ("mcc:MD_ScopeCode",), "code": _STRING,
    "codeSpace": _STRING, "level": ("mcc:MD_ScopeCode",), "extent": ("gex:EX_Extent",),
    "levelDescription": ("mcc:MD_ScopeDescription",),
    "dataset": _STRING, "language": ("lan:LanguageCode",), "characterEncoding": ("lan:MD_CharacterSetCode",),
    "date": ("gco:Date", "gco:DateTime"), "dateType": ("cit:CI_DateTypeCode",), "title": _STRING,
    "referenceSystemIdentifier": ("mcc:MD_Identifier",), "citation": _CITATION, "abstract": _STRING,
    "geographicElement": ("gex:EX_GeographicBoundingBox",),
    **dict.fromkeys(("westBoundLongitude", "eastBoundLongitude", "southBoundLatitude", "northBoundLatitude"),
                    ("gco:Decimal",)),
    "scope": _SCOPE, "standaloneQualityReport": ("mdq:DQ_StandaloneQualityReportInformation",),
    "report": _ELEMENTS + _METAQUALITY, "reportReference": _CITATION, "measure": ("mdq:DQ_MeasureReference",),
    "evaluationMethod": _METHODS,
    "result": ("mdq:DQ_QuantitativeResult", "mdq:DQ_ConformanceResult", "mdq:QE_CoverageResult"),
    "relatedElement": _ELEMENTS, "measureIdentification": ("mcc:MD_Identifier",), "nameOfMeasure": _STRING,
    "measureDescription": _STRING, "dateTime": _MOMENT, "evaluationMethodDescription": _STRING,
    "referenceDoc": _CITATION,
    "samplingScheme": _STRING, "lotDescription": _STRING, "samplingRatio": _STRING, "resultScope": _SCOPE,
    "value": ("gco:Record",), "valueUnit": ("gml:UnitDefinition",), "valueRecordType": ("gco:RecordType",),
    "specification": _CITATION, "explanation": _STRING, "pass": ("gco:Boolean",),
    "spatialRepresentationType": ("mcc:MD_SpatialRepresentationTypeCode",), "resultFile": ("mdq:QualityResultFile",),
    "resultSpatialRepresentation": ("msr:MD_GridSpatialRepresentation",),
    "resultContentDescription": ("mrc:MD_CoverageDescription",), "resultFormat": ("mrd:MD_Format",),
    "fileName": ("gcx:FileName",), "fileType": ("gcx:MimeFileType",), "fileDescription": _STRING,
    "fileFormat": ("mrd:MD_Format",), "formatSpecificationCitation": _CITATION, "numberOfDimensions": ("gco:Integer",),
    "axisDimensionProperties": ("msr:MD_Dimension",), "cellGeometry": ("msr:MD_CellGeometryCode",),
    "transformationParameterAvailability": ("gco:Boolean",), "dimensionName": ("msr:MD_DimensionNameTypeCode",),
    "dimensionSize": ("gco:Integer",), "resolution": ("gco:Measure",), "attributeDescription": ("gco:RecordType",),
    "attributeGroup": ("mrc:MD_AttributeGroup",), "contentType": ("mrc:MD_CoverageContentTypeCode",),
    "statement": _STRING, "source": ("mrl:LI_Source",), "processStep": ("mrl:LI_ProcessStep",), "description": _STRING,
}  # fmt: skip
"""Of each property the classes of its value."""

SIMPLE = {
    "gco:CharacterString": TEXT, "gco:DateTime": MOMENT, "gco:Decimal": NUMBER, "gco:Integer": WHOLE,
    "gco:Boolean": YES_NO, "gco:Measure": NUMBER, "gco:RecordType": TEXT, "gco:Record": FREE, "gcx:FileName": TEXT,
    "gcx:MimeFileType": TEXT,
}  # fmt: skip
CODES = {
    "mcc:MD_ScopeCode": ("dataset", "series"), "lan:LanguageCode": ("eng", "pol"), "lan:MD_CharacterSetCode": ("utf8",),
    "cit:CI_DateTypeCode": ("creation",), "mcc:MD_SpatialRepresentationTypeCode": ("grid",),
    "msr:MD_DimensionNameTypeCode": ("row", "column"), "msr:MD_CellGeometryCode": ("area",),
    "mrc:MD_CoverageContentTypeCode": ("qualityInformation",),
}  # fmt: skip
_NEEDED = {"gco:Measure": "uom", "gcx:MimeFileType": "type"}
_NIL = {"inapplicable", "missing", "template", "unknown", "withheld"}


def faults(document: str) -> list[str]:
    """What of a record is not as the schemas ask; empty for a valid one."""
    root = fromstring(document.encode())
    ids = [element.get("id") for element in root.iter() if element.get("id")]
    found = [f"id {one} twice" for one in ids if ids.count(one) > 1]
    hrefs = (element.get(f"{{{NAMESPACES['xlink']}}}href", "") for element in root.iter())
    found += [f"{href} leads nowhere" for href in hrefs if href.startswith("#") and href[1:] not in ids]
    if _name(root) != "mdb:MD_Metadata":
        return [*found, f"root is {_name(root)}"]
    return [*found, *_of_class(root)]


def _of_class(element: Element) -> Iterator[str]:
    name = _name(element)
    if name in CODES:
        if element.get("codeListValue") not in CODES[name] or "codelists.xml#" not in element.get("codeList", ""):
            yield f"{name}: {element.attrib}"
    elif name in SIMPLE:
        if len(element) or not re.fullmatch(_CONTENT[SIMPLE[name]], element.text or "", re.DOTALL):
            yield f"{name}: {element.text!r}"
        if name in _NEEDED and not element.get(_NEEDED[name]):
            yield f"{name} without {_NEEDED[name]}"
    elif name in CHILDREN:
        prefix, own = name.split(":")[0], [_name(child) for child in element]
        pattern = "".join(f"({word.rstrip('*+?')} ){word[len(word.rstrip('*+?')):]}" for word in CHILDREN[name].split())
        if not re.fullmatch(pattern, "".join(f"{one.partition(':')[2]} " for one in own)):
            yield f"{name} holds {own}"
        yield from (f"{one} in {name}" for one in own if not one.startswith(f"{prefix}:"))
        for child in element:
            yield from _of_property(child)
    else:
        yield f"{name} is unknown"


def _of_property(element: Element) -> Iterator[str]:
    name = _name(element)
    nil, linked = (element.get(f"{{{NAMESPACES[of]}}}{word}") for of, word in (("gco", "nilReason"), ("xlink", "href")))
    if nil is not None or linked is not None:
        if len(element) or (nil is not None and nil not in _NIL):
            yield f"{name}: {element.attrib}"
        return
    known = VALUES.get(name.partition(":")[2], ())
    if (element.text or "").strip() or len(element) != 1 or _name(element[0]) not in known:
        yield f"{name} holds {[_name(child) for child in element]} {element.text!r}"
        return
    yield from _of_class(element[0])


def _name(element: Element) -> str:
    address, _, name = element.tag[1:].partition("}")
    return f"{_PREFIXES.get(address, address)}:{name}"
