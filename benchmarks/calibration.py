"""How often the calibration's range covers the true threshold: `make benchmark-calibration`.

Verdicts are drawn from known distributions whose best Youden threshold is known, alone or in neighbourhoods that share
an effect. Printed per case: how often the range of the product covers it, and its median width; beside it the range
that a percentile bootstrap of the judged windows' best step has; and how far the threshold and that step err.
Nothing of it is asserted: docs/appendix/calibration.md says the figures.
"""
from __future__ import annotations

import argparse
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

import numpy as np
from scipy import stats
from seam_inspector.plugin.seams.measure.calibration.threshold_calibration import (
    Neighbourhoods,
    best_threshold,
    find_neighbourhoods,
)

from .timing import print_table

SIZES = ((10, 10), (20, 20), (50, 20), (200, 60))
BEST_STEP_RESAMPLES = 500
_SEED = 13


@dataclass(frozen=True)
class Population:
    """What verdicts of either kind are drawn from."""

    name: str
    visible: Any
    """A frozen distribution of scipy."""
    invisible: Any
    step: float = 0.0
    """Values are rounded to it."""

    def truth(self) -> tuple[float, float]:
        """From where to where thresholds have the largest Youden index; one number unless values are rounded."""
        values = np.arange(-0.5, 3, self.step or 1e-5)
        youden = self.visible.cdf(values + self.step / 2) - self.invisible.cdf(values + self.step / 2)
        best = float(values[youden.argmax()])
        return best, best + self.step

    def values(self, effects: np.ndarray, kinds: np.ndarray) -> np.ndarray:
        """Values of verdicts (True: visible) whose standard normal effects are given."""
        shares = stats.norm.cdf(effects)
        drawn = np.where(kinds, self.visible.ppf(shares), self.invisible.ppf(shares))
        return np.round(drawn / self.step) * self.step if self.step else drawn


@dataclass(frozen=True)
class Layout:
    """How the verdicts lie in neighbourhoods."""

    name: str
    size: int = 1
    """Verdicts in a neighbourhood."""
    correlation: float = 0.0
    """Between the values of a kind in a neighbourhood."""
    mixed: bool = True
    """Whether a neighbourhood holds verdicts of both kinds."""
    is_row: bool = False
    """Whether the windows stand along one seam instead, every two sides, each correlated so with the next."""

    def draw(
        self, random: np.random.Generator, population: Population, counts: tuple[int, int]
    ) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Values, kinds (True: visible) and neighbourhoods."""
        kinds = np.repeat([True, False], counts)
        if self.mixed:
            kinds = random.permutation(kinds)
        own = random.normal(size=len(kinds))
        if self.is_row:
            return population.values(self._along(own), kinds), kinds, self._blocks(len(kinds))
        places = np.arange(len(kinds)) // self.size
        shared = random.normal(size=places.max() + 1)[places]
        effects = np.sqrt(self.correlation) * shared + np.sqrt(1 - self.correlation) * own
        return population.values(effects, kinds), kinds, places

    def _along(self, own: np.ndarray) -> np.ndarray:
        """Effects that follow each other."""
        effects = own.copy()
        for place in range(1, len(own)):
            effects[place] = self.correlation * effects[place - 1] + np.sqrt(1 - self.correlation**2) * own[place]
        return effects

    @staticmethod
    def _blocks(count: int) -> np.ndarray:
        """Neighbourhoods as the product makes them of the windows' outlines."""
        return np.array(find_neighbourhoods([(200.0 * k, 0.0, 200.0 * k + 100, 100.0) for k in range(count)]))


def _normals(name: str, area: float, visible: float = 0.15, invisible: float = 0.15, step: float = 0.0) -> Population:
    apart = stats.norm.ppf(area) * np.hypot(visible, invisible)
    return Population(name, stats.norm(0.5, visible), stats.norm(0.5 + apart, invisible), step)


ALONE = Layout("alone")
POPULATIONS = (
    *(_normals(f"normal, AUC {area}", area) for area in (0.75, 0.85, 0.92, 0.98)),
    *(_normals(f"normal, spreads 1:2, AUC {area}", area, 0.1, 0.2) for area in (0.75, 0.85, 0.95)),
    *(_normals(f"normal, spreads 2:1, AUC {area}", area, 0.2, 0.1) for area in (0.75, 0.85, 0.95)),
    Population("lognormal, AUC 0.80", stats.lognorm(0.35, scale=0.5), stats.lognorm(0.35, scale=0.758)),
    Population("lognormal, AUC 0.92", stats.lognorm(0.35, scale=0.5), stats.lognorm(0.35, scale=1.002)),
    Population("gamma 4 and 8, AUC 0.89", stats.gamma(4, scale=0.1), stats.gamma(8, scale=0.1)),
    Population("beta, AUC 0.91", stats.beta(2.5, 4), stats.beta(5, 2)),
    Population("beta and normal, AUC 0.99", stats.beta(2, 4), stats.norm(0.85, 0.12)),
    Population("Student's t of 4, AUC 0.92", stats.t(4, 0.45, 0.12), stats.t(4, 0.75, 0.12)),
    Population("skewed towards each other, AUC 0.96", stats.lognorm(0.4, scale=0.4), stats.beta(9, 1.8)),
    _normals("normal, rounded to 0.05, AUC 0.90", 0.9, step=0.05),
    _normals("normal, rounded to 0.1, AUC 0.88", 0.88, step=0.1),
)
LAYOUTS = (
    Layout("by 2, mixed, correlation 0.5", 2, 0.5),
    Layout("by 4, mixed, correlation 0", 4),
    Layout("by 4, mixed, correlation 0.3", 4, 0.3),
    Layout("by 4, mixed, correlation 0.6", 4, 0.6),
    Layout("by 2, of one kind, correlation 0.5", 2, 0.5, mixed=False),
    Layout("by 4, of one kind, correlation 0", 4, mixed=False),
    Layout("by 4, of one kind, correlation 0.5", 4, 0.5, mixed=False),
    Layout("along a seam, correlation 0", is_row=True),
    Layout("along a seam, correlation 0.5", correlation=0.5, is_row=True),
)


