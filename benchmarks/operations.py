"""What is done to a mosaic, one way after another: how its seam was made, and what came over all of it afterwards.

Each operation says what it did in the words of the plugin's causes. Every second parameter is held back: nobody looks
at those while limits are set, nor at the windows in the east (``known_windows``).
"""
from __future__ import annotations

import zlib
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from . import aftermaths as after
from . import seam_makings as seams
from .aftermaths import Change
from .known_windows import KnownWindow, hard_cut
from .seam_makings import Mix, Mixed

Offset = tuple[float, float]

MIN_CLIPPED = 0.005
"""Of the pixels: from there on an operation may be called clipping too."""
PHASE: Offset = (0.45, 0.37)
"""Of grids that pixels are resampled from, px; below half a pixel, so that frames hold the same ground."""


@dataclass(frozen=True)
class Making:
    """One way to make a seam."""

    name: str
    mix: Mix
    cause: str = "none"
    also: tuple[str, ...] = ()
    possible: tuple[str, ...] = ()
    """Causes that it is no mistake to name besides."""
    lost: bool = False
    """Whether detail was lost in a strip along the seam."""
    kind: str = ""
    """Column of the pooled tables that it belongs to."""
    three: bool = False
    covered: bool = False
    """Whether it needs three sources, and sources that cover all of the frame."""
    offset: Offset = (0.0, 0.0)
    """How the grid of the second source lies beside the mosaic's: down and right, px."""


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


@dataclass(frozen=True, eq=False)
class Made:
    """What an operation made of a window's frame."""

    bands: np.ndarray
    hard: np.ndarray
    """The known hard cut after the same aftermath."""
    before: np.ndarray
    """The hard cut of the sources as they are, with no aftermath."""
    sources: tuple[np.ndarray, ...]
    """Those that are given, (bands, rows, columns) 8 or 16 bit."""
    valid: tuple[np.ndarray, ...]
    offsets: tuple[Offset, ...]
    """How the grid of each lies beside the mosaic's."""
    distance: np.ndarray
    """From the true seam, px."""
    foreign: np.ndarray
    """Pixels from a source that is not given, (rows, columns) bool."""
    allowed: frozenset[str]
    """Causes that are true or that it is no mistake to name."""


@dataclass(frozen=True)
class Operation:
    """A seam and what came afterwards."""

    making: Making
    aftermath: Aftermath
    held_back: bool
    always: bool = False
    """Whether it belongs to both halves: the plain seams that everything is compared with."""

    @property
    def name(self) -> str:
        return self.making.name if self.aftermath is NOTHING else f"{self.making.name}, {self.aftermath.name}"

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

    def in_half(self, held_back: bool) -> bool:
        return self.always or self.held_back is held_back

    def fits(self, window: KnownWindow) -> bool:
        """Whether the window has the sources that it needs."""
        making = self.making
        return (len(window.sources) > 2 or not making.three) and (window.is_covered or not making.covered)

    def make(self, window: KnownWindow) -> Made:
        """The mosaic of one window, always the same."""
        mixed, distance = _mixed(self.making, window)
        seed = _seed(self.name, window)
        change = self.aftermath.fit(mixed.bands) if self.aftermath.fit else self.aftermath.change
        bands, hard = (change(one, np.random.default_rng(seed)) for one in (mixed.bands, mixed.hard))
        before = hard_cut(window.sources, mixed.labels)
        ends = ((bands == 0) & (before > 0)) | ((bands == 255) & (before < 255))
        clipped = ("clipping",) if ends.mean(axis=(1, 2)).max() >= MIN_CLIPPED else ()
        depth = self.aftermath.depth
        given = (deepened(window.sources[k], depth, np.random.default_rng([*seed, k])) for k in mixed.given)
        return Made(
            bands,
            hard,
            before,
            tuple(given),
            tuple(window.valid[k] for k in mixed.given),
            tuple(self._offset(k == window.main[1]) for k in mixed.given),
            distance,
            mixed.foreign,
            frozenset((*self.true_causes, *self.making.possible, *self.aftermath.possible, *clipped)),
        )

    def _offset(self, of_second: bool) -> Offset:
        own, whole = self.making.offset if of_second else (0.0, 0.0), self.aftermath.offset
        return own[0] + whole[0], own[1] + whole[1]


