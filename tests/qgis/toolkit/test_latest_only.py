"""Work that is overtaken is not done."""
from __future__ import annotations

import threading
import time
from collections.abc import Callable, Iterator

import pytest
from qgis.core import QgsApplication
from qgis.PyQt.QtCore import QThread
from seam_inspector.plugin.toolkit.background_tasks import LatestOnly

from tests.patience import PATIENCE_S


@pytest.fixture
def worker(qgis_app: QgsApplication) -> Iterator[LatestOnly]:
    made = LatestOnly("test")
    yield made
    made.close()


def until(condition: Callable[[], object]) -> None:
    end = time.monotonic() + PATIENCE_S
    while not condition():
        assert time.monotonic() < end
        QgsApplication.processEvents()


def test_the_newest_takes_the_place_of_the_one_that_waits(worker: LatestOnly) -> None:
    done, arrived, threads = [], [], []
    begun, may_end = threading.Event(), threading.Event()

    def work(number: int) -> int:
        done.append(number)
        threads.append(threading.get_ident())
        begun.set()
        assert may_end.wait(PATIENCE_S)
        return number

    def take(number: int) -> None:
        arrived.append(number)
        assert QThread.currentThread() is worker.thread()

    worker.arrived.connect(take)
    worker.ask(lambda: work(1))
    assert begun.wait(PATIENCE_S)
    for number in (2, 3, 4):
        worker.ask(lambda number=number: work(number))
    may_end.set()
    until(lambda: len(arrived) == 2)
    assert done == arrived == [1, 4]
    assert set(threads) != {threading.get_ident()}
    assert len(set(threads)) == 1


def test_nothing_comes_of_what_was_asked_before_forget(worker: LatestOnly) -> None:
    arrived = []
    begun, may_end = threading.Event(), threading.Event()

    def work() -> str:
        begun.set()
        assert may_end.wait(PATIENCE_S)
        return "old"

    worker.arrived.connect(arrived.append)
    worker.ask(work)
    assert begun.wait(PATIENCE_S)
    worker.forget()
    may_end.set()
    worker.ask(lambda: "new")
    until(lambda: arrived)
    assert arrived == ["new"]


def test_what_nobody_foresaw_is_told_and_work_goes_on(worker: LatestOnly) -> None:
    arrived, failed = [], []
    worker.arrived.connect(arrived.append)
    worker.failed.connect(failed.append)
    worker.ask(lambda: 1 // 0)
    until(lambda: failed)
    worker.ask(lambda: 7)
    until(lambda: arrived)
    assert "ZeroDivisionError" in str(failed[0])
    assert arrived == [7]
