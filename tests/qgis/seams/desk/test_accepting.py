"""What the desk suggests for a decision is there when QGIS is closed, and takes the place of no earlier document."""
from __future__ import annotations

import os
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from qgis.core import QgsApplication, QgsProject, QgsRasterLayer, QgsVectorLayer
from qgis.gui import QgisInterface, QgsProcessingAlgorithmDialogBase
from qgis.PyQt import sip
from qgis.PyQt.QtCore import QTimer
from qgis.PyQt.QtWidgets import QWidget
from seam_inspector.plugin.imagery.atomic_files import replacing
from seam_inspector.plugin.imagery.errors import SettingsError
from seam_inspector.plugin.seams.desk import accepting
from seam_inspector.plugin.seams.desk.accept_page import AcceptPage
from seam_inspector.plugin.seams.desk.accepting import DECISION, WHOLE_WAY, made_form, offered_form, open_form
from seam_inspector.plugin.seams.desk.inputs.project_inputs import Inputs

from tests.numbers.synthetic import write_raster
from tests.qgis.acceptance.seam_scenes import X, Y, file, seams
from tests.qgis.runs import algorithm, run
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
        found = QgsVectorLayer(path, "worst", "ogr")
        found.setCustomProperty("seam_inspector/mosaic", self.mosaic.id())
        self.project.addMapLayer(found)

    def save(self, folder: Path) -> None:
        folder.mkdir()
        assert self.project.write(str(folder / "block.qgs"))

    def offered(self) -> tuple[str, dict[str, Any]]:
        name, values = offered_form(self.project, Inputs(mosaic=self.mosaic.id()))
        job = algorithm(name.partition(":")[2])
        made = {one.name() for one in job.destinationParameterDefinitions()}
        return name, {key: value for key, value in values.items() if key in made}


@pytest.fixture
def delivery(project: QgsProject, tmp_path: Path) -> Delivery:
    return Delivery(project, tmp_path / "delivered")


@pytest.mark.slow
def test_what_is_signed_lies_beside_the_project(delivery: Delivery, tmp_path: Path) -> None:
    delivery.scan(tmp_path / "scans")
    delivery.save(tmp_path / "project")
    name, values = offered_form(delivery.project, Inputs(mosaic=delivery.mosaic.id()))
    assert name == DECISION
    outcome = run(name.partition(":")[2], **values)
    assert outcome.complaint is None
    assert outcome.results["DECISION"] == "rejected"
    first = {one: Path(outcome.results[one]) for one in ("REPORT", "QUALITY", "DEFECTS")}
    assert {path.parent for path in first.values()} == {tmp_path / "project"}
    assert all(path.stat().st_size for path in first.values())
    assert outcome.layer("DEFECTS").featureCount() == 1
    assert (tmp_path / "project" / "ortho_5_defects_pictures").is_dir()
    _, again = delivery.offered()
    assert {Path(path).stem[-2:] for path in again.values()} == {"_2"}
    assert not {*map(str, first.values())} & {*again.values()}


@pytest.mark.parametrize("earlier", ["ortho_5_quality.xml", "ortho_5_defects_pictures"])
def test_any_earlier_document_gives_all_another_number(delivery: Delivery, tmp_path: Path, earlier: str) -> None:
    delivery.scan(tmp_path)
    delivery.save(tmp_path / "project")
    (tmp_path / "project" / earlier).touch()
    assert Path(delivery.offered()[1]["REPORT"]).name == "ortho_5_report_2.html"


def test_a_project_without_a_file_has_its_documents_beside_the_scan(delivery: Delivery, tmp_path: Path) -> None:
    assert Path(delivery.offered()[1]["accept:report"]).parent == delivery.folder
    delivery.scan(tmp_path / "scans")
    assert Path(delivery.offered()[1]["REPORT"]).parent == tmp_path / "scans"


