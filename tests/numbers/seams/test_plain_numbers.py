"""Results hold no numbers of numpy's own."""
from __future__ import annotations

from dataclasses import fields, is_dataclass

import numpy as np
import pytest

from tests.numbers.seams.inspecting import SIZE, MakeRaster, block_of, inspect, mosaic_of, softened
from tests.numbers.synthetic import orthoimage


def test_a_result_is_of_plain_numbers(make_raster: MakeRaster, monkeypatch: pytest.MonkeyPatch) -> None:
    """Layers, sentences and JSON take no others. Counts are numpy's own from numpy 2.4 on."""
    count = np.count_nonzero
    monkeypatch.setattr(np, "count_nonzero", lambda *given, **how: np.asarray(count(*given, **how))[()])
    image = orthoimage(SIZE)
    block = block_of(mosaic_of(make_raster, softened(image, 1.5)), make_raster("source.tif", image))
    assert numpys_in(inspect(block), "result") == []


def numpys_in(value: object, name: str) -> list[str]:
    """The names of scalars of numpy's within nested results."""
    if isinstance(value, np.generic):
        return [name]
    parts: list[tuple[object, object]] = []
    if is_dataclass(value):
        parts = [(field.name, getattr(value, field.name)) for field in fields(value)]
    elif isinstance(value, (list, tuple)):
        parts = list(enumerate(value))
    return [place for part, held in parts for place in numpys_in(held, f"{name}.{part}")]
