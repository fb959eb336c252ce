#!/bin/bash
# build_qgis_qt6.sh ROOT [MIRROR]: QGIS 3.40 on Qt 6, which no Debian has, built of Debian's source in a trixie in the
# folder ROOT, as root. Leaves ROOT/opt/qgis6 and ROOT/qgis-qt6.tar.xz for `make test-matrix SUITES=qt6 QT6=...`. An hour
# or so on two cores and 8 GiB (a unity build without optimisation, server, 3D, GRASS, PDAL and WebEngine); goes on where
# it was broken off.
set -euo pipefail
ROOT=$1 MIRROR=${2:-}
HERE=$(dirname "$(readlink -f "$0")")
QWT=https://downloads.sourceforge.net/project/qwt/qwt/6.2.0/qwt-6.2.0.tar.bz2 # Debian has it for Qt 5 alone

[ -e "$ROOT/etc/debian_version" ] ||
    debootstrap --variant=minbase --include=ca-certificates trixie "$ROOT" "$MIRROR" sid
printf 'APT::Install-Recommends "false";\nAcquire::Check-Valid-Until "false";\n' >"$ROOT/etc/apt/apt.conf.d/99matrix"
printf '#!/bin/sh\nexit 101\n' >"$ROOT/usr/sbin/policy-rc.d" # no service starts in there
chmod +x "$ROOT/usr/sbin/policy-rc.d"
cp /etc/resolv.conf "$ROOT/etc/resolv.conf"
grep -q '^deb-src' "$ROOT/etc/apt/sources.list" ||
    sed -n 's/^deb /deb-src /p' "$ROOT/etc/apt/sources.list" >>"$ROOT/etc/apt/sources.list"
mkdir -p "$ROOT/src" "$ROOT/build"
cp "$HERE/patch_unity_build.sh" "$ROOT/src/"
"$HERE/in_chroot.sh" "$ROOT" bash -euc '
    export DEBIAN_FRONTEND=noninteractive CCACHE_DIR=/src/ccache
    apt-get -q update
    apt-get -q -o Dpkg::Use-Pty=0 install -y bison flex cmake ninja-build ccache g++ pkgconf dpkg-dev gdal-bin wget bzip2 \
        xz-utils libexiv2-dev libexpat1-dev libgdal-dev libgeos-dev libgsl-dev libpq-dev libproj-dev libprotobuf-dev \
        protobuf-compiler libspatialindex-dev libspatialite-dev libsqlite3-dev libsqlite3-mod-spatialite libzip-dev \
        libzstd-dev nlohmann-json3-dev libqca-qt6-dev libqca-qt6-plugins libqscintilla2-qt6-dev qtkeychain-qt6-dev \
        qt6-base-dev qt6-base-private-dev qt6-svg-dev qt6-positioning-dev qt6-serialport-dev qt6-multimedia-dev \
        qt6-tools-dev qt6-tools-dev-tools qt6-l10n-tools qt6-svg-plugins qt6-5compat-dev qt6-declarative-dev pyqt6-dev \
        pyqt6-dev-tools python3-pyqt6 python3-pyqt6.qsci pyqt6.qsci-dev python3-pyqt6.qtsvg python3-pyqt6.qtpositioning \
        python3-pyqt6.qtmultimedia python3-pyqt6.qtserialport python3-pyqtbuild python3-sipbuild sip-tools python3-dev \
        python3-gdal python3-yaml python3-owslib python3-psycopg2
    cd /src
    [ -d qgis ] || { apt-get -q source --download-only qgis; dpkg-source -x qgis_*.dsc qgis; }
    if [ ! -e /opt/qgis6/lib/libqwt.so ]; then
        [ -d qwt-6.2.0 ] || wget -qO- "$1" | tar xj
        cd qwt-6.2.0
        sed -i -E "s/^( *)(QWT_CONFIG *\+= *Qwt(Designer|Examples|Tests|Playground))/\1#\2/" qwtconfig.pri
        (cd src && qmake6 QWT_OUT_ROOT=/src/qwt-6.2.0 src.pro CONFIG+=release && make -j"$(nproc)" -s)
        mkdir -p /usr/local/include/qwt /opt/qgis6/lib
        cp src/*.h classincludes/* /usr/local/include/qwt/
        cp -a lib/libqwt.so* /opt/qgis6/lib/
    fi
    bash /src/patch_unity_build.sh /src/qgis
    cd /build
    [ -e build.ninja ] || cmake -G Ninja /src/qgis -DCMAKE_BUILD_TYPE=None -DCMAKE_CXX_FLAGS="-O0 -g0 -w" \
        -DCMAKE_C_FLAGS="-O0 -g0 -w" -DCMAKE_UNITY_BUILD=ON -DCMAKE_UNITY_BUILD_BATCH_SIZE=10 -DBUILD_WITH_QT6=ON \
        -DWITH_QTWEBKIT=OFF -DWITH_QTWEBENGINE=OFF -DWITH_3D=OFF -DWITH_GRASS8=OFF -DWITH_GRASS7=OFF -DWITH_SERVER=OFF \
        -DWITH_PDAL=OFF -DWITH_DRACO=OFF -DENABLE_TESTS=OFF -DWITH_QUICK=OFF -DWITH_OAUTH2_PLUGIN=OFF \
        -DWITH_CUSTOM_WIDGETS=OFF -DWITH_POSTGRESQL=OFF -DUSE_OPENCL=OFF -DWITH_QTSERIALPORT=OFF -DWITH_APIDOC=OFF \
        -DWITH_QSCIAPI=OFF -DWITH_INTERNAL_MESHOPTIMIZER=ON -DWITH_INTERNAL_POLY2TRI=ON \
        -DCMAKE_INSTALL_PREFIX=/opt/qgis6 -DQWT_INCLUDE_DIR=/usr/local/include/qwt -DQWT_LIBRARY=/opt/qgis6/lib/libqwt.so
    ninja
    ninja install >/dev/null
    tar -C /opt -cJf /qgis-qt6.tar.xz qgis6
    ' bash "$QWT"
