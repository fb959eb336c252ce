"""Sources that meet a rectangle, among very many."""
from __future__ import annotations

from hypothesis import given
from hypothesis import strategies as st
from seam_inspector.plugin.imagery.grids import Extent, extents_meet
from seam_inspector.plugin.imagery.rasters import RasterRef
from seam_inspector.plugin.seams.measure import messages
from seam_inspector.plugin.seams.measure.source_images import Footprints, Source, gather_sources

from tests.work import calls_of


def source(number: int, extent: Extent) -> Source:
    return Source(RasterRef(f"{number}.tif"), extent)


@st.composite
def rectangles(draw: st.DrawFn) -> Extent:
    """On a coarse grid, so that borders touch, from points to ones that hold all others."""
    x, y = draw(st.integers(-20, 20)), draw(st.integers(-20, 20))
    size = st.integers(0, draw(st.sampled_from([1, 3, 100])))
    return (x, y, x + draw(size), y + draw(size))


@given(st.lists(rectangles(), max_size=300), rectangles())
def test_it_finds_what_looking_at_every_one_finds_in_the_same_order(given: list[Extent], asked: Extent) -> None:
    sources = [source(number, extent) for number, extent in enumerate(given)]
    assert [sources[number] for number in Footprints(sources).meeting(asked)] == [
        met for met in sources if extents_meet(met.extent, asked)
    ]


def test_footprints_that_are_no_numbers_meet_nothing_and_endless_ones_everything() -> None:
    nan, inf = float("nan"), float("inf")
    sources = [source(n, extent) for n, extent in enumerate([(nan,) * 4, (-inf, -inf, inf, inf), (0, 0, 1, 1)])]
    assert Footprints(sources).meeting((0, 0, 2, 2)) == [1, 2]


def test_of_many_footprints_all_are_looked_at_at_once() -> None:
    sources = [source(n, (n, 0, n + 1, 1)) for n in range(10_000)]
    footprints = Footprints(sources)
    assert calls_of(lambda: footprints.meeting((5.5, 0, 7.5, 1))) < 50
    assert footprints.meeting((5.5, 0, 7.5, 1)) == [5, 6, 7]


def test_addresses_are_gathered_as_they_are_read_in_parts_and_once() -> None:
    named = [source(0, (0, 0, 1, 1)), *(Source(RasterRef(path), (0, 0, 1, 1)) for path in (
        "https://a.example/b.tif", "/vsicurl/https://a.example/b.tif", "https://a.example/mosaic.tif"
    ))]
    kept, notices = gather_sources((), named, "", RasterRef("/vsicurl/https://a.example/mosaic.tif"))
    assert [source.ref.path for source in kept] == ["0.tif", "/vsicurl/https://a.example/b.tif"]
    assert [notice.template for notice in notices] == [messages.MOSAIC_AMONG_SOURCES.template]
