"""XML of other programs: namespaces, encodings, and what is refused."""
from __future__ import annotations

from pathlib import Path
from xml.etree.ElementTree import ParseError

import pytest
from seam_inspector.plugin.imagery.documents import looks_like_xml, xml_root


@pytest.mark.parametrize("encoding", ["utf-8", "utf-8-sig", "utf-16", "iso-8859-2"])
def test_the_encoding_is_the_documents_own(encoding: str) -> None:
    name = encoding.replace("-sig", "")
    content = f'<?xml version="1.0" encoding="{name}"?>\n<mark>Łódź</mark>'.encode(encoding)
    assert looks_like_xml(content)
    assert xml_root(content).text == "Łódź"


def test_entities_are_refused_before_they_grow(tmp_path: Path) -> None:
    """A bomb of ten billion letters, and a file that an entity names."""
    grown = "".join(f'<!ENTITY a{n} "{f"&a{n - 1};" * 10}">' for n in range(1, 11))
    secret = tmp_path / "secret.txt"
    secret.write_text("secret")
    for declared, used in ((f'<!ENTITY a0 "x">{grown}', "a10"), (f'<!ENTITY file SYSTEM "{secret.as_uri()}">', "file")):
        with pytest.raises(ParseError, match="document types are refused"):
            xml_root(f'<?xml version="1.0"?><!DOCTYPE a [{declared}]><a>&{used};</a>'.encode())
    with pytest.raises(ParseError, match="document types are refused"):
        xml_root(f'<!DOCTYPE a SYSTEM "{secret.as_uri()}"><a/>'.encode())


@pytest.mark.parametrize(
    "content", [b"", b"<a>", b"<a>&b;</a>", b'<?xml version="1.0" encoding="none"?><a/>', b"<a>\xff</a>", b"text"]
)
def test_what_is_no_document_is_refused(content: bytes) -> None:
    with pytest.raises(ParseError):
        xml_root(content)
