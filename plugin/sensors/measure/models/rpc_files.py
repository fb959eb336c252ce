"""An RPC as GDAL's metadata have it, and in the files of image vendors."""
from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path
from xml.etree.ElementTree import ParseError

import numpy as np

from ....imagery import messages as imagery_messages
from ....imagery.atomic_files import save_text
from ....imagery.documents.document_files import document_bytes
from ....imagery.documents.xml_documents import looks_like_xml, xml_root
from ....imagery.errors import SensorModelError
from ....imagery.message import Message
from ....imagery.open_raster import OpenRaster
from ....imagery.rasters import Raster
from .. import messages
from ..sensor_images import rpc_metadata
from .least_squares import Scaling
from .rational import Rational

_OFFSETS = ("LINE", "SAMP", "LAT", "LONG", "HEIGHT")
_COEFFICIENTS = ("LINE_NUM", "LINE_DEN", "SAMP_NUM", "SAMP_DEN")
_RPB_NAMES = {"line": "LINE", "samp": "SAMP", "lat": "LAT", "long": "LONG", "height": "HEIGHT"}
RPC_DOMAIN = 1.1  # how far beyond its own range, relative to it, an RPC is still taken at its word
PIXEL_CENTRE = 0.5
"""An RPC counts from the centre of the first pixel, GDAL and we from its corner."""
DIMAP_FIRST_PIXEL = 1
"""DIMAP numbers the first pixel 1, all others 0."""


def to_metadata(rpc: Rational) -> dict[str, str]:
    """The items of GDAL's metadata domain ``RPC``."""
    full = rpc.padded()
    column, row = full.image.offset - PIXEL_CENTRE
    longitude, latitude, height = full.ground.offset
    scales = dict(zip(("LONG", "LAT", "HEIGHT"), full.ground.scale))
    scales.update(zip(("SAMP", "LINE"), full.image.scale))
    offsets = {"LINE": row, "SAMP": column, "LAT": latitude, "LONG": longitude, "HEIGHT": height}
    items = {f"{name}_OFF": repr(float(offsets[name])) for name in _OFFSETS}
    items.update({f"{name}_SCALE": repr(float(scales[name])) for name in _OFFSETS})
    arrays = (full.numerators[:, 1], full.denominators[:, 1], full.numerators[:, 0], full.denominators[:, 0])
    for name, values in zip(_COEFFICIENTS, arrays):
        items[f"{name}_COEFF"] = " ".join(repr(float(value)) for value in values)
    return items


def from_metadata(items: Mapping[str, str], name: str, first_pixel: int = 0) -> Rational:
    """An RPC from the items of GDAL's metadata domain. Raises SensorModelError where some are missing or no numbers."""
    numbers = [f"{name}_{kind}" for name in _OFFSETS for kind in ("OFF", "SCALE")]
    try:
        value = {part: float(str(items[part]).split()[0]) for part in numbers}
        arrays = {part: np.array(str(items[f"{part}_COEFF"]).split(), float) for part in _COEFFICIENTS}
    except (KeyError, ValueError, IndexError):
        raise SensorModelError(messages.RPC_INCOMPLETE(name=name)) from None
    offsets, scales = ([value[f"{part}_{kind}"] for part in ("LONG", "LAT", "HEIGHT")] for kind in ("OFF", "SCALE"))
    image = [value[name] - first_pixel + PIXEL_CENTRE for name in ("SAMP_OFF", "LINE_OFF")]
    finite = np.isfinite(np.concatenate([list(value.values()), *arrays.values()])).all()
    full = all(len(array) == 20 for array in arrays.values())
    sound = full and finite and 0 not in (*scales, value["SAMP_SCALE"], value["LINE_SCALE"])
    if not sound or arrays["LINE_DEN"][0] == 0 or arrays["SAMP_DEN"][0] == 0:
        raise SensorModelError(messages.RPC_INCOMPLETE(name=name))
    return Rational(
        3,
        Scaling(np.array(offsets), np.array(scales)),
        Scaling(np.array(image), np.array([value["SAMP_SCALE"], value["LINE_SCALE"]])),
        np.column_stack([arrays["SAMP_NUM"], arrays["LINE_NUM"]]),
        np.column_stack([arrays["SAMP_DEN"], arrays["LINE_DEN"]]),
    )


def write_rpc(rpc: Rational, path: Path) -> None:
    """A file as GDAL reads it beside ``image.tif``: ``image.RPB`` where the name ends so, else ``image_RPC.TXT``."""
    lines = []
    if path.suffix.lower() == ".rpb":
        save_text(_rpb_text(to_metadata(rpc)), path, "ascii")
        return
    for name, value in to_metadata(rpc).items():
        if name.endswith("_COEFF"):
            lines += [f"{name}_{number}: {one}" for number, one in enumerate(value.split(), 1)]
        else:
            lines.append(f"{name}: {value}")
    save_text("\n".join(lines) + "\n", path, "ascii")


