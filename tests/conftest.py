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

settings.register_profile(
    "seam_inspector",
    derandomize=True,
    deadline=None,
    max_examples=60,
    suppress_health_check=[HealthCheck.too_slow, HealthCheck.data_too_large],
)
settings.load_profile("seam_inspector")


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
