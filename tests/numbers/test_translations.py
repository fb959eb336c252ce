"""The translations are complete, up to date with the code whose texts are collected, and take the same values."""
from __future__ import annotations

import ast
import importlib
import shutil
import string
import subprocess
import xml.etree.ElementTree as ElementTree
from collections.abc import Iterator
from pathlib import Path
from types import ModuleType

import pytest
from seam_inspector.plugin.imagery.errors import Message

from tools import template_texts
from tools.collect_translations import Translated, found_texts, known_translations, texts_of, written

TEXT_ARGUMENT = {"tr": 0, "Message": 0, "QT_TRANSLATE_NOOP": 1, "QT_TR_NOOP": 0}
"""The argument of a call that is a text to translate."""
CONTEXT = "@default"  # the context where the plugin looks for all translations


@pytest.fixture(scope="module")
def contexts(repository: Path) -> dict[str, list[ElementTree.Element]]:
    """The entries of the Polish translation by their context."""
    root = ElementTree.parse(repository / "i18n" / "seam_inspector_pl.ts").getroot()
    return {context.findtext("name", ""): context.findall("message") for context in root.findall("context")}


@pytest.fixture(scope="module")
def entries(contexts: dict[str, list[ElementTree.Element]]) -> list[ElementTree.Element]:
    return [entry for context in contexts.values() for entry in context]


def source(entry: ElementTree.Element) -> str:
    return entry.findtext("source", "")


def translation(entry: ElementTree.Element) -> str:
    return entry.findtext("translation", "")


def placeholders(text: str) -> list[tuple[str, str, str | None]]:
    """Name, format and conversion of every ``{name}``, in an order that does not depend on the sentence's."""
    return sorted(
        (name, form or "", conversion)
        for _, name, form, conversion in string.Formatter().parse(text)
        if name is not None and "|" not in (form or "")
    )


def forms(text: str) -> list[tuple[str, int]]:
    """The counts that words are inflected by, and in how many forms."""
    parsed = string.Formatter().parse(text)
    return [(name, form.count("|") + 1) for _, name, form, _ in parsed if name and form and "|" in form]


def texts(package: Path) -> Iterator[str]:
    """Every text that the code of a package, or a template, marks for translation."""
    yield from template_texts.texts(package)
    for path in sorted(package.rglob("*.py")):
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            if isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id in TEXT_ARGUMENT:
                argument = node.args[TEXT_ARGUMENT[node.func.id]] if node.args else None
                if isinstance(argument, ast.Constant) and isinstance(argument.value, str):
                    yield argument.value


def test_all_is_in_the_context_where_the_plugin_looks(contexts: dict[str, list[ElementTree.Element]]) -> None:
    assert list(contexts) == [CONTEXT]


def test_every_entry_is_translated_and_finished(entries: list[ElementTree.Element]) -> None:
    assert entries
    assert [source(entry) for entry in entries if not translation(entry).strip()] == []
    types = {source(entry): entry.find("translation").get("type") for entry in entries}  # type: ignore[union-attr]
    assert {text: kind for text, kind in types.items() if kind is not None} == {}  # unfinished, obsolete, vanished


def test_values_go_into_a_translation_as_into_its_source(entries: list[ElementTree.Element]) -> None:
    differing = [
        (placeholders(source(entry)), translation(entry))
        for entry in entries
        if placeholders(source(entry)) != placeholders(translation(entry))
    ]
    assert differing == []


def test_polish_words_have_three_forms_by_a_count_of_the_source(entries: list[ElementTree.Element]) -> None:
    inflected = {source(entry): forms(translation(entry)) for entry in entries if forms(translation(entry))}
    assert inflected
    wrong = {
        text: forms
        for text, forms in inflected.items()
        for count, words in forms
        if words != 3 or count not in {name for name, _, _ in placeholders(text)}
    }
    assert wrong == {}


def message_modules(repository: Path) -> list[Path]:
    """The files that hold the sentences for the user."""
    return sorted((repository / "plugin").rglob("messages.py"))


