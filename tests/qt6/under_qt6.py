"""Lets tests of tests/qgis that ask little of QGIS run under PyQt6 too, on the stand-in: `-p tests.qt6.under_qt6`."""
from __future__ import annotations

import os
import sys
from collections.abc import Iterator, Sequence
from importlib.abc import MetaPathFinder
from pathlib import Path

import pytest

os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")
CHECKOUT = Path(__file__).resolve().parents[2]
sys.path[:0] = [str(CHECKOUT / "tests" / "qt6" / "stand_in"), str(CHECKOUT / "build" / "plugins"), str(CHECKOUT)]


class _NoPyQt5(MetaPathFinder):
    """QGIS 4 refuses its modules too."""

    def find_spec(self, name: str, path: Sequence[str] | None, target: object = None) -> None:
        if name.partition(".")[0] == "PyQt5":
            raise ImportError(f"{name} must not meet PyQt6")


sys.meta_path.insert(0, _NoPyQt5())

_raised: list[BaseException] = []
sys.excepthook = lambda kind, error, trace: _raised.append(error)  # else PyQt aborts where a slot raises


@pytest.hookimpl(hookwrapper=True)
def pytest_runtest_makereport(item: pytest.Item, call: pytest.CallInfo[None]) -> Iterator[None]:
    """A test that asks for more of QGIS than there is here is none of this run."""
    from qgis.placeholders import NeedsQgis

    answer = yield
    report = answer.get_result()
    if call.excinfo is None:
        return
    missing = [error for error in (call.excinfo.value, *_raised) if isinstance(error, NeedsQgis)]
    if missing:
        _raised.clear()
        report.outcome = "skipped"
        report.longrepr = (str(item.path), 0, f"Skipped: needs QGIS ({missing[0]})")


@pytest.fixture(autouse=True)
def slot_errors() -> Iterator[list[BaseException]]:
    """What Qt slots raised during the test. It fails the test, unless the test takes it off the list."""
    _raised.clear()
    yield _raised
    if _raised:
        raise _raised[0]


@pytest.fixture(scope="session")
def qgis_app() -> object:
    """The application that widgets need."""
    from qgis.core import QgsApplication

    app = QgsApplication.instance() or QgsApplication(["qgis"], True)
    font = app.font()
    font.setPixelSize(17)  # as Qt 5's, so that as much has room
    app.setFont(font)
    return app


@pytest.fixture
def project() -> Iterator[object]:
    from qgis.core import QgsProject

    yield QgsProject.instance()
    QgsProject.instance().clear()


@pytest.fixture(scope="session")
def repository() -> Path:
    return CHECKOUT
