"""Rules files: what they may say, and what is said of those that are wrong."""
from __future__ import annotations

import json
import re
from pathlib import Path
from typing import Any

import pytest
from seam_inspector.plugin.imagery.errors import SettingsError
from seam_inspector.plugin.radiometry.measure.rules import CHECKS, Rule, RuleSet, default_rules, load_rules

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


def test_the_documented_file_is_the_default(repository: Path, tmp_path: Path) -> None:
    page = (repository / "docs" / "radiometry.md").read_text(encoding="utf-8")
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
        ("{", r"no JSON \(line 1"),
        ("[]", "holds no rules"),
        ({"rules": []}, "holds no rules"),
        ({"rules": ["contrast"]}, "holds no rules"),
        ({"rules": [GOOD], "limits": 3}, "The object in rules.json has the unknown key 'limits'"),
        ({"rules": [{**GOOD, "max": 3}]}, "Rule 1 in rules.json has the unknown key 'max'; known are check, least"),
        ({"rules": [{**GOOD, "check": "sharpness"}]}, "Rule 1 in rules.json names the unknown check 'sharpness'"),
        ({"rules": [GOOD, {"source": "s"}]}, "Rule 2 in rules.json names the unknown check 'None'"),
        ({"rules": [{**GOOD, "check": ["contrast"]}]}, "unknown check"),
        ({"rules": [GOOD, GOOD]}, "has two rules for 'contrast'"),
        ({"rules": [{**GOOD, "most": "20 %"}]}, "'most' has to be a number"),
        ({"rules": [{**GOOD, "least": -1}]}, "'least' has to be a number"),
        ({"rules": [{**GOOD, "least": True}]}, "'least' has to be a number"),
        ('{"rules": [{"check": "peak", "most": NaN, "source": "s"}]}', "'most' has to be a number"),
        ({"rules": [{**GOOD, "least": 0.3}]}, "'least' is larger than 'most'"),
        ({"rules": [{**GOOD, "values": 5}]}, "'values' belongs to clipped_low and clipped_high"),
        ({"rules": [{"check": "clipped_low", "values": 0, "source": "s"}]}, "'values' has to be a whole number"),
        ({"rules": [{**GOOD, "source": " "}]}, "has no 'source'"),
        ({"rules": [GOOD], "value_range": [5, 5]}, "'value_range' in rules.json has to be two numbers"),
        ({"rules": [GOOD], "value_range": "0-255"}, "'value_range' in rules.json has to be two numbers"),
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
    for name, words in (("none.json", "No such file"), ("binary.json", "no UTF-8 text")):
        with pytest.raises(SettingsError, match=words):
            load_rules(tmp_path / name)
