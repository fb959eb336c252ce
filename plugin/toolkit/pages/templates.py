"""Reports from templates: plain data in, one HTML page out.

The templates lie in ``resources/reports``. Whatever they are given is escaped, so that no name becomes markup.
"""
from __future__ import annotations

import base64
import os
import re
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from datetime import date
from functools import cache
from pathlib import Path
from typing import NamedTuple

import numpy as np
from jinja2 import Environment, FileSystemLoader, StrictUndefined
from markupsafe import Markup, escape
from qgis.core import Qgis

from ...imagery.atomic_files import whole_file
from ...imagery.documents import plugin_version
from ...imagery.errors import Message, printable
from ...imagery.rasters import Raster, RasterRef
from ...imagery.reference_systems import is_geographic
from ..reference_systems import reference_system
from ..resources import RESOURCES, plugin_commit
from ..translation import filled, formatted, language, sentence, shown_number, tr

_SHORT_COMMIT = 12  # digits
MOST_RASTERS = 40  # listed one by one: a page of them


class MeasuredRaster(NamedTuple):
    """A row of a report's table of rasters."""

    role: str  # what it is to the measurement: mosaic, orthoimage, image
    path: str
    size: str = ""  # columns and rows; empty where it was not opened
    pixel: str = ""
    pixels: str = ""  # how many bands of which type
    system: str = ""  # reference system, by its code where it has one


@dataclass(frozen=True)
class HowMeasured:
    """The settings and rasters that the figures of a report come from."""

    settings: Sequence[tuple[str, str]] = ()  # names and values: wavelet, limits, files
    rasters: Sequence[MeasuredRaster] = ()  # the rasters that were measured, in an order that their reader knows
    made_on: date | None = None  # the day of the measurement; None for today

    @property
    def day(self) -> str:
        """Day as the world writes it, so that no month is taken for a day."""
        return (self.made_on or date.today()).isoformat()

    @property
    def software(self) -> str:
        """Names and versions of the programs, ours to the commit where that is known."""
        commit = plugin_commit()[:_SHORT_COMMIT]
        version = f"{plugin_version()} ({commit})" if commit else plugin_version()
        return f"Seam Inspector {version}, QGIS {Qgis.version()}"

    @property
    def listed(self) -> Sequence[MeasuredRaster]:
        return self.rasters[:MOST_RASTERS]

    @property
    def left_out(self) -> int:
        return len(self.rasters) - len(self.listed)


def measured_raster(role: str, raster: Raster | RasterRef) -> MeasuredRaster:
    """Facts of one raster; of one that was not opened its path alone is known."""
    if isinstance(raster, RasterRef):
        return MeasuredRaster(role, whole_path(raster.path))
    side, system = "", ""
    if raster.has_place:
        size, system = raster.ground_sample_distance, system_name(raster.wkt)
        side = f"{shown_number(size, 4).rstrip('0').rstrip('.,')} m"
        if is_geographic(raster.wkt):
            side = filled(tr("about {size:.3g} m"), size=size)
    pixels = f"{len(raster.band_names)} x {raster.data_type}"
    return MeasuredRaster(
        role, whole_path(raster.ref.path), f"{raster.columns} x {raster.rows} px", side, pixels, system)


def each_raster(role: str, rasters: Iterable[Raster | RasterRef]) -> list[MeasuredRaster]:
    """Facts of several rasters, each path once."""
    return list({facts.path: facts for facts in (measured_raster(role, raster) for raster in rasters)}.values())


def whole_path(address: str) -> str:
    """The address of a file or a layer in it, from whatever folder it is read; other addresses as they are."""
    path, bar, layer = address.partition("|")
    return f"{os.path.abspath(path)}{bar}{layer}" if path and os.path.exists(path) else address


def system_name(wkt: str) -> str:
    """The name of a reference system and its code; empty for none."""
    crs = reference_system(wkt)
    if not crs.isValid():
        return ""
    return f"{crs.authid()}, {crs.description()}" if crs.authid() else crs.description()


_NUMBER = re.compile(r"[-+]?\d[\d.,]*%?(\s|$)")  # in whatever language its decimals are, and what may follow it
_LONGEST_FOOT = 110  # letters of a title at the foot of a printed page


def save_page(path: Path, template: str, how: HowMeasured, **view: object) -> None:
    """Write what a template makes of a view and of how it was measured.

    It is written piece by piece: what an iterator in the view gives is never all in memory.

    An exception from such an iterator leaves no page, or the older one. Raises SettingsError where no file can be.
    """
    pieces = environment().get_template(f"{template}.html.j2").generate(view, how=how)
    with whole_file(path) as unfinished, unfinished.open("w", encoding="utf-8") as file:
        file.writelines(pieces)


def sentences_once(notices: Iterable[Message]) -> list[str]:
    """Messages in the user's language, each once."""
    return list(dict.fromkeys(map(sentence, notices)))


@cache
def environment() -> Environment:
    """The environment of the templates: their folder, and the functions and filters that they all have."""
    made = Environment(
        loader=FileSystemLoader(RESOURCES / "reports"), autoescape=True, undefined=StrictUndefined,
        trim_blocks=True, lstrip_blocks=True, finalize=_shown,
    )
    made.globals.update(tr=tr, filled=filled, language=language)
    made.filters.update(
        data_address=_data_address, css_text=_css_text, filled_columns=_filled_columns,
        number_columns=_number_columns, with_breaks=_with_breaks, number=formatted,
    )
    return made


def _shown(value: object) -> object:
    """Whatever a template puts into a page; what is markup already was made of such values."""
    return printable(value) if type(value) is str else value


def _data_address(data: bytes | str, media: str) -> str:
    """A picture file as the address of a picture."""
    content = data.encode() if isinstance(data, str) else data
    return f"data:image/{media};base64,{base64.b64encode(content).decode()}"


def _with_breaks(value: object) -> Markup:
    """Words that a line may break behind a folder, before it would be within a name."""
    return Markup(re.sub(r"(?<=[/\\])(?=[^/\\])", "<wbr>", str(escape(printable(str(value))))))


def _css_text(words: str) -> str:
    """Words as a string of CSS, in which nothing but letters and digits means what it says."""
    short = words if len(words) <= _LONGEST_FOOT else words[: _LONGEST_FOOT - 1] + "…"
    return re.sub(r"[^A-Za-z0-9 ]", lambda letter: f"\\{ord(letter.group()):x} ", short)


def _filled_columns(
    headings: Sequence[str], rows: Iterable[Sequence[object]]
) -> tuple[list[str], list[list[object]]]:
    """Headings and rows of a table without the columns that say nothing in any row."""
    known = [list(row) for row in rows]
    kept = [place for place in range(len(headings)) if not known or any(row[place] not in (None, "") for row in known)]
    return [headings[place] for place in kept], [[row[place] for place in kept] for row in known]


def _number_columns(headings: Sequence[str], rows: Sequence[Sequence[object]]) -> list[bool]:
    """Whether all of a column's values are numbers or empty."""
    return [bool(rows) and all(_is_number(row[place]) for row in rows) for place in range(len(headings))]


def _is_number(value: object) -> bool:
    """Whether it is a number, words that begin with one, or nothing."""
    if value in (None, "", "\u2013") or isinstance(value, (int, float, np.number)):
        return True
    return _NUMBER.match(str(value)) is not None
