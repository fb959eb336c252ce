"""Reports open anywhere and take any name."""
from __future__ import annotations

import numpy as np
import pytest
from osgeo import gdal
from seam_inspector.plugin.imagery.errors import SettingsError
from seam_inspector.plugin.toolkit.pages import html_page

from tests.pages import outline


def test_words_of_users_never_become_markup() -> None:
    evil = '<script>alert("1")</script> & Söhne'
    parts = [
        html_page.heading(evil),
        html_page.heading(evil, 3, evil),
        html_page.grouped_table([[(evil, 1, 1), (evil, 1, 1)]], [([evil], [[html_page.lines(evil)]])], 2),
        html_page.legend([("#fff", evil)]),
        html_page.table(["a"], [(html_page.link(evil, evil),), (html_page.chip(evil, evil),)]),
        html_page.paragraph(evil, "small"),
        html_page.table([evil, "n"], [(evil, 1), (None, 2)]),
        html_page.drawing("<svg xmlns='http://www.w3.org/2000/svg'/>", evil),
    ]
    page = html_page.page(evil, parts)
    read = outline(page)
    assert "<script" not in page
    assert read.words.count(evil) == 15  # title, its heading, and each part: once, the tables in all cells


def test_a_page_needs_no_network() -> None:
    pixels = np.zeros((4, 6, 3), np.uint8)
    read = outline(html_page.page("Report", [html_page.picture(pixels, "clip", 2), html_page.drawing("<svg/>")]))
    assert len(read.addresses) == 2
    assert all(address.startswith("data:image/") for address in read.addresses)


def test_numbers_stand_to_the_right() -> None:
    html = html_page.table(["name", "ratio", "share"], [("a", 0.5, "3 %"), ("b", None, "12.5 %")])
    assert html.count('class="number"') == 6  # two columns of a heading and two rows


def test_pictures_keep_their_pixels(tmp_path) -> None:
    pixels = np.random.default_rng(1).integers(0, 256, (5, 7, 3)).astype(np.uint8)
    file = tmp_path / "picture.png"
    file.write_bytes(html_page.encoded(pixels, "PNG"))
    assert (np.moveaxis(gdal.Open(str(file)).ReadAsArray(), 0, 2) == pixels).all()
    grey = html_page.encoded(pixels[..., 0], "JPEG")
    assert grey[:3] == b"\xff\xd8\xff"


def test_a_report_that_can_not_be_written_is_told(tmp_path) -> None:
    html_page.save_page("<html></html>", tmp_path / "report.html")
    assert (tmp_path / "report.html").read_text() == "<html></html>"
    with pytest.raises(SettingsError, match="can't be written"):
        html_page.save_page("", tmp_path / "none" / "report.html")


def test_a_page_is_written_part_by_part_and_only_when_it_is_whole(tmp_path) -> None:
    path = tmp_path / "report.html"
    html_page.write_page(path, "Report", (html_page.paragraph(str(number)) for number in range(3)))
    assert path.read_text(encoding="utf-8") == html_page.page("Report", [html_page.paragraph(str(i)) for i in range(3)])

    def failing():
        yield html_page.paragraph("new")
        assert (tmp_path / "report.html.part").exists()
        raise ZeroDivisionError

    with pytest.raises(ZeroDivisionError):
        html_page.write_page(path, "Report", failing())
    assert ">2<" in path.read_text(encoding="utf-8")  # the older one
    assert [one.name for one in tmp_path.iterdir()] == ["report.html"]
    with pytest.raises(SettingsError, match="can't be written"):
        html_page.write_page(tmp_path / "none" / "report.html", "", [])


def test_headings_of_numbers_stand_above_them() -> None:
    headings = [[("name", 1, 2), ("share", 2, 1), ("n", 1, 2)], [("1", 1, 1), ("2", 1, 1)]]
    html = html_page.grouped_table(headings, [(["a"], [[0.1, 0.2, 3], [0.4, 0.5, 6]])], 1)
    first, second, *_ = html.split("</tr>")
    assert '<th rowspan="2">name</th>' in first
    assert '<th class="group" colspan="2">share</th>' in first
    assert '<th class="number" rowspan="2">n</th>' in first
    assert second.count('class="number"') == 2
    assert '<td rowspan="2">a</td>' in html
    assert html.count('<td class="number">') == 6


def test_a_picture_leaves_nothing_in_memory(monkeypatch: pytest.MonkeyPatch) -> None:
    """GDAL 3.10 raises where a file to be removed is not there; older ones only say so."""
    unlink, missing = gdal.Unlink, []

    def strict(path: str) -> int:
        if gdal.VSIStatL(path) is None:
            missing.append(path)
        return int(unlink(path))

    monkeypatch.setattr(gdal, "Unlink", strict)
    before = gdal.ReadDir("/vsimem/")
    html_page.encoded(np.zeros((8, 8), np.uint8), "PNG")
    assert missing == []
    assert gdal.ReadDir("/vsimem/") == before
