"""Quotients with terms left out: those that are there are found, others stay away, and fewer points do."""
from __future__ import annotations

from dataclasses import replace

import numpy as np
from seam_inspector.plugin.sensors.measure.polynomials import Rational, fit_chosen_terms, fit_rational

from tests.numbers.sensors.sensor_scenes import made_rational, places


def sparse() -> Rational:
    """Quotients with three terms beyond the linear ones of the column and none of the row."""
    made = made_rational(2, 3)
    numerators, denominators = made.numerators.copy(), np.zeros((10, 2))
    numerators[4:] = 0
    numerators[5, 0], numerators[8, 0] = 0.02, -0.01
    denominators[0], denominators[2, 0] = 1, 0.015
    return replace(made, numerators=numerators, denominators=denominators)


def test_fifteen_points_see_a_scene_that_order_two_needs_nineteen_for() -> None:
    """Fifteen noisy points: the terms that are there, and an error over the scene far below that of order 1."""
    truth, ground, everywhere = sparse(), places(15, 8), places(400, 9)
    image = truth.project(ground) + np.random.default_rng(1).normal(0, 0.3, (15, 2))
    chosen = fit_chosen_terms(ground, image, np.ones(15))
    assert isinstance(chosen.model, Rational)
    plain = fit_rational(ground, image, np.ones(15), 1).model
    misses = [np.sqrt(np.mean((model.project(everywhere) - truth.project(everywhere)) ** 2))
              for model in (chosen.model, plain)]
    assert misses[0] < 2
    assert misses[0] < misses[1] / 20
    assert chosen.unknowns <= 12
    assert not chosen.model.numerators[4:, 1].any()
    assert not chosen.model.denominators[1:, 1].any()
