"""`make test-matrix`: what it says of a run, and where another QGIS can't be had."""
from __future__ import annotations

import os
import shutil
import subprocess
from pathlib import Path
from typing import Any

import pytest

from tools.qgis_matrix import places, run
from tools.qgis_matrix.places import Chroot, PlaceError
from tools.qgis_matrix.run import Row, ended, table

VERSIONS = {"QGIS": "3.40.6", "Qt": "5.15.15", "Python": "3.13.5"}


@pytest.mark.parametrize(
    ("code", "last", "passed", "told"),
    [
        (0, "== 812 passed, 3 skipped, 1 warning in 90.1s ==", True, "812 passed, 3 skipped"),
        (0, "== 12 passed in 9s ==", True, "12 passed"),
        (0, "== 3 skipped in 0.1s ==", False, "FAILED (nothing ran)"),
        (1, "== 2 failed, 10 passed, 1 error in 9s ==", False, "3 FAILED of 13"),
        (4, "ImportError: no module", False, "FAILED (exit code 4)"),
        (134, "", False, "FAILED (exit code 134)"),
        (134, "== 12 passed in 9s ==", False, "FAILED (exit code 134)"),
        (124, "tests/qgis ....", False, "out of time"),
    ],
)
def test_how_a_step_ended(code: int, last: str, passed: bool, told: str) -> None:
    assert ended(code, f"1 failed\n{last}\n") == (passed, told)


def test_the_table_has_a_line_for_each_qgis() -> None:
    results = {"numbers": "812 passed, 3:02", "qgis": "1 FAILED of 9, 0:40", "desktop": "2 passed, 1:10"}
    good = Row("trixie", VERSIONS, results, 292.0, "output/matrix/qgis-3.40.png")
    heading, first, second = table([good, Row("sid", failed=True)]).splitlines()
    assert heading.split() == [*VERSIONS, "numbers", "qgis", "desktop", "time", "picture"]
    assert first.split()[:4] == ["trixie", *VERSIONS.values()]
    assert heading.index("desktop") == first.index("2 passed, 1:10") == second.rindex("not run")
    assert first.endswith("4:52  output/matrix/qgis-3.40.png")


def test_a_qgis_that_cannot_be_had_fails_the_run_with_a_sentence(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(os, "geteuid", lambda: 1000)
    monkeypatch.setattr(shutil, "which", lambda name: None)
    monkeypatch.setattr(run, "OUTPUT", tmp_path)
    monkeypatch.setattr(run, "make_package", lambda folder: folder / "plugin.zip")
    monkeypatch.setattr("sys.argv", ["run", "--suites", "trixie", "--chroots", str(tmp_path)])
    assert run.main() == 1
    assert "trixie: A chroot with another Debian needs root: install sudo, or run as root." in capsys.readouterr().out


def test_a_machine_without_mounts_of_ones_own_is_told(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def refused(command: list[str], **_options: Any) -> subprocess.CompletedProcess[str]:
        return subprocess.CompletedProcess(command, 1, "", "unshare: unshare failed: Operation not permitted\n")

    monkeypatch.setattr(os, "geteuid", lambda: 0)
    monkeypatch.setattr(shutil, "which", lambda name: "/usr/bin/" + name)
    monkeypatch.setattr(places.subprocess, "run", refused)
    with pytest.raises(PlaceError, match=r"no mounts of one's own \(unshare: .* not permitted\).*SYS_ADMIN"):
        Chroot("sid", tmp_path).prepare(tmp_path / "plugin.zip", tmp_path / "log")


def test_a_debian_that_cannot_be_installed_is_told(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def broken(command: list[str], **_options: Any) -> subprocess.CompletedProcess[str]:
        return subprocess.CompletedProcess(command, int("unshare" not in command), "", "")

    monkeypatch.setattr(os, "geteuid", lambda: 0)
    monkeypatch.setattr(shutil, "which", lambda name: "/usr/bin/" + name)
    monkeypatch.setattr(places.subprocess, "run", broken)
    with pytest.raises(PlaceError, match=r"Debian sid can't be installed into .*MIRROR=address"):
        Chroot("sid", tmp_path).prepare(tmp_path / "plugin.zip", tmp_path / "log")
    assert not (tmp_path / "sid.stamp").exists()
