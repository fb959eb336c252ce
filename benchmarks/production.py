"""What an operation is: one way to make a seam, one to treat the whole mosaic afterwards, and what both are called."""
from __future__ import annotations

import zlib
from collections.abc import Callable
from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from . import seam_makings as seams
from .known_windows import KnownWindow, hard_cut
from .seam_makings import Change, Mix, Mixed, whole_values
from .true_profile import Truth, taken_by_change, truth_of

Offset = tuple[float, float]

HALVES = ("used", "held back", "strange")
"""Halves of the operations; strange ones are nobody's to look at while limits are set, as those that are held back."""
TAKE_DETAIL = ("blur", "resampled", "compressed")
"""What takes detail from the whole window."""
MIN_CLIPPED = 0.005
"""Least share of the pixels: from there on an operation may be called clipping too."""
NOTHING_NAME = "nothing"


@dataclass(frozen=True)
class KnownTone:
    """What became of grey values: a line, or a power of the whole scale."""

    gain: float = 1.0
    bias: float = 0.0
    gamma: float = 1.0

    def __call__(self, bands: np.ndarray, rng: np.random.Generator) -> np.ndarray:
        if self.gamma != 1:
            return whole_values(255 * (bands / np.float32(255)) ** np.float32(self.gamma))
        return whole_values(bands * np.float32(self.gain) + np.float32(self.bias))


AS_IT_IS = KnownTone()


@dataclass(frozen=True)
class Making:
    """One way to make a seam."""

    name: str
    mix: Mix
    cause: str = "none"
    also: tuple[str, ...] = ()
    possible: tuple[str, ...] = ()
    """Causes that it is no mistake to name besides."""
    as_well: tuple[str, ...] = ()
    """Causes that are as right as its own."""
    lost: bool = False
    """Whether detail was lost in a strip along the seam."""
    kind: str = ""
    """Row of the tables that it belongs to."""
    group: str = ""
    """What kinds are pooled by: ``hard``, ``13 px`` or ``33 px and more``."""
    missing: float = 0.0
    """Share of the pixels from a source that is not given."""
    three: bool = False
    covered: bool = False
    """Whether it needs three sources, and sources that cover all of the frame."""
    offset: Offset = (0.0, 0.0)
    """How the grid of the second source lies beside the mosaic's: down and right, px."""
    tones: tuple[KnownTone | None, KnownTone | None] = (AS_IT_IS, AS_IT_IS)
    """What became of the grey values of the two sources with most pixels; None where it isn't told."""
    shift: Offset | None = None
    """How much the second source was moved: down and right, px."""


@dataclass(frozen=True)
class Aftermath:
    """One way to treat a whole mosaic."""

    name: str
    change: Change
    cause: str = "none"
    possible: tuple[str, ...] = ()
    """Causes that it is no mistake to name besides."""
    depth: int = 8
    """Bits of the sources; the mosaic has 8."""
    offset: Offset = (0.0, 0.0)
    """How the grids of all sources lie beside the mosaic's."""
    fit: Callable[[np.ndarray], Change] | None = None
    """What the change follows from, where it depends on the mosaic."""
    tone: KnownTone | None = AS_IT_IS
    """What became of the grey values; None where that is not one line or power for all bands and pixels."""
    shift: Offset | None = None
    """How much the mosaic was moved: down and right, px."""

    @property
    def is_nothing(self) -> bool:
        return self.name == NOTHING_NAME


@dataclass(frozen=True, eq=False)
class Made:
    """What an operation made of a window's frame."""

    bands: np.ndarray
    before: np.ndarray
    """The hard cut of the sources as they are, with no aftermath."""
    sources: tuple[np.ndarray, ...]
    """Those that are given, (bands, rows, columns) 8 or 16 bit."""
    valid: tuple[np.ndarray, ...]
    offsets: tuple[Offset, ...]
    """How the grid of each lies beside the mosaic's."""
    truth: float
    """kept_1 as it was before the aftermath."""
    mains: frozenset[str]
    """Causes that are right as the main one."""
    foreign: np.ndarray
    """Pixels from a source that is not given, (rows, columns) bool."""
    allowed: frozenset[str]
    """Causes that are true or that it is no mistake to name."""


