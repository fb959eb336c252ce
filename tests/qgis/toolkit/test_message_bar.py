"""What stands in QGIS's message bar, which cuts what is longer than a line."""
from __future__ import annotations

import pytest
from seam_inspector.plugin.toolkit.desk.message_bar import brief_words

SHORT, FIRST, SECOND = "Eleven were placed.", "It is said in one sentence.", "word " * 30
LONG = "A sentence that has no room beside a button is the first that is told."


@pytest.mark.parametrize(
    ("text", "brief"),
    [(SHORT, SHORT), (f"{FIRST} {SHORT} {SECOND}", f"{FIRST} {SHORT}"), (SECOND, None),
     (f"{FIRST} {SHORT} {FIRST}", f"{FIRST} {SHORT}"), (LONG, LONG), (f"{LONG} {SHORT}", LONG), ("x" * 200, None)],
)
def test_the_bar_has_room_for_a_line_and_the_rest_comes_behind(text: str, brief: str | None) -> None:
    said, rest = brief_words(text)
    assert len(said) <= 92
    assert brief in (None, said)
    assert f"{said.removesuffix(' …')}{rest}".replace(" ", "") == text.replace(" ", "")