@lru_cache(maxsize=2)
def _mixed(making: Making, window: KnownWindow) -> tuple[Mixed, np.ndarray]:
    """The mosaic before anything came over it, and the distance from its seam; asked for with every aftermath."""
    mixed = making.mix(window, np.random.default_rng(_seed(making.name, window)))
    return mixed, seams.seam_distance(mixed.labels)


def _seed(name: str, window: KnownWindow) -> list[int]:
    return [zlib.crc32(name.encode()), zlib.crc32(window.imagery.encode()), window.number, window.side]


def deepened(bands: np.ndarray, depth: int, rng: np.random.Generator) -> np.ndarray:
    """The scan that 8 bit were made of by a line: 12 bit of the whole scale, or 16 bit that use a sixth of it."""
    if depth == 8:
        return bands
    step, first = (16, 0) if depth == 12 else (40, 500)
    return (bands.astype(np.uint16) * step + first + rng.integers(0, step, bands.shape)).astype(np.uint16)


HARD = Making("hard cut", seams.hard, kind="hard")
FEATHER_33 = Making("feather 33 px", seams.feathered(33), "feathering", lost=True, kind="33 px and more")
PLAIN = (
    HARD,
    Making("feather 13 px", seams.feathered(13), "feathering", lost=True, kind="13 px"),
    FEATHER_33,
    Making("feather 256 px linear", seams.feathered(256, "linear"), "feathering", lost=True, kind="256 px"),
)
"""Each with every aftermath."""
WIDER = tuple(
    Making(name, mix, "feathering", lost=True, kind="33 px and more")
    for name, mix in (
        ("feather 66 px", seams.feathered(66)),
        ("feather 128 px", seams.feathered(128)),
        ("feather Gaussian, sigma 13 px", seams.feathered(13, "gaussian")),
        ("feather 48 px linear", seams.feathered(48, "linear")),
    )
)


def _balanced(name: str, first: Change, second: Change, cause: str = "balanced", width: float = 0.0) -> Making:
    mix = seams.changed({0: first, 1: second}, width)
    if width:
        return Making(f"{name}, feather {width:g} px", mix, "feathering", (cause,), lost=True, kind="33 px and more")
    return Making(name, mix, cause, possible=("balanced",), kind="hard")


def _moved(y_px: float, x_px: float) -> Making:
    mix = seams.changed({1: after.resampled(y_px, x_px, 3)}, 33)
    also = ("feathering",) if (y_px + x_px).is_integer() else ("feathering", "resampled")
    return Making(f"one source {np.hypot(y_px, x_px):g} px off, feather 33 px", mix, "misregistration", also,
                  lost=True, covered=True)


def _missing(share: float, width: float = 0.0) -> Making:
    name = f"source of {share:.0%} missing" + (f", feather {width:g} px" if width else "")
    also = ("feathering",) if width else ()
    return Making(name, seams.missing(share, width), "missing source", also, covered=True)


