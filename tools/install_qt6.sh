#!/bin/sh
# Makes .venv-qt6: PyQt6, what knows the names of QGIS, and the newest scipy that takes the system's numpy, which the
# system's matplotlib and GDAL need; next to the system's packages. Nothing when it is all there.
set -eu
cd "$(dirname "$0")/.."

PYTHON=/usr/bin/python3
constraint=$("$PYTHON" -c 'import numpy; print(f"numpy=={numpy.__version__}")')
stamp=$(cat requirements-qt6.txt tools/qt6/typed_qgis.py tests/qt6/stand_in/qgis/PyQt/*.py && echo "$constraint" &&
    "$PYTHON" -c 'import sys; print(sys.version)')
if [ "$(cat .venv-qt6/stamp 2>/dev/null || true)" != "$stamp" ]; then
    echo "Installing PyQt6 into .venv-qt6"
    rm -rf .venv-qt6
    "$PYTHON" -m venv --system-site-packages .venv-qt6
    echo "$constraint" >.venv-qt6/constraints.txt
    # shellcheck disable=SC2046  # one word a requirement
    .venv-qt6/bin/python -m pip install --quiet --disable-pip-version-check --upgrade -c .venv-qt6/constraints.txt \
        $(sed 's/ *#.*//; /^qgis-stubs/d' requirements-qt6.txt)
    .venv-qt6/bin/python -m pip install --quiet --disable-pip-version-check --no-deps \
        $(sed -n 's/^\(qgis-stubs[^ ]*\).*/\1/p' requirements-qt6.txt)
    .venv-qt6/bin/python tools/qt6/typed_qgis.py .venv-qt6/typings
    echo "$stamp" >.venv-qt6/stamp
fi
