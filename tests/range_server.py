"""A web server on this machine that knows Range requests, counts what it sends, and fails as it is told."""
from __future__ import annotations

import re
import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from dataclasses import dataclass, field
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path


@dataclass(frozen=True)
class Answer:
    """One request and what was sent."""

    method: str
    path: str  # below the folder, with its leading slash and without a query
    start: int  # first byte asked for; 0 without a range
    stop: int | None  # behind the last byte asked for; None without an end
    status: int  # 0 where no answer was given
    sent: int = 0  # bytes of the file


@dataclass(frozen=True)
class Fault:
    """What goes wrong with one answer."""

    status: int = 0  # the answer is this status and nothing else
    silent: bool = False  # no answer at all, until the server is closed
    dropped: bool = False  # the connection is closed at once
    dripping: float = 0.0  # seconds from each byte to the next
    cut_to: float = 1.0  # share of the bytes that are sent before the connection is closed
    claimed: int = 0
    """So many bytes more than there are, of the file and of what is sent, are said to come; the connection stays."""
    endless: bool = False  # whatever is asked for, bytes come and never end


NONE = Fault()


@dataclass
class RangeServer:
    """What was asked for so far, and how to fail."""

    folder: Path
    port: int = 0
    answers: list[Answer] = field(default_factory=list)
    fault: Callable[[Answer], Fault] = lambda asked: NONE  # given what was asked for, before it is answered
    closing: threading.Event = field(default_factory=threading.Event)

    def address(self, name: str) -> str:
        """Address of a file in the folder."""
        return f"http://127.0.0.1:{self.port}/{name}"

    def vsi(self, name: str) -> str:
        """Address of a file as GDAL opens it."""
        return f"/vsicurl/{self.address(name)}"

    @property
    def sent(self) -> int:
        """Bytes of files that were sent."""
        return sum(answer.sent for answer in self.answers)

    def forget(self) -> None:
        """Count from here on."""
        self.answers.clear()


@contextmanager
def serving(folder: Path) -> Iterator[RangeServer]:
    """The files of a folder, no listings of folders."""
    state = RangeServer(folder)

    class Handler(_Handler):
        server_state = state

    server = ThreadingHTTPServer(("127.0.0.1", 0), Handler)
    server.daemon_threads = True
    state.port = server.server_address[1]
    thread = threading.Thread(target=server.serve_forever, kwargs={"poll_interval": 0.02}, daemon=True)
    thread.start()
    try:
        yield state
    finally:
        state.closing.set()
        server.shutdown()
        server.server_close()
        thread.join(10)


class _Handler(BaseHTTPRequestHandler):
    protocol_version = "HTTP/1.1"
    server_state: RangeServer

    def do_GET(self) -> None:
        state = self.server_state
        path = self.path.partition("?")[0]
        wanted = re.fullmatch(r"bytes=(\d+)-(\d*)", self.headers.get("Range", ""))
        start = int(wanted[1]) if wanted else 0
        stop = int(wanted[2]) + 1 if wanted and wanted[2] else None
        asked = Answer(self.command, path, start, stop, 0)
        fault = state.fault(asked)
        file = state.folder / path.lstrip("/")
        data = file.read_bytes() if file.is_file() else None
        part = (data or b"")[start:stop]
        if fault.silent:
            state.answers.append(asked)
            state.closing.wait(60)
        if fault.endless:
            state.answers.append(asked)
            self._send_for_ever()
        if fault.silent or fault.dropped or fault.endless:
            self.close_connection = True
            return
        status = fault.status or (404 if data is None else 416 if wanted and not part else 206 if wanted else 200)
        if status not in (200, 206):
            part = b""
        self.send_response(status)
        if status == 206 and data is not None:
            last, size = start + len(part) - 1 + fault.claimed, len(data) + fault.claimed
            self.send_header("Content-Range", f"bytes {start}-{last}/{size}")
        self.send_header("Accept-Ranges", "bytes")
        if data is not None:
            self.send_header("ETag", f'"{file.stat().st_mtime_ns}"')
        self.send_header("Content-Length", str(len(part) + fault.claimed))
        sent = part[: int(len(part) * fault.cut_to)] if self.command == "GET" else b""
        state.answers.append(Answer(self.command, path, start, stop, status, len(sent)))
        self.end_headers()  # from here on the other side may go on
        with suppress(BrokenPipeError):  # the other side had enough
            for byte in sent if fault.dripping else ():
                state.closing.wait(fault.dripping)
                self.wfile.write(bytes([byte]))
            self.wfile.write(b"" if fault.dripping else sent)
            if fault.claimed and self.command == "GET":
                self.wfile.flush()
                state.closing.wait(60)
                self.close_connection = True
        if fault.cut_to < 1:
            self.close_connection = True

    def _send_for_ever(self) -> None:
        self.send_response(200)
        self.end_headers()
        with suppress(BrokenPipeError, ConnectionResetError):
            while self.command == "GET" and not self.server_state.closing.wait(0.001):
                self.wfile.write(bytes(65536))

    def do_HEAD(self) -> None:
        self.do_GET()

    def log_message(self, format: str, *args: object) -> None:
        """The answers are told by ``answers``."""
