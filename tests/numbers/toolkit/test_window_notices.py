"""What is told of many windows: a sentence of each kind, with the windows' numbers."""
from __future__ import annotations

from seam_inspector.plugin.imagery.errors import INFO, WARNING, Message
from seam_inspector.plugin.toolkit.algorithms.window_notices import WindowNotices

PART = Message("{name} covers {share} %.", INFO)
NOTHING = Message("Nothing covers the window.", WARNING)
WHY = Message("Can't be compared: {why}", INFO)


def texts(*notices: tuple[int, list[Message | None]]) -> list[str]:
    gathered = WindowNotices()
    for window, said in notices:
        gathered.add(window, said)
    return [str(message) for message in gathered.messages()]


def test_one_window_is_named_in_its_sentence() -> None:
    assert texts((7, [NOTHING, None])) == ["Window 7: Nothing covers the window."]


def test_the_same_of_many_windows_is_said_once() -> None:
    assert texts(*((number, [NOTHING]) for number in (1, 2, 3, 5, 9, 8))) == [
        "In 6 windows (1\u20133, 5, 8\u20139), such as 1: Nothing covers the window."
    ]


def test_other_values_are_the_same_kind_and_the_first_stands_for_them() -> None:
    assert texts((4, [PART(name="a", share=10), PART(name="b", share=20)]), (5, [PART(name="a", share=30)])) == [
        "In 2 windows (4\u20135), such as 4: a covers 10 %."
    ]


def test_a_reason_within_makes_another_kind() -> None:
    assert len(texts((1, [WHY(why=NOTHING)]), (2, [WHY(why=PART(name="a", share=1))]), (3, [WHY(why=NOTHING)]))) == 2


def test_ten_thousand_windows_make_a_short_line_that_keeps_its_level() -> None:
    gathered = WindowNotices()
    for number in range(1, 20000, 2):
        gathered.add(number, [NOTHING])
    (line,) = gathered.messages()
    assert line.level is WARNING
    assert str(line).startswith("In 10000 windows (1, 3, 5, ")
    assert len(str(line)) < 150


def test_every_line_begins_with_a_word() -> None:
    for line in texts((1, [NOTHING]), (2, [PART(name="a", share=1)]), (3, [PART(name="b", share=1)])):
        assert line[0].isalpha()
