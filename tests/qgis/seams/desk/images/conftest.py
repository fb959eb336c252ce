"""What the tests of the images panel share."""
from __future__ import annotations

from collections.abc import Iterator

import pytest
from qgis.PyQt.QtWidgets import QApplication, QWidget
from seam_inspector.plugin.seams.desk.images.images_panel import ImagesPanel

from tests.qgis.seams.desk.images.images_desk import Session, make_pictures, open_desk


@pytest.fixture
def session(qgis_app: object) -> Session:
    return Session()


@pytest.fixture
def desk(session: Session) -> Iterator[QWidget]:
    desk = open_desk(session)
    yield desk
    desk.close()
    desk.deleteLater()


@pytest.fixture
def panel(desk: QWidget, session: Session) -> ImagesPanel:
    """Shows window 1 with two sources."""
    session.ready[1] = make_pictures()
    session.select([1])
    panel = desk.findChild(ImagesPanel)
    QApplication.processEvents()
    return panel
