"""Rasters that are taken for the sources of a mosaic, by their headers."""
from __future__ import annotations

from dataclasses import replace

from seam_inspector.plugin.seams.measure import messages
from seam_inspector.plugin.seams.measure.inputs.raster_facts import RasterFacts, likely_mosaic, suitable_by_header

MOSAIC = RasterFacts("mosaic", "mosaic", (0, 0, 100, 100), 0.1, 3, "8 bit", True)
SOURCE = replace(MOSAIC, key="a", extent=(-5, 0, 60, 70))


def test_headers_tell_what_can_not_be_a_source() -> None:
    others = {
        "apart": replace(SOURCE, extent=(100, 0, 160, 70)),
        "nowhere": replace(SOURCE, extent=None),
        "heights": replace(SOURCE, bands=1),
        "half": replace(SOURCE, pixel_size=0.2),
        "fine": replace(SOURCE, pixel_size=0.02),
        "converted": replace(SOURCE, pixel_type="16 bit"),
        "moved": replace(SOURCE, has_mosaic_system=False),
        "whole": replace(SOURCE, extent=(-5, -5, 110, 110)),
        "edition": replace(SOURCE, extent=(-1, 0, 100, 101)),
        "itself": replace(MOSAIC, is_mosaic=True),
    }
    rasters = [SOURCE, replace(SOURCE, key="b"), replace(SOURCE, key="finer", pixel_size=0.05)]
    suitable = suitable_by_header(MOSAIC, [*rasters, *(replace(other, key=key) for key, other in others.items())])
    assert [key for key, reason in suitable.items() if reason is None] == ["a", "b", "finer"]
    reasons = {key: reason.template for key, reason in suitable.items() if reason is not None}
    assert reasons == {
        "apart": messages.APART_FROM_MOSAIC.template,
        "nowhere": messages.APART_FROM_MOSAIC.template,
        "heights": messages.OTHER_BANDS.template,
        "half": messages.LARGER_PIXELS.template,
        "fine": messages.SMALLER_PIXELS.template,
        "converted": messages.OTHER_TYPE.template,
        "moved": messages.OTHER_SYSTEM.template,
        "whole": messages.COVERS_MOSAIC.template,
        "edition": messages.COVERS_MOSAIC.template,
        "itself": messages.IS_THE_MOSAIC.template,
    }


def test_sources_that_were_all_converted_stay() -> None:
    moved = [replace(SOURCE, key=key, has_mosaic_system=False, pixel_type="16 bit") for key in "ab"]
    assert not any(suitable_by_header(MOSAIC, moved).values())


def test_what_covers_the_mosaic_is_left_out_unless_most_others_do() -> None:
    covering = [replace(MOSAIC, key=key) for key in ("copy", "edition")]
    rasters = [replace(SOURCE, key=key) for key in "abc"]
    suitable = suitable_by_header(MOSAIC, [*rasters, *covering])
    assert [key for key, reason in suitable.items() if reason] == ["copy", "edition"]
    assert {reason for reason in suitable.values() if reason} == {messages.COVERS_MOSAIC()}
    assert not any(suitable_by_header(MOSAIC, [*rasters[:2], *covering]).values())


def test_one_mosaic_with_sources_is_likely_and_two_are_not() -> None:
    sources = [SOURCE, replace(SOURCE, key="b", extent=(40, 20, 104, 100))]
    assert likely_mosaic([*sources, MOSAIC, replace(MOSAIC, key="dem", bands=1, pixel_size=1.0)]) == "mosaic"
    assert likely_mosaic([*sources, MOSAIC, replace(MOSAIC, key="other")]) is None
    assert likely_mosaic(sources) is None
    close = [replace(SOURCE, key=str(step), extent=(step, step, 60 + step, 60 + step)) for step in (0, 5, 10, 40)]
    assert likely_mosaic([*close, MOSAIC]) == "mosaic"
    assert likely_mosaic(close) is None
