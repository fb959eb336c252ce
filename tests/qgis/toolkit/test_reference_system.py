"""Reference systems of texts and layers, whatever threads have asked QGIS for them, and what leads between them."""
from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest
from qgis.core import QgsCoordinateReferenceSystem, QgsCoordinateTransformContext, QgsPointXY
from seam_inspector.plugin.imagery.errors import WindowError
from seam_inspector.plugin.toolkit import reference_systems
from seam_inspector.plugin.toolkit.layers import system_wkt
from seam_inspector.plugin.toolkit.reference_systems import known_system, reference_system, transformation

from tests.numbers.synthetic import UTM33, wkt
from tests.qgis.emptied import UNDEFINED, asked_in_thread, emptied_system
from tests.qgis.runs import assert_sentence

pytestmark = pytest.mark.usefixtures("qgis_app")

NOWHERE = QgsCoordinateTransformContext()
PLACE = QgsPointXY(500_000, 5_000_000)
CUSTOM = "+proj=tmerc +lat_0=0 +lon_0=19.3 +k=0.9993 +x_0=77 +y_0=0 +ellps=GRS80 +units=m +type=crs"


@pytest.fixture(autouse=True)
def _forgotten() -> Iterator[None]:
    """What was emptied is of one test."""
    yield
    QgsCoordinateReferenceSystem.invalidateCache()


@pytest.mark.parametrize("text", ["", "nothing that means any"])
def test_what_means_nothing_is_invalid(text: str) -> None:
    assert not reference_system(text).isValid()


@pytest.mark.parametrize("system", [UTM33, CUSTOM])
def test_a_system_is_whole_when_the_thread_that_asked_qgis_first_has_ended(system: str | int) -> None:
    text = wkt(system)
    assert not emptied_system(text).toWkt()  # what QGIS still gives to everybody
    assert reference_system(text).isValid()
    assert reference_system(text).toWkt()


def test_a_system_stays_whole_when_another_thread_that_asked_ends() -> None:
    with asked_in_thread(lambda: reference_system(wkt(UTM33))):
        held = reference_system(wkt(UTM33))
        assert held.toWkt()
    assert held.toWkt()


def test_a_layers_system_is_whole_again() -> None:
    emptied = emptied_system(wkt(UTM33))
    assert known_system(emptied).toWkt()
    assert known_system(emptied) == emptied


def test_nothing_is_transformed_from_what_a_thread_has_emptied() -> None:
    emptied, degrees = emptied_system(wkt(UTM33)), QgsCoordinateReferenceSystem("EPSG:4326")
    place = transformation(emptied, degrees, NOWHERE).transform(PLACE)
    assert (place.x(), place.y()) == pytest.approx((15.0, 45.15), abs=0.01)
    assert transformation(degrees, emptied, NOWHERE).transform(place).x() == pytest.approx(PLACE.x(), abs=1e-3)


@pytest.mark.parametrize("ask", [
    lambda: emptied_system(wkt(CUSTOM)), lambda: reference_system(wkt("+proj=longlat +R=1737400 +no_defs +type=crs"))
], ids=["emptied, and nothing names it", "the Moon's"])  # fmt: skip
def test_a_system_that_nothing_leads_from_is_told(ask: Callable[[], QgsCoordinateReferenceSystem]) -> None:
    with pytest.raises(WindowError) as raised:
        transformation(ask(), reference_system(wkt(UTM33)), NOWHERE)
    assert_sentence(str(raised.value), "reference system")


@pytest.mark.parametrize("text", ["", UNDEFINED])
def test_what_has_no_system_stays_where_it_is(text: str) -> None:
    undefined = QgsCoordinateReferenceSystem.fromWkt(text)
    assert not known_system(undefined).isValid()
    assert transformation(undefined, reference_system(wkt(UTM33)), NOWHERE).transform(PLACE) == PLACE


def test_an_epoch_is_kept() -> None:
    dated = QgsCoordinateReferenceSystem("EPSG:7912")
    dated.setCoordinateEpoch(2020.5)
    assert known_system(dated).coordinateEpoch() == 2020.5
    assert system_wkt(known_system(dated))


def test_systems_and_transformations_are_made_in_one_place() -> None:
    """It minds threads that end and asks PROJ first; QGIS's writer, which minds neither, writes nothing."""
    made = re.compile(r"QgsCoordinateTransform\(|QgsCoordinateReferenceSystem\.from|\.setDestinationCrs\("
                      r"|QgsVectorFileWriter\.(?:create|write)")  # fmt: skip
    one_place = Path(reference_systems.__file__).resolve()
    seams = one_place.parents[1] / "seams"
    maps = {seams / "desk" / "images" / "images_panel.py", seams / "report" / "window_map.py"}
    sources = {path: path.read_text(encoding="utf-8") for path in one_place.parents[1].rglob("*.py")}
    match = {path: set(made.findall(text)) for path, text in sources.items() if made.search(text)}
    assert match.keys() == maps | {one_place}
    assert all(match[path] == {".setDestinationCrs("} for path in maps)  # of systems that were made there