@dataclass(frozen=True)
class Coverage:
    """What the runs of one case came to."""

    covered: float
    width: float
    """Median."""
    covered_by_step: float
    """How often a percentile bootstrap of the best step covers, each window for itself."""
    error: float
    """Root mean square, of the threshold."""
    error_of_step: float


def coverage(
    population: Population, layout: Layout, counts: tuple[int, int], runs: int, are_known: bool = True
) -> Coverage:
    """Coverage by so many drawn sets of verdicts, their neighbourhoods known or not."""
    random = np.random.default_rng(_SEED)
    low, high = population.truth()
    rows = []
    for _ in range(runs):
        values, kinds, places = layout.draw(random, population, counts)
        if not are_known:
            places = np.arange(len(values))
        visible, invisible = values[kinds], values[~kinds]
        found = best_threshold(visible, invisible, Neighbourhoods(places[kinds], places[~kinds]))
        step, step_low, step_high = _best_step(random, visible, invisible)
        rows.append((
            found.low <= high and found.high >= low, found.high - found.low,
            step_low <= high and step_high >= low,
            found.value - np.clip(found.value, low, high), step - np.clip(step, low, high),
        ))  # fmt: skip
    table = np.array(rows, np.float64)
    errors = np.sqrt((table[:, 3:] ** 2).mean(axis=0))
    return Coverage(
        float(table[:, 0].mean()), float(np.median(table[:, 1])), float(table[:, 2].mean()), *map(float, errors)
    )


def _best_step(
    random: np.random.Generator, visible: np.ndarray, invisible: np.ndarray
) -> tuple[float, float, float]:
    """The threshold with the largest Youden index of the values themselves, and its percentile bootstrap."""
    values, places = np.unique(np.concatenate([visible, invisible]), return_inverse=True)
    cuts = (values + np.append(values[1:], values[-1])) / 2
    counts = [np.bincount(one, minlength=len(values)) for one in np.split(places, [len(visible)])]

    def best(drawn: list[np.ndarray]) -> np.ndarray:
        hits, vain = (np.cumsum(one, axis=1) for one in drawn)
        found: np.ndarray = cuts[(hits * len(invisible) - vain * len(visible)).argmax(axis=1)]
        return found

    drawn = [random.multinomial(count.sum(), count / count.sum(), BEST_STEP_RESAMPLES) for count in counts]
    low, high = np.percentile(best(drawn), (2.5, 97.5))
    return float(best([count[np.newaxis] for count in counts])[0]), float(low), float(high)


def _rows(cases: list[tuple[Population, Layout]], counts: tuple[int, int], runs: int) -> Iterator[list[str]]:
    for population, layout in cases:
        found = coverage(population, layout, counts, runs)
        name = population.name if layout is ALONE else layout.name
        yield [
            name, f"{found.covered:.3f}", f"{found.width:.3f}", f"{found.covered_by_step:.3f}",
            f"{found.error:.3f}", f"{found.error_of_step:.3f}",
        ]  # fmt: skip


def _size(words: str) -> tuple[int, int]:
    visible, invisible = words.split("+")
    return int(visible), int(invisible)


def main() -> int:
    parser = argparse.ArgumentParser(prog="python -m benchmarks.calibration", description=__doc__.split("\n")[0])
    parser.add_argument("--runs", type=int, default=1000, help="sets of verdicts per case; a quarter with 200 + 60")
    parser.add_argument("--sizes", nargs="+", default=SIZES, type=_size, help="verdicts of either kind, as 10+10")
    arguments = parser.parse_args()
    between = _normals("normal, AUC 0.88", 0.88)
    cases = [*((population, ALONE) for population in POPULATIONS), *((between, layout) for layout in LAYOUTS)]
    for counts in arguments.sizes:
        rows = list(_rows(cases, counts, arguments.runs if sum(counts) < 200 else max(arguments.runs // 4, 1)))
        covered = [float(row[1]) for row in rows]
        inside = sum(0.93 <= one <= 0.97 for one in covered)
        print_table(
            f"{counts[0]} visible and {counts[1]} invisible verdicts: covered {np.mean(covered):.3f} in the mean, "
            f"{min(covered):.3f} to {max(covered):.3f}, {inside} of {len(rows)} cases between 0.93 and 0.97",
            ["verdicts from", "covered", "width", "best step's bootstrap", "error", "best step's error"],
            rows,
        )
    return 0


if __name__ == "__main__":
    raise SystemExit(main())
