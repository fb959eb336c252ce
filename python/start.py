"""The command ``seam-inspector``, also where what it needs is missing: Python's own exit code would mean rejected."""
from __future__ import annotations

import sys

ERROR = 3  # exit code of what is no decision


def main() -> int:
    """Run the command with the arguments of this process, and give its exit code."""
    try:
        from .command_line import main as run
    except ModuleNotFoundError as error:
        sys.stderr.write(f"seam-inspector: {error.name} is missing; install it into this environment, GDAL's bindings "
                         "(osgeo) as python3-gdal of the system or gdal of conda.\n")
        return ERROR
    return run()
