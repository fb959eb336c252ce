"""What proves a failure: the mosaic beside the orthoimages that it was made from and the cut that it could have been.

Who has the orthoimages is no matter here: the decision knows none, and takes proofs from whoever can give them.
"""
from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Protocol

import numpy as np

from ...imagery.grids import PixelWindow
from ...imagery.rasters import Raster, RasterRef

if TYPE_CHECKING:
    from ...toolkit.algorithms.run import Run

PROOF_PX = 106  # side of what is shown at 2x: three of them stand beside each other on A4
MOSAIC_PANEL, CUT_PANEL, IMAGE_PANEL = "mosaic", "cut", "image"


@dataclass(frozen=True, eq=False)
class ProofPanel:
    """One of the pictures of a place."""

    kind: str  # mosaic, cut (the composite: the same orthoimages cut hard) or image (an orthoimage)
    name: str  # name of the orthoimage's file; empty for the others
    pixels: np.ndarray
    """(rows, columns, 3) uint8, a pixel of the mosaic each; all panels of a place are stretched alike."""


Prover = Callable[[Raster, PixelWindow, tuple[str, str]], Sequence[ProofPanel]]
"""From a mosaic, a part of it, and what the piece in its middle calls the two orthoimages beside it, to the panels of
that part: mosaic, cut and up to two orthoimages; empty where no orthoimage shows it."""


class Proving(Protocol):
    """Who knows the orthoimages and proves failures: the algorithm."""

    def orthoimages(self, run: Run, scanned: Sequence[str], mosaics: Sequence[Raster]) -> tuple[RasterRef, ...]:
        """What the mosaics were made from: as given, else as the scan says (``scanned``, paths)."""

    def prover(self) -> Prover | None:
        """Who proves failures, once ``orthoimages`` was asked; None where nobody does."""
