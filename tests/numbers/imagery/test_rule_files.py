"""What all rules files share, and what is said of those that are wrong."""
from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest
from seam_inspector.plugin.imagery import documents
from seam_inspector.plugin.imagery.documents import RuleObject, read_rules, ready_rules
from seam_inspector.plugin.imagery.errors import SettingsError


def read(folder: Path, content: Any) -> tuple[RuleObject, list[RuleObject]]:
    path = folder / "rules.json"
    path.write_bytes(content if isinstance(content, bytes) else json.dumps(content).encode())
    return read_rules(path, lambda whole, rules: (whole, rules))


def test_an_object_gives_what_stands_in_it(tmp_path: Path) -> None:
    whole, (one,) = read(tmp_path, {"name": "ours", "rules": [
        {"check": "a", "least": 0.1, "most": 2, "source": "contract", "count": 3, "required": False}]})
    assert whole.content["name"] == "ours"
    assert one.limits() == (0.1, 2.0)
    assert one.number("other") is None
    assert (one.whole("count", 5), one.whole("other", 5)) == (3, 5)
    assert (one.flag("required", True), one.flag("other", True)) == (False, True)
    assert (one.word("check", ["a", "b"]), one.source()) == ("a", "contract")


class Key(str):
    """Counts how often keys are compared."""

    compared = 0

    def __eq__(self, other: object) -> bool:
        Key.compared += 1
        return super().__eq__(other)

    __hash__ = str.__hash__


def test_very_many_keys_are_not_compared_with_each_other() -> None:
    pairs = [(Key(number), 0) for number in range(20_000)]
    assert len(documents._object("rules.json", pairs)) == len(pairs)
    assert Key.compared < len(pairs)


@pytest.mark.parametrize("text", ["[" * 200_000, "9" * 100_000, f"[-{9}]".replace("9", "9" * 401)])
def test_what_is_nested_or_counted_beyond_sense_is_a_sentence(tmp_path: Path, text: str) -> None:
    with pytest.raises(SettingsError, match=r"are no JSON \(see line"):
        read(tmp_path, text.encode())


def test_a_byte_order_mark_is_no_fault(tmp_path: Path) -> None:
    assert read(tmp_path, b"\xef\xbb\xbf" + json.dumps({"rules": [{}]}).encode())[0].file == "rules.json"


@pytest.mark.parametrize(
    ("rule", "words"),
    [
        ({"kind": 3}, "Rule 1 in rules.json has the unknown key 'kind'; known are check, least, most, source, count."),
        ({"check": ["a"]}, r"has the unknown check '\['a'\]'; known are a, b."),
        ({"check": "c"}, "has the unknown check 'c'; known are a, b."),
        ({"least": "10 %"}, "'least' has to be a number of 0 or more"),
        ({"least": True}, "'least' has to be a number of 0 or more"),
        ({"most": -1}, "'most' has to be a number of 0 or more"),
        ({"least": 2, "most": 1}, "'least' is larger than 'most'"),
        ({"count": 0}, "'count' has to be a whole number of 1 or more"),
        ({"count": 1.5}, "'count' has to be a whole number of 1 or more"),
        ({"source": " "}, "has no 'source'"),
    ],
)
def test_what_is_wrong_is_named_with_its_place(tmp_path: Path, rule: dict[str, Any], words: str) -> None:
    _, (one,) = read(tmp_path, {"rules": [{"check": "a", "source": "s", **rule}]})

    def ask() -> None:
        one.allow(["check", "least", "most", "source", "count"])
        one.word("check", ["a", "b"])
        one.limits()
        one.whole("count", 1)
        one.source()

    with pytest.raises(SettingsError, match=words):
        ask()


@pytest.mark.parametrize("content", [b"[" * 100_000, b"[]", b'{"rules": {}}', b'{"rules": []}', b'{"rules": [1]}'])
def test_what_holds_no_rules_is_refused(tmp_path: Path, content: bytes) -> None:
    with pytest.raises(SettingsError, match=r"holds no rules|are no JSON"):
        read(tmp_path, content)


def test_ready_files_are_found_by_their_names() -> None:
    assert {"jrc_lpis", "jrc_lpis_each_band"} <= set(ready_rules("radiometry"))
    assert ready_rules("nobody") == {}
