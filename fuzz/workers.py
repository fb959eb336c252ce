"""Workers seen from outside: started, asked, stopped where they take too long or too much."""
from __future__ import annotations

import json
import os
import select
import signal
import subprocess
import sys
import time
from contextlib import suppress
from pathlib import Path
from typing import Any, NoReturn

from fuzz.judging import MOST_BYTES, Report

START_SECONDS = 300.0
CPU_SECONDS = 60.0
"""Time of the processor, which a busy machine does not change."""
IDLE_SECONDS = 60.0
"""Waiting for something that is not the processor."""
_HERE = str(Path(__file__).parent)
_TICKS = os.sysconf("SC_CLK_TCK")


class WorkerLostError(Exception):
    """The process ended or was stopped; the text says how."""


class Worker:
    """A process that plays one case after the other, in a folder of its own."""

    def __init__(self, samples: Path, folder: Path, findings: Path) -> None:
        """``findings``: a file where a case is noted before the process is stopped because of it."""
        folder.mkdir(parents=True, exist_ok=True)
        self.folder, self.played = folder, 0
        self._findings, self._case = findings, ""
        home = folder / "home"
        home.mkdir(exist_ok=True, mode=0o700)
        (folder / "temporary").mkdir(exist_ok=True)
        environment = {
            **os.environ, "HOME": str(home), "TMPDIR": str(folder / "temporary"), "QT_QPA_PLATFORM": "offscreen",
            "XDG_RUNTIME_DIR": str(home), "QGIS_CUSTOM_CONFIG_PATH": str(home / "profile"), "MPLBACKEND": "Agg",
            "PYTHONPATH": os.pathsep.join([os.getcwd(), os.environ.get("PYTHONPATH", "")]),
            "OPENBLAS_NUM_THREADS": "1", "OMP_NUM_THREADS": "1",
        }  # fmt: skip
        environment.pop("GDAL_VRT_ENABLE_PYTHON", None)
        with open(folder / "worker.log", "ab") as log:
            self._process = subprocess.Popen(
                [sys.executable, "-m", "fuzz.worker", str(samples), str(folder), str(os.getpid())],
                stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=log, env=environment, start_new_session=True,
            )  # fmt: skip
        self._rest = b""
        self.kinds: list[str] = self._answer(START_SECONDS)

    def play(self, case: str) -> Report:
        """A report also of a process that is lost; then another worker is needed."""
        self.played += 1
        self._case = case
        assert self._process.stdin is not None
        start = time.monotonic()
        try:
            self._process.stdin.write(case.encode() + b"\n")
            self._process.stdin.flush()
            return Report(**self._answer(CPU_SECONDS))
        except (WorkerLostError, BrokenPipeError) as lost:
            said = self._said()
            how = str(lost) or "crashed"
            return Report(case, how.split(":")[0], [f"{how} / {_last_lines(said)}"], [], said, 0,
                          time.monotonic() - start)

    @property
    def is_lost(self) -> bool:
        return self._process.poll() is not None

    def close(self) -> None:
        if not self.is_lost:
            os.killpg(self._process.pid, signal.SIGKILL)
        self._process.wait()

    def _answer(self, cpu_seconds: float) -> Any:
        """The next line of the process."""
        assert self._process.stdout is not None
        start, used, before = time.monotonic(), self._cpu(), self._kept_waiting()
        while b"\n" not in self._rest:
            if select.select([self._process.stdout], [], [], 0.25)[0]:
                piece = os.read(self._process.stdout.fileno(), 2**20)
                if not piece:
                    self._process.wait()
                    raise WorkerLostError(f"crashed: ended with {self._process.returncode}")
                self._rest += piece
                continue
            worked, waited = self._cpu() - used, self._kept_waiting() - before
            if worked > cpu_seconds or time.monotonic() - start - waited > IDLE_SECONDS + worked:
                self._stop(f"hung: {worked:.0f} s of the processor, {time.monotonic() - start:.0f} s in all")
            if self._memory() > MOST_BYTES:
                self._stop(f"too much memory: over {MOST_BYTES / 2**30:.1f} GB")
        line, self._rest = self._rest.split(b"\n", 1)
        return json.loads(line)

    def _stop(self, how: str) -> NoReturn:
        """Written down first: whatever becomes of the process, or of this one, is known by then."""
        if self._case:
            noted(self._findings, f"{self._case}\n    {how}\n")
        os.kill(self._process.pid, signal.SIGUSR1)  # writes down where it is
        time.sleep(0.5)
        os.killpg(self._process.pid, signal.SIGKILL)
        self._process.wait()
        raise WorkerLostError(how)

    def _cpu(self) -> float:
        try:
            parts = Path(f"/proc/{self._process.pid}/stat").read_text().rpartition(")")[2].split()
        except OSError:
            return 0.0
        return (int(parts[11]) + int(parts[12])) / _TICKS

    def _kept_waiting(self) -> float:
        """Seconds in which it could have run and others had the processor: what a busy machine takes is no hang."""
        waits = [0]
        for thread in Path(f"/proc/{self._process.pid}/task").glob("*/schedstat"):
            with suppress(OSError):
                waits.append(int(thread.read_text().split()[1]))
        return max(waits) / 1e9

    def _memory(self) -> int:
        try:
            return int(Path(f"/proc/{self._process.pid}/statm").read_text().split()[1]) * os.sysconf("SC_PAGE_SIZE")
        except (OSError, IndexError):
            return 0

    def _said(self) -> str:
        folders = sorted((self.folder / "played").glob("*"), key=lambda one: int(one.name))
        path = folders[-1] / "said.txt" if folders else self.folder / "worker.log"
        return path.read_text(errors="replace") if path.is_file() else ""


def noted(path: Path, text: str) -> None:
    """At the end of a file, whole and at once."""
    with open(path, "a", encoding="utf-8", errors="replace") as file:
        file.write(text)


def _last_lines(said: str) -> str:
    lines = [line.strip() for line in said.splitlines() if "File \"" in line and _HERE not in line]
    return " / ".join(lines[:6])[:600]
