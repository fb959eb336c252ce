"""Images that fit or do not fit, as they are given and as they are placed in the mosaic: who is told that they do not.

Both images of a window are made of one orthoimage, so that they truly fit before they are moved: the second has noise
of its own, and detail from elsewhere in a part of the ground.
"""
from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from scipy import ndimage

from . import aftermaths as after
from . import seam_makings as seams
from .campaign import Task
from .figures import figure, median, percent, sides_of
from .known_windows import KnownWindow
from .operations import NOTHING
from .outcomes import Outcome
from .production import Aftermath, Making, Offset, Operation
from .seam_makings import whole_values
from .timing import print_table

PREFIX = "misfit: "
MISREGISTRATION = "misregistration"
WIDTHS = {"cut hard": 0.0, "mixed over 33 px": 33.0}
"""Full widths, px."""
NOISE_DN = 2.0
OTHER_DETAIL = 0.35
"""Share of the ground where the second image has other detail."""
OTHER_DETAIL_PX = (137, 91)
"""From how far that is taken."""
STILL: Offset = (0.0, 0.0)
HALF: Offset = (0.5, 0.5)
MIN_TOLD_PX = 1.0
"""From there on images that were feathered do not fit."""


@dataclass(frozen=True)
class Case:
    """How the second image lies: down and right, px."""

    name: str
    given: Offset = STILL
    """On the first one, pixel by pixel as it is given."""
    back: Offset = STILL
    """What it is moved by in the mosaic."""
    grid: Offset = STILL
    """Its grid beside the mosaic's."""
    aftermath: Aftermath = NOTHING

    @property
    def misfit(self) -> float:
        """Misfit as placed, px."""
        return float(np.hypot(*np.add(self.given, self.back)))

    def making(self, seam: str, width_px: float) -> Making:
        """Cut or feathered after the second image was moved."""
        move = after.resampled(self.back[0], self.back[1], 3)
        mix = seams.changed({} if self.back == STILL else {1: move}, width_px)
        return Making(f"{PREFIX}{self.name}, {seam}", mix, kind=self.name, group=seam, offset=self.grid)

    def window(self, window: KnownWindow) -> KnownWindow:
        """With both images made of the first one's."""
        first, second = window.main
        rng = np.random.default_rng([window.number, window.side])
        sources = list(window.sources[:2])
        bands = sources[first]
        sources[second] = whole_values(after.interpolated(twin(bands, rng), self.given[0], self.given[1], 3))
        return replace(window, sources=tuple(sources), valid=(np.ones(window.labels.shape, bool),) * 2)


CASES = (
    Case("fits"),
    Case("1 px off as placed", (1.0, 0.0)),
    Case("1.4 px off as placed", (-1.0, 1.0)),
    Case("2 px off as placed", (0.0, 2.0)),
    Case("3 px off as placed", (3.0, 0.0)),
    Case("1 px off, corrected", (0.0, 1.0), (0.0, -1.0)),
    Case("3 px off, corrected", (3.0, 0.0), (-3.0, 0.0)),
    Case("grids out of phase", (-0.5, -0.5), HALF, HALF),
    Case("whole mosaic moved by half a pixel",
         aftermath=Aftermath("whole mosaic moved", after.resampled(*HALF, 3), "resampled", shift=HALF)),
)


def twin(bands: np.ndarray, rng: np.random.Generator) -> np.ndarray:
    """Another image of the same ground from the same place: noise of its own, other detail in patches."""
    low = after.smoothed(bands, 2.0)
    elsewhere = np.roll(bands - low, OTHER_DETAIL_PX, (1, 2))
    patches = ndimage.gaussian_filter(rng.standard_normal(bands.shape[1:]), 8.0)
    share = np.clip(4 * (patches - np.quantile(patches, 1 - OTHER_DETAIL)) / patches.std() + 0.5, 0, 1)
    return bands + share * (elsewhere - (bands - low)) + rng.normal(0, NOISE_DN, bands.shape)


def misfit_tasks(windows: Sequence[KnownWindow], count: int, wanted: str = "") -> list[Task]:
    """All cases in the first windows whose images cover them."""
    covered = [window for window in windows if window.is_covered and set(window.main) == {0, 1}][:count]
    return [
        Task(case.window(window), (operation,))
        for window in covered for case in CASES for seam, width_px in WIDTHS.items()
        if wanted in (operation := Operation(case.making(seam, width_px), case.aftermath, "used")).name
    ]


def is_misfit(outcome: Outcome) -> bool:
    """Whether it is one of these cases."""
    return outcome.operation.making.name.startswith(PREFIX)


def is_right(case: Case, causes: Sequence[str]) -> bool:
    """Images that do not fit are to be named, cut or feathered; those that fit are not."""
    return (MISREGISTRATION in causes) is (case.misfit >= MIN_TOLD_PX)


def is_right_case(outcome: Outcome) -> bool:
    """Whether what was read of one of these cases is right."""
    making = outcome.operation.making
    case = next(one for one in CASES if one.name == making.kind)
    return is_right(case, outcome.reading.causes)


def print_misfits(title: str, outcomes: Sequence[Outcome]) -> None:
    """Case by case, hard cuts and feathers."""
    rows = []
    for side in sides_of(outcomes):
        for case in CASES:
            for seam in WIDTHS:
                own = [one for one in outcomes if one.window.side == side and one.operation.making.group == seam
                       and one.operation.making.kind == case.name]
                if own:
                    rows.append([f"{side} px: {case.name}, {seam}", *_cells(case, seam, own)])
        every = [is_right_case(outcome) for outcome in outcomes if outcome.window.side == side]
        rows.append([f"{side} px: all", str(len(every)), percent(every), "", "", "", "", ""])
    head = ["case", "windows", "right %", "named %", "main %", "misfit, px", "true", "main causes"]
    print_table(f"Images that fit or do not fit, {title}", head, rows,
                "Right: misregistration is named where images lie 1 px or more off each other as placed, and not\n"
                "  where they fit.\n"
                "  Misfit: what the plugin says, the median, and how it was made.")


def _cells(case: Case, seam: str, own: Sequence[Outcome]) -> list[str]:
    said = [one.reading.causes for one in own]
    main = Counter(one.reading.cause for one in own)
    return [
        str(len(own)),
        percent(is_right(case, causes) for causes in said),
        percent(MISREGISTRATION in causes for causes in said),
        percent(causes[:1] == (MISREGISTRATION,) for causes in said),
        figure(median(one.reading.misfit for one in own)),
        figure(case.misfit),
        ", ".join(f"{cause} {count}" for cause, count in main.most_common(3)),
    ]
