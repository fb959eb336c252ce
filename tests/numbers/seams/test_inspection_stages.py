"""An inspection in two stages: the curves of the clips first, then the same result as in one."""
from __future__ import annotations

import pytest
from seam_inspector.plugin.imagery.grids import Extent
from seam_inspector.plugin.seams.measure.judgement.verdicts import Verdict
from seam_inspector.plugin.seams.measure.window.inspection import (
    Block,
    inspect_in_stages,
    inspect_window,
    window_request,
)
from seam_inspector.plugin.seams.measure.window.measured_window import InspectionSettings
from seam_inspector.plugin.seams.measure.window.window_result import WindowClips, WindowResult
from seam_inspector.plugin.seams.measure.window_records import REFERENCES

from tests.numbers.seams.inspecting import FAR_AWAY, SIZE, WINDOW, MakeRaster, block_of, mosaic_of, softened
from tests.numbers.synthetic import orthoimage


@pytest.fixture
def block(make_raster: MakeRaster) -> Block:
    """A blurred mosaic with two sources."""
    image = orthoimage(SIZE, 1)
    other = orthoimage(SIZE, 2)
    mosaic = mosaic_of(make_raster, softened(image, 0.8))
    return block_of(mosaic, make_raster("a.tif", image), make_raster("b.tif", other))


def extent_of(block: Block) -> Extent:
    return block.mosaic.grid.window_extent(WINDOW)


@pytest.mark.parametrize("reference", REFERENCES)
def test_curves_and_the_papers_verdict_come_first_and_stay(block: Block, reference: str) -> None:
    request = window_request(block, 3, extent_of(block), InspectionSettings(reference=reference))
    first, whole = inspect_in_stages(request)
    assert isinstance(first, WindowClips)
    assert isinstance(whole, WindowResult)
    assert (first.window_id, first.window) == (whole.window_id, whole.window) == (3, WINDOW)
    assert [clip.role for clip in first.clips] == ["mosaic", "source", "source"]
    assert first.clips == whole.clips
    assert first.paper_verdict == whole.paper_verdict
    assert first.judgement.ratios == whole.judgement.ratios
    assert repr(whole) == repr(inspect_window(request))  # an explanation holds arrays, which don't compare


def test_a_window_that_cannot_be_measured_has_its_reason_alone(block: Block) -> None:
    (result,) = inspect_in_stages(window_request(block, 3, FAR_AWAY, InspectionSettings()))
    assert isinstance(result, WindowResult)
    assert result.judgement.verdict is Verdict.NOT_COMPARABLE
    assert result.judgement.reason is not None


def test_what_nobody_foresaw_becomes_the_reason(block: Block) -> None:
    def broken(_request: object) -> None:
        raise ZeroDivisionError("of the test")

    (result,) = inspect_in_stages(window_request(block, 3, extent_of(block), InspectionSettings()), broken)
    assert isinstance(result, WindowResult)
    assert "ZeroDivisionError: of the test" in str(result.judgement.reason)
