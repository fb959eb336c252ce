"""The files of a fit: its model file, RPC in three forms, and points for the georeferencer."""
from __future__ import annotations

from dataclasses import asdict, dataclass
from functools import cached_property
from pathlib import Path
from typing import Callable

import numpy as np

from ...imagery.errors import RasterError, SensorModelError
from ...imagery.message import Message
from ...imagery.open_raster import OpenRaster
from . import messages
from .adjustment import Adjustment
from .control_coverage import ImageBox
from .models.model_file import ModelFile, save_model
from .models.rpc import Domain, RpcOfModel, rpc_heights, rpc_of
from .models.rpc_files import write_rpc
from .models.rpc_images import write_image_with_rpc
from .point_files import source_coordinates, write_point_file
from .view_direction import ViewDirection, view_direction


@dataclass(frozen=True)
class FitFiles:
    """Writes what programs read of a fit. Each raises SettingsError where no file can be."""

    done: Adjustment
    image: OpenRaster | None
    box: ImageBox
    """The image's rectangle, or that of the points."""
    cancelled: Callable[[], bool]

    @cached_property
    def domain(self) -> Domain:
        """Where the model is used: over the image, at the points' heights."""
        ground = self.done.points.ground
        heights = ground[:, 2][np.isfinite(ground[:, 2])]
        low, high = (float(heights.min()), float(heights.max())) if len(heights) else (0.0, 0.0)
        middle = ground[:, :2].mean(axis=0)
        left, top, right, bottom = self.box
        return Domain((left, right), (top, bottom), (low, high), (float(middle[0]), float(middle[1])))

    @cached_property
    def _rpc(self) -> RpcOfModel:
        return rpc_of(self.done.fitted.model, self.done.points.wkt, self.domain)

    @property
    def view(self) -> ViewDirection | None:
        """The line of sight; None for a model that knows none, or that is too bent to be inverted."""
        try:
            return view_direction(self.done.fitted.model, self.done.points.wkt, self.domain)
        except SensorModelError:
            return None

    def save_model(self, path: Path) -> None:
        """The model file."""
        done = self.done
        facts = {
            "model": done.request.name,
            "condition": done.fitted.condition,
            "iterations": done.fitted.iterations,
            "converged": done.fitted.converged,
            "sigma_px": done.sigma_px,
            "control": asdict(done.control),
            "check": asdict(done.check),
            "blunders": [name for name, one in zip(done.points.ids, done.blunder) if one],
        }
        save_model(ModelFile(done.fitted.model, done.points.wkt, self.domain, facts), path)

    def save_rpc(self, path: Path) -> tuple[Message, bool]:
        """The RPC; what to tell of it, or why there is none, and whether there is one."""
        try:
            write_rpc(self._rpc.rpc, path)
        except SensorModelError as error:
            return messages.RPC_NOT_WRITTEN(why=error.message), False
        return self._followed(), True

    def save_rpc_image(self, path: Path) -> tuple[Message, bool]:
        """A copy of the image with the RPC in its tags; what to tell as for ``save_rpc``."""
        if self.image is None:
            return messages.RPC_IMAGE_WITHOUT_IMAGE(), False
        try:
            write_image_with_rpc(self.image, self._rpc.rpc, path, self.cancelled)
        except (SensorModelError, RasterError) as error:
            return messages.RPC_NOT_WRITTEN(why=error.message), False
        return self._followed(), True

    def save_points(self, path: Path) -> None:
        """The points with their residuals; check points and blunders are switched off."""
        points, transform = self.done.points, self.image.raster.geotransform if self.image is not None else None
        source = source_coordinates(points.image, transform)
        used = ~points.check & ~self.done.blunder
        write_point_file(path, points.wkt, points.ground, source, used, self.done.residuals_px)

    def _followed(self) -> Message:
        """How closely the RPC follows the model."""
        if self._rpc.exact:
            return messages.RPC_EXACT()
        low, high = rpc_heights(self.domain)
        return messages.RPC_FITTED(rms=self._rpc.rms_px, largest=self._rpc.max_px, low=low, high=high)
