"""Dataclasses as bytes and back; bytes of others become a refusal and nothing else."""
from __future__ import annotations

import os
import pickle
from dataclasses import dataclass, field
from enum import Enum

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from seam_inspector.plugin.imagery.errors import INFO, WARNING, Message
from seam_inspector.plugin.imagery.records import NotUnderstoodError, packed, record_of, value_of

from tests.examples import times

FAR = Message("It lies {metres:.1f} m off, since {why}.", WARNING)
WHY = Message("nobody looked", INFO)
SENTENCES = {sentence.template: sentence for sentence in (FAR, WHY)}


class Colour(str, Enum):
    RED = "red"
    BLUE = "blue"


@dataclass(frozen=True)
class Part:
    name: str
    share: float | None
    colours: tuple[Colour, ...] = ()


@dataclass(frozen=True)
class Whole:
    number: int
    is_sound: bool
    parts: dict[str, Part]
    pair: tuple[int, float]
    reason: Message | None = None
    either: int | str | None = None
    picture: np.ndarray | None = field(default=None, compare=False)


parts = st.builds(Part, st.text(), st.none() | st.floats(allow_nan=False), st.lists(st.sampled_from(Colour)).map(tuple))
reasons = st.none() | st.just(FAR(metres=2.25, why=WHY())) | st.just(FAR(metres=1, why=(WHY(), "rain")))
wholes = st.builds(
    Whole, st.integers(), st.booleans(), st.dictionaries(st.text(), parts, max_size=4),
    st.tuples(st.integers(), st.floats(allow_nan=False)), reasons, st.none() | st.integers() | st.text(),
    st.none() | st.just(np.arange(6.0).reshape(2, 3)),
)  # fmt: skip


@given(wholes)
@times(3)
def test_what_was_recorded_comes_back(whole: Whole) -> None:
    restored = value_of(Whole, record_of(whole), SENTENCES)
    assert restored == whole
    assert str(restored.reason) == str(whole.reason)
    assert restored.reason is None or restored.reason.level == WARNING
    assert (restored.picture is None) == (whole.picture is None)
    if whole.picture is not None:
        np.testing.assert_array_equal(restored.picture, whole.picture)


def test_pictures_come_back_to_a_two_thousandth_and_holes_stay() -> None:
    picture = np.linspace(0.0, 3.0, 1000, dtype=np.float32).reshape(20, 50)
    picture[3, 4] = np.nan
    restored = value_of(Whole, record_of(Whole(1, True, {}, (1, 2.0), picture=picture)), {}).picture
    assert restored.dtype == np.float32
    np.testing.assert_allclose(restored, picture, rtol=5e-4, atol=1e-7)


def json_record(text: str) -> bytes:
    return packed({"json": np.frombuffer(text.encode(), np.uint8)})


SAID = '{"template":"FAR","level":"error","values":VALUES}'.replace("FAR", FAR.template)
RIGHT = '{"number":1,"is_sound":true,"parts":{},"pair":[1,2.0],"reason":null}'


@pytest.mark.parametrize(
    "text",
    [
        RIGHT.replace("1,", '"1",', 1),
        RIGHT.replace("true", "1"),
        RIGHT.replace("[1,2.0]", "[1]"),
        RIGHT.replace("[1,2.0]", "[1,2.0,3]"),
        RIGHT.replace('"number":1,', ""),
        RIGHT.replace('"number"', '"__class__"'),
        RIGHT.replace("null", '{"template":"{x.__class__}","level":"error","values":{"x":1}}'),
        RIGHT.replace("null", SAID.replace("VALUES", '{"metres":"far","why":1}')),
        RIGHT.replace("null", SAID.replace("VALUES", '{"metres":1}')),
        RIGHT[:-1],
        "[]",
        "null",
        "[" * 100_000,
    ],
)
def test_what_does_not_fit_is_refused(text: str) -> None:
    assert value_of(Whole, json_record(RIGHT), SENTENCES) == Whole(1, True, {}, (1, 2.0))
    with pytest.raises(NotUnderstoodError):
        value_of(Whole, json_record(text), SENTENCES)


class Bomb:
    def __reduce__(self) -> tuple[object, ...]:
        return os.system, ("echo no",)


@given(st.binary(max_size=400))
@times(5)
def test_any_bytes_are_refused(record: bytes) -> None:
    with pytest.raises(NotUnderstoodError):
        value_of(Whole, record, SENTENCES)


def test_pickles_and_bombs_are_refused() -> None:
    huge = packed({"json": np.zeros(2**20, np.uint8)}).replace(b"1048576", b"10485_6")
    for record in (pickle.dumps(Bomb()), huge, packed({"json": np.zeros(8, "f8")})):
        with pytest.raises(NotUnderstoodError):
            value_of(Whole, record, SENTENCES)
