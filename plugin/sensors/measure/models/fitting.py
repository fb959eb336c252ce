"""Fitting any sensor model to points, where there are enough of them and they determine it."""
from __future__ import annotations

from dataclasses import replace

import numpy as np

from ....imagery.errors import SensorModelError
from .. import limits, messages
from ..ground_system import WGS84, GroundSystem
from ..points import Points
from .least_squares import Scaling, least_squares
from .registry import ModelRequest
from .sensor_model import FittedModel


def fit_model(request: ModelRequest, points: Points, weights: np.ndarray) -> FittedModel:
    """Fit a model to points with weights (n,), 1 / standard deviation in px; points of weight 0 do not count.

    Raises SensorModelError where they are too few or do not determine it, SettingsError where an RPC is missing.
    """
    used = weights > 0
    points, weights = points.only(used), weights[used]
    fewest = request.variant.fewest
    if len(points) < fewest:
        raise SensorModelError(messages.TOO_FEW_POINTS(model=request.name, count=len(points), fewest=fewest))
    _check_spread(request, points)
    if request.kind.model_class().GEOGRAPHIC:
        points = replace(points, ground=GroundSystem(points.wkt).to_geographic(points.ground), wkt=WGS84)
    return request.kind.fit(request, points, weights)


def _check_spread(request: ModelRequest, points: Points) -> None:
    """Refuse points that leave the linear part of a model open: on a line, or on a plane where Z has terms."""
    if request.variant.fewest < 3:
        return  # a model of so few points asks for no extent
    in_image = request.kind.corrects_rpc
    places = points.image if in_image else points.ground[:, :2]
    linear = np.column_stack([np.ones(len(places)), Scaling.of(places).to(places)])
    flat = least_squares(linear, places[:, 0])
    if flat.rank < 3 or flat.condition > limits.MAX_LINEAR_CONDITION:
        raise SensorModelError(messages.POINTS_ON_A_LINE(model=request.name))
    if request.needs_heights and not in_image:
        linear = np.column_stack([linear, Scaling.of(points.ground[:, 2:]).to(points.ground[:, 2:])])
        solid = least_squares(linear, places[:, 0])
        if solid.rank < 4 or solid.condition > limits.MAX_LINEAR_CONDITION:
            raise SensorModelError(messages.POINTS_ON_A_PLANE(model=request.name))
