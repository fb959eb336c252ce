"""Reports: one HTML page that opens anywhere, without network, and prints well on A4.

The parts are strings of HTML. Whatever comes from a user or a file name goes through ``text``, so that it can
never become markup; every function here does so with its words.
"""
from __future__ import annotations

import base64
import html
import os
from collections.abc import Iterable, Iterator, Sequence
from contextlib import suppress
from pathlib import Path
from typing import NewType

import numpy as np
from osgeo import gdal

from ...imagery import messages as imagery_messages
from ...imagery.datasets import drop_from_memory
from ...imagery.errors import SettingsError
from ...imagery.gdal_messages import gdal_silenced

Html = NewType("Html", str)

_STYLE = """
:root { color-scheme: light; }
body { font: 14px/1.45 system-ui, "Segoe UI", "DejaVu Sans", sans-serif; color: #1b1f23; background: #fff;
  max-width: 62rem; margin: 2rem auto; padding: 0 1.5rem; }
h1 { font-size: 1.6rem; margin: 0 0 .3rem; } h2 { font-size: 1.2rem; margin: 2rem 0 .5rem; }
h3 { font-size: 1rem; margin: 1.2rem 0 .3rem; }
p { margin: .4rem 0; } p.small { color: #57606a; font-size: .88em; }
.warning { border-left: 4px solid #d55e00; padding: .2rem .7rem; background: #fdf3ec; }
.scroll { overflow-x: auto; }
table { border-collapse: collapse; font-variant-numeric: tabular-nums; margin: .5rem 0; }
th, td { padding: .25rem .65rem; border-bottom: 1px solid #d0d7de; text-align: left; vertical-align: top; }
th { border-bottom: 2px solid #1b1f23; vertical-align: bottom; }
td .words { display: inline-block; min-width: 10em; overflow-wrap: anywhere; }
td.number, th.number { text-align: right; } td.number { white-space: nowrap; }
.row { display: flex; flex-wrap: wrap; gap: 1rem; align-items: flex-start; }
figure { margin: .5rem 0; } figure img { max-width: 100%; height: auto; display: block; }
figure img.pixels { image-rendering: pixelated; }
figcaption { color: #57606a; font-size: .88em; max-width: 40rem; overflow-wrap: anywhere; }
a { color: inherit; } svg { display: block; max-width: 100%; height: auto; }
tbody.group { break-inside: avoid; }
tbody.group td { border-bottom: none; padding-top: .1rem; padding-bottom: .1rem; }
tbody.group tr:last-child td, tbody.group td[rowspan] { border-bottom: 1px solid #8c959f; }
th.group { text-align: center; }
.chip { display: inline-block; width: .8em; height: .8em; border-radius: .15em; margin-right: .35em;
  print-color-adjust: exact; -webkit-print-color-adjust: exact; }
ul.legend { list-style: none; padding: 0; margin: .2rem 0; color: #57606a; font-size: .88em; overflow-wrap: anywhere; }
ul.legend li { display: flex; } ul.legend .chip { flex: none; margin-top: .35em; }
ul.legend.inline li { display: inline-flex; margin-right: 1.2em; }
div.column { max-width: 320px; }
.together { break-inside: avoid; }
@page { size: A4; margin: 15mm; }
@media print { body { max-width: none; margin: 0; padding: 0; font-size: 10pt; } h2, h3 { break-after: avoid; }
  table { font-size: 9pt; } th, td { padding: .2rem .4rem; } tr { break-inside: avoid; }
  .scroll { overflow: visible; } }
"""


def text(value: object) -> Html:
    """A value as HTML, its special characters escaped; nothing for None."""
    return Html("" if value is None else html.escape(str(value)))


def heading(words: str, level: int = 2, anchor: str = "") -> Html:
    """A heading, 1 the page's own; links to ``#anchor`` lead to it."""
    name = f' id="{text(anchor)}"' if anchor else ""
    return Html(f"<h{level}{name}>{text(words)}</h{level}>")


def paragraph(words: str, kind: str = "") -> Html:
    """A paragraph; ``kind`` is empty, ``small`` or ``warning``."""
    return Html(f'<p class="{kind}">{text(words)}</p>' if kind else f"<p>{text(words)}</p>")


def table(headings: Sequence[str], rows: Iterable[Sequence[object]]) -> Html:
    """A table; columns whose values are all numbers (or formatted with one in front) stand to the right.

    A value that is already ``Html`` from this module has to be given as ``Markup(value)``.
    """
    cells = [tuple(row) for row in rows]
    right = [bool(cells) and all(_is_number(row[i]) for row in cells) for i in range(len(headings))]
    head = "".join(f"<th{_kind(number)}>{text(words)}</th>" for words, number in zip(headings, right))
    body = "".join(
        "<tr>" + "".join(f"<td{_kind(number)}>{_cell(value)}</td>" for value, number in zip(row, right)) + "</tr>"
        for row in cells
    )
    return Html(f'<div class="scroll"><table><thead><tr>{head}</tr></thead><tbody>{body}</tbody></table></div>')


