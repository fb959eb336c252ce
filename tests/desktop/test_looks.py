"""What the desk looks like in the real QGIS desktop, by theme, scaling, screen and language. Figures: `pytest -s`."""
from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from demo.desktop import play
from tests.desktop.conftest import SCENARIOS, check, say

pytestmark = pytest.mark.slow

SIDE_M = 25.0  # 256 px of the block
READABLE = 3.0  # contrast of words, by WCAG 2.1 what large ones need; themes of QGIS's own hardly give more


@pytest.mark.parametrize(
    ("name", "options"),
    [
        ("light", {}),
        ("dark", {"theme": "Night Mapping", "screen": "1366x768"}),
        ("scaled", {"scale": 2, "screen": "3200x2000"}),
        ("polish", {"screen": "1366x768", "locale": "pl"}),
    ],
)
def test_looks(name: str, options: dict[str, Any], small_block: Path, tmp_path: Path, screenshots: Path) -> None:
    """Right of the map and below it: nothing is cut off, all can be read, and the keyboard gets everywhere."""
    parameters = {"block": str(small_block), "side_m": SIDE_M, "screenshots": str(screenshots), "name": name}
    run = play(SCENARIOS / "looks.py", tmp_path, parameters, **options)
    say(f"looks, {name}", run.seconds, run.report)
    check(run)
    assert run.report["right_size"][0] <= 440
    assert run.report["inputs_cut"] == []
    for place in ("right", "right_images", "below", "below_images"):
        for defect in ("cut", "headings_cut", "no_tooltip", "steps_up", "no_focus_mark"):
            assert run.report[f"{place}_{defect}"] == [], f"{defect}, {place}"
        assert run.report[f"{place}_table_overflow"] == 0, place
        assert run.report[f"{place}_chart"] >= 150, place
        assert run.report[f"{place}_judge_whole"], place
        contrasts = run.report[f"{place}_contrasts"]
        what = {words.split()[0] for words in contrasts}
        own = {"images": set()}.get(place.partition("_")[2], {"legend"})
        assert what >= {"heading", "label", "button", *own}
        assert {words: ratio for words, ratio in contrasts.items() if ratio < READABLE} == {}, place
