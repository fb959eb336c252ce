"""Reports: one HTML page that opens anywhere, without network, and prints well on A4.

The parts are strings of HTML. Whatever comes from a user or a file name goes through ``text``, so that it can
never become markup; every function here does so with its words.
"""
from __future__ import annotations

import base64
import html
from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import NewType

import numpy as np
from osgeo import gdal

from . import messages
from .errors import SettingsError
from .quiet import quiet

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
th { border-bottom: 2px solid #1b1f23; } td.number, th.number { text-align: right; white-space: nowrap; }
.row { display: flex; flex-wrap: wrap; gap: 1rem; align-items: flex-start; }
figure { margin: .5rem 0; } figure img { max-width: 100%; height: auto; display: block; }
figure img.pixels { image-rendering: pixelated; }
figcaption { color: #57606a; font-size: .88em; max-width: 40rem; }
.together { break-inside: avoid; }
@page { size: A4; margin: 15mm; }
@media print { body { max-width: none; margin: 0; padding: 0; font-size: 10pt; } h2, h3 { break-after: avoid; }
  tr { break-inside: avoid; } .scroll { overflow: visible; } }
"""


def text(value: object) -> Html:
    """A value as HTML, its special characters escaped; nothing for None."""
    return Html("" if value is None else html.escape(str(value)))


def heading(words: str, level: int = 2) -> Html:
    """A heading, 1 the page's own."""
    return Html(f"<h{level}>{text(words)}</h{level}>")


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


def drawing(svg: str, caption: str = "", width_mm: float | None = None) -> Html:
    """An SVG picture. It becomes a picture of its own, so that its ids can't meet those of others in the page."""
    return _figure(svg.encode(), "svg+xml", caption, "" if width_mm is None else f"width:{width_mm:g}mm")


def picture(pixels: np.ndarray, caption: str = "", magnification: float = 1, lossless: bool = False) -> Html:
    """A photograph, (rows, columns) or (rows, columns, 3) uint8, each pixel shown ``magnification`` times as wide."""
    data = encoded(pixels, "PNG" if lossless else "JPEG")
    width = f"width:{pixels.shape[1] * magnification:g}px"
    return _figure(data, "png" if lossless else "jpeg", caption, width, "pixels" if magnification > 1 else "")


def row(parts: Iterable[Html]) -> Html:
    """Parts side by side, as many as fit."""
    return Html(f'<div class="row">{"".join(parts)}</div>')


def together(parts: Iterable[Html]) -> Html:
    """Parts that stay on one printed page where they fit."""
    return Html(f'<div class="together">{"".join(parts)}</div>')


def page(title: str, parts: Iterable[Html], language: str = "en") -> str:
    """The whole page, its title as heading."""
    return (
        f'<!DOCTYPE html>\n<html lang="{text(language)}"><head><meta charset="utf-8">'
        f'<meta name="viewport" content="width=device-width, initial-scale=1"><title>{text(title)}</title>'
        f"<style>{_STYLE}</style></head><body>\n{heading(title, 1)}\n" + "\n".join(parts) + "\n</body></html>\n"
    )


def save_page(html_text: str, path: Path) -> None:
    """Write a page. Raises SettingsError where no file can be."""
    try:
        path.write_text(html_text, encoding="utf-8")
    except OSError as error:
        raise SettingsError(messages.FILE_NOT_WRITTEN(path=path, error=error.strerror or error)) from None


def encoded(pixels: np.ndarray, driver: str) -> bytes:
    """The bytes of a picture file, PNG or JPEG, of (rows, columns) or (rows, columns, 3) uint8."""
    bands = np.moveaxis(np.atleast_3d(pixels), 2, 0)
    path = f"/vsimem/report-{id(pixels)}"
    with quiet():
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
            gdal.Unlink(path)
            gdal.Unlink(path + ".aux.xml")
    return bytes(data)


def _figure(data: bytes, media: str, caption: str, style: str, kind: str = "") -> Html:
    source = f"data:image/{media};base64,{base64.b64encode(data).decode()}"
    words = f"<figcaption>{text(caption)}</figcaption>" if caption else ""
    return Html(f'<figure><img class="{kind}" style="{style}" alt="{text(caption)}" src="{source}">{words}</figure>')


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