class Markup(str):
    """HTML made by this module, to be put into a table's cell as it is."""


Heading = tuple[str, int, int]
"""Words of a table's heading, and how many columns and rows it spans."""
Group = tuple[Sequence[object], Sequence[Sequence[object]]]
"""Cells that span all rows of a group, and the cells of each of its rows."""


def grouped_table(headings: Iterable[Sequence[Heading]], groups: Iterable[Group], first_number: int) -> Html:
    """A table whose rows belong together in groups, as in table 1 of Pyka 2010; groups stay on one printed page.

    ``first_number``: columns from this one on, the spanning cells counted, hold numbers.
    """
    head = "".join(f"<tr>{cells}</tr>" for cells in _heading_rows(headings, first_number))
    body = "".join(f'<tbody class="group">{_group_rows(*group, first_number)}</tbody>' for group in groups)
    return Html(f'<div class="scroll"><table><thead>{head}</thead>{body}</table></div>')


def link(words: str, anchor: str) -> Markup:
    """Words that lead to a heading with that anchor."""
    return Markup(f'<a href="#{text(anchor)}">{text(words)}</a>')


def chip(colour: str, words: str) -> Markup:
    """Words behind a small square of a colour."""
    return Markup(f'<span class="chip" style="background:{text(colour)}"></span>{text(words)}')


def lines(*cells: object) -> Markup:
    """Words, or markup, one below the other in a cell; words without spaces are broken where they are too long."""
    return Markup(f'<span class="words">{"<br>".join(map(_cell, cells))}</span>')


def legend(entries: Iterable[tuple[str, str]], in_line: bool = False) -> Html:
    """What colours mean: colours and words."""
    items = "".join(f"<li>{chip(colour, words)}</li>" for colour, words in entries)
    return Html(f'<ul class="legend{" inline" if in_line else ""}">{items}</ul>')


def inline_svg(svg: str) -> Html:
    """An SVG picture made by this package that is part of the page, so that its links work. It has no ids."""
    return Html(f"<figure>{svg}</figure>")


def drawing(svg: str, caption: str = "", width_mm: float | None = None) -> Html:
    """An SVG picture. It becomes a picture of its own, so that its ids can't meet those of others in the page."""
    return _figure(svg.encode(), "svg+xml", caption, "" if width_mm is None else f"width:{width_mm:g}mm")


def picture(pixels: np.ndarray, caption: str = "", magnification: float = 1, lossless: bool = False) -> Html:
    """A photograph, (rows, columns) or (rows, columns, 3) uint8, each pixel shown ``magnification`` times as wide."""
    data = encoded(pixels, "PNG" if lossless else "JPEG")
    return photograph(data, pixels.shape[1], caption, magnification, "png" if lossless else "jpeg")


def photograph(data: bytes, columns: int, caption: str = "", magnification: float = 1, media: str = "jpeg") -> Html:
    """A picture file of that many columns, ``jpeg`` or ``png``, each pixel shown ``magnification`` times as wide."""
    width = f"width:{columns * magnification:g}px"
    return _figure(data, media, caption, width, "pixels" if magnification > 1 else "", width)


def row(parts: Iterable[Html]) -> Html:
    """Parts side by side, as many as fit."""
    return Html(f'<div class="row">{"".join(parts)}</div>')


def column(parts: Iterable[Html]) -> Html:
    """Parts one below the other, as one member of a row."""
    return Html(f'<div class="column">{"".join(parts)}</div>')


def together(parts: Iterable[Html]) -> Html:
    """Parts that stay on one printed page where they fit."""
    return Html(f'<div class="together">{"".join(parts)}</div>')


def page(title: str, parts: Iterable[Html], language: str = "en") -> str:
    """The whole page, its title as heading."""
    return "".join(_page_pieces(title, parts, language))


def write_page(path: Path, title: str, parts: Iterable[Html], language: str = "en") -> None:
    """Write a page part by part, so that no more than one part is in memory.

    The file appears, and replaces an older one, when all parts are written; an exception from ``parts`` leaves none.
    Raises SettingsError where no file can be.
    """
    unfinished = path.with_name(path.name + ".part")
    pieces = _page_pieces(title, parts, language)
    try:
        try:
            with unfinished.open("w", encoding="utf-8") as file:
                for piece in pieces:
                    file.write(piece)
            os.replace(unfinished, path)
        finally:
            with suppress(OSError):
                unfinished.unlink()
    except OSError as error:
        raise SettingsError(imagery_messages.FILE_NOT_WRITTEN(path=path, error=error.strerror or error)) from None


