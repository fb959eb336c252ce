#!/bin/bash
# make_chroot.sh SUITE ROOT WHEELS [MIRROR]: a Debian of that suite with its QGIS and what the tests need in the folder
# ROOT, as root. WHEELS is a folder with pytest-qgis, which no Debian has. Some 4 minutes and 3 GiB; goes on where it was
# broken off. debootstrap knows the mirror where none is given.
set -euo pipefail
SUITE=$1 ROOT=$2 WHEELS=$3 MIRROR=${4:-}
HERE=$(dirname "$(readlink -f "$0")")
PACKAGES="qgis python3-qgis gdal-bin python3-gdal python3-numpy python3-pywt python3-scipy python3-matplotlib
    python3-jinja2 python3-yaml python3-markdown-it python3-pytest python3-pytest-xdist python3-hypothesis python3-skimage
    python3-opencv python3-distributed python3-hatchling python3-venv python3-pip git xvfb xauth libgl1-mesa-dri fonts-dejavu-core
    fonts-open-sans procps poppler-utils"

if ! command -v debootstrap >/dev/null; then
    command -v apt-get >/dev/null || { echo "install debootstrap" >&2; exit 1; }
    DEBIAN_FRONTEND=noninteractive apt-get -q install -y --no-install-recommends debootstrap debian-archive-keyring ||
        { apt-get -q update && DEBIAN_FRONTEND=noninteractive apt-get -q install -y --no-install-recommends debootstrap \
            debian-archive-keyring; }
fi
# sid's script serves every suite, also those that are newer than debootstrap
[ -e "$ROOT/etc/debian_version" ] ||
    debootstrap --variant=minbase --include=ca-certificates "$SUITE" "$ROOT" "$MIRROR" sid
printf 'APT::Install-Recommends "false";\nAcquire::Check-Valid-Until "false";\n' >"$ROOT/etc/apt/apt.conf.d/99matrix"
printf '#!/bin/sh\nexit 101\n' >"$ROOT/usr/sbin/policy-rc.d" # no service starts in there
chmod +x "$ROOT/usr/sbin/policy-rc.d"
cp /etc/resolv.conf "$ROOT/etc/resolv.conf"
mkdir -p "$ROOT/wheels"
cp "$WHEELS"/*.whl "$ROOT/wheels/"
# shellcheck disable=SC2086  # one word a package
"$HERE/in_chroot.sh" "$ROOT" sh -euc '
    export DEBIAN_FRONTEND=noninteractive
    apt-get -q update
    apt-get -q -o Dpkg::Use-Pty=0 install -y "$@"
    apt-get clean
    python3 -m pip install --quiet --root-user-action ignore --break-system-packages --no-index --no-deps /wheels/*.whl
    ' sh $PACKAGES
