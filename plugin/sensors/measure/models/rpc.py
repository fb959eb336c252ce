"""RPC: from any model in space, to and from files that GDAL reads."""
from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from ....imagery import messages as imagery_messages
from ....imagery.atomic_files import save_text
from ....imagery.errors import SensorModelError
from .. import messages
from ..ground_system import GEOGRAPHIC, GroundSystem
from ..image_description import SensorImage
from .bias import BiasedRpc
from .least_squares import Scaling
from .locating import locate
from .polynomials import Polynomial2D, Polynomial3D
from .rational import Dlt, Rational, fit_rational
from .sensor_model import SensorModel

RPC_GRID = (21, 21, 7)  # columns, rows, heights of the terrain-independent fit: 39 unknowns an axis
MIN_RPC_HEIGHTS_M = 50.0  # half the range of heights at least, so that the quotient is sound around flat terrain

_OFFSETS = ("LINE", "SAMP", "LAT", "LONG", "HEIGHT")
_COEFFICIENTS = ("LINE_NUM", "LINE_DEN", "SAMP_NUM", "SAMP_DEN")
PIXEL_CENTRE = 0.5
"""An RPC counts from the centre of the first pixel, GDAL and we from its corner."""


@dataclass(frozen=True)
class Domain:
    """Where a model is used."""

    columns: tuple[float, float]
    """First and last, px."""
    rows: tuple[float, float]
    heights: tuple[float, float]
    """Lowest and highest, m above the ellipsoid."""
    middle: tuple[float, float]
    """x and y on the ground of a place in it, in the frame of the model's points."""


@dataclass(frozen=True)
class RpcOfModel:
    """An RPC and how closely it follows the model it was made from."""

    rpc: Rational
    rms_px: float
    """Against the model, on places between those it was fitted to; 0 for a model that is an RPC already."""
    max_px: float

    @property
    def exact(self) -> bool:
        """Whether it is the model itself."""
        return self.max_px == 0


def rpc_of(model: SensorModel, wkt: str, domain: Domain) -> RpcOfModel:
    """A model in space as RPC: as it is where it has that form, else by a terrain-independent fit over the domain.

    ``wkt`` is the system of the points that the model was fitted to. Raises SensorModelError for a plane model.
    """
    frame = GEOGRAPHIC if model.GEOGRAPHIC else GroundSystem(wkt)
    if isinstance(model, Polynomial2D):
        raise SensorModelError(messages.PLANE_MODEL_HAS_NO_RPC())
    exact = _as_rational(model) if frame.is_wgs84 else None
    if exact is not None:
        return RpcOfModel(exact.padded(), 0.0, 0.0)
    counts = RPC_GRID
    fitted_to, judged_on = _grid(domain, counts, 0.0), _grid(domain, (counts[0] - 1, counts[1] - 1, counts[2] - 1), 0.5)
    ground = _located(model, frame, wkt, fitted_to, domain)
    fit = fit_rational(ground, fitted_to[:, :2], np.ones(len(ground)), 3)
    misses = fit.model.project(_located(model, frame, wkt, judged_on, domain)) - judged_on[:, :2]
    rational = fit.model
    assert isinstance(rational, Rational)
    distance = np.linalg.norm(misses, axis=1)
    return RpcOfModel(rational, float(np.sqrt(np.mean(distance**2))), float(distance.max()))


def _as_rational(model: SensorModel) -> Rational | None:
    if isinstance(model, Rational):
        return model
    if isinstance(model, Dlt):
        return model.rational()
    if isinstance(model, Polynomial3D):
        ones = np.zeros_like(model.coefficients)
        ones[0] = 1.0
        return Rational(model.order, model.ground, model.image, model.coefficients, ones)
    if isinstance(model, BiasedRpc) and not model.correction[1:].any():
        scaling = Scaling(model.rpc.image.offset + model.correction[0], model.rpc.image.scale)
        return Rational(model.rpc.order, model.rpc.ground, scaling, model.rpc.numerators, model.rpc.denominators)
    return None


def _grid(domain: Domain, counts: tuple[int, int, int], inset: float) -> np.ndarray:
    """(n, 3) column, row, height; with ``inset`` 0.5 the middles of the grid's cells."""
    axes = []
    for (first, last), count in zip((domain.columns, domain.rows, rpc_heights(domain)), counts):
        cells = count if inset else count - 1
        axes.append(first + (np.arange(count) + inset) * (last - first) / cells)
    return np.stack(np.meshgrid(*axes, indexing="ij"), axis=-1).reshape(-1, 3)


def rpc_heights(domain: Domain) -> tuple[float, float]:
    """The heights that an RPC is fitted to: those of the domain, 100 m at least."""
    low, high = domain.heights
    half = max((high - low) / 2, MIN_RPC_HEIGHTS_M)
    return (low + high) / 2 - half, (low + high) / 2 + half


def _located(model: SensorModel, frame: GroundSystem, wkt: str, grid: np.ndarray, domain: Domain) -> np.ndarray:
    """(n, 3) longitude, latitude, height of grid places (n, 3) column, row, height."""
    middle = np.array([[*domain.middle, float(np.mean(domain.heights))]])
    if model.GEOGRAPHIC:
        middle = GroundSystem(wkt).to_geographic(middle)
    metres = frame.metres(float(middle[0, 1]))
    start = np.repeat(middle[:, :2], len(grid), axis=0)
    found = locate(model.project, grid[:, :2], grid[:, 2], start, (1 / metres[0], 1 / metres[1]))
    return frame.to_geographic(np.column_stack([found, grid[:, 2]]))


# --- as GDAL has it --------------------------------------------------------------------------------------------


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


