"""Reports open anywhere and take any name."""
from __future__ import annotations

from html.parser import HTMLParser

import numpy as np
import pytest
from osgeo import gdal
from seam_inspector.plugin.core import report
from seam_inspector.plugin.core.errors import SettingsError


class _Outline(HTMLParser):
    """Tags that were opened, addresses that would be fetched, and text."""

    def __init__(self) -> None:
        super().__init__()
        self.open: list[str] = []
        self.addresses: list[str] = []
        self.words = ""

    def handle_starttag(self, tag: str, attributes: list) -> None:
        if tag not in ("meta", "img"):
            self.open.append(tag)
        self.addresses += [value for name, value in attributes if name in ("src", "href")]

    def handle_endtag(self, tag: str) -> None:
        assert self.open.pop() == tag

    def handle_data(self, data: str) -> None:
        self.words += data


def _outline(page: str) -> _Outline:
    outline = _Outline()
    outline.feed(page)
    assert outline.open == []
    return outline


def test_words_of_users_never_become_markup() -> None:
    evil = '<script>alert("1")</script> & Söhne'
    parts = [
        report.heading(evil),
        report.paragraph(evil, "small"),
        report.table([evil, "n"], [(evil, 1), (None, 2)]),
        report.drawing("<svg xmlns='http://www.w3.org/2000/svg'/>", evil),
    ]
    page = report.page(evil, parts)
    outline = _outline(page)
    assert "<script" not in page
    assert outline.words.count(evil) == 7  # title, its heading, and each part: once, the table in both rows


def test_a_page_needs_no_network() -> None:
    pixels = np.zeros((4, 6, 3), np.uint8)
    outline = _outline(report.page("Report", [report.picture(pixels, "clip", 2), report.drawing("<svg/>")]))
    assert len(outline.addresses) == 2
    assert all(address.startswith("data:image/") for address in outline.addresses)


def test_numbers_stand_to_the_right() -> None:
    html = report.table(["name", "ratio", "share"], [("a", 0.5, "3 %"), ("b", None, "12.5 %")])
    assert html.count('class="number"') == 6  # two columns of a heading and two rows


def test_pictures_keep_their_pixels(tmp_path) -> None:
    pixels = np.random.default_rng(1).integers(0, 256, (5, 7, 3)).astype(np.uint8)
    file = tmp_path / "picture.png"
    file.write_bytes(report.encoded(pixels, "PNG"))
    assert (np.moveaxis(gdal.Open(str(file)).ReadAsArray(), 0, 2) == pixels).all()
    grey = report.encoded(pixels[..., 0], "JPEG")
    assert grey[:3] == b"\xff\xd8\xff"


def test_a_report_that_can_not_be_written_is_told(tmp_path) -> None:
    report.save_page("<html></html>", tmp_path / "report.html")
    assert (tmp_path / "report.html").read_text() == "<html></html>"
    with pytest.raises(SettingsError, match="can't be written"):
        report.save_page("", tmp_path / "none" / "report.html")
