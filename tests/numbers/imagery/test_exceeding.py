"""A share that is over its limit is written so that it is seen to be."""
from __future__ import annotations

import pytest
from seam_inspector.plugin.imagery.errors import Stated
from seam_inspector.plugin.imagery.messages import TOO_MANY_INVALID


@pytest.mark.parametrize(
    ("share", "text"),
    [(0.2, "20.00%"), (0.00123, "0.12%"), (0.00104, "0.104%"), (0.0010004, "0.10004%")],
)
def test_as_many_decimals_as_it_takes(share: float, text: str) -> None:
    said = str(TOO_MANY_INVALID(name="a.tif", share=Stated(share, 0.001), most=0.001))
    assert said.startswith(f"{text} of the pixels of a.tif are invalid in the window and 0.1% are allowed")


def test_it_is_a_number_like_others() -> None:
    made = Stated(0.5, 0.25)
    assert made == 0.5
    assert f"{made} {made:g} {made:.1f}" == "0.5 0.5 0.5"
