#!/bin/sh
# Install what only tests need and pip cannot bring: Chromium, LinuxCNC, gcc, PostgreSQL,
# Ghostscript and nginx, if we may.
set -u
missing=""
command -v chromium >/dev/null 2>&1 || missing="$missing chromium"
command -v rs274 >/dev/null 2>&1 || missing="$missing linuxcnc-uspace"
command -v gs >/dev/null 2>&1 || missing="$missing ghostscript"
command -v gcc >/dev/null 2>&1 || missing="$missing gcc libc6-dev"
command -v initdb >/dev/null 2>&1 || ls /usr/lib/postgresql/*/bin/initdb >/dev/null 2>&1 ||
    missing="$missing postgresql"
[ -x /usr/sbin/nginx ] || command -v nginx >/dev/null 2>&1 || missing="$missing nginx-light"
[ -n "$missing" ] || exit 0
if [ "$(id -u)" != 0 ] || ! command -v apt-get >/dev/null 2>&1; then
    echo "without$missing: their tests will skip"
    exit 0
fi
export DEBIAN_FRONTEND=noninteractive
apt-get update -qq && apt-get install -qq -y --no-install-recommends $missing >/dev/null ||
    echo "could not install$missing: their tests will skip"
exit 0
