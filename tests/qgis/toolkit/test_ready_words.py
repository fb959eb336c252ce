"""Rules and models that come with the plugin are in the user's language; what users name themselves stays as it is."""
from __future__ import annotations

from qgis.core import QgsProcessingProvider
from seam_inspector.plugin.acceptance.measure.acceptance_rules import rules_of_objects
from seam_inspector.plugin.imagery.documents import RuleObject, read_rules, ready_rules
from seam_inspector.plugin.imagery.messages import RULES_PLACE
from seam_inspector.plugin.provider import SeamInspectorProvider
from seam_inspector.plugin.radiometry.measure.rules import load_rules, ready_rule_files
from seam_inspector.plugin.toolkit.translation import tr


def test_ready_rules_and_their_sources_are_polish(polish: None) -> None:
    for path in ready_rules("acceptance").values():
        rules, worded = (read_rules(path, rules_of_objects, words) for words in (str, tr))
        assert worded.name != rules.name
        assert worded.kept_source != rules.kept_source
        assert [rule.limit for rule in worded.rules] == [rule.limit for rule in rules.rules]
        assert all(new.source != old.source for new, old in zip(worded.rules, rules.rules))
    for path in ready_rule_files().values():
        assert load_rules(path, tr).name.startswith("specyfikacja JRC")


def test_a_contracts_own_words_stay(polish: None) -> None:
    assert RuleObject({"name": "Umowa 12/2026 {x}"}, "a.json", RULES_PLACE(), tr).name() == "Umowa 12/2026 {x}"


def test_the_ready_model_speaks_polish(polish: None, provider: QgsProcessingProvider) -> None:
    made = SeamInspectorProvider()
    made.refreshAlgorithms()
    model = made.algorithm("inspect_mosaic")
    assert model.displayName() == "Skontroluj ortofotomapę"
    assert model.group() == "Kontrola linii mozaikowania"
    assert "linii mozaikowania" in model.shortHelpString()
    copy = model.create()
    names = {definition.name(): definition.description() for definition in copy.parameterDefinitions()}
    assert names["mosaic"] == "Ortofotomapa"
    assert names["inspect:windows"] == "Skontrolowane okna"
