#!/bin/bash
# make_chroot.sh SUITE ROOT WHEELS [MIRROR [QGIS]]: a Debian of that suite with its QGIS and what the tests need in the
# folder ROOT, as root. WHEELS is a folder with what no Debian has, such as pytest-qgis. QGIS is one on Qt 6, which
# takes the place of Debian's: what build_qgis_qt6.sh left, as a folder or packed. Some 4 minutes and 3 GiB; goes on where
# it was broken off. debootstrap knows the mirror where none is given, or an empty one.
set -euo pipefail
SUITE=$1 ROOT=$2 WHEELS=$3 MIRROR=${4:-} QGIS=${5:-}
HERE=$(dirname "$(readlink -f "$0")")
DEBIANS_QGIS="qgis python3-qgis"
# The libraries that QGIS is linked with, and what its own plugins import
FOR_QGIS_ON_QT6="libspatialindex8 libspatialite8t64 libsqlite3-mod-spatialite libgsl28 libexiv2-28 libprotobuf-lite32t64
    libzip5 libpq5 libpython3.13 libqca-qt6-2 libqca-qt6-plugins libqscintilla2-qt6-15 libqt6keychain1 libqt6concurrent6
    libqt6core5compat6 libqt6dbus6 libqt6multimedia6 libqt6multimediawidgets6 libqt6network6 libqt6opengl6
    libqt6openglwidgets6 libqt6positioning6 libqt6printsupport6 libqt6quickwidgets6 libqt6sql6-sqlite libqt6svg6
    libqt6svgwidgets6 libqt6uitools6 libqt6xml6 qt6-svg-plugins qt6-qpa-plugins python3-pyqt6 python3-pyqt6.qsci
    python3-pyqt6.qtmultimedia python3-pyqt6.qtpositioning python3-pyqt6.qtserialport python3-pyqt6.qtsvg python3-owslib
    python3-psycopg2 pyqt6-dev-tools zip"
PACKAGES="gdal-bin python3-gdal python3-numpy python3-pywt python3-scipy python3-matplotlib
    python3-jinja2 python3-yaml python3-markdown-it python3-pytest python3-pytest-xdist python3-hypothesis python3-skimage
    python3-opencv python3-distributed python3-hatchling python3-lxml python3-threadpoolctl python3-venv
    libopenblas0-pthread
    python3-pip git xvfb xauth libgl1-mesa-dri fonts-dejavu-core fonts-open-sans procps poppler-utils"
if [ -n "$QGIS" ]; then PACKAGES="$PACKAGES $FOR_QGIS_ON_QT6"; else PACKAGES="$PACKAGES $DEBIANS_QGIS"; fi

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
    # as PyQt6 asks for, and PyQt5 takes; pytest-qgis 5.0.2 does it from QGIS 4 on
    sed -i "s/QSettings.IniFormat/QSettings.Format.IniFormat/; s/QSettings.UserScope/QSettings.Scope.UserScope/" \
        /usr/local/lib/python3*/dist-packages/pytest_qgis/plugin.py
    ' sh $PACKAGES
[ -z "$QGIS" ] || [ -e "$ROOT/opt/qgis6/bin/qgis" ] || {
    mkdir -p "$ROOT/opt"
    if [ -d "$QGIS" ]; then cp -a "$QGIS" "$ROOT/opt/qgis6"; else tar xf "$QGIS" -C "$ROOT/opt"; fi
    # found as Debian's is, by the linker, by Python and on the path
    echo /opt/qgis6/lib >"$ROOT/etc/ld.so.conf.d/qgis6.conf"
    printf '/opt/qgis6/share/qgis/python%s\n' "" /plugins >"$ROOT/usr/lib/python3/dist-packages/qgis6.pth"
    "$HERE/in_chroot.sh" "$ROOT" sh -euc 'ldconfig; ln -sf /opt/qgis6/bin/* /usr/local/bin/'
}
