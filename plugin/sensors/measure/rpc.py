"""RPCs: of any model in space, of images and of vendors' files, corrected by control points, and written."""
from __future__ import annotations

import re
import uuid
from collections.abc import Mapping
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any, Callable, ClassVar
from xml.etree.ElementTree import ParseError

import numpy as np
from osgeo import gdal

from ...imagery import messages as imagery_messages
from ...imagery.atomic_files import save_text
from ...imagery.documents import looks_like_xml, xml_root
from ...imagery.errors import CancelledError, Message, SensorModelError, SettingsError
from ...imagery.gdal_calls import drop_from_memory, gdal_silenced, gdal_writing, taken_from_memory
from ...imagery.open_raster import OpenRaster
from ...imagery.raster_writer import whole_raster
from ...imagery.rasters import Raster, RasterRef
from ...imagery.reference_systems import metres_per_unit, same_system, transform_points
from . import messages
from .polynomials import EXPONENTS_3D, Rational, fit_rational
from .sensor_model import WGS84, FittedModel, Scaling, SensorModel, file_content, least_squares

RPC_GRID = (21, 21, 7)  # columns, rows, heights of the terrain-independent fit: 39 unknowns an axis
MIN_RPC_HEIGHTS_M = 50.0  # half the range of heights at least, so that the quotient is sound around flat terrain
_TRIALS: dict[str, tuple[tuple[tuple[int, ...], tuple[int, ...]], ...]] = {
    "shift": (((0,), (0,)),), "shift_drift": (((0, 2), (0,)), ((0,), (0, 2))), "affine": (((0, 1, 2), (0, 1, 2)),),
}  # fmt: skip
"""The terms (constant, column, row) of the corrections of column and row; of several trials the best fit is taken."""
_OFFSETS = ("LINE", "SAMP", "LAT", "LONG", "HEIGHT")
_COEFFICIENTS = ("LINE_NUM", "LINE_DEN", "SAMP_NUM", "SAMP_DEN")
RPC_DOMAIN = 1.1  # how far beyond its own range, relative to it, an RPC is still taken at its word
PIXEL_CENTRE = 0.5  # an RPC counts from the centre of the first pixel, GDAL and we from its corner
DIMAP_FIRST_PIXEL = 1  # all others number it 0
_COMPRESSED = ("COMPRESS=DEFLATE", "BIGTIFF=IF_SAFER", "NUM_THREADS=ALL_CPUS")
CREATION = {"GTiff": [*_COMPRESSED, "TILED=YES"], "COG": [*_COMPRESSED]}


def open_image(ref: RasterRef) -> OpenRaster:
    """An image as a sensor took it, which may have no place on the map yet; radar's complex values are welcome."""
    return OpenRaster(ref, complex_values=True)


@dataclass(frozen=True)
class Domain:
    """The part of image and ground that a model is used in."""

    columns: tuple[float, float]  # first and last, px
    rows: tuple[float, float]  # first and last, px
    heights: tuple[float, float]  # lowest and highest, m above the ellipsoid
    middle: tuple[float, float]  # x and y on the ground of a place in it, in the frame of the model's points

    @property
    def middle_and_corners(self) -> np.ndarray:
        (left, right), (top, bottom) = self.columns, self.rows
        middle = ((left + right) / 2, (top + bottom) / 2)
        return np.array([middle, (left, top), (right, top), (left, bottom), (right, bottom)])


@dataclass(frozen=True)
class RpcOfModel:
    """An RPC and how closely it follows the model it was made from."""

    rpc: Rational
    rms_px: float  # against the model, on places between those it was fitted to; 0 for a model that is an RPC already
    max_px: float  # 0 likewise


