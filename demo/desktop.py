"""Starts the real QGIS desktop with the plugin, in a throwaway profile on a virtual screen, and plays a scenario in it.

A scenario is a Python file with a function ``play(desk: Desk) -> None``; see demo/desk.py.
"""
from __future__ import annotations

import json
import os
import shutil
import signal
import subprocess
import sys
import time
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

REPOSITORY = Path(__file__).resolve().parents[1]
_PLUGIN = REPOSITORY / "build" / "plugins" / "seam_inspector"
_SETTINGS = """\
[locale]
overrideFlag=true
userLocale={locale}
globalLocale={locale}

[UI]
UITheme={theme}

[qgis]
checkVersion=false
iconSize=24
"""
_ENABLED = """
[PythonPlugins]
seam_inspector=true
"""


@dataclass(frozen=True)
class Run:
    """What became of one start of QGIS."""

    code: int | None
    """Exit code of the process; None when it had to be killed."""
    seconds: float
    status: str
    """``passed``, or why not."""
    report: dict[str, Any]
    """What the scenario measured."""
    raised: list[str]
    """Tracebacks of what Qt slots raised."""
    output: str
    """What QGIS wrote."""
    seconds_to_exit: float
    """From the scenario's end to the process's."""


def why_not() -> str:
    """Why the desktop can't be started here; empty when it can."""
    missing = [program for program in ("qgis", "xvfb-run") if shutil.which(program) is None]
    return f"{' and '.join(missing)} not installed" if missing else ""


def play(
    scenario: Path,
    folder: Path,
    parameters: Mapping[str, object] | None = None,
    *,
    seconds: float = 300,
    screen: str = "1600x1000",
    theme: str = "default",
    scale: int = 1,
    locale: str = "en_US",
    linked: bool = True,
) -> Run:
    """Start QGIS, play a scenario, wait for the end of the process. The profile is made in the folder.

    It has the checkout as its plugin, ``linked``, or none.
    """
    folder.mkdir(parents=True, exist_ok=True)
    profiles = _make_profile(folder / "profiles", theme, locale, linked)
    job, status_file, log = folder / "job.json", folder / "status.json", folder / "qgis.log"
    status_file.unlink(missing_ok=True)
    job.write_text(
        json.dumps({
            "repository": str(REPOSITORY),
            "scenario": str(scenario),
            "status": str(status_file),
            "folder": str(folder),
            "size": screen,
            "parameters": dict(parameters or {}),
        })
    )
    command = ["xvfb-run", "-a", "-s", f"-screen 0 {screen}x24 +extension GLX", "qgis", "--profiles-path"]
    command += [str(profiles), "--nologo", "--noversioncheck", "--code", str(REPOSITORY / "demo" / "player.py")]
    start = time.time()
    with open(log, "wb") as output:
        code = _run(command, _environment(job, folder, scale), output, seconds)
    end = time.time()
    status: dict[str, Any] = {}
    if status_file.exists():
        status = json.loads(status_file.read_text())
    ended = float(status.get("ended", end))
    missing = f"no status after {end - start:.0f} s"
    return Run(
        code,
        end - start,
        str(status.get("status", missing)),
        status.get("report", {}),
        status.get("raised", []),
        log.read_text(errors="replace"),
        end - ended,
    )


def _run(command: list[str], environment: dict[str, str], output: Any, seconds: float) -> int | None:
    """The exit code; None when time was up. Everything that was started is ended then."""
    process = subprocess.Popen(
        command, env=environment, stdout=output, stderr=subprocess.STDOUT, stdin=subprocess.DEVNULL,
        start_new_session=True,
    )  # fmt: skip
    try:
        return process.wait(seconds)
    except subprocess.TimeoutExpired:
        return None
    finally:
        if process.poll() is None:
            for number, patience in ((signal.SIGTERM, 5), (signal.SIGKILL, 5)):
                os.killpg(process.pid, number)
                try:
                    process.wait(patience)
                    break
                except subprocess.TimeoutExpired:
                    continue


def _make_profile(folder: Path, theme: str, locale: str, linked: bool) -> Path:
    """A profile with nothing but the plugin, linked and enabled, or with nothing at all."""
    shutil.rmtree(folder, ignore_errors=True)
    plugins, settings = folder / "profiles/default/python/plugins", folder / "profiles/default/QGIS/QGIS3.ini"
    settings.parent.mkdir(parents=True)
    settings.write_text(_SETTINGS.format(locale=locale, theme=theme) + (_ENABLED if linked else ""))
    if linked:
        plugins.mkdir(parents=True)
        (plugins / "seam_inspector").symlink_to(_PLUGIN.resolve(), target_is_directory=True)
    return folder


def _environment(job: Path, folder: Path, scale: int) -> dict[str, str]:
    """Ours, less what make and the tests set for QGIS without a desktop."""
    unwanted = {
        "QT_QPA_PLATFORM", "QGIS_PLUGINPATH", "QGIS_CUSTOM_CONFIG_PATH", "PYTHONPATH", "DISPLAY", "XAUTHORITY",
        "OPENBLAS_NUM_THREADS", "OMP_NUM_THREADS",
    }  # fmt: skip
    environment = {name: value for name, value in os.environ.items() if name not in unwanted}
    runtime = folder / "runtime"
    runtime.mkdir(mode=0o700, exist_ok=True)
    environment |= {
        "SEAM_INSPECTOR_JOB": str(job),
        "XDG_RUNTIME_DIR": str(runtime),  # else Qt warns
        "TMPDIR": str(runtime),  # else QGIS takes a block in /tmp for temporary layers, and asks before it forgets them
    }
    if scale != 1:
        environment |= {"QT_SCALE_FACTOR": str(scale)}
    if sys.prefix != sys.base_prefix:  # QGIS runs on the system's Python
        environment.pop("VIRTUAL_ENV", None)
    return environment
