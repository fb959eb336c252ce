"""Our texts appear in the language of QGIS's interface. ``make link`` compiles the translations."""
from __future__ import annotations

from collections.abc import Iterator

import pytest
from qgis.core import QgsApplication
from seam_inspector.plugin.imagery import messages as imagery_messages
from seam_inspector.plugin.noise.noise_summary import VERDICT_WORDS
from seam_inspector.plugin.photos.measure import messages as photos_messages
from seam_inspector.plugin.seams.algorithms.inspectwindows import InspectWindows
from seam_inspector.plugin.seams.measure import messages as seams_messages
from seam_inspector.plugin.seams.words import VERDICTS
from seam_inspector.plugin.toolkit.translation import Translation, sentence, tr

ENGLISH, POLISH = "Inspect windows", "Skontroluj okna"


@pytest.fixture
def translation(request: pytest.FixtureRequest, monkeypatch: pytest.MonkeyPatch) -> Iterator[Translation]:
    """Our translation while QGIS speaks the language of the test's parameter."""
    monkeypatch.setattr(QgsApplication, "locale", staticmethod(lambda: request.param))
    made = Translation()
    yield made
    made.remove()


@pytest.mark.parametrize("translation", ["pl", "pl_PL"], indirect=True)
def test_texts_and_sentences_are_polish_until_removed(translation: Translation) -> None:
    assert tr(ENGLISH) == POLISH
    assert sentence(seams_messages.NO_SOURCES()).startswith("Żaden ortoobraz źródłowy nie pokrywa okna;")

    translation.remove()
    assert tr(ENGLISH) == ENGLISH
    assert sentence(seams_messages.NO_SOURCES()) == str(seams_messages.NO_SOURCES())


@pytest.mark.parametrize("translation", ["pl"], indirect=True)
def test_values_and_sentences_within_a_sentence_are_put_in(translation: Translation) -> None:
    why = (
        imagery_messages.NOT_COVERED(name="a.tif"),
        imagery_messages.TOO_MANY_INVALID(name="b.tif", share=0.0123, most=0.001),
    )
    assert sentence(seams_messages.NO_SOURCE_COMPARABLE(why=why)) == (
        "Żadnego ortoobrazu źródłowego nie można tu porównać: Raster a.tif nie pokrywa całego okna. "
        "Udział pikseli bez danych w oknie wynosi w rastrze b.tif 1.23\u00a0%, a dopuszczalne jest 0.1\u00a0%; wybierz "
        "inne miejsce."
    )


@pytest.mark.parametrize("translation", ["pl"], indirect=True)
def test_words_for_verdicts_models_and_marks_are_polish(translation: Translation) -> None:
    english = [item.word for item in VERDICTS.values()] + list(VERDICT_WORDS.values())
    assert [word for word in english if tr(word) == word] == []
    assert [str(word) for word in photos_messages.WORDS.values() if sentence(word) == str(word)] == []


@pytest.mark.parametrize("translation", ["pl"], indirect=True)
def test_an_algorithm_keeps_its_name_and_shows_polish(translation: Translation) -> None:
    algorithm = InspectWindows().create()
    assert algorithm.name() == "inspectwindows"
    assert algorithm.displayName() == POLISH
    assert algorithm.group() == "Kontrola linii mozaikowania"
    assert "significant" in algorithm.shortHelpString()
    assert algorithm.parameterDefinition("MOSAIC").description() == "Ortofotomapa"


@pytest.mark.parametrize("translation", ["en", "en_US", "de", "C"], indirect=True)
def test_a_language_we_have_not_shows_english(translation: Translation) -> None:
    assert tr(ENGLISH) == ENGLISH