def rpc_of(model: SensorModel, wkt: str, domain: Domain) -> RpcOfModel:
    """A model in space: itself where it has that form, else a terrain-independent fit. Raises SensorModelError."""
    if not model.SPATIAL:
        raise SensorModelError(messages.PLANE_MODEL_HAS_NO_RPC())
    exact = model.as_rational() if same_system(model.ground_system(wkt), WGS84) else None
    if exact is not None:
        assert isinstance(exact, Rational)
        return RpcOfModel(exact.padded(), 0.0, 0.0)
    columns, rows, heights = RPC_GRID
    fitted_to, judged_on = _grid(domain, RPC_GRID, 0.0), _grid(domain, (columns - 1, rows - 1, heights - 1), 0.5)
    ground = located(model, wkt, fitted_to, domain)
    rational = fit_rational(ground, fitted_to[:, :2], np.ones(len(ground)), 3).model
    assert isinstance(rational, Rational)
    misses = rational.project(located(model, wkt, judged_on, domain)) - judged_on[:, :2]
    distance = np.linalg.norm(misses, axis=1)
    return RpcOfModel(rational, float(np.sqrt(np.mean(distance**2))), float(distance.max()))


def _grid(domain: Domain, counts: tuple[int, int, int], inset: float) -> np.ndarray:
    """(n, 3) column, row, height; with ``inset`` 0.5 the middles of the grid's cells."""
    axes = [
        first + (np.arange(count) + inset) * (last - first) / (count if inset else count - 1)
        for (first, last), count in zip((domain.columns, domain.rows, rpc_heights(domain)), counts)
    ]
    return np.stack(np.meshgrid(*axes, indexing="ij"), axis=-1).reshape(-1, 3)


def rpc_heights(domain: Domain) -> tuple[float, float]:
    """The heights that an RPC is fitted to: those of the domain, 100 m at least."""
    low, high = domain.heights
    half = max((high - low) / 2, MIN_RPC_HEIGHTS_M)
    return (low + high) / 2 - half, (low + high) / 2 + half


def located(model: SensorModel, wkt: str, grid: np.ndarray, domain: Domain) -> np.ndarray:
    """(n, 3) longitude, latitude, height of (n, 3) column, row, height. Raises SensorModelError if not invertible."""
    system = model.ground_system(wkt)
    middle = transform_points(np.array([domain.middle]), wkt, system)
    places = model.places(grid[:, :2], grid[:, 2], middle, metres_per_unit(system, middle[0]))
    return np.column_stack([transform_points(places, system, WGS84), grid[:, 2]])


@dataclass(frozen=True)
class BiasedRpc(SensorModel):
    """An RPC plus a correction in the image, linear in its column and row (Grodecki and Dial 2003)."""

    GEOGRAPHIC: ClassVar[bool] = True

    rpc: Rational
    correction: np.ndarray  # (3, 2) px: constant, per scaled column, per scaled row; of column and row

    def project(self, ground: np.ndarray) -> np.ndarray:
        seen = self.rpc.project(ground)
        return seen + self.bias(seen)

    def bias(self, image: np.ndarray) -> np.ndarray:
        """(n, 2) px: how far off the RPC is at the places (n, 2) where it sees points; what is measured minus that."""
        return _linear(self.rpc.image, image) @ self.correction

    def as_rational(self) -> Rational | None:
        if self.correction[1:].any():
            return None
        scaling = Scaling(self.rpc.image.offset + self.correction[0], self.rpc.image.scale)
        return replace(self.rpc, image=scaling)


def fit_bias(
    ground: np.ndarray, image: np.ndarray, weights: np.ndarray, form: str, rpc: Rational | None
) -> FittedModel:
    """Fit the correction of an RPC in the image, of a ``form`` of ``_TRIALS``: ``shift_drift`` lets the column or the
    row grow with the line. Raises SettingsError without an RPC."""
    if rpc is None:
        raise SettingsError(messages.NO_RPC())
    seen = rpc.project(ground)
    linear = _linear(rpc.image, seen)
    missing = image - seen
    fits = []
    for used in _TRIALS[form]:
        correction, condition = np.zeros((3, 2)), 1.0
        for axis in (0, 1):
            weighted = linear[:, used[axis]] * weights[:, None], missing[:, axis] * weights
            correction[list(used[axis]), axis], last_condition = least_squares(*weighted)
            condition = max(condition, last_condition)
        misfit = float(np.sum(((missing - linear @ correction) * weights[:, None]) ** 2))
        fits.append((misfit, FittedModel(BiasedRpc(rpc, correction), condition, 1, True, sum(map(len, used)))))
    return min(fits, key=lambda fit: fit[0])[1]


