"""The Polish texts speak the field's language: one Polish word for each term, none that the field does not know."""
from __future__ import annotations

import json
import re
import xml.etree.ElementTree as ElementTree
from pathlib import Path
from typing import Any

import pytest

_PLACEHOLDER = re.compile(r"\{[^{}]*\}")
_QUOTED_WORD = re.compile(r"(?<!\w)'[^' ]*'|„[^” ]*”")
"""Names of fields and values, which no language changes."""


@pytest.fixture(scope="module")
def glossary(repository: Path) -> dict[str, Any]:
    return json.loads((repository / "i18n" / "glossary.json").read_text(encoding="utf-8"))  # type: ignore[no-any-return]


@pytest.fixture(scope="module")
def texts(repository: Path) -> dict[str, str]:
    """English and Polish of every text, without values, names of fields and the marks of keys."""
    root = ElementTree.parse(repository / "i18n" / "seam_inspector_pl.ts").getroot()
    both = ((message.findtext("source", ""), message.findtext("translation", "")) for message in root.iter("message"))
    return {_words(source): _words(translation) for source, translation in both}


def _words(text: str) -> str:
    forms = re.sub(r"\{\w+:([^{}]*\|[^{}]*)\}", lambda match: " ".join(match[1].split("|")), text)
    return _QUOTED_WORD.sub("", _PLACEHOLDER.sub("", forms)).replace("&", "")


def test_terms_have_their_polish_word(glossary: dict[str, Any], texts: dict[str, str]) -> None:
    missing = [
        f"{term['english']} is {term['polish']}: {source} = {translation}"
        for term in glossary["terms"]
        for source, translation in texts.items()
        if re.search(term["in_text"], source, re.IGNORECASE) and not re.search(term["stem"], translation, re.IGNORECASE)
    ]
    assert missing == []


def test_no_word_that_the_field_does_not_know(glossary: dict[str, Any], texts: dict[str, str]) -> None:
    faults = [
        f"{word['instead']}: {translation}"
        for word in glossary["forbidden"]
        for translation in texts.values()
        if re.search(word["pattern"], translation, re.IGNORECASE)
    ]
    assert faults == []


def test_spelling_is_polish(texts: dict[str, str]) -> None:
    """Decimal commas, quotes as Polish has them, a space that does not break before the per cent sign."""
    wrong = {
        r"(?<![\d.])\d\.\d+(?![\d.])": "a decimal point",
        r"\d %": "a space that breaks before %",
        r"\d%": "no space before %",
        r"\b[\w)]+ \.\.\.": "a space before the dots",
        r" - ": "a hyphen for a dash",
        r"\(s\)": "(s)",
    }
    faults = [
        f"{what}: {translation}"
        for source, translation in texts.items()
        for pattern, what in wrong.items()
        if re.search(pattern, translation) and not re.search(r"kept_1 < |rpc|rozdział|QGIS \d|swoistość", translation)
    ]
    assert faults == []
