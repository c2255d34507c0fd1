#!/usr/bin/env bash
# Runs a command of this project in a Debian of another release, which is built once and kept.
# usage: bash scripts/debian_system.sh RELEASE COMMAND [ARGUMENT...]      (as root)
#
# The project and ../shared are copied in anew each time; .venv in there is kept. Where things are:
#   ORTHO_MATRIX_CACHE    the systems, 4 GB each (default: /var/tmp/ortho-matrix)
#   ORTHO_MATRIX_MIRROR   where Debian is fetched from (default: where this Debian's apt does)
# Exit code 75: the system cannot be had here; one line says why.
set -euo pipefail
# shellcheck source=scripts/common.sh
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"

unavailable=75
[ $# -ge 2 ] || fail "expected a Debian release and a command" 2
release=$1
shift
home=${ORTHO_MATRIX_CACHE:-/var/tmp/ortho-matrix}/$release
system=$home/system
inside=/ortho/freecad_ortho # the project's place in that system

os_release() { sed -n "s/^$1=\"\{0,1\}\([^\"]*\)\"\{0,1\}\$/\1/p" /etc/os-release 2>/dev/null; }

mirror() {
  if [ -n "${ORTHO_MATRIX_MIRROR:-}" ]; then
    printf '%s\n' "$ORTHO_MATRIX_MIRROR"
  elif [ "$(os_release ID)" = debian ]; then
    # shellcheck disable=SC2016 # apt's own variables
    apt-get indextargets --format '$(REPO_URI) $(RELEASE)' 'Created-By: Packages' |
      awk -v release="$(os_release VERSION_CODENAME)" '$2 == release && !n++ { print $1 }'
  fi
}

has_debootstrap() {
  command -v debootstrap >/dev/null && return 0
  command -v apt-get >/dev/null || return 1
  apt-get -q -y install debootstrap >/dev/null 2>&1 && return 0
  apt-get -q update >/dev/null 2>&1 && apt-get -q -y install debootstrap >/dev/null 2>&1
}

# A half-built system is never taken for a whole one.
build() {
  local script=/usr/share/debootstrap/scripts/$release source
  has_debootstrap || fail "$release: debootstrap is missing and apt-get cannot install it" $unavailable
  source=$(mirror)
  [ -n "$source" ] ||
    fail "$release: this is no Debian; set ORTHO_MATRIX_MIRROR to a mirror of Debian" $unavailable
  # A release that is newer than debootstrap is built like the unstable one.
  [ -e "$script" ] || script=/usr/share/debootstrap/scripts/sid
  say "$release: building a Debian (a few minutes, once)"
  rm -rf --one-file-system "$system.partial"
  if ! debootstrap --variant=minbase --include=ca-certificates "$release" "$system.partial" \
    "$source" "$script" >"$home/build.log" 2>&1; then
    tail -n 3 "$home/build.log" >&2
    fail "$release: could not be built, see above (the whole log: $home/build.log)" $unavailable
  fi
  mkdir -p "$system.partial$inside"
  mv "$system.partial" "$system"
}

copy_project() {
  find "$system$inside" -mindepth 1 -maxdepth 1 ! -name .venv -exec rm -rf {} +
  tar -C "$root" --exclude=./.venv --exclude=./.git --exclude=__pycache__ --exclude='./.*_cache' \
    -cf - . | tar -C "$system$inside" --no-same-owner -xf -
  rm -rf "$system$inside/../shared"
  if [ -d "$root/../shared" ]; then cp -rL "$root/../shared" "$system$inside/../shared"; fi
}

# The files and folders of this machine that name resolution, pip and the certificates go by;
# of an index of packages on disk the folder round its "simple", which holds the packages.
network_files() {
  local python=python3
  if [ -x "$venv/bin/python" ]; then python=$venv/bin/python; fi
  printf '%s\n' /etc/resolv.conf /etc/hosts "${SSL_CERT_FILE:-}" "${PIP_CONFIG_FILE:-}"
  "$python" -m pip config debug 2>/dev/null | sed -n 's/^ *\(\/.*\), exists: True$/\1/p'
  { "$python" -m pip config list 2>/dev/null; env | grep '^PIP_'; } |
    grep -oE "(file://|[ '=])/[^][ ,'\"]+" | sed -E "s#^(file://|[ '=])##; s#/simple/?\$##"
}

# These mounts live in this process's own namespace and end with it.
mount_all() {
  local path
  mount -t proc proc "$system/proc"
  mount -t sysfs -o ro sys "$system/sys"
  mount --rbind /dev "$system/dev"
  network_files | sort -u | while IFS= read -r path; do
    if [ ! -e "$path" ]; then continue; fi
    mkdir -p "$system$(dirname "$path")"
    if [ -d "$path" ]; then mkdir -p "$system$path"; else : >>"$system$path"; fi
    mount --bind "$path" "$system$path"
    mount -o remount,bind,ro "$system$path"
  done
  apt-config dump 2>/dev/null | grep -E '^Acquire::(http|https|Check|Retries|AllowInsecure)' \
    >"$system/etc/apt/apt.conf.d/90machine" || true
}

[ "$(id -u)" -eq 0 ] || fail "$release: only root can build and enter a system" $unavailable
if [ -z "${ORTHO_ALONE:-}" ]; then
  unshare --mount --pid --fork true 2>/dev/null ||
    fail "$release: this machine lets even root mount nothing (a container without that right)" \
      $unavailable
  # Whatever is mounted and started in namespaces of its own is gone with them, however this ends.
  exec env ORTHO_ALONE=yes unshare --mount --pid --fork --kill-child --mount-proc \
    bash "${BASH_SOURCE[0]}" "$release" "$@"
fi

mkdir -p "$home"
exec 8>"$home/lock"
flock 8 # runs at the same time take turns
[ -d "$system" ] || build
copy_project
mount_all
kept=()
while IFS= read -r setting; do kept+=("$setting"); done < <(env | grep -E \
  '^(PIP_|SSL_CERT_|REQUESTS_CA_BUNDLE=|CURL_CA_BUNDLE=|[a-zA-Z]+_(proxy|PROXY)=|OPENBLAS_|OMP_|ORTHO_TEST_)')
exec env -i HOME=/root LANG=C.UTF-8 TERM=dumb PATH=/usr/sbin:/usr/bin:/sbin:/bin \
  ${kept[@]+"${kept[@]}"} chroot "$system" bash -c "cd $inside && exec \"\$@\"" bash "$@"
