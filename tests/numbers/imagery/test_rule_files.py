"""What all rules files share, and what is said of those that are wrong."""
from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest
from seam_inspector.plugin.imagery.documents import RuleObject, read_rules
from seam_inspector.plugin.imagery.errors import SettingsError


def read(folder: Path, content: Any) -> tuple[RuleObject, list[RuleObject]]:
    path = folder / "rules.json"
    path.write_bytes(content if isinstance(content, bytes) else json.dumps(content).encode())
    return read_rules(path, lambda whole, rules: (whole, rules))


@pytest.mark.parametrize("text", ["[" * 200_000, "9" * 100_000, f"[-{9}]".replace("9", "9" * 401)])
def test_what_is_nested_or_counted_beyond_sense_is_a_sentence(tmp_path: Path, text: str) -> None:
    with pytest.raises(SettingsError, match=r"are not valid JSON \(see line"):
        read(tmp_path, text.encode())


def test_a_byte_order_mark_is_no_fault(tmp_path: Path) -> None:
    assert read(tmp_path, b"\xef\xbb\xbf" + json.dumps({"rules": [{}]}).encode())[0].file == "rules.json"