def from_metadata(items: Mapping[str, str], name: str) -> Rational:
    """An RPC from the items of GDAL's metadata domain. Raises SensorModelError where some are missing or no numbers."""
    try:
        value = {part: float(str(items[part]).split()[0]) for part in _number_names()}
        arrays = {part: np.array(str(items[f"{part}_COEFF"]).split(), float) for part in _COEFFICIENTS}
    except (KeyError, ValueError, IndexError):
        raise SensorModelError(messages.RPC_INCOMPLETE(name=name)) from None
    offsets, scales = ([value[f"{part}_{kind}"] for part in ("LONG", "LAT", "HEIGHT")] for kind in ("OFF", "SCALE"))
    image = [value["SAMP_OFF"] + PIXEL_CENTRE, value["LINE_OFF"] + PIXEL_CENTRE]
    numbers = (*value.values(), *(number for array in arrays.values() for number in array))
    lengths = {len(array) for array in arrays.values()}
    all_scales = (*scales, value["SAMP_SCALE"], value["LINE_SCALE"])
    sound = lengths == {20} and np.isfinite(numbers).all() and 0 not in all_scales
    if not sound or arrays["LINE_DEN"][0] == 0 or arrays["SAMP_DEN"][0] == 0:
        raise SensorModelError(messages.RPC_INCOMPLETE(name=name))
    return Rational(
        3,
        Scaling(np.array(offsets), np.array(scales)),
        Scaling(np.array(image), np.array([value["SAMP_SCALE"], value["LINE_SCALE"]])),
        np.column_stack([arrays["SAMP_NUM"], arrays["LINE_NUM"]]),
        np.column_stack([arrays["SAMP_DEN"], arrays["LINE_DEN"]]),
    )


def _number_names() -> Iterable[str]:
    return (f"{name}_{kind}" for name in _OFFSETS for kind in ("OFF", "SCALE"))


# --- files -----------------------------------------------------------------------------------------------------


def write_rpc(rpc: Rational, path: Path) -> None:
    """A text file as GDAL reads it beside ``image.tif`` under the name ``image_RPC.TXT``."""
    lines = []
    for name, value in to_metadata(rpc).items():
        values = value.split()
        if name.endswith("_COEFF"):
            lines += [f"{name}_{number}: {one}" for number, one in enumerate(values, 1)]
        else:
            lines.append(f"{name}: {value}")
    save_text("\n".join(lines) + "\n", path, "ascii")


def read_rpc(path: Path) -> Rational:
    """An RPC from a text file (``_RPC.TXT``), a DIMAP file (``RPC_*.XML``), ``.RPB`` or OSSIM's ``.geom``.

    DIMAP counts pixels from 1, so 1 is taken off its offsets, as GDAL does. Raises SensorModelError.
    """
    try:
        text = path.read_text(encoding="utf-8", errors="replace")
    except OSError:
        raise SensorModelError(imagery_messages.NOT_FOUND(path=path)) from None
    if "<Rational_Function_Model>" in text:
        return from_metadata(_dimap_items(text), path.name)
    if "BEGIN_GROUP" in text:
        return from_metadata(_rpb_items(text), path.name)
    items: dict[str, str] = {}
    for name, value in re.findall(r"^\s*([A-Za-z_]+(?:_?\d+)?)\s*[:=]\s*([-+.\deE]+)", text, re.MULTILINE):
        items[name.upper()] = value
    first = 0 if "LINE_NUM_COEFF_00" in items else 1
    pattern = "{name}_COEFF_{number:02d}" if first == 0 else "{name}_COEFF_{number}"
    for name in _COEFFICIENTS:
        items[f"{name}_COEFF"] = " ".join(
            items.get(pattern.format(name=name, number=number), "") for number in range(first, first + 20)
        )
    return from_metadata(items, path.name)


def _dimap_items(text: str) -> dict[str, str]:
    inverse = text[text.find("<Inverse_Model>") : text.find("</Inverse_Model>")]
    items = dict(re.findall(r"<(\w+)>\s*([-+.\deE]+)\s*<", text[text.find("<RFM_Validity>") :]))
    found = dict(re.findall(r"<(\w+)>\s*([-+.\deE]+)\s*<", inverse))
    for name in _COEFFICIENTS:
        items[f"{name}_COEFF"] = " ".join(found.get(f"{name}_COEFF_{number}", "") for number in range(1, 21))
    for name in ("LINE_OFF", "SAMP_OFF"):
        if name in items:
            items[name] = repr(float(items[name]) - 1)
    return items


def _rpb_items(text: str) -> dict[str, str]:
    names = {"line": "LINE", "samp": "SAMP", "lat": "LAT", "long": "LONG", "height": "HEIGHT"}
    items = {}
    for name, value in re.findall(r"(\w+)\s*=\s*([-+.\deE]+)\s*;", text):
        for ours in names:
            if name in (f"{ours}Offset", f"{ours}Scale"):
                items[f"{names[ours]}_{'OFF' if name.endswith('Offset') else 'SCALE'}"] = value
    for name, values in re.findall(r"(\w+)Coef\s*=\s*\(([^)]*)\)", text):
        ours = re.sub(r"(?=[A-Z])", "_", name).upper()
        items[f"{ours}_COEFF"] = " ".join(values.replace(",", " ").split())
    return items


def own_rpc(image: SensorImage) -> Rational | None:
    """The RPC that goes with an image: GDAL's, or that of OSSIM's ``.geom`` beside it. Raises SensorModelError."""
    if image.rpc:
        return from_metadata(image.rpc, image.ref.name)
    beside = Path(image.ref.path).with_suffix(".geom")
    return read_rpc(beside) if beside.is_file() else None
