"""Rules files: what they may say, and what is said of those that are wrong."""
from __future__ import annotations

import json
import re
from pathlib import Path
from typing import Any

import pytest
from seam_inspector.plugin.imagery.errors import SettingsError
from seam_inspector.plugin.radiometry.measure.rules import (
    CHECKS,
    FROM_HISTOGRAM,
    Rule,
    RuleSet,
    load_rules,
    ready_rule_files,
)

from tests.numbers.radiometry.judging import default_rules

GOOD: dict[str, Any] = {"check": "contrast", "least": 0.1, "most": 0.2, "source": "contract 7"}


def load(folder: Path, content: Any) -> RuleSet:
    path = folder / "rules.json"
    path.write_text(content if isinstance(content, str) else json.dumps(content), encoding="utf-8")
    return load_rules(path)


def test_the_default_is_the_jrc_specification() -> None:
    rules = default_rules()
    assert [rule.check for rule in rules.rules] == list(CHECKS)
    limits = {rule.check: (rule.least, rule.most) for rule in rules.rules}
    assert limits == {
        "clipped_low": (None, 0.005), "clipped_high": (None, 0.005), "peak": (None, 0.15), "contrast": (0.1, 0.2),
        "signal_to_noise": (5, None), "colour_balance": (None, 0.02), "seam_step": (None, None),
        "seam_contrast": (None, None),
    }
    assert all("JRC" in rule.source for rule in rules.rules[:-2])
    assert "16 septembre 2003" in rules.rules[-2].source
    bands = {rule.check: rule.band for rule in rules.rules}
    assert {bands[check] for check in FROM_HISTOGRAM} == {"luminosity"}
    assert (bands["signal_to_noise"], bands["colour_balance"]) == ("each", "all")
    assert [rule.check for rule in rules.rules if not rule.required] == ["signal_to_noise", "colour_balance"]


def test_the_stricter_ready_file_holds_each_band_to_the_same_limits() -> None:
    assert list(ready_rule_files()) == ["jrc_lpis", "jrc_lpis_each_band"]
    text, strict = default_rules(), load_rules(ready_rule_files()["jrc_lpis_each_band"])
    assert [(rule.check, rule.least, rule.most, rule.source) for rule in text.rules] == [
        (rule.check, rule.least, rule.most, rule.source) for rule in strict.rules
    ]
    assert {rule.band for rule in strict.rules} == {"each", "all"}
    assert all(rule.required for rule in strict.rules)


def test_a_band_may_have_a_rule_of_its_own_beside_luminosity(tmp_path: Path) -> None:
    rules = load(tmp_path, {"rules": [{**GOOD, "band": band} for band in ("luminosity", "nir", "band_5")]})
    assert [rule.band for rule in rules.rules] == ["luminosity", "nir", "band_5"]
    assert load(tmp_path, {"rules": [GOOD]}).rules[0].band == "each"


def test_the_documented_file_is_the_default(repository: Path, tmp_path: Path) -> None:
    page = (repository / "docs" / "neighbours" / "radiometry.md").read_text(encoding="utf-8")
    (shown,) = re.findall(r"```json\n(.*?)```", page, re.DOTALL)
    assert load(tmp_path, shown) == default_rules()


def test_a_rule_and_its_range(tmp_path: Path) -> None:
    rules = load(tmp_path, {"name": "ours", "value_range": [0, 4095], "rules": [
        GOOD, {"check": "clipped_low", "most": 0.01, "values": 3, "source": "s"}]})
    assert rules == RuleSet(
        "ours", (Rule("contrast", 0.1, 0.2, "contract 7"), Rule("clipped_low", None, 0.01, "s", 3)), (0.0, 4095.0)
    )
    assert [rules.rules[0].passes(value) for value in (0.09, 0.1, 0.2, 0.21)] == [False, True, True, False]


@pytest.mark.parametrize(
    ("content", "words"),
    [
        ("{", r"not valid JSON \(see line 1"),
        ("[]", "holds no rules"),
        ({"rules": []}, "holds no rules"),
        ({"rules": [GOOD], "limits": 3}, "The object in rules.json has the unknown key 'limits'"),
        ({"rules": [{**GOOD, "max": 3}]}, "Rule 1 in rules.json has the unknown key 'max'; known are check, band"),
        ({"rules": [{**GOOD, "check": "sharpness"}]}, "Rule 1 in rules.json has the unknown check 'sharpness'"),
        ({"rules": [GOOD, {"source": "s"}]}, "Rule 2 in rules.json has the unknown check 'None'"),
        ({"rules": [GOOD, GOOD]}, "Rule 2 in rules.json: 'contrast' of each already has a rule"),
        ({"rules": [GOOD, {**GOOD, "band": "red"}]}, "Rule 2 in rules.json: 'contrast' of red already has a rule"),
        ({"rules": [{**GOOD, "band": "infrared"}]}, "'band' has to be luminosity, each, or the name of a band"),
        ({"rules": [{"check": "colour_balance", "band": "red", "source": "s"}]}, "so it has no 'band'"),
        ({"rules": [{**GOOD, "required": "no"}]}, "'required' has to be true or false"),
        ({"rules": [{**GOOD, "most": "20 %"}]}, "'most' has to be a number"),
        ({"rules": [{**GOOD, "least": True}]}, "'least' has to be a number"),
        ('{"rules": [{"check": "peak", "most": NaN, "source": "s"}]}', "'most' has to be a number"),
        ({"rules": [{**GOOD, "least": 0.3}]}, "'least' is larger than 'most'"),
        ({"rules": [{**GOOD, "values": 5}]}, "'values' belongs to clipped_low and clipped_high"),
        ({"rules": [{"check": "clipped_low", "values": 0, "source": "s"}]}, "'values' has to be a whole number"),
        ({"rules": [{**GOOD, "source": " "}]}, "has no 'source'"),
        ({"rules": [GOOD], "value_range": [5, 5]}, "in rules.json: 'value_range' has to be two numbers"),
    ],
)
def test_a_wrong_file_is_refused_in_one_sentence(tmp_path: Path, content: Any, words: str) -> None:
    with pytest.raises(SettingsError, match=words) as raised:
        load(tmp_path, content)
    said = str(raised.value)
    assert said.endswith(".")
    assert "\n" not in said


def test_files_that_are_not_there_or_no_text(tmp_path: Path) -> None:
    (tmp_path / "binary.json").write_bytes(b"\xff\xfe\x00")
    for name, words in (("none.json", "No such file"), ("binary.json", "not valid JSON")):
        with pytest.raises(SettingsError, match=words):
            load_rules(tmp_path / name)