def read_rpc(path: Path) -> Rational:
    """An RPC from a text file (``_RPC.TXT``), a DIMAP file (``RPC_*.XML``), ``.RPB`` or OSSIM's ``.geom``.

    Raises SensorModelError.
    """
    try:
        content = document_bytes(path)
    except OSError:
        raise SensorModelError(imagery_messages.NOT_FOUND(path=path)) from None
    if looks_like_xml(content):
        return from_metadata(_dimap_items(content, path.name), path.name, DIMAP_FIRST_PIXEL)
    text = content.decode(errors="replace")
    if "BEGIN_GROUP" in text:
        return from_metadata(_rpb_items(text), path.name)
    items: dict[str, str] = {}
    for name, value in re.findall(r"^[ \t]*([A-Za-z_]+(?:_?\d+)?)[ \t]*[:=]\s*([-+.\deE]+)", text, re.MULTILINE):
        items[name.upper()] = value
    first, pattern = (0, "{}_COEFF_{:02d}") if "LINE_NUM_COEFF_00" in items else (1, "{}_COEFF_{}")
    return from_metadata({**items, **_coefficients(items, pattern, first)}, path.name)


def _coefficients(items: Mapping[str, str], pattern: str, first: int) -> dict[str, str]:
    """The lists of coefficients as GDAL has them, from items that hold one each."""
    numbers = range(first, first + 20)
    return {
        f"{name}_COEFF": " ".join(items.get(pattern.format(name, number), "") for number in numbers)
        for name in _COEFFICIENTS
    }


def _dimap_items(content: bytes, name: str) -> dict[str, str]:
    """As GDAL has them, of the model from the ground to the image."""
    try:
        root = xml_root(content)
    except ParseError:
        raise SensorModelError(messages.RPC_INCOMPLETE(name=name)) from None
    model, validity = (
        {element.tag: (element.text or "").strip() for element in root.iterfind(f".//{part}//*")}
        for part in ("Inverse_Model", "RFM_Validity")
    )
    return {**validity, **_coefficients(model, "{}_COEFF_{}", 1)}


def _rpb_text(items: Mapping[str, str]) -> str:
    """The RPB of GDAL's items; the errors of the RPC are not known and stand as 0, as GDAL writes them."""
    lines = ['satId = "";', 'bandId = "";', 'SpecId = "RPC00B";', "BEGIN_GROUP = IMAGE"]
    lines += ["\terrBias = 0.0;", "\terrRand = 0.0;"]
    for kind, ending in (("OFF", "Offset"), ("SCALE", "Scale")):
        lines += [f"\t{ours}{ending} = {items[f'{name}_{kind}']};" for ours, name in _RPB_NAMES.items()]
    for name in _COEFFICIENTS:
        axis, part = name.lower().split("_")
        values = ",\n".join(f"\t\t\t{value}" for value in items[f"{name}_COEFF"].split())
        lines.append(f"\t{axis}{part.capitalize()}Coef = (\n{values});")
    return "\n".join([*lines, "END_GROUP = IMAGE", "END;", ""])


def _rpb_items(text: str) -> dict[str, str]:
    items = {}
    for name, value in re.findall(r"\b(\w+)\s*=\s*([-+.\deE]+)\s*;", text):
        for ours in _RPB_NAMES:
            if name in (f"{ours}Offset", f"{ours}Scale"):
                items[f"{_RPB_NAMES[ours]}_{'OFF' if name.endswith('Offset') else 'SCALE'}"] = value
    for name, values in re.findall(r"\b(\w+)Coef\s*=\s*\(([^)]*)\)", text):
        ours = re.sub(r"(?=[A-Z])", "_", name).upper()
        items[f"{ours}_COEFF"] = " ".join(values.replace(",", " ").split())
    return items


def own_rpc(image: OpenRaster) -> Rational | None:
    """The RPC that goes with an image: GDAL's, or that of OSSIM's ``.geom`` beside it. Raises SensorModelError."""
    metadata = rpc_metadata(image)
    if metadata:
        return from_metadata(metadata, image.ref.name)
    beside = Path(image.ref.path).with_suffix(".geom")
    return read_rpc(beside) if beside.is_file() else None


def rpc_of_image_part(rpc: Rational, image: Raster) -> tuple[Rational, Message | None]:
    """The RPC of a whole scene for an image that is a part of it, and what to say about that.

    A part keeps its place in a geotransform of whole pixels without a reference system (origin = first column and
    row). It is believed when the RPC's own range holds the part there, so that an RPC of the part itself stays as
    it is.
    """
    if image.geotransform is None or image.own_wkt:
        return rpc, None
    left, across, skew_x, top, skew_y, down = image.geotransform
    if (across, skew_x, skew_y) != (1.0, 0.0, 0.0) or abs(down) != 1.0 or (left, top) == (0.0, 0.0):
        return rpc, None
    first = np.array([left, abs(top)])
    corners = np.array([first, first + [image.columns, image.rows]])
    if np.abs(rpc.image.to(corners)).max() > RPC_DOMAIN:
        return rpc, None
    moved = replace(rpc, image=Scaling(rpc.image.offset - first, rpc.image.scale))
    return moved, messages.RPC_OF_WHOLE_SCENE(column=first[0], row=first[1])
