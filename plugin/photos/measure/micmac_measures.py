"""Measured marks as MicMac keeps them: ``Ori-InterneScan/MeasuresIm-PHOTO.xml``, a photo's marks in pixels."""
from __future__ import annotations

from collections.abc import Iterable, Iterator
from pathlib import Path
from xml.etree import ElementTree
from xml.etree.ElementTree import Element, ParseError, SubElement

from ...imagery.documents.document_files import document_bytes
from ...imagery.documents.xml_documents import looks_like_xml, xml_root
from ...imagery.errors import PhotoError, system_reason
from . import messages
from .orientation import MarkResult
from .photo_views import Place

_SET, _PHOTO, _MARK = "SetOfMesureAppuisFlottants", "MesureAppuiFlottant1Im", "OneMesureAF1I"


def measures_text(photo: str, marks: Iterable[MarkResult]) -> str:
    """The document for one photo: every mark that has a place, its column and row with pixel centres at .5."""
    root = Element(_SET)
    image = SubElement(root, _PHOTO)
    SubElement(image, "NameIm").text = photo
    for mark in marks:
        if mark.place is not None:
            one = SubElement(image, _MARK)
            SubElement(one, "NamePt").text = mark.name
            SubElement(one, "PtIm").text = " ".join(f"{value:.6f}" for value in mark.place)
    ElementTree.indent(root, " " * 5)
    return '<?xml version="1.0" ?>\n' + ElementTree.tostring(root, encoding="unicode") + "\n"


def read_measures(path: Path) -> list[tuple[str, str, Place]]:
    """Photo, mark and its column and row, of all photos in a file; none where the XML is about something else.

    Raises PhotoError for a file that can't be read.
    """
    try:
        content = document_bytes(path)
        if not looks_like_xml(content):
            raise ParseError
        return list(_measures(xml_root(content), path.name))
    except OSError as error:
        raise PhotoError(messages.MEASURES_NOT_READ(name=path.name, error=system_reason(error))) from None
    except ParseError:
        raise PhotoError(messages.MEASURES_NOT_READ(name=path.name, error="no XML")) from None


def _measures(root: Element, name: str) -> Iterator[tuple[str, str, Place]]:
    for image in root.iter(_PHOTO):
        photo = (image.findtext("NameIm") or "").strip()
        for one in image.iter(_MARK):
            mark = (one.findtext("NamePt") or "").strip()
            try:
                column, row = (float(part) for part in (one.findtext("PtIm") or "").split())
            except ValueError:
                raise PhotoError(messages.MEASURES_ROW(name=name, mark=mark)) from None
            yield photo, mark, (column, row)
