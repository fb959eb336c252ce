"""Reports open anywhere, take any name and are there whole or not at all; their pictures hold the pixels."""
from __future__ import annotations

import re
from datetime import date

import numpy as np
import pytest
from jinja2 import UndefinedError
from osgeo import gdal
from qgis.core import QgsCoordinateReferenceSystem
from seam_inspector.plugin.imagery.errors import printable
from seam_inspector.plugin.imagery.rasters import Raster, RasterRef
from seam_inspector.plugin.toolkit.pages.templates import (
    HowMeasured,
    each_raster,
    environment,
    measured_raster,
)
from seam_inspector.plugin.toolkit.pictures import encoded

from tests.pages import outline

EVIL = "<script>alert(\"1\")</script> & 'Söhne' {{7*7}} \u202egnp.exe\x01\udcff"
SHOWN = printable(EVIL)
PARTS = """
{% extends "page.html.j2" %}
{% from "parts.html.j2" import chip, decision, drawing, facts_table, key_figures, legend, mark, marked_notes %}
{% from "parts.html.j2" import note, photograph, signatures, table, warnings %}
{% block body %}BODY{% endblock %}
"""


def page(body: str, how: HowMeasured = HowMeasured(), **view: object) -> str:  # noqa: B008 - it is frozen
    """A page with that body, which may use all parts."""
    return environment().from_string(PARTS.strip().replace("BODY", body)).render(title="Report", how=how, **view)


def test_numbers_stand_to_the_right_in_every_language() -> None:
    rows = [("a", "5.00 %", "5,00 %", "1,063\u00a0m", "2 / 40", "2019-07-04", "-0,5"), ("b", "", "", "", "", "", None)]
    numbers = environment().filters["number_columns"]([""] * 7, rows)
    assert numbers == [False, True, True, True, True, False, True]


def test_words_of_users_never_become_markup() -> None:
    text = page(
        "{{ warnings([evil]) }}{{ table([evil, 'n'], [(evil, 1), (none, 2)]) }}{{ legend([(evil, evil)], evil) }}"
        "{{ drawing('<svg/>', evil) }}{{ photograph('', evil, 1, evil) }}{{ evil }}", evil=EVIL,
    )  # fmt: skip
    assert "<script" not in text
    read = outline(text)
    assert read.words.count(SHOWN) == 7  # a warning, a heading, a cell, a legend, two captions; and bare
    assert read.captions == [SHOWN, SHOWN]


def test_a_title_at_the_foot_of_the_page_is_words_alone() -> None:
    """In a style sheet nothing is escaped by itself: quotes, braces and ends of tags would act."""
    evil = "</style>\"; } body { display: none } \\ ąć"
    text = environment().from_string("{{ evil|css_text }}").render(evil=evil)
    assert re.fullmatch(r"(?:[A-Za-z0-9 ]|\\[0-9a-f]+ )*", text)
    words = re.sub(r"\\([0-9a-f]+) ", lambda code: chr(int(code.group(1), 16)), text)
    assert words == evil
    assert len(environment().from_string("{{ 'x' * 999 }}{{ ('x' * 999)|css_text }}").render()) < 999 + 130


def test_how_it_was_measured_is_told_whole() -> None:
    wkt = QgsCoordinateReferenceSystem("EPSG:32633").toWkt()
    raster = Raster(RasterRef("/data/a.tif"), 300, 200, (500000, 0.1, 0, 0, 0, -0.1), wkt, ("red", "green"), "uint16")
    scan = Raster(RasterRef("scan.tif"), 30, 20, None, "", ("band_1",), "uint8")
    known = [measured_raster("mosaic", raster), *each_raster("photo", [scan, scan, RasterRef("gone.tif")])]
    read = outline(page("", HowMeasured([("wavelet", "coif3")], known, date(2026, 1, 2))))
    assert ["wavelet", "coif3"] in read.rows
    assert ["date", "2026-01-02"] in read.rows
    assert any(name == "software" and "Seam Inspector 0." in value for name, value in read.rows[:2])
    assert read.rows[-3:] == [
        ["mosaic", "/data/a.tif", "300 x 200 px", "0.1 m", "2 x uint16", "EPSG:32633, WGS 84 / UTM zone 33N"],
        ["photo", "scan.tif", "30 x 20 px", "", "1 x uint8", ""],
        ["photo", "gone.tif", "", "", "", ""],
    ]
    many = HowMeasured((), each_raster("", (RasterRef(f"{number}.tif") for number in range(1000))))
    assert "And 960 more." in page("", many)


def test_every_template_escapes_and_refuses_what_it_is_not_given() -> None:
    made = environment()
    assert len(made.list_templates(["j2"])) > 5
    for name in made.list_templates(["j2"]):
        source = made.loader.get_source(made, name)[0]  # type: ignore[union-attr]
        assert not re.search(r"\|\s*safe\b|autoescape", source), name
    with pytest.raises(UndefinedError):
        page("{{ nobody_said }}")


def test_a_page_needs_no_network() -> None:
    data = encoded(np.zeros((4, 6, 3), np.uint8), "JPEG")
    text = page("{{ photograph(data, 'jpeg', 6, 'clip', 2) }}{{ drawing('<svg/>') }}", data=data)
    read = outline(text)
    assert len(read.addresses) == 2
    assert all(address.startswith("data:image/") for address in read.addresses)
    assert read.pictures("jpeg") == [data]
    assert "url(" not in text
    assert "@import" not in text
    assert "default-src 'none'; img-src data:; style-src 'unsafe-inline'; base-uri 'none'; form-action 'none'" in text


def test_pictures_keep_their_pixels(tmp_path) -> None:
    pixels = np.random.default_rng(1).integers(0, 256, (5, 7, 3)).astype(np.uint8)
    file = tmp_path / "picture.png"
    file.write_bytes(encoded(pixels, "PNG"))
    assert (np.moveaxis(gdal.Open(str(file)).ReadAsArray(), 0, 2) == pixels).all()
    grey = encoded(pixels[..., 0], "JPEG")
    assert grey[:3] == b"\xff\xd8\xff"


def test_a_picture_leaves_nothing_in_memory(monkeypatch: pytest.MonkeyPatch) -> None:
    """GDAL 3.10 raises where a file to be removed is not there; older ones only say so."""
    unlink, missing = gdal.Unlink, []

    def strict(path: str) -> int:
        if gdal.VSIStatL(path) is None:
            missing.append(path)
        return int(unlink(path))

    monkeypatch.setattr(gdal, "Unlink", strict)
    before = gdal.ReadDir("/vsimem/")
    encoded(np.zeros((8, 8), np.uint8), "PNG")
    assert missing == []
    assert gdal.ReadDir("/vsimem/") == before
