"""The guide builds without a warning, no link leads nowhere, and the Polish texts speak the field's language."""
from __future__ import annotations

import json
import re
import subprocess
import sys
import xml.etree.ElementTree as ElementTree
from pathlib import Path
from typing import Any

import pytest

OUTSIDE = sorted(path.name for path in Path(__file__).parents[2].glob("*.md"))  # Sphinx sees docs alone
LINK = re.compile(r"\]\((?![a-z]+:)([^)#\s]*)(?:#([^)\s]+))?\)")
HEADING = re.compile(r"^#+ (.+)$", re.MULTILINE)


def anchors(page: Path) -> set[str]:
    """Anchors as GitHub makes them of headings."""
    titles = (re.sub(r"[^\w\s-]", "", title).strip().lower() for title in HEADING.findall(page.read_text("utf-8")))
    return {title.replace(" ", "-") for title in titles}


@pytest.mark.slow
def test_the_guide_builds_without_a_warning(repository: Path, tmp_path: Path) -> None:
    """Sphinx follows every link, anchor and picture of its pages, and wants each page in the tree."""
    command = [sys.executable, "-m", "sphinx", "-W", "--keep-going", "-q", "-b", "dummy", "docs", str(tmp_path)]
    built = subprocess.run(command, cwd=repository, capture_output=True, text=True, timeout=120)
    assert (built.returncode, built.stderr) == (0, "")


@pytest.mark.parametrize("name", OUTSIDE)
def test_links_into_the_guide_lead_somewhere(repository: Path, name: str) -> None:
    lost = []
    for target, anchor in LINK.findall((repository / name).read_text("utf-8")):
        page = repository / (target or name)
        if not page.exists() or (anchor and anchor not in anchors(page)):
            lost.append((target, anchor))
    assert lost == []


def test_every_picture_is_shown(repository: Path) -> None:
    pages = [*(repository / "docs").rglob("*.md"), repository / "README.md"]
    shown = {Path(target).name for page in pages for target, _ in LINK.findall(page.read_text("utf-8"))}
    pictures = {path.name for path in (repository / "docs" / "pictures").iterdir()}
    assert pictures - shown == set()


@pytest.mark.parametrize(
    ("section", "figure", "page"),
    [
        ("What it costs", r"\d+ s\b", "docs/reference/speed.md"),
        ("How good it is", r"\d\.\d+|(?<=None of )\d+", "docs/appendix/detection.md"),
    ],
)
def test_the_readmes_figures_are_those_of_the_page_that_it_names(
    repository: Path, section: str, figure: str, page: str
) -> None:
    readme = (repository / "README.md").read_text("utf-8")
    said = re.findall(figure, readme.partition(f"## {section}")[2].partition("\n## ")[0])
    assert len(said) > 1
    page_text = (repository / page).read_text("utf-8")
    assert [figure for figure in said if not re.search(rf"(?<![\d.]){re.escape(figure)}(?![\d.]\d)", page_text)] == []


_PLACEHOLDER = re.compile(r"\{[^{}]*\}")
_QUOTED_WORD = re.compile(r"(?<!\w)'[^' ]*'|„[^” ]*”")  # names of fields and values, which no language changes


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