def _page_pieces(title: str, parts: Iterable[Html], language: str) -> Iterator[str]:
    yield (
        f'<!DOCTYPE html>\n<html lang="{text(language)}"><head><meta charset="utf-8">'
        f'<meta name="viewport" content="width=device-width, initial-scale=1"><title>{text(title)}</title>'
        f"<style>{_STYLE}</style></head><body>\n{heading(title, 1)}\n"
    )
    for part in parts:
        yield part + "\n"
    yield "</body></html>\n"


def save_page(html_text: str, path: Path) -> None:
    """Write a page. Raises SettingsError where no file can be."""
    try:
        path.write_text(html_text, encoding="utf-8")
    except OSError as error:
        raise SettingsError(imagery_messages.FILE_NOT_WRITTEN(path=path, error=error.strerror or error)) from None


def encoded(pixels: np.ndarray, driver: str) -> bytes:
    """The bytes of a picture file, PNG or JPEG, of (rows, columns) or (rows, columns, 3) uint8."""
    bands = np.moveaxis(np.atleast_3d(pixels), 2, 0)
    path = f"/vsimem/report-{id(pixels)}"
    with gdal_silenced():
        memory = gdal.GetDriverByName("MEM").Create("", bands.shape[2], bands.shape[1], len(bands), gdal.GDT_Byte)
        for i, band in enumerate(bands, 1):
            memory.GetRasterBand(i).WriteArray(np.ascontiguousarray(band))
        options = ["QUALITY=88"] if driver == "JPEG" else []
        copy = gdal.GetDriverByName(driver).CreateCopy(path, memory, options=options)
        copy = None  # noqa: F841 - closing the dataset writes the file
        file = gdal.VSIFOpenL(path, "rb")
        try:
            data = gdal.VSIFReadL(1, gdal.VSIStatL(path).size, file)
        finally:
            gdal.VSIFCloseL(file)
            drop_from_memory(path)
    return bytes(data)


def _figure(data: bytes, media: str, caption: str, style: str, kind: str = "", figure_style: str = "") -> Html:
    source = f"data:image/{media};base64,{base64.b64encode(data).decode()}"
    words = f"<figcaption>{text(caption)}</figcaption>" if caption else ""
    box = f' style="max-{figure_style}"' if figure_style else ""  # the caption no wider than the picture
    return Html(
        f'<figure{box}><img class="{kind}" style="{style}" alt="{text(caption)}" src="{source}">{words}</figure>'
    )


def _heading_rows(headings: Iterable[Sequence[Heading]], first_number: int) -> Iterator[str]:
    """The cells of each row; those above one column of numbers stand to the right as they do."""
    taken: dict[int, int] = {}  # rows that a heading from further up still spans, by column
    for row in headings:
        column, cells = 0, []
        for words, columns, rows in row:
            while taken.get(column, 0):
                taken[column] -= 1
                column += 1
            kind = ' class="group"' if columns > 1 else _kind(column >= first_number)
            spans = f' colspan="{columns}"' * (columns > 1) + f' rowspan="{rows}"' * (rows > 1)
            cells.append(f"<th{kind}{spans}>{text(words)}</th>")
            taken.update(dict.fromkeys(range(column, column + columns), rows - 1))
            column += columns
        for further in [place for place, left in taken.items() if place >= column and left]:
            taken[further] -= 1
        yield "".join(cells)


def _group_rows(leading: Sequence[object], rows: Sequence[Sequence[object]], first_number: int) -> str:
    span = f' rowspan="{len(rows)}"' if len(rows) > 1 else ""
    spanning = "".join(
        f"<td{span}{_kind(place >= first_number)}>{_cell(value)}</td>" for place, value in enumerate(leading)
    )
    made = []
    for row in rows:
        places = range(len(leading), len(leading) + len(row))
        cells = "".join(f"<td{_kind(place >= first_number)}>{_cell(value)}</td>" for place, value in zip(places, row))
        made.append(f"<tr>{spanning}{cells}</tr>")
        spanning = ""
    return "".join(made)


def _cell(value: object) -> str:
    return value if isinstance(value, Markup) else text(value)


def _kind(number: bool) -> str:
    return ' class="number"' if number else ""


def _is_number(value: object) -> bool:
    if value is None or value == "" or isinstance(value, (int, float, np.number)):
        return True
    try:
        float(str(value).split()[0].rstrip("%"))
    except (ValueError, IndexError):
        return False
    return True
