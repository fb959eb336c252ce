"""XML that other programs wrote, read with care."""
from __future__ import annotations

from xml.etree.ElementTree import Element, ParseError, TreeBuilder, XMLParser

_PIECE = 64  # bytes given to the parser at once: it stops before a document type's entities are put to use


def looks_like_xml(content: bytes) -> bool:
    """Whether a file's content begins as XML does, in any encoding."""
    return content.lstrip(b"\xef\xbb\xbf\xfe\xff\0 \t\r\n").startswith(b"<")


def xml_root(content: bytes) -> Element:
    """The root of a document, all names without their namespaces.

    Raises ParseError for what is no XML and for a document type of its own: no data need one, and its entities can
    name other files or grow beyond all memory.
    """
    parser = XMLParser(target=_PlainElements())
    try:
        for start in range(0, len(content), _PIECE):
            parser.feed(content[start : start + _PIECE])
        root = parser.close()
    except (ValueError, LookupError) as error:  # an encoding that is unknown or not kept to
        raise ParseError(str(error)) from None
    assert isinstance(root, Element)
    return root


class _PlainElements(TreeBuilder):
    def start(self, tag: str, attributes: dict[str, str]) -> Element:
        return super().start(tag.rpartition("}")[2], attributes)

    def end(self, tag: str) -> Element:
        return super().end(tag.rpartition("}")[2])

    def doctype(self, *declared: object) -> None:
        raise ParseError("document types are refused")
