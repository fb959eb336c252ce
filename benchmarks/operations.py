"""What is done to a mosaic, one way after another: how its seam was made, and what came over all of it afterwards.

Each operation says what it did in the words of the plugin's causes. Every second parameter is held back, and all that
is strange: nobody looks at those while limits are set, nor at the windows in the east (``known_windows``).
"""
from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from . import aftermaths as after
from . import seam_makings as seams
from . import strange_makings as strange
from .production import AS_IT_IS, HALVES, NOTHING_NAME, Aftermath, KnownTone, Making, Offset, Operation

PHASE: Offset = (0.45, 0.37)
"""Phase of grids that pixels are resampled from, px; below half a pixel, so that frames hold the same ground."""


def _feather(width_px: int, shape: str, group: str) -> Making:
    return Making(f"feather {width_px} px {shape}", seams.feathered(width_px, shape), "feathering", lost=True,
                  kind=f"{width_px} px {shape}", group=group)


HARD = Making("hard cut", seams.hard, kind="hard cut", group="hard")
RESAMPLED = Making("hard cut, each source resampled and balanced", seams.each_changed(after.resampled_and_balanced),
                   "resampled", possible=("balanced", "none"), as_well=("balanced", "none"),
                   kind="hard cut, resampled", group="hard", tones=(None, None))
KINDS = (
    HARD,
    RESAMPLED,
    *(_feather(13, shape, "13 px") for shape in ("cosine", "linear")),
    *(_feather(width, shape, "33 px and more") for width in (33, 66, 256) for shape in ("cosine", "linear")),
    Making("feather Gaussian, sigma 13 px", seams.feathered(13, "gaussian"), "feathering", lost=True,
           kind="Gaussian, sigma 13 px", group="33 px and more"),
    Making("pyramid blend", seams.blended, possible=("feathering",), kind="multiband"),  # keeps 0.97 beside the seam
)
"""Rows of the tables, each with every aftermath."""


def _balanced(name: str, first: KnownTone, second: KnownTone, cause: str = "balanced", width: float = 0.0) -> Making:
    mix, tones = seams.changed({0: first, 1: second}, width), (first, second)
    if width:
        return Making(f"{name}, feather {width:g} px", mix, "feathering", (cause,), lost=True,
                      group="33 px and more", tones=tones)
    return Making(name, mix, cause, possible=("balanced",), group="hard", tones=tones)


def _moved(y_px: float, x_px: float) -> Making:
    mix = seams.changed({1: after.resampled(y_px, x_px, 3)}, 33)
    also = () if (y_px + x_px).is_integer() else ("resampled",)
    return Making(f"one source {np.hypot(y_px, x_px):g} px off, feather 33 px", mix, "feathering", also,
                  lost=True, covered=True, shift=(y_px, x_px))


def _missing(share: float, width: float = 0.0) -> Making:
    name = f"source of {share:.0%} missing" + (f", feather {width:g} px" if width else "")
    also = ("feathering",) if width else ()
    return Making(name, seams.missing(share, width), "missing source", also, covered=True, missing=share)


OTHERS = (
    Making("three sources meet", seams.meeting(0), group="hard", three=True, covered=True),
    Making("three sources meet, feather 33 px", seams.meeting(33), "feathering", lost=True,
           group="33 px and more", three=True, covered=True),
    _balanced("gains 0.8 and 1", KnownTone(0.8), AS_IT_IS),
    _balanced("gains 0.9 and 1.1", KnownTone(0.9), KnownTone(1.1)),
    _balanced("offset 25", KnownTone(1, 25), AS_IT_IS),
    _balanced("gains 0.85 and 1.05", KnownTone(0.85, 10), KnownTone(1.05, -5), width=33),
    _balanced("gamma 0.8 and 1.2", KnownTone(gamma=0.8), KnownTone(gamma=1.2), "gamma"),
    _moved(0.5, 0.0),
    _moved(0.0, 1.0),
    _moved(2.0, 0.0),
    Making("one source blurred 0.8 px", seams.changed({1: after.blurred(0.8)}), "blur"),
    Making("one source resampled, cubic", seams.changed({1: after.resampled(*PHASE, 3)}), "resampled",
           possible=("blur",), offset=PHASE),
    _missing(0.3, 33),
)
"""Alone."""
MISSING = tuple(_missing(share) for share in (0.05, 0.1, 0.15, 0.3, 0.55))
"""Alone, in both halves."""


