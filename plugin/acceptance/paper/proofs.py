"""What proves a failure: the mosaic beside the orthoimages that it was made from and the cut that it could have been.

Who measures it is no matter here: the decision knows no orthoimages, and takes a proof from whoever can give one.
"""
from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Protocol

import numpy as np

from ...imagery.grids import Extent, PixelWindow
from ...imagery.rasters import Raster, RasterRef

if TYPE_CHECKING:
    from ...toolkit.algorithms.run import Run

PROOF_SIDE_M = 40.0
"""Side of the place where least is kept, of which the proof is."""
LEAST_PIECE_PX = 96
"""Side of what its profile is measured in, at least."""
PROOF_PX = 160
"""Side of the part that is shown at 2x: two of them fit beside each other on A4, and four on a page."""
MOSAIC_PANEL, CUT_PANEL, IMAGE_PANEL = "mosaic", "cut", "image"


@dataclass(frozen=True, eq=False)
class ProofPanel:
    """One of the pictures."""

    kind: str
    """``mosaic``, ``cut`` (the composite: the same orthoimages cut hard) or ``image`` (an orthoimage)."""
    name: str
    """Name of the orthoimage's file; empty for the others."""
    pixels: np.ndarray
    """(rows, columns, 3) uint8, a pixel of the mosaic each; all panels of a proof are stretched alike."""


@dataclass(frozen=True, eq=False)
class Proof:
    """The part where most was lost, in all rasters, and what is kept by distance from the seam."""

    panels: tuple[ProofPanel, ...]
    """The mosaic first, then the cut, then up to two orthoimages."""
    part: PixelWindow
    """What the panels show, pixels of the mosaic."""
    profile_svg: str = ""
    """The seam profile of the piece that kept least; empty where none can be told."""


Prover = Callable[[Raster, Extent, Extent, tuple[str, str]], "Proof | None"]
"""From a mosaic, a place and the piece of seam in its middle, both in the mosaic's reference system, and what the piece
calls the two orthoimages beside it, to the proof; None where there is none."""


class Proving(Protocol):
    """Who knows the orthoimages and proves failures: the algorithm."""

    def orthoimages(self, run: Run, scanned: Sequence[str], mosaics: Sequence[Raster]) -> tuple[RasterRef, ...]:
        """What the mosaics were made from: as given, else as the scan says (``scanned``, paths)."""

    def prover(self, run: Run, min_kept: float) -> Prover | None:
        """Who proves failures, once ``orthoimages`` was asked; None where nobody does."""
