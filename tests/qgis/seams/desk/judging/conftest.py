"""What the tests of judging share."""
from __future__ import annotations

from collections.abc import Iterator

import pytest
from qgis.core import QgsProject
from qgis.PyQt.QtCore import QObject, pyqtSignal
from seam_inspector.plugin.seams.desk.judge_bar import JudgeBar
from seam_inspector.plugin.seams.desk.judging import Judging
from seam_inspector.plugin.seams.desk.windows.windows_panel import WindowsPanel

from tests.qgis.seams.desk.windows_session import Show, WindowsSession


class NoPieces(QObject):
    """No piece of a scanned seam is clicked."""

    changed = pyqtSignal()
    current = None

    def judge(self) -> bool:
        return False


class Asked:
    """The operator who is asked before many windows are judged at once."""

    def __init__(self) -> None:
        self.questions: list[str] = []
        self.answer = True

    def __call__(self, question: str) -> bool:
        self.questions.append(question)
        return self.answer


@pytest.fixture
def asked() -> Asked:
    return Asked()


@pytest.fixture
def judging(session: WindowsSession, panel: WindowsPanel, asked: Asked, project: QgsProject) -> Iterator[Judging]:
    made = Judging(session, panel.ordered_fids, asked)
    yield made
    made.close()


@pytest.fixture
def bar(session: WindowsSession, panel: WindowsPanel, judging: Judging, show: Show) -> JudgeBar:
    bar = JudgeBar(session, judging, NoPieces(panel))
    panel.orderChanged.connect(bar.refresh)
    show(bar)
    return bar
