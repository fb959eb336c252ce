"""Texts in the interface's language, and decimal commas there, but never in tables and XML that programs read."""
from __future__ import annotations

import csv
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from qgis.core import QgsApplication
from seam_inspector.plugin.imagery import messages as imagery_messages
from seam_inspector.plugin.noise.noise_summary import VERDICT_WORDS
from seam_inspector.plugin.photos.measure import messages as photos_messages
from seam_inspector.plugin.seams.algorithms.inspectwindows import InspectWindows
from seam_inspector.plugin.seams.measure import messages as seams_messages
from seam_inspector.plugin.seams.words import VERDICTS
from seam_inspector.plugin.toolkit.translation import Translation, sentence, tr

from fuzz.running import outputs
from tests.qgis.runs import Run, run
from tests.qgis.scenes import BLURRED, SHARP, Scene, windows

pytestmark = pytest.mark.usefixtures("provider")

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


def calls(scene: Scene, given: dict[str, Any]) -> dict[str, dict[str, Any]]:
    return {
        "inspectwindows": {
            "WINDOWS": windows(SHARP, BLURRED), "MOSAIC": str(scene.mosaic), "SOURCES": scene.sources},
        "checkradiometry": {"RASTERS": [str(scene.mosaic)]},
        "fitsensormodel": {"GCPS": given["gcps"], "HEIGHTS": "ellipsoid", "MODEL": "polynomial_3d"},
        "interiororientation": {"PHOTO": given["photo"], "CALIBRATION": given["calibration"]},
    }  # fmt: skip


def written(name: str, folder: Path, values: dict[str, Any]) -> Run:
    """All outputs, tables as CSV."""
    folder.mkdir()
    files = {key: path.replace(".gpkg", ".csv") for key, path in outputs(name, folder).items()}
    ended = run(name, **{**{key: path for key, path in files.items() if not path.endswith(".tif")}, **values})
    assert ended.complaint is None
    return ended


def numbers(folder: Path) -> dict[str, list[list[str]]]:
    """Cells of CSV files that are numbers, whatever their decimal sign."""
    items = {}
    for path in sorted(folder.glob("*.csv")):
        with open(path, encoding="utf-8", newline="") as file:
            rows = list(csv.reader(file))
        items[path.name] = [[cell for cell in row if cell.replace(",", ".").lstrip("-").replace(".", "").isdigit()]
                            for row in rows]
    return items


@pytest.mark.parametrize("name", ["inspectwindows", "checkradiometry", "fitsensormodel", "interiororientation"])
def test_tables_have_points(
    name: str, scene: Scene, given: dict[str, Any], tmp_path: Path, request: pytest.FixtureRequest
) -> None:
    values = calls(scene, given)[name]
    written(name, tmp_path / "points", values).close()
    request.getfixturevalue("commas")
    written(name, tmp_path / "commas", values).close()
    expected = numbers(tmp_path / "points")
    assert any(map(len, expected.values()))
    assert numbers(tmp_path / "commas") == expected
