"""The files of a fit: its model file, RPC in three forms, and points for the georeferencer."""
from __future__ import annotations

import json
import typing
from dataclasses import asdict, dataclass, fields, is_dataclass
from functools import cached_property
from operator import methodcaller
from pathlib import Path
from typing import Any, Callable, NamedTuple

import numpy as np

from ...imagery.atomic_files import save_text
from ...imagery.documents import json_document
from ...imagery.errors import Message, RasterError, SensorModelError
from ...imagery.open_raster import OpenRaster
from ...imagery.reference_systems import metres_per_unit
from . import messages, registry
from .adjustment import Adjustment
from .points import ImageBox, write_point_file
from .rpc import BiasedRpc, Domain, RpcOfModel, located, rpc_heights, rpc_of, write_image_with_rpc, write_rpc
from .sensor_model import WGS84, SensorModel, file_content

FORMAT = "seam_inspector sensor model"
VERSION = 1
_TRIED = 5  # places that a model read from a file has to take to the image
_RISE_M = 100.0  # between the two heights that a line of sight is taken at


@dataclass(frozen=True)
class ModelFile:
    model: SensorModel
    wkt: str  # system of the points it was fitted to; models in longitude and latitude ignore it
    domain: Domain
    facts: dict[str, Any]  # accuracy, condition, points and the like, for the reader


def save_model(file: ModelFile, path: Path) -> None:
    kind = next(name for name, kind in registry.KINDS.items() if type(file.model) is kind.model_class())
    conventions = {
        "image": "column and row in pixels, (0, 0) is the upper left corner of the first pixel",
        "ground": "longitude and latitude in degrees (EPSG:4326)" if file.model.GEOGRAPHIC else "x and y of 'crs'",
        "height": "metres above the ellipsoid",
        "scaling": "scaled = (value - offset) / scale",
        "terms": "1 x y z xy xz yz xx yy zz xyz xxx xyy xzz xxy yyy yzz xxz yyz zzz; in a plane without z",
    }
    document = {
        "format": FORMAT, "version": VERSION, "model": kind, "conventions": conventions, "crs": file.wkt,
        "domain": asdict(file.domain), "parameters": asdict(file.model), "facts": file.facts,
    }  # fmt: skip
    text = json.dumps(document, default=methodcaller("tolist"))
    plain = json.loads(text, parse_constant=lambda name: None)  # what is no number stands as null
    save_text(json.dumps(plain, indent=1, allow_nan=False) + "\n", path)


def load_model(path: Path) -> ModelFile:
    """Read a model file. Raises SensorModelError when it is none, or one of a newer version."""
    try:
        document = json_document(file_content(path).decode())
        if document["format"] != FORMAT:
            raise ValueError
        if document.get("version") != VERSION:
            raise SensorModelError(messages.MODEL_FILE_VERSION(name=path.name, version=document.get("version")))
        model = _built(registry.KINDS[document["model"]].model_class(), document["parameters"])
        ranges = [document["domain"][field.name] for field in fields(Domain)]
        domain = Domain(*((float(low), float(high)) for low, high, *_ in ranges))
        with np.errstate(all="ignore"):  # arrays may be of other shapes
            if model.project(np.zeros((_TRIED, 3))).shape != (_TRIED, 2):
                raise ValueError
        return ModelFile(model, str(document["crs"]), domain, document.get("facts", {}))
    except (KeyError, IndexError, TypeError, ValueError, AttributeError):
        raise SensorModelError(messages.NO_MODEL_FILE(name=path.name)) from None


def _built(kind: Any, plain: Any) -> Any:
    """The value of a type whose fields, numbers and lists were in JSON."""
    if kind is np.ndarray:
        array = np.array(plain, float)
        if not np.isfinite(array).all():
            raise ValueError
        return array
    if isinstance(kind, type) and is_dataclass(kind):
        hints = typing.get_type_hints(kind)
        return kind(**{field.name: _built(hints[field.name], plain[field.name]) for field in fields(kind)})
    return kind(plain)


class ViewDirection(NamedTuple):
    """The line of sight, at the ground."""

    angle: float  # from the vertical, degrees, in the middle of the image
    azimuth: float  # where it was taken from, degrees from north over east
    largest: float  # the largest angle from the vertical in the image's corners, degrees
    error: float  # in the terrain's heights, m
    shift: float  # of the orthoimage's middle by that error, m

    @property
    def notice(self) -> Message:
        return messages.VIEW_TOLD(
            angle=self.angle, azimuth=self.azimuth, largest=self.largest, error=self.error, shift=self.shift
        )


