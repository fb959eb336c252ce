"""The rules that images are held against unless others are given."""
from __future__ import annotations

from seam_inspector.plugin.radiometry.measure.rules import DEFAULT_RULES, RuleSet, load_rules, ready_rule_files


def default_rules() -> RuleSet:
    """JRC's orthoimage specification for LPIS, as its text says."""
    return load_rules(ready_rule_files()[DEFAULT_RULES])
