"""XML of other programs: namespaces, encodings, and what is refused."""
from __future__ import annotations

from contextlib import suppress
from pathlib import Path
from xml.etree.ElementTree import ParseError
from xml.parsers import expat

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


class CountedParser:
    """A parser as expat's; notes how much it is given at once."""

    def __init__(self, given: list[int], parser: object) -> None:
        vars(self).update(given=given, parser=parser)

    def __setattr__(self, name: str, value: object) -> None:
        setattr(self.parser, name, value)

    def Parse(self, data: bytes, last: bool) -> None:  # noqa: N802
        self.given.append(len(data))
        self.parser.Parse(data, last)


@pytest.mark.slow
@pytest.mark.parametrize("content", [
    b'<a b="' + b"x" * 20_000_000 + b'"/>', b"<a " * 5_000_000, b"<a>" * 200_000 + b"</a>" * 200_000,
    b"<a><!--" + b"-" * 20_000_000,
], ids=["attribute", "unfinished", "deep", "comment"])  # fmt: skip
def test_large_documents_are_read_in_one_go(content: bytes, monkeypatch: pytest.MonkeyPatch) -> None:
    """Bit by bit a long attribute would be looked at again with each bit: minutes for a megabyte."""
    given: list[int] = []
    plain = expat.ParserCreate
    monkeypatch.setattr(expat, "ParserCreate", lambda **named: CountedParser(given, plain(**named)))
    with suppress(ParseError):
        xml_root(content)
    assert given == [len(content)]


@pytest.mark.parametrize(
    "content", [b"", b"<a>", b"<a>&b;</a>", b'<?xml version="1.0" encoding="none"?><a/>', b"<a>\xff</a>", b"text"]
)
def test_what_is_no_document_is_refused(content: bytes) -> None:
    with pytest.raises(ParseError):
        xml_root(content)
