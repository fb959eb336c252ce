"""What all tests share: the package under its name, real data, and property tests that repeat exactly."""
from __future__ import annotations

import os
import sys
from pathlib import Path

import pytest
from hypothesis import HealthCheck, settings

REPOSITORY = Path(__file__).resolve().parents[1]
PLUGINS = REPOSITORY / "build" / "plugins"

# The package is called seam_inspector, whatever the checkout's folder is called.
LINK = PLUGINS / "seam_inspector"
if not LINK.exists():
    PLUGINS.mkdir(parents=True, exist_ok=True)
    LINK.symlink_to("../..", target_is_directory=True)
sys.path.insert(0, str(PLUGINS))

_DESKTOP_BEGUN = 0.7
"""Share of the run by which all files of the real application are begun: the last ones take a while."""

for profile, examples in (("all", 60), ("quick", 10)):
    settings.register_profile(
        profile,
        derandomize=True,
        deadline=None,
        max_examples=examples,
        suppress_health_check=[HealthCheck.too_slow, HealthCheck.data_too_large],
    )


def pytest_addoption(parser: pytest.Parser) -> None:
    parser.addoption("--quick", action="store_true", help="without tests that are slow or read real data; few examples")


def pytest_configure(config: pytest.Config) -> None:
    settings.load_profile("quick" if config.getoption("quick") else "all")


def pytest_collection_modifyitems(config: pytest.Config, items: list[pytest.Item]) -> None:
    turns = _turns(items)
    items.sort(key=lambda item: turns[item.path])
    if config.getoption("quick"):
        config.hook.pytest_deselected(items=[item for item in items if _is_slow(item)])
        items[:] = [item for item in items if not _is_slow(item)]


def _turns(items: list[pytest.Item]) -> dict[Path, float]:
    """When the tests of a file are begun, 0 to 1: long ones first, so that none is left for the end. The real
    application waits as often as it works, so its files come among the others, which take the processor meanwhile."""
    long_files = {item.path for item in items if _is_slow(item)}
    files = sorted(dict.fromkeys(item.path for item in items), key=lambda path: path not in long_files)
    desktop = [path for path in files if path.parent.name == "desktop"]
    others = [path for path in files if path.parent.name != "desktop"]
    ends = (others, 1.0), (desktop, _DESKTOP_BEGUN)
    return {path: end * turn / len(kind) for kind, end in ends for turn, path in enumerate(kind)}


def pytest_collection_finish(session: pytest.Session) -> None:
    if session.config.getoption("quick"):
        sys.addaudithook(_refuse_processes)


def _refuse_processes(event: str, _arguments: object) -> None:
    if event in ("subprocess.Popen", "os.fork", "os.posix_spawn"):
        raise AssertionError("A quick test starts no process: mark it as slow.")


def _is_slow(item: pytest.Item) -> bool:
    is_marked = any(item.get_closest_marker(name) is not None for name in ("slow", "release"))
    return is_marked or "data_folder" in getattr(item, "fixturenames", ())


@pytest.fixture(scope="session")
def repository() -> Path:
    """The checkout's folder."""
    return REPOSITORY


@pytest.fixture(scope="session")
def data_folder() -> Path:
    """The real rasters, which are no part of the repository."""
    folder = Path(os.environ.get("SEAM_INSPECTOR_DATA", REPOSITORY.parent / "shared" / "data"))
    if not folder.is_dir():
        pytest.skip(f"no real data at {folder}; set SEAM_INSPECTOR_DATA to its folder")
    return folder


@pytest.fixture(scope="session")
def brighton(data_folder: Path) -> Path:
    """The folder of eight orthoimages, the two mosaics of them and their seamlines."""
    return data_folder / "seams" / "brighton"
