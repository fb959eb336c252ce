"""Which sources meet a rectangle, among very many."""
from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from seam_inspector.plugin.imagery.grids import Extent
from seam_inspector.plugin.imagery.rasters import RasterRef
from seam_inspector.plugin.seams.measure import messages, source_images
from seam_inspector.plugin.seams.measure.source_images import Source, SourceTree, gather_sources, sources_in

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
    tree = SourceTree(sources)
    assert tree.meeting(asked) == sources_in(sources, asked)
    assert [sources[number] for number in tree.numbers_meeting(asked)] == list(sources_in(sources, asked))


def test_footprints_that_are_no_numbers_meet_nothing_and_endless_ones_everything() -> None:
    nan, inf = float("nan"), float("inf")
    sources = [source(n, extent) for n, extent in enumerate([(nan,) * 4, (-inf, -inf, inf, inf), (0, 0, 1, 1)])]
    assert SourceTree(sources).numbers_meeting((0, 0, 2, 2)) == [1, 2]


def test_without_sources_nothing_is_found() -> None:
    assert SourceTree([]).meeting((0, 0, 1, 1)) == ()


@pytest.mark.slow
def test_of_a_hundred_thousand_footprints_few_are_looked_at(monkeypatch: pytest.MonkeyPatch) -> None:
    """A national block: frames of 1.2 km every 400 m, and ten sheets that cover all of it."""
    rng = np.random.default_rng(1)
    left, bottom = np.meshgrid(np.arange(400) * 400.0, np.arange(250) * 400.0)
    corners = np.stack([left.ravel(), bottom.ravel()], axis=1) + rng.normal(0, 50, (100_000, 2))
    rng.shuffle(corners)
    sources = [source(n, (x, y, x + 1200, y + 1200)) for n, (x, y) in enumerate(corners.tolist())]
    sources += [source(100_000 + n, (-1e4, -1e4, 2e5, 2e5)) for n in range(10)]
    assert calls_of(lambda: SourceTree(sources)) < 10_000  # packed together, not one by one
    tree, looked_at, meet = SourceTree(sources), 0, source_images._meet

    def counted(rectangles: np.ndarray, extent: Extent) -> np.ndarray:
        nonlocal looked_at
        looked_at += rectangles.size // 4
        return meet(rectangles, extent)

    monkeypatch.setattr(source_images, "_meet", counted)
    places = rng.uniform((0, 0), (160_000, 100_000), (1000, 2)).tolist()
    found = [tree.numbers_meeting((x, y, x + 512, y + 512)) for x, y in places]
    assert [tree.sources[n] for n in found[0]] == list(sources_in(sources, (*places[0], *(p + 512 for p in places[0]))))
    assert looked_at / len(places) < 5000


def test_addresses_are_gathered_as_they_are_read_in_parts_and_once() -> None:
    named = [source(0, (0, 0, 1, 1)), *(Source(RasterRef(path), (0, 0, 1, 1)) for path in (
        "https://a.example/b.tif", "/vsicurl/https://a.example/b.tif", "https://a.example/mosaic.tif"
    ))]
    kept, notices = gather_sources((), named, "", RasterRef("/vsicurl/https://a.example/mosaic.tif"))
    assert [one.ref.path for one in kept] == ["0.tif", "/vsicurl/https://a.example/b.tif"]
    assert [one.template for one in notices] == [messages.MOSAIC_AMONG_SOURCES.template]
