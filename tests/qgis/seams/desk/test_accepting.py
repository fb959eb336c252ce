"""What the desk suggests for a decision is there when QGIS is closed, and takes the place of no earlier document."""
from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest
from qgis.core import QgsProject, QgsRasterLayer, QgsVectorLayer
from qgis.PyQt.QtWidgets import QWidget
from seam_inspector.plugin.imagery.errors import SettingsError
from seam_inspector.plugin.seams.desk.accept_page import AcceptPage, suggested_files
from seam_inspector.plugin.seams.desk.inputs.project_inputs import Inputs
from seam_inspector.plugin.seams.desk.session import Session

from tests.numbers.synthetic import write_raster
from tests.qgis.acceptance.seam_scenes import X, Y, file, seams
from tests.qgis.seams.desk.session_desk import settle, wait_until

pytestmark = pytest.mark.usefixtures("provider")


class Delivery:
    """A project with a mosaic, and perhaps a scan of it."""

    def __init__(self, project: QgsProject, folder: Path) -> None:
        self.project, self.folder = project, folder
        folder.mkdir(exist_ok=True)
        image = np.random.default_rng(1).integers(0, 255, (64, 800), np.uint8)
        path = write_raster(folder / "ortho 5.tif", image, gsd=0.25, origin=(X, Y + 8), system=32633)
        self.mosaic = QgsRasterLayer(path, "mosaic")
        project.addMapLayer(self.mosaic)

    def scan(self, folder: Path) -> None:
        """The layer of a scan, which the desk takes for its last one."""
        path = file(seams([0.9, 0.3, 0.9, 0.9]), folder / "seams.gpkg")
        result = QgsVectorLayer(path, "worst", "ogr")
        result.setCustomProperty("seam_inspector/made_for", self.mosaic.id())
        result.setCustomProperty("seam_inspector/scanned", "2026-01-01")
        self.project.addMapLayer(result)

    def save(self, folder: Path) -> None:
        folder.mkdir()
        assert self.project.write(str(folder / "block.qgs"))

    def suggested(self) -> dict[str, Path]:
        files = suggested_files(self.project, Inputs(mosaic=self.mosaic.id()))
        return {name: Path(file) for name, file in files.items()}


@pytest.fixture
def delivery(project: QgsProject, tmp_path: Path) -> Delivery:
    return Delivery(project, tmp_path / "delivered")


@pytest.mark.parametrize("earlier", ["ortho_5_quality.xml", "ortho_5_defects_pictures"])
def test_any_earlier_document_gives_all_another_number(delivery: Delivery, tmp_path: Path, earlier: str) -> None:
    delivery.scan(tmp_path)
    delivery.save(tmp_path / "project")
    (tmp_path / "project" / earlier).touch()
    names = {"ortho_5_report_2.html", "ortho_5_defects_2.gpkg", "ortho_5_quality_2.xml"}
    assert {file.name for file in delivery.suggested().values()} == names


# The page


@pytest.fixture
def gone_to() -> list[QgsVectorLayer]:
    """Layers that the map went to."""
    return []


@pytest.fixture
def page(delivery: Delivery, tmp_path: Path, gone_to: list[QgsVectorLayer]) -> Iterator[AcceptPage]:
    delivery.scan(tmp_path / "scans")
    delivery.save(tmp_path / "project")
    dock = QWidget()
    made = AcceptPage(delivery.project, Inputs(mosaic=delivery.mosaic.id()), dock, gone_to.append)
    made.show()
    yield made
    dock.deleteLater()
    settle()


def decided(page: AcceptPage) -> str:
    """What the page says once it has decided."""
    page.decide()
    wait_until(lambda: page.decider.isEnabled(), "for the decision")
    return page.verdict.text()


def test_a_scan_that_moved_while_the_page_is_open_is_decided_on_where_it_is(page: AcceptPage, tmp_path: Path) -> None:
    (worst,) = QgsProject.instance().mapLayersByName("worst")
    moved = (tmp_path / "scans" / "seams.gpkg").rename(tmp_path / "seams.gpkg")
    worst.setDataSource(str(moved), "worst", "ogr")
    assert page.values()["SEAMS"] == [f"{moved}|layername=seams"]


