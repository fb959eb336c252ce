"""Files of rules of acceptance: what they are called, and what they have to decide by."""
from __future__ import annotations

import json
from pathlib import Path

import pytest
from seam_inspector.plugin.acceptance.measure import messages
from seam_inspector.plugin.acceptance.measure.acceptance_rules import load_acceptance_rules
from seam_inspector.plugin.acceptance.measure.deciding import decide
from seam_inspector.plugin.imagery.errors import SettingsError

from tests.numbers.acceptance.deliveries import delivery, seam

KEPT = {"check": "kept", "least": 0.7, "source": "contract"}
SHARE = {"check": "failed_share", "most": 1.0, "source": "contract"}


def written(folder: Path, **content: object) -> Path:
    path = folder / "mine.json"
    path.write_text(json.dumps(content), encoding="utf-8")
    return path


def test_rules_are_called_by_their_name_and_else_by_their_file(tmp_path: Path) -> None:
    assert load_acceptance_rules(written(tmp_path, name="Ours", rules=[KEPT, SHARE])).name == "Ours"
    assert load_acceptance_rules(written(tmp_path, rules=[KEPT, SHARE])).name == "mine.json"


def test_a_decision_by_a_file_says_its_limits_whatever_it_is_called(tmp_path: Path) -> None:
    run = {"check": "longest_failure", "most": 1000.0, "source": "contract"}
    name = "at least 70 % kept, at most 2 % failed, at most 50 m without a break, at least 90 % measured"
    for rule, words in (
        (run, "no limit on the share that failed, at most 1000 m without a break"),
        (SHARE, "at most 100% failed, no limit on metres without a break"),
    ):
        rules = load_acceptance_rules(written(tmp_path, name=name, rules=[KEPT, rule]))
        limits = f"the limits are at least 70% kept, {words}, at least 90% measured."
        headline = str(decide(delivery(seam([0.4] * 9)), rules).sentences[0])
        assert headline.startswith(f"Accepted by '{name}': ")
        assert headline.endswith(limits)


def test_rules_by_which_nothing_is_decided_are_refused(tmp_path: Path) -> None:
    measured = {"check": "measured_share", "least": 0.9, "source": "contract"}
    with pytest.raises(SettingsError) as raised:
        load_acceptance_rules(written(tmp_path, rules=[KEPT, measured]))
    assert str(raised.value) == str(messages.RULES_DECIDE_NOTHING(name="mine.json"))
    with pytest.raises(SettingsError) as raised:
        load_acceptance_rules(written(tmp_path, rules=[{**KEPT, "least": 0}, SHARE]))
    assert str(raised.value) == str(messages.KEPT_NOTHING())