@dataclass(frozen=True)
class Operation:
    """A seam and what came afterwards."""

    making: Making
    aftermath: Aftermath
    half: str
    """One of ``HALVES``."""
    always: bool = False
    """Whether it belongs to the half held back as well: the plain seams that everything is compared with."""

    @property
    def name(self) -> str:
        return self.making.name if self.aftermath.is_nothing else f"{self.making.name}, {self.aftermath.name}"

    @property
    def true_causes(self) -> tuple[str, ...]:
        """The main one first: a loss along the seam, else what came over the whole mosaic."""
        making, aftermath = self.making, self.aftermath
        whole = () if aftermath.cause == "none" else (aftermath.cause,)
        own = () if making.cause == "none" else (making.cause, *making.also)
        return (own + whole if making.lost or not whole else whole + own) or ("none",)

    @property
    def lost_in_strip(self) -> bool:
        return self.making.lost

    def in_half(self, half: str) -> bool:
        return self.half == half or (self.always and half == "held back")

    def fits(self, window: KnownWindow) -> bool:
        """Whether the window has the sources that it needs."""
        making = self.making
        return (len(window.sources) > 2 or not making.three) and (window.is_covered or not making.covered)

    def tone(self, of_second: bool) -> KnownTone | None:
        """What became of the grey values of a main source; None where it isn't known."""
        own, whole = self.making.tones[of_second], self.aftermath.tone
        return own if whole == AS_IT_IS else whole if own == AS_IT_IS else None

    def shift(self, of_second: bool) -> Offset | None:
        """How much a main source was moved; None where it wasn't."""
        return self.aftermath.shift or (self.making.shift if of_second else None)

    def make(self, window: KnownWindow) -> Made:
        """The mosaic of one window, always the same."""
        mixed, truth = _mixed(self.making, window)
        seed = _seed(self.name, window)
        change = self.aftermath.fit(mixed.bands) if self.aftermath.fit else self.aftermath.change
        bands = change(mixed.bands, np.random.default_rng(seed))
        before = hard_cut(window.sources, mixed.labels)
        ends = ((bands == 0) & (before > 0)) | ((bands == 255) & (before < 255))
        clipped = ("clipping",) if ends.mean(axis=(1, 2)).max() >= MIN_CLIPPED else ()
        depth = self.aftermath.depth
        given = (deepened(window.sources[k], depth, np.random.default_rng([*seed, k])) for k in mixed.given)
        return Made(
            bands,
            before,
            tuple(given),
            tuple(window.valid[k] for k in mixed.given),
            tuple(self._offset(k == window.main[1]) for k in mixed.given),
            truth.near,
            self._mains(truth, mixed, bands, window),
            mixed.foreign,
            frozenset((*self.true_causes, *self.making.as_well, *self.making.possible, *self.aftermath.possible,
                       *clipped)),
        )

    def _mains(self, truth: Truth, mixed: Mixed, bands: np.ndarray, window: KnownWindow) -> frozenset[str]:
        """The main true cause, and what is as right: a making's others, or what took more of the whole window."""
        making, aftermath = self.making, self.aftermath
        right = {self.true_causes[0]}
        if making.as_well:
            right |= {making.cause, *making.as_well, *self.true_causes}
        if making.lost and aftermath.cause in TAKE_DETAIL:
            taken = taken_by_change(mixed.bands, bands, window.middle)
            right |= {aftermath.cause} if taken > truth.taken / 2 else set()
        return frozenset(right)

    def _offset(self, of_second: bool) -> Offset:
        own, whole = self.making.offset if of_second else (0.0, 0.0), self.aftermath.offset
        return own[0] + whole[0], own[1] + whole[1]


@lru_cache(maxsize=2)
def _mixed(making: Making, window: KnownWindow) -> tuple[Mixed, Truth]:
    """The mosaic before anything came over it, and what it kept; asked for with every aftermath.

    Beside ground of a source that is not given nobody can tell what was kept: nan.
    """
    mixed = making.mix(window, np.random.default_rng(_seed(making.name, window)))
    if mixed.foreign[window.middle].any():
        return mixed, Truth(np.nan, np.nan)
    return mixed, truth_of(mixed, seams.seam_distance(mixed.labels), window.middle)


def _seed(name: str, window: KnownWindow) -> list[int]:
    return [zlib.crc32(name.encode()), zlib.crc32(window.imagery.encode()), window.number, window.side]


def deepened(bands: np.ndarray, depth: int, rng: np.random.Generator) -> np.ndarray:
    """The scan that 8 bit were made of by a line: 12 bit of the whole scale, or 16 bit that use a sixth of it."""
    if depth == 8:
        return bands
    step, first = (16, 0) if depth == 12 else (40, 500)
    return (bands.astype(np.uint16) * step + first + rng.integers(0, step, bands.shape)).astype(np.uint16)
