"""The speed of the measurement: `make benchmark`, or `.venv/bin/python -m benchmarks.run [--quick]`.

Everything runs on one core unless its table says otherwise: the libraries' own threads are switched off here, before
numpy is loaded, as in the Makefile. A variable that is already set is left as it is.
"""
from __future__ import annotations

import os
import sys
from pathlib import Path

for _variable in ("OPENBLAS_NUM_THREADS", "OMP_NUM_THREADS", "MKL_NUM_THREADS", "GDAL_NUM_THREADS"):
    os.environ.setdefault(_variable, "1")

# The package is called seam_inspector, whatever the checkout's folder is called.
_LINK = Path(__file__).resolve().parents[1] / "build" / "plugins" / "seam_inspector"
if not _LINK.exists():
    _LINK.parent.mkdir(parents=True, exist_ok=True)
    _LINK.symlink_to("../..", target_is_directory=True)
if str(_LINK.parent) not in sys.path:
    sys.path.insert(0, str(_LINK.parent))
