#!/bin/bash
# in_chroot.sh [--data FOLDER] ROOT COMMAND...: run it inside ROOT, as root; FOLDER is seen there as /data, read-only.
# Mounts and processes are private and vanish with it, whatever the command left behind, so removing ROOT stays safe.
set -euo pipefail
DATA=
if [ "$1" = --data ]; then
    DATA=$2
    shift 2
fi
ROOT=$(readlink -f "$1")
shift
# The inner bash is the first process in there, and as such collects the orphans
exec unshare --mount --propagation private --pid --fork --kill-child bash -euc '
    ROOT=$1 DATA=$2
    shift 2
    mount -t proc proc "$ROOT/proc"
    mount --rbind /dev "$ROOT/dev"
    mount -t tmpfs tmpfs "$ROOT/run"
    if [ -n "$DATA" ]; then
        mkdir -p "$ROOT/data"
        mount --bind -o ro "$DATA" "$ROOT/data"
    fi
    code=0
    chroot "$ROOT" env -i PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin HOME=/root LANG=C.UTF-8 \
        XDG_RUNTIME_DIR=/run ${http_proxy:+http_proxy="$http_proxy"} ${https_proxy:+https_proxy="$https_proxy"} "$@" ||
        code=$?
    exit "$code"
    ' bash "$ROOT" "$DATA" "$@"
