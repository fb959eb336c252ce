"""How long the interface stands still."""
from __future__ import annotations

import sys
import threading
import time
import traceback
from pathlib import Path
from typing import Any

from qgis.PyQt.QtCore import Qt, QTimer

_PERIOD_MS = 2
_LONG_S = 0.05


class Gaps:
    """The event loop's longest gaps: ``with Gaps() as gaps: ...``, while a true event loop runs.

    On a busy machine a gap by the clock may be somebody else's. The processor time that the interface's thread takes
    between two turns of its loop is its own: with processors to itself it stalls no longer than that, but for waiting.
    """

    def __init__(self) -> None:
        self.longest_s = 0.0
        """Longest gap by the clock."""
        self.longest_work_s = 0.0
        """Longest work of the interface's thread."""
        self.long_ones: list[tuple[float, float, str]] = []
        """Gap, work in it, and where Python was."""
        self._timer = QTimer()
        self._timer.setTimerType(Qt.TimerType.PreciseTimer)
        self._timer.timeout.connect(self._tick)
        self._clock = self._worked = 0.0
        self._seen = ""
        self._on = False
        self._thread = threading.get_ident()
        self._watch = threading.Thread(target=self._watch_stack, daemon=True)

    def __enter__(self) -> Gaps:
        self._clock, self._worked, self._on = time.perf_counter(), time.thread_time(), True
        self._timer.start(_PERIOD_MS)
        self._watch.start()
        return self

    def __exit__(self, *_: object) -> None:
        self._timer.stop()
        self._tick()
        self._on = False
        self._watch.join()

    def note(self, report: dict[str, Any], name: str) -> None:
        """How long the interface stood still, into a report."""
        report[f"{name}_gap_ms"] = 1000 * self.longest_s
        report[f"{name}_work_ms"] = 1000 * self.longest_work_s
        report[f"{name}_gaps"] = self.long_ones

    def _tick(self) -> None:
        clock, worked = time.perf_counter(), time.thread_time()
        gap, work = clock - self._clock, worked - self._worked
        self.longest_s, self.longest_work_s = max(self.longest_s, gap), max(self.longest_work_s, work)
        if gap > _LONG_S:
            self.long_ones.append((gap, work, self._seen))
        self._clock, self._worked, self._seen = clock, worked, ""

    def _watch_stack(self) -> None:
        while self._on:
            time.sleep(0.02)
            if time.perf_counter() - self._clock > _LONG_S * 0.7 and not self._seen:
                stack = traceback.extract_stack(sys._current_frames()[self._thread])
                places = [f"{Path(frame.filename).name}:{frame.lineno} {frame.name}" for frame in stack[-6:]]
                self._seen = " > ".join(places)
