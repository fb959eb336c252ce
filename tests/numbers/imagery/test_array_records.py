"""Arrays as bytes and back."""
from __future__ import annotations

import numpy as np
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra.numpy import array_shapes, arrays
from seam_inspector.plugin.imagery.records import packed, unpacked

kinds = st.sampled_from(["?", "u1", "<i4", "<i8", "<f4", "<f8"])
shapes = array_shapes(min_dims=0, max_dims=4, min_side=0, max_side=6)
any_array = kinds.flatmap(lambda kind: arrays(np.dtype(kind), shapes))


@given(st.dictionaries(st.text(min_size=1, max_size=8), any_array, max_size=6))
def test_what_was_packed_comes_back_bit_for_bit(given_arrays: dict[str, np.ndarray]) -> None:
    read = unpacked(packed(given_arrays))
    assert list(read) == list(given_arrays)
    for name, array in given_arrays.items():
        assert read[name].dtype == array.dtype
        assert read[name].shape == array.shape
        assert read[name].tobytes() == np.ascontiguousarray(array).tobytes()


def test_parts_of_arrays_and_other_orders_are_what_they_show() -> None:
    values = np.arange(24.0).reshape(4, 6)
    shown = {"turned": values.T, "part": values[1:3, ::2], "fortran": np.asfortranarray(values)}
    read = unpacked(packed(shown))
    for name, array in shown.items():
        assert (read[name] == array).all()
