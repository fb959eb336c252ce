"""What is released, built as a publisher builds it: in a clone of the last commit."""
from __future__ import annotations

import os
import subprocess
import sys
from collections.abc import Mapping
from pathlib import Path

import pytest


def cloned(repository: Path, folder: Path) -> Path:
    """A clone of the checkout's last commit."""
    command = ["git", "-c", "safe.directory=*", "clone", "--quiet", str(repository), str(folder)]
    made = subprocess.run(command, capture_output=True, text=True, check=False)
    if made.returncode:
        pytest.skip(f"not a git checkout, so there is nothing to clone: {made.stderr.strip()}")
    return folder


def run_tool(
    clone: Path, tool: str, *arguments: str, environment: Mapping[str, str] | None = None, umask: int = -1
) -> subprocess.CompletedProcess[str]:
    """One of the clone's own tools."""
    inherited = {name: value for name, value in os.environ.items() if not name.startswith(("PYTHON", "GIT_"))}
    return subprocess.run(
        [sys.executable, "-m", f"tools.{tool}", *arguments], cwd=clone, env={**inherited, **(environment or {})},
        capture_output=True, text=True, check=False, umask=umask,
    )  # fmt: skip


def built(clone: Path, tool: str, environment: Mapping[str, str] | None = None, umask: int = -1) -> Path:
    """What a tool makes in the clone's build folder."""
    run = run_tool(clone, tool, environment=environment, umask=umask)
    assert run.returncode == 0, run.stdout + run.stderr
    return Path(run.stdout.strip())
