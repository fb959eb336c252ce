"""Windows that are measured before anybody asks for them, such as the one under the mouse."""
from __future__ import annotations

from collections import OrderedDict
from concurrent.futures import Future
from dataclasses import replace
from threading import Lock

from ....imagery.raster_pool import ReadEach
from .measured_window import Measured, MeasuredWindow, measure_window
from .window_request import WindowRequest

KEPT = 2  # windows with their pixels, some 10 MB each: the one under the mouse, and the one before


class MeasuredAhead:
    """A ``MeasureWindow`` that keeps the last windows; who asks for one that is under way waits for it."""

    def __init__(self, read_each: ReadEach) -> None:
        self._read_each = read_each
        self._found: OrderedDict[WindowRequest, Future[Measured]] = OrderedDict()
        self._lock = Lock()

    def __call__(self, request: WindowRequest) -> Measured:
        key = replace(request, window_id=0)
        with self._lock:
            future = self._found.get(key)
            if is_new := future is None:
                future = self._found[key] = Future()
                while len(self._found) > KEPT:
                    self._found.popitem(last=False)
        assert future is not None
        if is_new:
            try:
                future.set_result(measure_window(key, self._read_each))
            except Exception as error:
                self._drop(key)
                future.set_exception(error)
        found = future.result()
        return replace(found, request=request) if isinstance(found, MeasuredWindow) else found

    def forget(self) -> None:
        """Let go of the pixels."""
        with self._lock:
            self._found.clear()

    def _drop(self, key: WindowRequest) -> None:
        with self._lock:
            self._found.pop(key, None)