OTHERS = (
    Making("pyramid blend", seams.blended, possible=("feathering",)),  # keeps 0.97 in the first 8 px
    Making("three sources meet", seams.meeting(0), kind="hard", three=True, covered=True),
    Making("three sources meet, feather 33 px", seams.meeting(33), "feathering", lost=True, kind="33 px and more",
           three=True, covered=True),
    _balanced("gains 0.8 and 1", after.line(0.8), after.nothing),
    _balanced("gains 0.9 and 1.1", after.line(0.9), after.line(1.1)),
    _balanced("offset 25", after.line(1, 25), after.nothing),
    _balanced("gains 0.85 and 1.05", after.line(0.85, 10), after.line(1.05, -5), width=33),
    _balanced("gamma 0.8 and 1.2", after.gamma(0.8), after.gamma(1.2), "gamma"),
    _moved(0.5, 0.0),
    _moved(0.0, 1.0),
    _moved(2.0, 0.0),
    Making("one source blurred 0.8 px", seams.changed({1: after.blurred(0.8)}), "blur"),
    Making("one source resampled, cubic", seams.changed({1: after.resampled(*PHASE, 3)}), "resampled",
           possible=("blur",), offset=PHASE),
    _missing(0.12),
    _missing(0.3),
    _missing(0.55),
    _missing(0.3, 33),
    _missing(0.2),
)
"""Alone, or with few aftermaths."""

NOTHING = Aftermath("nothing", after.nothing)
AFTERMATHS = (
    NOTHING,
    Aftermath("unsharp 0.5", after.unsharp(0.5), "sharpened"),
    Aftermath("unsharp 1", after.unsharp(1.0), "sharpened"),
    *(Aftermath(f"JPEG {quality}", after.jpeg(quality), "compressed") for quality in (50, 65, 75, 85, 95)),
    *(Aftermath(f"noise {sigma} DN", after.noise(sigma), "noise added") for sigma in (2, 4, 6)),
    Aftermath("gain 0.6", after.line(0.6, 20), "narrowed histogram"),
    Aftermath("gain 0.8", after.line(0.8, 15), "narrowed histogram"),
    Aftermath("gain 1.2", after.line(1.2, -15)),
    *(Aftermath(f"gamma {exponent}", after.gamma(exponent), "gamma", ("narrowed histogram",))
      for exponent in (0.6, 0.7, 1.3, 1.6)),
    Aftermath("dodged 0.7 to 1.1", after.dodged(0.7, 1.1), "dodging", ("narrowed histogram",)),
    Aftermath("dodged round", after.dodged_round(0.75, 1.15), "dodging", ("narrowed histogram",)),
    Aftermath("flattened", after.flattened(0.8), "dodging"),
    Aftermath("blur 0.5 px", after.blurred(0.5), "blur"),
    Aftermath("blur 0.8 px", after.blurred(0.8), "blur"),
    Aftermath("resampled, cubic", after.resampled(*PHASE, 3), "resampled", ("blur",), offset=PHASE),
    Aftermath("resampled, bilinear", after.resampled(*PHASE, 1), "resampled", ("blur",), offset=PHASE),
    Aftermath("moved 0.62 px, cubic", after.resampled(0.5, 0.37, 3), "misregistration", ("resampled", "blur")),
    Aftermath("moved 0.3 px, cubic", after.resampled(-0.3, 0.0, 3), "resampled", ("misregistration", "blur")),
    Aftermath("gains by channel", after.gains((0.85, 1.0, 0.92)), "colour shift", ("narrowed histogram",)),
    Aftermath("clipping 3 %", after.nothing, "clipping", fit=after.clipping(0.03)),
    Aftermath("of 12 bit", after.nothing, depth=12),
    Aftermath("of 16 bit", after.nothing, depth=16),
)
"""Every second one is held back, from the second on."""
FEW = tuple(one for one in AFTERMATHS if one.name in ("nothing", "unsharp 1", "JPEG 75", "JPEG 85", "noise 6 DN"))


def _operations() -> Iterator[Operation]:
    for making in PLAIN:
        for number, aftermath in enumerate(AFTERMATHS):
            yield Operation(making, aftermath, number % 2 == 1, always=aftermath is NOTHING)
    for number, making in enumerate(WIDER):
        for aftermath in FEW:
            yield Operation(making, aftermath, number % 2 == 1)
    for number, making in enumerate(OTHERS):
        yield Operation(making, NOTHING, number % 2 == 1)


OPERATIONS = tuple(_operations())
