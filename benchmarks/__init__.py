"""The speed of the measurement: `make benchmark`, or `.venv/bin/python -m benchmarks.run [--quick]`.

Where the Makefile switches the libraries' own threads off everything runs on one core, unless its table says otherwise;
the scan is measured without that, as a user runs it.
"""
from __future__ import annotations

import sys
from pathlib import Path

# The package is called seam_inspector, whatever the checkout's folder is called.
_LINK = Path(__file__).resolve().parents[1] / "build" / "plugins" / "seam_inspector"
if not _LINK.exists():
    _LINK.parent.mkdir(parents=True, exist_ok=True)
    _LINK.symlink_to("../..", target_is_directory=True)
if str(_LINK.parent) not in sys.path:
    sys.path.insert(0, str(_LINK.parent))