def view_direction(model: SensorModel, wkt: str, domain: Domain, error: float) -> ViewDirection | None:
    """View direction of a model fitted to points of ``wkt``, with an ``error`` of terrain heights, m; None for a plane
    one, or one too bent to be inverted."""
    if not model.SPATIAL:
        return None
    levels = np.mean(domain.heights) + np.array([-0.5, 0.5]) * _RISE_M
    places = domain.middle_and_corners
    try:
        low, high = (
            located(model, wkt, np.column_stack([places, np.full(len(places), level)]), domain) for level in levels
        )
    except SensorModelError:
        return None
    towards = (high - low)[:, :2] * metres_per_unit(WGS84, low[0])
    angles = np.degrees(np.arctan(np.linalg.norm(towards, axis=1) / _RISE_M))
    azimuth = float(np.degrees(np.arctan2(towards[0, 0], towards[0, 1])) % 360)
    shift = float(np.tan(np.radians(angles[0])) * abs(error))
    return ViewDirection(float(angles[0]), azimuth, float(angles.max()), error, shift)


@dataclass(frozen=True)
class FitFiles:
    """The writer of the files of a fit. Each method raises SettingsError where no file can be."""

    done: Adjustment
    image: OpenRaster | None
    box: ImageBox  # the image's rectangle, or that of the points
    cancelled: Callable[[], bool]
    tell: Callable[[Message], None]  # says how an RPC follows the model, or why there is none

    @cached_property
    def domain(self) -> Domain:
        """The domain of the model: the image, at the points' heights."""
        ground = self.done.points.ground
        heights = ground[:, 2][np.isfinite(ground[:, 2])]
        low, high = (float(heights.min()), float(heights.max())) if len(heights) else (0.0, 0.0)
        x, y = ground[:, :2].mean(axis=0).tolist()
        return Domain(self.box[0::2], self.box[1::2], (low, high), (x, y))

    @cached_property
    def _rpc(self) -> RpcOfModel:
        return rpc_of(self.done.fitted.model, self.done.points.wkt, self.domain)

    @property
    def rpc_bias(self) -> np.ndarray | None:
        """(5, 2) px: how far off an RPC was that is corrected, in the middle of the image and in its corners."""
        model = self.done.fitted.model
        return model.bias(self.domain.middle_and_corners) if isinstance(model, BiasedRpc) else None

    def save_model(self, path: Path) -> None:
        done, fitted = self.done, self.done.fitted
        facts = {
            "model": done.request.name, "condition": fitted.condition, "iterations": fitted.iterations,
            "converged": fitted.converged, "sigma_px": done.sigma_px, "control": asdict(done.control),
            "check": asdict(done.check), "blunders": done.points.named(done.blunder),
        }  # fmt: skip
        save_model(ModelFile(fitted.model, done.points.wkt, self.domain, facts), path)

    def save_rpc(self, path: Path) -> bool:
        """Write the RPC; whether there is one."""
        return self._written(lambda: write_rpc(self._rpc.rpc, path))

    def save_rpc_image(self, path: Path) -> bool:
        """Write a copy of the image with the RPC in its tags; whether there is one."""
        if (image := self.image) is None:
            self.tell(messages.RPC_IMAGE_WITHOUT_IMAGE())
            return False
        return self._written(lambda: write_image_with_rpc(image, self._rpc.rpc, path, self.cancelled))

    def save_points(self, path: Path) -> None:
        """Write the points with their residuals; check points and blunders are switched off."""
        used = ~self.done.points.check & ~self.done.blunder
        transform = self.image.raster.geotransform if self.image is not None else None
        write_point_file(path, self.done.points, used, self.done.residuals_px, transform)

    def _written(self, write: Callable[[], None]) -> bool:
        """Write an RPC, and say how closely it follows the model."""
        try:
            write()
        except (SensorModelError, RasterError) as error:
            self.tell(messages.RPC_NOT_WRITTEN(why=error.message))
            return False
        low, high = rpc_heights(self.domain)
        self.tell(messages.RPC_FITTED(rms=self._rpc.rms_px, largest=self._rpc.max_px, low=low, high=high))
        return True