def _linear(scaling: Scaling, image: np.ndarray) -> np.ndarray:
    return np.column_stack([np.ones(len(image)), scaling.to(image)])


def to_metadata(rpc: Rational) -> dict[str, str]:
    """The items of GDAL's metadata domain ``RPC``."""
    full, order = rpc.padded(), [1, 0, 2]
    offsets = [*(full.image.offset - PIXEL_CENTRE)[::-1], *full.ground.offset[order]]
    scales = [*full.image.scale[::-1], *full.ground.scale[order]]
    items = {f"{name}_OFF": repr(float(value)) for name, value in zip(_OFFSETS, offsets)}
    items.update({f"{name}_SCALE": repr(float(value)) for name, value in zip(_OFFSETS, scales)})
    arrays = (full.numerators[:, 1], full.denominators[:, 1], full.numerators[:, 0], full.denominators[:, 0])
    for name, values in zip(_COEFFICIENTS, arrays):
        items[f"{name}_COEFF"] = " ".join(repr(float(value)) for value in values)
    return items


def from_metadata(items: Mapping[str, str], name: str, first_pixel: int = 0) -> Rational:
    """An RPC from the items of GDAL's metadata domain. Raises SensorModelError where some are missing or no numbers."""
    try:
        offsets, scales = (
            np.array([float(str(items[f"{part}_{kind}"]).split()[0]) for part in _OFFSETS]) for kind in ("OFF", "SCALE")
        )
        arrays = {part: np.array(str(items[f"{part}_COEFF"]).split(), float) for part in _COEFFICIENTS}
        finite = np.isfinite(np.concatenate([offsets, scales, *arrays.values()])).all()
        whole = all(len(array) == len(EXPONENTS_3D) for array in arrays.values())
        if not (finite and whole and scales.all() and arrays["LINE_DEN"][0] and arrays["SAMP_DEN"][0]):
            raise ValueError
    except (KeyError, ValueError, IndexError):
        raise SensorModelError(messages.RPC_INCOMPLETE(name=name)) from None
    image, ground = [1, 0], [3, 2, 4]  # of those five
    scaling = Scaling(offsets[image] - first_pixel + PIXEL_CENTRE, scales[image])
    above, below = (np.column_stack([arrays[f"SAMP_{part}"], arrays[f"LINE_{part}"]]) for part in ("NUM", "DEN"))
    return Rational(3, Scaling(offsets[ground], scales[ground]), scaling, above, below)


def write_rpc(rpc: Rational, path: Path) -> None:
    """A file as GDAL has it beside ``image.tif``: ``image.RPB`` where the name ends so, else ``image_RPC.TXT``."""
    option, ending = ("RPB=YES", ".RPB") if path.suffix.lower() == ".rpb" else ("RPCTXT=YES", "_RPC.TXT")
    image = f"/vsimem/rpc-{uuid.uuid4().hex}"
    with gdal_silenced():
        bare = gdal.GetDriverByName("MEM").Create("", 1, 1)
        bare.SetMetadata(to_metadata(rpc), "RPC")
        gdal.GetDriverByName("GTiff").CreateCopy(f"{image}.tif", bare, options=["PROFILE=BASELINE", option])
    drop_from_memory(f"{image}.tif")
    text = taken_from_memory(image + ending).decode()
    save_text(text.replace('"QB02"', '""').replace('"P"', '""'), path, "ascii")  # not every satellite is GDAL's


