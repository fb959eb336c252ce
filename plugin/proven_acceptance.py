"""``acceptmosaic`` with proof: of each failure the window that the seams' own subject measures there.

The decision knows no orthoimages and the inspection no decisions; here the two meet.
"""
from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

from .acceptance.acceptmosaic import AcceptMosaic
from .seams.algorithms.block_parameters import gathered_sources, given_sources
from .toolkit.algorithms import parameters as common

if TYPE_CHECKING:
    import numpy as np

    from .acceptance.paper.proofs import Proof, ProofPanel, Prover
    from .imagery.grids import Extent
    from .imagery.rasters import Raster, RasterRef
    from .seams.measure.inspection import Block
    from .seams.measure.source_images import Source
    from .seams.measure.window.window_request import WindowRequest
    from .seams.measure.window.window_result import WindowResult
    from .toolkit.algorithms.run import Run

_MOST_IMAGES = 2
_PROFILE_PX = 290, 210  # 70 mm on paper with letters of 8 points


class ProvenAcceptMosaic(AcceptMosaic):
    """Measures the 40 m of each failure where least is kept."""

    def prepare(self, run: Run) -> None:
        super().prepare(run)
        self._given = given_sources(run)

    def orthoimages(self, run: Run, scanned: Sequence[str], mosaics: Sequence[Raster]) -> tuple[RasterRef, ...]:
        if not mosaics:
            return super().orthoimages(run, scanned, mosaics)
        from .imagery.rasters import RasterRef

        given = self._given
        if not (given.refs or run.parameters.get(common.SOURCE_INDEX)):
            given = replace(given, refs=tuple(map(RasterRef, scanned)))
            if not given.refs:
                return ()
        from .toolkit.layers import mosaic_crs

        first = mosaics[0]
        self._sources = gathered_sources(run, given, mosaic_crs(first), first.wkt)
        self._wkt = first.wkt
        return tuple(one.ref for one in self._sources)

    def prover(self, run: Run, min_kept: float) -> Prover | None:
        sources: Sequence[Source] = getattr(self, "_sources", ())
        if not sources:
            return None

        def prove(mosaic: Raster, extent: Extent, piece: Extent, sides: tuple[str, str]) -> Proof | None:
            from .seams.measure.inspection import Block

            block = Block(mosaic, tuple(sources))
            return proof_of(block, extent, piece, sides, min_kept) if mosaic.wkt == self._wkt else None

        return prove


def proof_of(block: Block, extent: Extent, piece: Extent, sides: tuple[str, str], min_kept: float) -> Proof | None:
    """The part of a place where most was lost, in the mosaic, its orthoimages and their cut; of the piece alone where
    the place can't be measured, as beside pixels without data, and its middle where neither can. None where no
    orthoimage shows the place.

    ``piece``: what holds the piece of seam that failed, of which the profile is: sound seams lie around it.
    ``sides``: what the two orthoimages beside the seam are called; those of other names that lie there are left out
    where both are found.
    """
    from .acceptance.paper.proofs import PROOF_PX, Proof
    from .seams.measure.inspection import InspectionSettings, inspect_window, window_request
    from .seams.report.clip_parts import PlacedLoss, most_lost

    settings = InspectionSettings(min_kept=min_kept)
    request, of_piece = (
        replace(one, sources=_beside(one.sources, sides))
        for one in (window_request(block, 1, place, settings) for place in (extent, piece))
    )
    result, measured = map(inspect_window, (request, of_piece))
    if result.loss is None and measured.loss is not None:
        request, result = of_piece, measured
    window = request.window
    if window is None or not request.sources:
        return None
    side = min(PROOF_PX, window.width, window.height)
    row, column = (window.height - side) // 2, (window.width - side) // 2
    if result.loss is not None and result.window is not None:
        row, column = most_lost(window, PlacedLoss(result.window, result.loss), side)
    panels = tuple(_panels(request, (row, column, side)))
    part = replace(window, column=window.column + column, row=window.row + row, width=side, height=side)
    return Proof(panels, part, _profile(measured, min_kept)) if len(panels) > 1 else None


def _beside(sources: Sequence[Source], sides: tuple[str, str]) -> tuple[Source, ...]:
    from .seams.measure.seam_cells import source_stem

    wanted = {source_stem(name) for name in sides if name}
    named = tuple(one for one in sources if source_stem(one.ref.name) in wanted)
    return named if len({source_stem(one.ref.name) for one in named}) == _MOST_IMAGES else tuple(sources)


def _panels(request: WindowRequest, part: tuple[int, int, int]) -> Iterator[ProofPanel]:
    """Panels of a part, given by row, column and side in the window."""
    from .acceptance.paper.proofs import CUT_PANEL, IMAGE_PANEL, MOSAIC_PANEL, ProofPanel
    from .imagery.limits import has_colours
    from .seams.clip_pictures import make_pictures
    from .seams.measure.window.explained_window import WindowComposite, window_composite
    from .toolkit.picture_stretch import brightness

    pictures, ranges = make_pictures(request)
    if not pictures or not pictures[0].is_mosaic:
        return
    mosaic, *images = pictures
    yield ProofPanel(MOSAIC_PANEL, "", _part(mosaic.pixels, part))
    composite = window_composite(request)
    if isinstance(composite, WindowComposite):
        shown = composite.bands[: 3 if has_colours(composite.names) else 1]
        yield ProofPanel(CUT_PANEL, "", _part(brightness(shown, ranges), part))
    images.sort(key=lambda one: -one.covered)
    for image in sorted(images[:_MOST_IMAGES], key=lambda one: one.raster):
        yield ProofPanel(IMAGE_PANEL, image.raster, _part(image.pixels, part))


def _part(pixels: np.ndarray, part: tuple[int, int, int]) -> np.ndarray:
    row, column, side = part
    return pixels[row : row + side, column : column + side]


def _profile(result: WindowResult, min_kept: float) -> str:
    from .seams.charts.profile_painter import ShownProfile
    from .seams.report.window_charts import profile_svg

    if result.profile is None:
        return ""
    shown = ShownProfile(result.profile, result.ground_sample_distance, min_kept, frozenset({1}))
    return profile_svg(shown, _PROFILE_PX)
