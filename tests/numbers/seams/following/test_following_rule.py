"""The rule of which source is followed: each of its limits from both sides."""
from __future__ import annotations

import numpy as np
import pytest
from seam_inspector.plugin.seams.measure.following.followed_source import is_sure, mixtures

COUNT = 20_000  # samples, which chance makes differ by 1 %


def sure(first: float, second: float) -> bool:
    return bool(is_sure(np.array([first]), np.array([first - second]))[0])


def mixed(weight: float, noise: float, alike: float = 0.0, contrast: float = 1.0) -> tuple[bool, float]:
    """Whether two textures so much alike are mixed, the second of that contrast, with noise; how much both explain."""
    rng = np.random.default_rng(1)
    common, one, two, strange = rng.standard_normal((4, COUNT))
    first, second = (np.sqrt(alike) * common + np.sqrt(1 - alike) * own for own in (one, two))
    second *= contrast
    mosaic = (1 - weight) * first + weight * second
    mosaic += noise * mosaic.std() * strange
    found, explained = mixtures(
        np.array([mosaic @ mosaic]),
        {2: np.array([first @ first]), 5: np.array([second @ second])},
        {2: np.array([mosaic @ first]), 5: np.array([mosaic @ second])},
        lambda i, j: np.array([first @ second]),
    )
    return bool(found[0]), float(explained[0])


@pytest.mark.parametrize(("first", "second", "expected"), [
    (0.60, 0.48, True), (0.60, 0.52, False),  # by its lead, 0.1
    (0.99, 0.97, True), (0.99, 0.985, False),  # by what the next leaves over: 0.020 against 0.059, and 0.030
    (0.30, 0.28, False), (0.05, -0.3, True),
])
def test_a_source_is_sure_by_its_lead_or_by_what_the_next_leaves_over(
    first: float, second: float, expected: bool
) -> None:
    assert sure(first, second) is expected


def test_the_worse_source_leaves_more_over_not_less() -> None:
    """Where the next leaves hardly more, the winner is a guess, however well both explain the mosaic."""
    assert not sure(0.999, 0.9988)
    assert sure(0.999, 0.99)


@pytest.mark.parametrize(("weight", "contrast", "expected"), [
    (0.5, 1.0, True), (0.25, 1.0, True), (0.0, 1.0, False), (0.15, 3.0, True), (0.05, 6.0, False),
])
def test_both_sources_of_a_mixture_have_their_weight(weight: float, contrast: float, expected: bool) -> None:
    """A small share of strong texture may matter, but tells of no feather."""
    assert mixed(weight, 0.05, contrast=contrast)[0] is expected


@pytest.mark.parametrize(("noise", "expected"), [(0.2, True), (0.28, True), (0.40, False), (1.0, False)])
def test_a_mixture_explains_nearly_all(noise: float, expected: bool) -> None:
    """What is left over is noise^2 / (1 + noise^2): 0.04, 0.07; 0.14, 0.5."""
    found, explained = mixed(0.5, noise)
    assert found is expected
    assert explained == pytest.approx(1 / (1 + noise**2), abs=0.02)


@pytest.mark.parametrize(("alike", "expected"), [(0.0, True), (0.8, True), (0.95, False)])
def test_a_mixture_explains_more_than_either_source_alone(alike: float, expected: bool) -> None:
    """Alone either explains (1 + alike) / 2 of the mean of both."""
    assert mixed(0.5, 0.05, alike)[0] is expected


def test_sources_that_are_taken_away_from_each_other_are_no_mixture() -> None:
    assert mixed(-0.5, 0.05) == (False, 0.0)
