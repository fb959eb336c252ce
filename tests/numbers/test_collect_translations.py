"""A translation file follows the texts of the code, without Qt's tools; these find the same texts and read it."""
from __future__ import annotations

import shutil
import subprocess
from pathlib import Path

import pytest

from tools.collect_translations import Translated, found_texts, known_translations, texts_of, written

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
