#!/bin/sh
# Installs the mosaicking programs that `make benchmark-programs` compares, each that the system's packages have; nothing
# when they are all there. The benchmark says which are missing.
set -eu

PACKAGES="gdal-bin python3-gdal otb-bin saga grass-core enblend enfuse python3-rasterio"

as_root() {
    if [ "$(id -u)" -eq 0 ]; then
        "$@"
    else
        sudo "$@"
    fi
}

for package in $PACKAGES; do
    status=$(dpkg-query -W -f='${db:Status-Status}' "$package" 2>/dev/null || true)
    [ "$status" = installed ] || missing="${missing:-} $package"
done
[ -n "${missing:-}" ] || exit 0
as_root apt-get -q update
for package in $missing; do
    echo "Installing $package"
    as_root env DEBIAN_FRONTEND=noninteractive apt-get -q -o DPkg::Lock::Timeout=300 -o Dpkg::Use-Pty=0 \
        install -y --no-install-recommends "$package" || echo "$package could not be installed" >&2
done
