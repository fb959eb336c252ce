#!/bin/sh
# install.sh [demo|package]: installs what the Makefile's targets need, or only what `make demo` or `make package` needs;
# nothing when it is all there:
# - QGIS and its tools from the system's packages (Debian 12 or Ubuntu 22.04, or newer)
# - Python packages into .venv, which sees the system's ones: QGIS's bindings exist only there; the demo does without, and
#   the package has its few in .venv-package where there is no .venv
set -eu
cd "$(dirname "$0")/.."

PYTHON=/usr/bin/python3 # another python3 on the path would not see QGIS
PACKAGES="qgis python3-qgis python3-gdal python3-numpy python3-pywt python3-scipy python3-matplotlib python3-jinja2
    python3-yaml"
[ "${1:-}" != package ] || [ ! -e .venv/stamp ] || set -- # whoever has .venv makes the package with it
if [ "${1:-}" = package ]; then
    PACKAGES="git python3-venv python3-pip qttools5-dev-tools"
elif [ "${1:-}" != demo ]; then
    PACKAGES="$PACKAGES git gdal-bin libopenblas0-pthread python3-venv python3-pip pyqt5-dev-tools qttools5-dev-tools
        xvfb xauth xdotool libgl1-mesa-dri fonts-dejavu-core fonts-open-sans procps poppler-utils"
    # It prints the reports in a test, which is skipped without it: Ubuntu has it as a snap alone, not from apt-get
    grep -qs '^ID=ubuntu' /etc/os-release || PACKAGES="$PACKAGES chromium"
fi

as_root() {
    if [ "$(id -u)" -eq 0 ]; then
        "$@"
    elif command -v sudo >/dev/null; then
        sudo "$@"
    else
        echo "Installing system packages needs root: install sudo, or run as root: $*" >&2
        exit 1
    fi
}

apt() {
    as_root env DEBIAN_FRONTEND=noninteractive apt-get -q -o DPkg::Lock::Timeout=300 -o Dpkg::Use-Pty=0 "$@"
}

missing_packages() {
    for package in $PACKAGES; do
        status=$(dpkg-query -W -f='${db:Status-Status}' "$package" 2>/dev/null || true)
        [ "$status" = installed ] || echo "$package"
    done
}

if ! command -v apt-get >/dev/null; then
    echo "This script knows apt-get only (Debian, Ubuntu). Install the likes of these by hand:" $PACKAGES >&2
    exit 1
fi
missing=$(missing_packages)
if [ -n "$missing" ]; then
    echo "Installing system packages:" $missing
    apt update
    # shellcheck disable=SC2086  # one word a package
    apt install -y --no-install-recommends $missing
fi
[ "${1:-}" != demo ] || exit 0
if [ "${1:-}" = package ]; then
    if [ "$(cat .venv-package/stamp 2>/dev/null || true)" != "$(cat requirements-package.txt)" ]; then
        echo "Installing Python packages into .venv-package"
        rm -rf .venv-package
        "$PYTHON" -m venv .venv-package
        .venv-package/bin/python -m pip install --quiet --disable-pip-version-check -r requirements-package.txt
        cp requirements-package.txt .venv-package/stamp
    fi
    exit 0
fi

# What is measured is measured with the system's own packages, as in QGIS there; another numpy would break GDAL's arrays.
constraints=$("$PYTHON" -c '
from importlib.metadata import version
for name in ("numpy", "scipy", "PyWavelets"):
    print(f"{name}=={version(name)}")')
# The stamp tells what .venv was made from: a changed requirement or a new system Python makes it anew.
stamp=$(cat requirements*.txt && echo "$constraints" && "$PYTHON" -c 'import sys; print(sys.version)')
if [ "$(cat .venv/stamp 2>/dev/null || true)" != "$stamp" ]; then
    echo "Installing Python packages into .venv"
    rm -rf .venv
    "$PYTHON" -m venv --system-site-packages .venv
    echo "$constraints" >.venv/constraints.txt
    .venv/bin/python -m pip install --quiet --disable-pip-version-check -c .venv/constraints.txt -r requirements-dev.txt
    echo "$stamp" >.venv/stamp
fi
