"""Names that others gave do nothing where they are shown."""
from __future__ import annotations

import json
import unicodedata

import pytest
from seam_inspector.plugin.imagery import messages
from seam_inspector.plugin.imagery.errors import Message, cell_text, in_sentence, of_cell, printable

NAMES = ["<script>alert(1)</script>", '"><svg onload=x>', "{{7*7}}", "[% @project_path %]",
         "{0.__class__}", "$\\frac$", "łódź",
         "\u0631\u0648\u200c\u0647\u0627", "\u200eabc", "日本"]  # fmt: skip


@pytest.mark.parametrize("name", NAMES)
def test_words_stay_as_they_are(name: str) -> None:
    assert printable(name) == in_sentence(name) == name


@pytest.mark.parametrize("sign", [*map(chr, range(9)), "\x0b", "\x1b", "\x7f", "\x85", "\u202e", "\u2066", "\u200b",
                                  "\ufeff", "\udcff", "\uffff"])  # fmt: skip
def test_what_shows_nothing_or_turns_words_is_made_plain(sign: str) -> None:
    assert printable(f"gpj{sign}.tif") == "gpj\ufffd.tif"
    printable(sign).encode()
    assert unicodedata.category(printable(sign)) == "So"


def test_a_sentence_is_one_line_and_short() -> None:
    name = "a\nb\r\nc\u2028d" + "x" * 4000 + ".tif"
    said = str(messages.NOT_A_RASTER(name=name))
    assert len(said) < 450
    assert len(said.splitlines()) == 1
    assert "a b c d" in said
    assert "x.tif" in said


@pytest.mark.parametrize("template", ["{0.__class__.__init__.__globals__}", "{name}", "{}", "%s%n", "{name!r}"])
def test_a_name_is_no_template(template: str) -> None:
    assert template in str(messages.NOT_A_RASTER(name=template))


@pytest.mark.parametrize("text", ["=cmd|' /C calc'!A0", "+1+1", "-2+3+cmd|' /C calc'!A0", "@SUM(1)", "\t=1", "-a.tif"])
def test_a_cell_holds_no_formula(text: str) -> None:
    assert cell_text(text) == f"'{text}"
    assert of_cell(cell_text(text)) == text


@pytest.mark.parametrize("text", ["", "-", "-1.5", "+3 %", "-0,5", "a=b", "mosaic-1.tif", json.dumps("=1")])
def test_a_cell_without_a_formula_stays(text: str) -> None:
    assert cell_text(text) == text
    assert of_cell(text) == text


def test_a_sentence_at_the_end_of_another_one_leaves_it_its_full_stop() -> None:
    inner, outer = Message("{name} is cut off; copy it anew."), Message("{sheet}: {finding}. Go on.")
    assert str(outer(sheet="A", finding=inner(name="a.tif"))) == "A: a.tif is cut off; copy it anew. Go on."
    assert str(outer(sheet="A", finding=Message("it is missing")())) == "A: it is missing. Go on."
    assert str(outer(sheet="A", finding="a.b.")) == "A: a.b.. Go on."  # a name keeps what is its own
