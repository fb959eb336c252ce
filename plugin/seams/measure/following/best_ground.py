"""What the sources of a mosaic leave over of its fine detail where they explain it best: what true sources leave.

A source that was used explains nearly all. What it leaves over is compression, noise or resampling, the same everywhere
as a function of how strong detail is. An image that merely resembles the true one leaves several times as much, in one
place. So ground is compared with the best of its own mosaic and not with a constant.
"""
from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..energy_response import EnergyResponse, fit_response, sampled

MIN_STRANGE = 0.4  # of the way from what true sources leave over to all of it: surely another image
MIN_ALIKE_STRANGE = 0.05  # the same of another image of the same ground, where there is much of it
MIN_ALIKE_FACTOR = 1.8  # by which that leaves more over than true sources do
MAX_TELLING = 0.7  # of the detail: where true sources leave over more, as of weak detail below noise, nothing is told
MIN_EVEN_LEFT, MIN_EVEN_SLOPE = 0.2, -0.15  # see ``is_of_none``

_FEWEST = 24  # places that anything is learned from
_CLASSES = 4  # of energy, in each of which the best ground is looked for
_BEST = 0.2  # of each class
_MOST_RISE = 2.0  # from one class to the next: a stronger one may be of another image altogether
_MOST_LEARNED = 1.5  # times as much as is expected so far: still learned from
_ROUNDS = 12
_WEAK, _STRONG = 0.1, 0.9  # quantiles of the energies


@dataclass(frozen=True, eq=False)
class BestGround:
    """What true sources leave over, learned of one mosaic."""

    response: EnergyResponse
    """Share that is left over, by the mosaic's energy."""
    weak: float
    strong: float
    """Energies that weak and strong detail has."""

    def is_of_none(self) -> bool:
        """Whether not even the best ground is of a given source.

        What noise leaves over grows less than detail does; what an image lacks that merely resembles the true one is an
        even share of it.
        """
        weak, strong = self.response(np.array([self.weak, self.strong])).tolist()
        slope = np.log(strong / weak) / max(np.log(self.strong / self.weak), 0.2)
        return bool(min(weak, strong) > MIN_EVEN_LEFT and slope > MIN_EVEN_SLOPE)

    def strangeness(
        self, energy: np.ndarray, left_over: np.ndarray, least: float = MIN_ALIKE_STRANGE,
        factor: float = MIN_ALIKE_FACTOR,
    ) -> tuple[np.ndarray, np.ndarray]:
        """How far what is left over of the mosaic's ``energy`` is on the way from the expected to all, 0 where
        nothing is told; and whether that is what images of the same ground leave over (bool): as far as ``least`` and
        ``factor`` times what is expected."""
        expected = self.response(energy)
        tells = expected < MAX_TELLING
        expected *= energy
        strange = np.where(tells, (left_over - expected) / np.where(tells, energy - expected, 1), 0)
        return strange, (strange > least) & (left_over > factor * expected)


def learn_best_ground(energy: np.ndarray, left_over: np.ndarray) -> BestGround | None:
    """Best ground of places (n,), from the mosaic's energy and what its sources leave over of it. None where there are
    too few, or values so large that energies are none."""
    if len(energy) < _FEWEST:
        return None
    energy, left_over = sampled(energy), sampled(left_over)
    share = left_over / energy
    chosen, most = np.zeros(len(energy), bool), np.inf
    for part in np.array_split(np.argsort(energy), _CLASSES):
        most = min(float(np.quantile(share[part], _BEST)), _MOST_RISE * most)
        chosen[part] = share[part] <= most
    if not chosen.any():  # nor is NaN less than anything
        return None
    response = fit_response(energy[chosen], left_over[chosen])
    for _ in range(_ROUNDS):
        before, chosen = chosen, share <= _MOST_LEARNED * response(energy)
        if np.count_nonzero(chosen) < _FEWEST // _CLASSES or (chosen == before).all():
            break
        response = fit_response(energy[chosen], left_over[chosen])
    weak, strong = np.quantile(energy, (_WEAK, _STRONG)).tolist()
    return BestGround(response, weak, strong)
