"""``acceptmosaic`` with proof: of each failure the same place in the orthoimages that the mosaic was made from.

The decision knows no orthoimages and the inspection no decisions; here the two meet.
"""
from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

from .acceptance.acceptmosaic import AcceptMosaic
from .imagery.grids import PixelWindow
from .seams.algorithms.block_parameters import gathered_sources, given_sources
from .toolkit.algorithms import parameters as common

if TYPE_CHECKING:
    import numpy as np

    from .acceptance.paper.defect_files import ProofPanel, Prover
    from .imagery.rasters import Raster
    from .seams.measure.source_images import Source
    from .seams.measure.window.inspection import Block
    from .seams.measure.window.measured_window import WindowRequest
    from .toolkit.algorithms.run import Run

_MOST_IMAGES = 2
_AROUND_PX = 416, 272, 176, 120  # sides of ground that tells which orthoimage is followed where: less where pixels lack


class ProvenAcceptMosaic(AcceptMosaic):
    """Shows the middle of the piece that kept least of each failure beside its orthoimages."""

    def prepare_run(self, run: Run) -> None:
        super().prepare_run(run)
        self._given = given_sources(run)

    def proof(
        self, run: Run, scanned: Sequence[str], mosaics: Sequence[Raster]
    ) -> tuple[Sequence[str], Prover | None]:
        from .imagery.rasters import RasterRef
        from .seams.measure.window.inspection import Block
        from .toolkit.layers import mosaic_crs

        given = self._given
        if not (given.refs or run.parameters.get(common.SOURCE_INDEX)):
            given = replace(given, refs=tuple(map(RasterRef, scanned)))
        if not (mosaics and (given.refs or run.parameters.get(common.SOURCE_INDEX))):
            return super().proof(run, scanned, mosaics)
        sources = tuple(gathered_sources(run, given, mosaic_crs(mosaics[0]), mosaics[0].wkt))

        def prove(mosaic: Raster, part: PixelWindow, sides: tuple[str, str]) -> Sequence[ProofPanel]:
            return proof_panels(Block(mosaic, sources), part, sides) if mosaic.wkt == mosaics[0].wkt else ()

        return [source.ref.path for source in sources], prove if sources else None


def proof_panels(block: Block, part: PixelWindow, sides: tuple[str, str]) -> Sequence[ProofPanel]:
    """A part of the mosaic, of its orthoimages and of their cut, by what is measured around it; empty where no
    orthoimage shows it.

    ``sides``: what the two orthoimages beside the seam are called; those of other names that lie there are left out
    where both are found.
    """
    from .seams.measure.window.inspection import InspectionSettings, window_request

    grid = block.mosaic.grid
    panels: tuple[ProofPanel, ...] = ()
    for side_px in _AROUND_PX:
        around = part.with_margin((side_px - part.width) // 2).moved_into(grid.columns, grid.rows)
        extent = grid.window_extent(around.cut_to(grid.columns, grid.rows))
        request = window_request(block, 1, extent, InspectionSettings())
        window, sources = request.window, _beside(request.sources, sides)
        if window is None or not sources or min(map(min, window.margins_of(part))) < 0:
            continue
        place = part.row - window.row, part.column - window.column, part.width, part.height
        panels = max(panels, tuple(_panels(replace(request, sources=sources), place)), key=len)
        if len(panels) > 1 + min(len(sources), _MOST_IMAGES):  # with the cut
            break
    return panels if len(panels) > 1 else ()


def _beside(sources: Sequence[Source], sides: tuple[str, str]) -> tuple[Source, ...]:
    from .seams.measure.seam_cells import source_stem

    wanted = {source_stem(name) for name in sides if name}
    named = {source: stem for source in sources if (stem := source_stem(source.ref.name)) in wanted}
    return tuple(named) if len({*named.values()}) == _MOST_IMAGES else tuple(sources)


def _panels(request: WindowRequest, part: tuple[int, int, int, int]) -> Iterator[ProofPanel]:
    """Panels of a part, given by row, column, width and height in the window."""
    from .acceptance.paper.defect_files import CUT_PANEL, IMAGE_PANEL, MOSAIC_PANEL, ProofPanel
    from .imagery.limits import has_colours
    from .seams.clip_pictures import make_pictures
    from .seams.measure.window.explained_window import window_composite
    from .toolkit.pictures import brightness

    pictures, ranges = make_pictures(request)
    if not pictures or not pictures[0].is_mosaic:
        return
    mosaic, *images = pictures
    yield ProofPanel(MOSAIC_PANEL, "", _part(mosaic.pixels, part))
    images = sorted(sorted(images, key=lambda image: -image.covered)[:_MOST_IMAGES], key=lambda image: image.raster)
    if isinstance(composite := window_composite(request), tuple):
        cut = brightness(composite[1][: 3 if has_colours(composite[0]) else 1], ranges)
        shown = [_part(pixels, part) for pixels in (cut, *(image.pixels for image in images))]
        least = [min(pixels.std(axis=axis).min() for axis in (0, 1)) for pixels in shown]
        if least[0] > 0.5 * min(least[1:], default=0):  # it is levelled, and flat where the mosaic follows nothing
            yield ProofPanel(CUT_PANEL, "", shown[0])
    for image in images:
        yield ProofPanel(IMAGE_PANEL, image.raster, _part(image.pixels, part))


def _part(pixels: np.ndarray, part: tuple[int, int, int, int]) -> np.ndarray:
    row, column, width, height = part
    return pixels[row : row + height, column : column + width]