def loaded(path: Path) -> ModuleType:
    return importlib.import_module(".".join(["seam_inspector", *path.with_suffix("").parts]))


def test_every_message_is_there(entries: list[ElementTree.Element], repository: Path) -> None:
    templates = {
        value.template
        for path in message_modules(repository)
        for value in vars(loaded(path.relative_to(repository))).values()
        if isinstance(value, Message)
    }
    assert templates
    assert sorted(templates - {source(entry) for entry in entries}) == [], "run `make translate`, then translate these"


def test_no_message_hides_another_of_its_name(repository: Path) -> None:
    names = [
        target.id
        for path in message_modules(repository)
        for node in ast.parse(path.read_text(encoding="utf-8")).body
        if isinstance(node, ast.Assign)
        for target in node.targets
        if isinstance(target, ast.Name)
    ]
    assert names
    assert sorted(name for name in set(names) if names.count(name) > 1) == []


def test_texts_are_those_of_the_code(entries: list[ElementTree.Element], repository: Path) -> None:
    translated, used = [source(entry) for entry in entries], set()
    for folder in ("plugin", "resources"):
        used.update(texts(repository / folder))
    assert sorted(used - set(translated)) == [], "run `make translate`, then translate these"
    assert sorted(set(translated) - used) == [], "run `make translate`: the code has these no longer"
    assert len(translated) == len(set(translated))


def test_a_text_in_a_template_that_nobody_could_collect_is_refused(tmp_path: Path) -> None:
    (tmp_path / "a.html.j2").write_text("\n{{ tr(words) }}", encoding="utf-8")
    with pytest.raises(ValueError, match=r"a\.html\.j2, line 2"):
        list(texts(tmp_path))


KNOWN = {"old": Translated("stary", ""), "gone": Translated("dawny", ""), "asked <b>'x'": Translated("?", "unfinished")}


def test_translations_stay_new_texts_come_and_gone_ones_leave(tmp_path: Path) -> None:
    path = tmp_path / "pl.ts"
    path.write_text(written({"new": None, "old": ("plugin/a.py", 3), "asked <b>'x'": None}, KNOWN), encoding="utf-8")
    assert list(known_translations(path).items()) == [
        ("old", Translated("stary", "")), ("asked <b>'x'", Translated("?", "unfinished")),
        ("new", Translated("", "unfinished")),
    ]  # fmt: skip


def test_written_again_it_is_the_same(repository: Path, tmp_path: Path) -> None:
    texts = found_texts(repository)
    path = tmp_path / "pl.ts"
    path.write_text(written(texts, known_translations(repository / "i18n" / "seam_inspector_pl.ts")), encoding="utf-8")
    assert written(texts, known_translations(path)) == path.read_text(encoding="utf-8")


@pytest.mark.parametrize("code", ["self.tr('a')", "tr(words)", "tr()", "tr('')", "tr(f'{a}')"])
def test_what_is_no_text_is_left_out(code: str) -> None:
    assert list(texts_of(code)) == []


@pytest.mark.slow
@pytest.mark.skipif(shutil.which("pylupdate5") is None, reason="PyQt5's tool is not installed")
def test_qt_5_finds_the_same_texts_and_changes_no_entry(repository: Path, tmp_path: Path) -> None:
    sources, path = sorted((repository / "plugin").rglob("*.py")), tmp_path / "pl.ts"
    collect = ["pylupdate5", "-noobsolete", "-tr-function", "Message", *map(str, sources), "-ts", str(path)]
    subprocess.run(collect, check=True, capture_output=True)
    texts = {text for text, place in found_texts(repository).items() if place is not None}
    assert set(known_translations(path)) == texts

    known = known_translations(repository / "i18n" / "seam_inspector_pl.ts")
    ours = {text: known[text] for text in texts if text in known}
    path.write_text(written(dict.fromkeys(ours, None), ours), encoding="utf-8")
    subprocess.run(collect, check=True, capture_output=True)
    read = known_translations(path)
    assert {text: read[text] for text in ours} == ours
