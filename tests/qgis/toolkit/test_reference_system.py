"""Texts of reference systems."""
from __future__ import annotations

import pytest
from qgis.core import QgsCoordinateReferenceSystem
from seam_inspector.plugin.toolkit import reference_systems
from seam_inspector.plugin.toolkit.reference_systems import reference_system

from tests.numbers.synthetic import UTM33, wkt

pytestmark = pytest.mark.usefixtures("qgis_app")


def test_a_text_is_known_by_its_code() -> None:
    assert reference_system(wkt(UTM33)).authid() == f"EPSG:{UTM33}"


@pytest.mark.parametrize("text", ["", "nothing that means any"])
def test_what_means_nothing_is_invalid(text: str) -> None:
    assert not reference_system(text).isValid()


def test_an_answer_that_could_not_be_given_once_is_asked_for_again(monkeypatch: pytest.MonkeyPatch) -> None:
    answers = [QgsCoordinateReferenceSystem(), QgsCoordinateReferenceSystem(f"EPSG:{UTM33}")]
    forgotten = []

    class Once(QgsCoordinateReferenceSystem):
        @staticmethod
        def fromWkt(text: str) -> QgsCoordinateReferenceSystem:
            return answers.pop(0)

        @staticmethod
        def invalidateCache(disableCache: bool = False) -> None:
            forgotten.append(True)

    monkeypatch.setattr(reference_systems, "QgsCoordinateReferenceSystem", Once)
    assert reference_system(wkt(UTM33)).authid() == f"EPSG:{UTM33}"
    assert forgotten == [True]


def test_what_qgis_can_not_read_is_known_by_the_code_in_the_text(monkeypatch: pytest.MonkeyPatch) -> None:
    class Never(QgsCoordinateReferenceSystem):
        @staticmethod
        def fromWkt(text: str) -> QgsCoordinateReferenceSystem:
            return QgsCoordinateReferenceSystem()

    monkeypatch.setattr(reference_systems, "QgsCoordinateReferenceSystem", Never)
    assert reference_system(wkt(UTM33)).authid() == f"EPSG:{UTM33}"
    assert not reference_system("nothing that means any").isValid()
