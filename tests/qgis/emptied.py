"""Reference systems as QGIS leaves them when a thread ends that was the first to ask for them."""
from __future__ import annotations

import threading
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Callable

from qgis.core import QgsCoordinateReferenceSystem

UNDEFINED = (
    'GEOGCS["Undefined geographic SRS",DATUM["unknown",SPHEROID["unknown",6378137,298.257223563]],'
    'PRIMEM["Greenwich",0],UNIT["degree",0.0174532925199433]]'
)
"""What a GeoPackage says of a table without a system."""


@contextmanager
def asked_in_thread(ask: Callable[[], object]) -> Iterator[None]:
    """Something is asked in a thread that ends with the block."""
    asked, over = threading.Event(), threading.Event()

    def work() -> None:
        held = ask()
        asked.set()
        over.wait()
        del held

    thread = threading.Thread(target=work)
    thread.start()
    assert asked.wait(60)
    try:
        yield
    finally:
        over.set()
        thread.join()
        task = Path(f"/proc/self/task/{thread.native_id}")
        until = time.monotonic() + 60
        while task.exists():  # PROJ's part goes with the system's thread, a moment after Python's is joined
            assert time.monotonic() < until
            time.sleep(0.001)


def emptied_system(wkt: str) -> QgsCoordinateReferenceSystem:
    """A system that was asked for in a thread which has ended: valid, without a text, and what QGIS gives to everybody
    who asks for it, until its cache is invalidated."""
    QgsCoordinateReferenceSystem.invalidateCache()
    with asked_in_thread(lambda: QgsCoordinateReferenceSystem.fromWkt(wkt).toWkt()):
        held = QgsCoordinateReferenceSystem.fromWkt(wkt)
        held.toWkt()  # without this, and that of the thread, QGIS forgets it when any thread ends
    return held