def read_rpc(path: Path) -> Rational:
    """An RPC from _RPC.TXT, DIMAP, .RPB or OSSIM's .geom. Raises SensorModelError."""
    content, first_pixel, first, pattern = file_content(path), 0, 1, "{}_COEFF_{}"
    text = content.decode(errors="replace")
    if looks_like_xml(content):  # DIMAP's has two models; that from the ground to the image is taken
        try:
            root = xml_root(content)
        except ParseError:
            raise SensorModelError(messages.RPC_INCOMPLETE(name=path.name)) from None
        elements = (element for part in ("Inverse_Model", "RFM_Validity") for element in root.iterfind(f".//{part}//*"))
        items, first_pixel = {element.tag: (element.text or "").strip() for element in elements}, DIMAP_FIRST_PIXEL
    elif "BEGIN_GROUP" in text:  # of .RPB: lineOffset = 1.0; and lineNumCoef = (1.0, ...);
        values = re.findall(r"\b([a-z]+)(Off|Scale)(?:set)?\s*=\s*([-+.\deE]+)\s*;", text)
        lists = re.findall(r"\b([a-z]+)([A-Z]\w*)Coef\s*=\s*\(([^)]*)\)", text)
        items = {f"{name}_{kind}".upper(): value for name, kind, value in values}
        items.update({f"{name}_{part}_COEFF".upper(): terms.replace(",", " ") for name, part, terms in lists})
    else:
        lines = re.findall(r"^[ \t]*([A-Za-z_]+(?:_?\d+)?)[ \t]*[:=]\s*([-+.\deE]+)", text, re.MULTILINE)
        items = {name.upper(): value for name, value in lines}
        if "LINE_NUM_COEFF_00" in items:
            first, pattern = 0, "{}_COEFF_{:02d}"
    for name in _COEFFICIENTS:
        terms = (items.get(pattern.format(name, number), "") for number in range(first, first + len(EXPONENTS_3D)))
        items.setdefault(f"{name}_COEFF", " ".join(terms))
    return from_metadata(items, path.name, first_pixel)


def own_rpc(image: OpenRaster) -> Rational | None:
    """The RPC that goes with an image: GDAL's, or that of OSSIM's ``.geom`` beside it. Raises SensorModelError."""
    if metadata := image.dataset.GetMetadata("RPC"):
        return from_metadata(metadata, image.ref.name)
    beside = Path(image.ref.path).with_suffix(".geom")
    return read_rpc(beside) if beside.is_file() else None


def rpc_of_image_part(rpc: Rational, image: Raster) -> tuple[Rational, Message | None]:
    """The RPC of a whole scene for an image that is a part of it, by a geotransform of whole pixels without a reference
    system, as long as the RPC's own range holds the part there; and what to say about that."""
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


def image_with_rpc(image: OpenRaster, rpc: Rational) -> gdal.Dataset:
    """The image, virtually, with the RPC and nothing else that could place it."""
    with gdal_silenced():
        source = gdal.Translate("", image.dataset, format="VRT", noData=None)
        source.SetGeoTransform((0.0, 1.0, 0.0, 0.0, 0.0, 1.0))
        source.SetProjection("")
        source.SetGCPs([], "")
        source.SetMetadata(to_metadata(rpc), "RPC")
    return source


def write_image_with_rpc(image: OpenRaster, rpc: Rational, path: Path, cancelled: Callable[[], bool]) -> None:
    """A GeoTIFF of the image with the RPC in its tags, whole or not at all. Raises RasterError, CancelledError."""
    source = image_with_rpc(image, rpc)

    def report(share: float, message: str, data: Any) -> int:
        return 0 if cancelled() else 1

    with whole_raster(str(path)) as unfinished:
        with gdal_writing(imagery_messages.RASTER_NOT_WRITTEN(path=path)):
            gdal.GetDriverByName("GTiff").CreateCopy(unfinished, source, False, CREATION["GTiff"], report)
        if cancelled():
            raise CancelledError(imagery_messages.CANCELLED())