@pytest.mark.slow
def test_the_page_decides_by_its_limits_and_saves_what_it_made(
    page: AcceptPage, tmp_path: Path, gone_to: list[QgsVectorLayer]
) -> None:
    assert page.values()["MAX_SHARE"] == 2.0
    page.head["CONTRACT"].setText("ZP-12/2026")
    assert decided(page) == "Rejected"
    assert page.reason.text().startswith("25")
    assert not list((tmp_path / "project").glob("ortho*"))
    QgsProject.instance().layerTreeRoot().insertGroup(0, "Scan of ortho")
    page.show_failures()
    page.show_failures()
    assert [layer.name() for layer in gone_to] == ["Failures", "Failures"]
    assert QgsProject.instance().layerTreeRoot().children()[0].name() == "Failures"
    page.save(tmp_path / "project")
    saved = {path.name for path in (tmp_path / "project").glob("ortho*")}
    assert saved == {"ortho_5_report.html", "ortho_5_defects.gpkg", "ortho_5_defects_pictures", "ortho_5_quality.xml"}
    assert "ZP-12/2026" in (tmp_path / "project" / "ortho_5_report.html").read_text()
    (failures,) = QgsProject.instance().mapLayersByName("Failures")
    assert Path(failures.source()).parent == tmp_path / "project"
    assert failures.featureCount() == 1
    with pytest.raises(SettingsError, match="choose another folder"):
        page.save(tmp_path / "project")
    page.limits["MAX_RUN"].setValue(12.5)
    page.close()  # what was given is the project's
    again = AcceptPage(QgsProject.instance(), Inputs(), page.parentWidget(), gone_to.append)
    assert (again.values()["CONTRACT"], again.values()["MAX_RUN"]) == ("ZP-12/2026", 12.5)
    again.close()
    QgsProject.instance().clear()
    other = AcceptPage(QgsProject.instance(), Inputs(), page.parentWidget(), gone_to.append)
    assert (other.values()["CONTRACT"], other.values()["MAX_RUN"]) == ("", 50)
    other.close()


@pytest.mark.slow
def test_a_project_saved_after_the_decision_is_where_that_is_saved(
    page: AcceptPage, delivery: Delivery, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    decided(page)
    page.show_failures()
    session = Session()
    delivery.save(tmp_path / "later")
    session.close()
    (failures,) = QgsProject.instance().mapLayersByName("Failures")
    assert Path(failures.source()).parent == tmp_path / "later"
    assert failures.featureCount() == 1
    (picture,) = (tmp_path / "later" / f"{Path(failures.source()).stem}_pictures").iterdir()
    assert next(failures.getFeatures())["picture"] == f"{picture.parent.name}/{picture.name}"
    page.show_failures()
    assert len(QgsProject.instance().mapLayersByName("Failures")) == 1
    asked: list[str] = []
    monkeypatch.setattr(
        "seam_inspector.plugin.seams.desk.accept_page.QFileDialog.getExistingDirectory",
        lambda _parent, _title, folder: asked.append(folder) or "",
    )
    page.saver.click()
    assert asked == [str(tmp_path / "later")]


@pytest.mark.slow
def test_other_limits_decide_anew_and_replace_no_document(page: AcceptPage, tmp_path: Path) -> None:
    decided(page)
    page.save(tmp_path / "project")
    before = (tmp_path / "project" / "ortho_5_report.html").read_bytes()
    page.limits["MAX_SHARE"].setValue(100)
    assert (page.verdict.text(), page.files, page.saver.isEnabled()) == ("", {}, False)  # of other limits
    assert decided(page) != "Rejected"
    page.save(tmp_path / "project")
    assert (tmp_path / "project" / "ortho_5_report_2.html").is_file()
    assert (tmp_path / "project" / "ortho_5_report.html").read_bytes() == before