def _toned(name: str, tone: KnownTone, cause: str, *possible: str) -> Aftermath:
    return Aftermath(name, tone, cause, possible, tone=tone)


NOTHING = Aftermath(NOTHING_NAME, after.nothing)
AFTERMATHS = (
    NOTHING,
    Aftermath("unsharp 0.5", after.unsharp(0.5), "sharpened"),
    Aftermath("unsharp 1", after.unsharp(1.0), "sharpened"),
    *(Aftermath(f"JPEG {quality}", after.jpeg(quality), "compressed") for quality in (50, 65, 75, 85, 95)),
    *(Aftermath(f"noise {sigma} DN", after.noise(sigma), "noise added") for sigma in (2, 4, 6)),
    _toned("gain 0.6", KnownTone(0.6, 20), "narrowed histogram"),
    _toned("gain 0.8", KnownTone(0.8, 15), "narrowed histogram"),
    _toned("gain 1.2", KnownTone(1.2, -15), "none"),
    *(_toned(f"gamma {exponent}", KnownTone(gamma=exponent), "gamma", "narrowed histogram")
      for exponent in (0.6, 0.7, 1.3, 1.6)),
    Aftermath("dodged 0.7 to 1.1", after.dodged(0.7, 1.1), "dodging", ("narrowed histogram",), tone=None),
    Aftermath("dodged round", after.dodged_round(0.75, 1.15), "dodging", ("narrowed histogram",), tone=None),
    Aftermath("flattened", after.flattened(0.8), "dodging", tone=None),
    Aftermath("blur 0.5 px", after.blurred(0.5), "blur"),
    Aftermath("blur 0.8 px", after.blurred(0.8), "blur"),
    Aftermath("resampled, cubic", after.resampled(*PHASE, 3), "resampled", ("blur",), offset=PHASE),
    Aftermath("resampled, bilinear", after.resampled(*PHASE, 1), "resampled", ("blur",), offset=PHASE),
    Aftermath("moved 0.62 px, cubic", after.resampled(0.5, 0.37, 3), "resampled", ("blur",), shift=(0.5, 0.37)),
    Aftermath("moved 0.3 px, cubic", after.resampled(-0.3, 0.0, 3), "resampled", ("blur",), shift=(-0.3, 0.0)),
    Aftermath("gains by channel", after.gains((0.85, 1.0, 0.92)), "colour shift", ("narrowed histogram",), tone=None),
    Aftermath("clipping 3 %", after.nothing, "clipping", fit=after.clipping(0.03), tone=None),
    Aftermath("of 12 bit", after.nothing, depth=12, tone=None),
    Aftermath("of 16 bit", after.nothing, depth=16, tone=None),
)
"""Every second one is held back, from the second on."""

OTHER_MIXTURE = "other mixture"
STRANGE_MAKINGS = (
    Making("darkest of two in 33 px", strange.darkest(33), OTHER_MIXTURE, possible=("feathering",)),
    Making("dissolve over 33 px", strange.dissolved(33), OTHER_MIXTURE, possible=("feathering",)),
    Making("soft brush", strange.brushed, "softened seam", lost=True),
)
STRANGE_AFTERMATHS = (
    Aftermath("JPEG 2000", after.jpeg2000(12), "compressed"),
    Aftermath("WebP 75", after.webp(75), "compressed"),
    Aftermath("median 3 x 3", after.median3, "blur"),
)


def _operations() -> Iterator[Operation]:
    for making in KINDS:
        for number, aftermath in enumerate(AFTERMATHS):
            yield Operation(making, aftermath, _half(number), always=aftermath is NOTHING)
    for number, making in enumerate(OTHERS):
        yield Operation(making, NOTHING, _half(number))
    for making in MISSING:
        yield Operation(making, NOTHING, HALVES[0], always=True)
    for making in STRANGE_MAKINGS:
        yield Operation(making, NOTHING, HALVES[2])
    for making in KINDS:
        for aftermath in STRANGE_AFTERMATHS:
            yield Operation(making, aftermath, HALVES[2])


def _half(number: int) -> str:
    return HALVES[number % 2]


OPERATIONS = tuple(_operations())
