"""Reading the pages of reports: every tag is closed, and what a page says, shows and would fetch."""
from __future__ import annotations

import base64
from html.parser import HTMLParser

_WITHOUT_END = ("meta", "img", "br", "wbr")


class Outline(HTMLParser):
    """Tags that are open, addresses, names of places in the page, text, and rows of tables."""

    def __init__(self) -> None:
        super().__init__()
        self.open: list[str] = []
        self.addresses: list[str] = []
        """Addresses of what would be fetched."""
        self.links: list[str] = []
        self.anchors: list[str] = []
        self.words = ""
        self.rows: list[list[str]] = []
        """The cells of all tables, row by row."""
        self.captions: list[str] = []
        """Captions of all pictures."""

    def handle_starttag(self, tag: str, attributes: list[tuple[str, str | None]]) -> None:
        if tag not in _WITHOUT_END:
            self.open.append(tag)
        values = {name: value or "" for name, value in attributes}
        self.anchors += [values["id"]] if "id" in values else []
        if tag == "a":
            self.links.append(values["href"])
        else:
            self.addresses += [values[name] for name in ("src", "href") if name in values]
        if tag == "img":
            self.captions.append(values["alt"])
        if tag == "tr":
            self.rows.append([])
        if tag in ("td", "th"):
            self.rows[-1].append("")

    def handle_startendtag(self, tag: str, attributes: list[tuple[str, str | None]]) -> None:
        self.handle_starttag(tag, attributes)
        if tag not in _WITHOUT_END:
            self.open.pop()

    def handle_endtag(self, tag: str) -> None:
        assert self.open.pop() == tag

    def handle_data(self, data: str) -> None:
        self.words += data
        if {"td", "th"} & set(self.open):
            self.rows[-1][-1] += data

    def pictures(self, media: str) -> list[bytes]:
        """The files of all pictures of a kind, in their order."""
        start = f"data:image/{media};base64,"
        return [base64.b64decode(address[len(start) :]) for address in self.addresses if address.startswith(start)]


def outline(page: str) -> Outline:
    """Read a page; every tag that it opens has to be closed."""
    read = Outline()
    read.feed(page)
    assert read.open == []
    return read