def test_nothing_is_left_in_the_profile_or_where_nothing_can_be_written(
    delivery: Delivery, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    profile = tmp_path / "profile"
    delivery.scan(profile)
    monkeypatch.setattr(QgsApplication, "qgisSettingsDirPath", lambda: f"{profile}/")
    assert Path(delivery.offered()[1]["REPORT"]).parent == delivery.folder
    monkeypatch.setattr(Path, "home", lambda: tmp_path)
    monkeypatch.setattr(accepting.os, "access", lambda path, mode: Path(path) != delivery.folder)
    assert Path(delivery.offered()[1]["REPORT"]).parent == tmp_path


def test_the_whole_way_keeps_all_that_it_makes(delivery: Delivery, tmp_path: Path) -> None:
    """But for the picture among the delivered sheets, where the next check would take it for a sheet."""
    name, beside_sheets = delivery.offered()
    assert name == WHOLE_WAY
    delivery.save(tmp_path / "project")
    _, offered = delivery.offered()
    assert offered.keys() - beside_sheets.keys() == {"scan:loss"}
    assert {os.path.basename(path) for path in offered.values()} == {
        "ortho_5_report.html", "ortho_5_quality.xml", "ortho_5_failures.gpkg", "ortho_5_checked_sheets.gpkg",
        "ortho_5_mosaic.vrt", "ortho_5_loss.tif", "ortho_5_seams.gpkg", "ortho_5_worst.gpkg",
    }  # fmt: skip


def test_without_a_mosaic_there_is_a_name_too(project: QgsProject, tmp_path: Path) -> None:
    assert project.write(str(tmp_path / "block.qgs"))
    assert offered_form(project, Inputs())[1]["accept:report"] == str(tmp_path / "block_report.html")


@pytest.mark.parametrize("is_scanned", [True, False])
def test_the_form_asks_for_them(
    delivery: Delivery, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, is_scanned: bool
) -> None:
    """They stand in QGIS's form, where the operator may change them."""
    from processing.gui import ParametersPanel
    from processing.gui.AlgorithmDialog import AlgorithmDialog

    monkeypatch.setattr(ParametersPanel, "iface", None)
    if is_scanned:
        delivery.scan(tmp_path)
    delivery.save(tmp_path / "project")
    name, values = offered_form(delivery.project, Inputs(mosaic=delivery.mosaic.id()))
    dialog = AlgorithmDialog(algorithm(name.partition(":")[2]))
    dialog.setParameters(values)
    shown = dialog.createProcessingParameters()
    _, made = delivery.offered()
    assert made
    for output, path in made.items():
        value = shown[output]
        assert path == (value if isinstance(value, str) else value.sink.staticValue())
    dialog.close()
    dialog.deleteLater()


# The form


@pytest.fixture
def forms(delivery: Delivery, qgis_iface: QgisInterface, monkeypatch: pytest.MonkeyPatch) -> Iterator[list[Any]]:
    """The desk's forms, as many as are made; none is left behind."""
    from processing.gui import AlgorithmDialog, ParametersPanel
    from processing.tools import general

    for module in (general, AlgorithmDialog):
        monkeypatch.setattr(module, "iface", qgis_iface)
    monkeypatch.setattr(ParametersPanel, "iface", None)
    monkeypatch.setattr(AlgorithmDialog, "handleAlgorithmResults", lambda *_: True)
    config = AlgorithmDialog.ProcessingConfig
    monkeypatch.setattr(config, "getSetting", lambda name, *_: name == config.KEEP_DIALOG_OPEN)  # as QGIS does
    made: list[Any] = []
    yield made
    for form in made:
        if not sip.isdeleted(form):
            form.close()
    settle()


def new_form(delivery: Delivery, forms: list[Any]) -> Any:
    form = made_form(delivery.project, Inputs(mosaic=delivery.mosaic.id()))
    assert form is not None
    form.show()
    forms.append(form)
    return form


def files_in(form: Any) -> dict[str, Path]:
    """What a form would make, by name."""
    values = form.createProcessingParameters()
    asked = {name: values.get(name) for name in ("REPORT", "QUALITY", "DEFECTS")}
    return {name: Path(one if isinstance(one, str) else one.sink.staticValue()) for name, one in asked.items()}


def finish(form: Any) -> None:
    """Run it, by its button, to the end."""
    ended: list[bool] = []
    form.algorithmFinished.connect(lambda is_successful, _: ended.append(is_successful))
    form.runAlgorithm()
    wait_until(lambda: ended, "for the decision")
    assert ended == [True]
    settle()


@pytest.mark.slow
def test_a_second_run_of_a_form_replaces_no_document(delivery: Delivery, tmp_path: Path, forms: list[Any]) -> None:
    """Not those that the operator named himself either: ``signed_2024`` is no number."""
    delivery.scan(tmp_path / "scans")
    delivery.save(tmp_path / "project")
    form = new_form(delivery, forms)
    form.setParameters({"QUALITY": str(tmp_path / "signed_2024.xml")})
    first = files_in(form)
    finish(form)
    before = {path: path.read_bytes() for path in first.values()}
    second = files_in(form)
    assert {name: path.name for name, path in second.items()} == {
        "REPORT": "ortho_5_report_2.html", "QUALITY": "signed_2024_2.xml", "DEFECTS": "ortho_5_defects_2.gpkg"
    }  # fmt: skip
    finish(form)
    assert all(path.is_file() for path in second.values())
    assert {path: path.read_bytes() for path in first.values()} == before
    assert files_in(form)["REPORT"].name == "ortho_5_report_3.html"


def test_two_open_forms_suggest_different_files(delivery: Delivery, tmp_path: Path, forms: list[Any]) -> None:
    delivery.scan(tmp_path / "scans")
    delivery.save(tmp_path / "project")
    first, second = new_form(delivery, forms), new_form(delivery, forms)
    assert not {*files_in(first).values()} & {*files_in(second).values()}
    first.close()
    settle()
    assert files_in(new_form(delivery, forms))["REPORT"].name == "ortho_5_report.html"


def test_a_form_that_is_closed_is_gone(delivery: Delivery, tmp_path: Path, forms: list[Any]) -> None:
    delivery.save(tmp_path / "project")
    main = QgsApplication.instance()

    def close() -> None:
        shown = [one for one in main.topLevelWidgets() if isinstance(one, QgsProcessingAlgorithmDialogBase)]
        forms.extend(shown)
        for form in shown:
            form.close()

    QTimer.singleShot(0, close)
    open_form(delivery.project, Inputs(mosaic=delivery.mosaic.id()))
    settle()
    assert [sip.isdeleted(form) for form in forms] == [True]


def test_a_file_that_is_being_written_has_its_name(delivery: Delivery, tmp_path: Path) -> None:
    delivery.scan(tmp_path / "scans")
    delivery.save(tmp_path / "project")
    with replacing(tmp_path / "project" / "ortho_5_quality.xml"):
        assert Path(delivery.offered()[1]["REPORT"]).name == "ortho_5_report_2.html"
    assert Path(delivery.offered()[1]["REPORT"]).name == "ortho_5_report.html"


# The page


@pytest.fixture
def page(delivery: Delivery, tmp_path: Path) -> Iterator[AcceptPage]:
    delivery.scan(tmp_path / "scans")
    delivery.save(tmp_path / "project")
    dock = QWidget()
    made = AcceptPage(delivery.project, Inputs(mosaic=delivery.mosaic.id()), dock)
    made.show()
    yield made
    dock.deleteLater()
    settle()


def decided(page: AcceptPage) -> str:
    """What the page says once it has decided."""
    page.decide()
    wait_until(lambda: page.decider.isEnabled(), "for the decision")
    return page.verdict.text()


@pytest.mark.slow
def test_the_page_decides_by_its_limits_and_saves_what_it_made(page: AcceptPage, tmp_path: Path) -> None:
    assert page.values()["MAX_SHARE"] == 2.0
    page.head["CONTRACT"].setText("ZP-12/2026")
    assert decided(page) == "Rejected"
    assert page.reason.text().startswith("25")
    assert not list((tmp_path / "project").glob("ortho*"))
    page.show_failures()
    page.save(tmp_path / "project")
    saved = {path.name for path in (tmp_path / "project").glob("ortho*")}
    assert saved == {"ortho_5_report.html", "ortho_5_defects.gpkg", "ortho_5_defects_pictures", "ortho_5_quality.xml"}
    assert "ZP-12/2026" in (tmp_path / "project" / "ortho_5_report.html").read_text()
    (failures,) = QgsProject.instance().mapLayersByName("Failures")
    assert Path(failures.source()).parent == tmp_path / "project"
    assert failures.featureCount() == 1
    with pytest.raises(SettingsError, match="choose another folder"):
        page.save(tmp_path / "project")


@pytest.mark.slow
def test_other_limits_decide_anew_and_replace_no_document(page: AcceptPage, tmp_path: Path) -> None:
    decided(page)
    page.save(tmp_path / "project")
    before = (tmp_path / "project" / "ortho_5_report.html").read_bytes()
    page.limits["MAX_SHARE"].setValue(100)
    assert decided(page) != "Rejected"
    page.save(tmp_path / "project")
    assert (tmp_path / "project" / "ortho_5_report_2.html").is_file()
    assert (tmp_path / "project" / "ortho_5_report.html").read_bytes() == before


def test_the_page_goes_with_its_project(page: AcceptPage, delivery: Delivery) -> None:
    delivery.project.clear()
    settle()
    assert sip.isdeleted(page)


def test_without_a_scan_nothing_can_be_decided(delivery: Delivery) -> None:
    dock = QWidget()
    page = AcceptPage(delivery.project, Inputs(mosaic=delivery.mosaic.id()), dock)
    assert not page.decider.isEnabled()
    dock.deleteLater()
    settle()
