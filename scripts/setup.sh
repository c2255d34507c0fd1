#!/usr/bin/env bash
# Installs what the workbench needs and nothing that is there already:
# FreeCAD and a virtual screen from the distribution, Python packages into .venv.
set -euo pipefail
# shellcheck source=scripts/common.sh
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"

usage() {
  cat <<'TEXT'
usage: bash scripts/setup.sh [--dev]

Installs FreeCAD (Debian, Ubuntu: with apt-get, as root or with sudo) and makes .venv with
FreeCAD's own Python version and the pinned packages of requirements.txt.

  --dev   also what the tests need (requirements-dev.txt, requirements-remesh.txt)

Where FreeCAD is already installed, or the system has no apt-get, these say where things are:
  ORTHO_FREECADCMD   FreeCAD's console program  (looked for: freecadcmd, FreeCADCmd)
  ORTHO_FREECAD      FreeCAD itself             (looked for: freecad, FreeCAD)
  ORTHO_PYTHON       a Python of FreeCAD's own minor version, with venv
TEXT
}

# libgl1 to libxi6: what cadquery and its viewer link to. The fonts are for pictures.
packages=(python3-venv xvfb xauth libgl1 libgl1-mesa-dri libegl1 libglu1-mesa
  libxrender1 libxext6 libxi6 fonts-dejavu-core)

mac=/Applications/FreeCAD.app/Contents

install_from_distribution() {
  command -v apt-get >/dev/null && command -v dpkg-query >/dev/null || return 0
  # A FreeCAD of the user's own takes the place of the distribution's.
  if [ -z "${ORTHO_FREECADCMD:-}" ]; then packages+=(freecad); fi
  local missing=() name log sudo=()
  for name in "${packages[@]}"; do
    dpkg-query -W -f '${db:Status-Status}' "$name" 2>/dev/null | grep -qx installed ||
      missing+=("$name")
  done
  if [ ${#missing[@]} -eq 0 ]; then return 0; fi
  if [ "$(id -u)" -ne 0 ]; then
    command -v sudo >/dev/null ||
      fail "not root and no sudo; have an administrator run: apt-get install ${missing[*]}"
    sudo=(sudo)
  fi
  log=$(mktemp)
  say "installing with apt-get: ${missing[*]} (a few minutes on a new machine)"
  # The package lists may be absent or old: new ones are fetched only when the first try fails.
  if ! apt_get install "${missing[@]}" >"$log" 2>&1; then
    say "fetching the package lists"
    if ! apt_get update >>"$log" 2>&1 || ! apt_get install "${missing[@]}" >>"$log" 2>&1; then
      tail -n 5 "$log" >&2
      fail "apt-get could not install ${missing[*]}; install them by hand and run this again (the whole log: $log)"
    fi
  fi
  rm -f "$log"
}

apt_get() {
  # ${a[@]+...}: an empty array is an unset variable for older shells.
  ${sudo[@]+"${sudo[@]}"} env DEBIAN_FRONTEND=noninteractive \
    apt-get -q -y -o DPkg::Lock::Timeout=300 --no-install-recommends "$@"
}

# first PROGRAM...: the path of the first that can be run.
first() {
  local program
  for program in "$@"; do
    if command -v "$program" 2>/dev/null; then return 0; fi
  done
  return 1
}

# Sets freecadcmd and freecad.
find_freecad() {
  if [ -n "${ORTHO_FREECADCMD:-}" ]; then
    freecadcmd=$(first "$ORTHO_FREECADCMD") ||
      fail "ORTHO_FREECADCMD is '$ORTHO_FREECADCMD', which cannot be run; set it to FreeCAD's console program"
  else
    freecadcmd=$(first freecadcmd FreeCADCmd /usr/lib/freecad/bin/freecadcmd \
      "$mac/Resources/bin/freecadcmd" "$mac/MacOS/FreeCADCmd") ||
      fail "no FreeCAD: looked for freecadcmd and FreeCADCmd; install FreeCAD 0.20.2 or later and set ORTHO_FREECADCMD to its console program"
  fi
  beside=$(dirname "$freecadcmd")
  if [ -n "${ORTHO_FREECAD:-}" ]; then
    freecad=$(first "$ORTHO_FREECAD") ||
      fail "ORTHO_FREECAD is '$ORTHO_FREECAD', which cannot be run; set it to the FreeCAD with the window"
  else
    freecad=$(first "$beside/freecad" "$beside/FreeCAD" freecad FreeCAD "$mac/MacOS/FreeCAD") ||
      fail "found $freecadcmd, but no FreeCAD with a window: looked for freecad and FreeCAD; set ORTHO_FREECAD"
  fi
}

# A checksum of everything that decides what gets installed.
wish() {
  {
    cat "$root/scripts/setup.sh" "$root"/requirements-{exchange,fast,remesh}.txt "${requirements[@]}"
    ls -lL "$freecadcmd"
    printf '%s\n' "$freecad" "${ORTHO_PYTHON:-}"
  } | cksum
}

is_ready() {
  [ -r "$paths" ] && grep -qxF "dev=$dev $(wish)" "$stamp" 2>/dev/null &&
    "$venv/bin/python" -c '' 2>/dev/null
}

# Sets minor (3.11) and release (0.20.2), as FreeCAD itself says.
ask_freecad() {
  local answer
  cat >"$scratch/probe.py" <<'PYTHON'
import sys
import FreeCAD
release = ".".join(part.strip() for part in FreeCAD.Version()[:3])
print("ORTHO-PROBE %d.%d %s" % (sys.version_info[0], sys.version_info[1], release))
PYTHON
  answer=$(FREECAD_USER_HOME="$scratch" "$freecadcmd" "$scratch/probe.py" </dev/null 2>&1 |
    sed -n 's/^.*ORTHO-PROBE //p' | tail -n 1) || true
  [ -n "$answer" ] ||
    fail "$freecadcmd does not start; run it by hand to see why, or set ORTHO_FREECADCMD to another FreeCAD"
  minor=${answer%% *}
  release=${answer#* }
}

# has_minor PROGRAM: is this a Python of FreeCAD's minor version?
has_minor() {
  [ "$("$1" -c 'import sys; print("%d.%d" % sys.version_info[:2])' 2>/dev/null)" = "$minor" ]
}

# Sets python. The distribution's own comes first: FreeCAD was built with that one.
find_python() {
  if [ -n "${ORTHO_PYTHON:-}" ]; then
    has_minor "$ORTHO_PYTHON" ||
      fail "ORTHO_PYTHON is '$ORTHO_PYTHON', but FreeCAD $release runs Python $minor; set it to a Python $minor"
    python=$ORTHO_PYTHON
    return 0
  fi
  for python in "/usr/bin/python$minor" "$beside/python" "$beside/python3" \
    "/usr/local/bin/python$minor" "/opt/homebrew/bin/python$minor" "python$minor"; do
    if has_minor "$python"; then return 0; fi
  done
  fail "FreeCAD $release runs Python $minor, and no python$minor was found; install one with its venv module and set ORTHO_PYTHON to it"
}

make_environment() {
  if [ -e "$venv" ] && ! has_minor "$venv/bin/python"; then
    say "making .venv anew: FreeCAD $release runs Python $minor"
    rm -rf "$venv"
  fi
  if [ -e "$venv" ]; then return 0; fi
  say "making .venv with $python"
  if ! "$python" -m venv "$venv" >"$scratch/log" 2>&1; then
    rm -rf "$venv"
    tail -n 3 "$scratch/log" >&2
    fail "$python cannot make a virtual environment; install its venv module (Debian: python3-venv)"
  fi
}

pip_install() { "$venv/bin/python" -m pip install -q --disable-pip-version-check "$@"; }

install_python_packages() {
  local file arguments=()
  for file in "${requirements[@]}"; do arguments+=(-r "$file"); done
  rm -f "$stamp"
  say "installing Python packages into .venv (a few minutes on a new machine)"
  pip_install "${arguments[@]}" ||
    fail "pip could not install the packages (see above); check the network and pip's own settings, then run this again"
  # One by one: what does not install here must not keep the others away.
  while read -r package; do
    pip_install "$package" >"$scratch/log" 2>&1 ||
      say "$package (requirements-fast.txt) does not install here; something slower or simpler takes its place"
  done < <(grep -v '^#' "$root/requirements-fast.txt")
  while read -r package; do
    pip_install "$package" >"$scratch/log" 2>&1 ||
      say "$package (requirements-exchange.txt) does not install here; its files for other programs are not written"
  done < <(grep -v '^#' "$root/requirements-exchange.txt")
  if [ "$dev" = yes ]; then
    pip_install -r "$root/requirements-remesh.txt" >"$scratch/log" 2>&1 ||
      say "the library that makes quads of triangles (requirements-remesh.txt) does not install here; its tests are skipped"
  fi
}

write_stamp() {
  {
    printf '# ready: FreeCAD %s (%s), Python %s in .venv\n' "$release" "$freecadcmd" \
      "$("$venv/bin/python" -c 'import platform; print(platform.python_version())')"
    printf 'export ORTHO_FREECADCMD=%q ORTHO_FREECAD=%q\n' "$freecadcmd" "$freecad"
  } >"$paths"
  printf 'dev=%s %s\n' "$dev" "$(wish)" >"$stamp"
  if [ "$dev" = yes ]; then # everything that a run without --dev asks for is there too
    requirements=("$root/requirements.txt")
    printf 'dev=no %s\n' "$(wish)" >>"$stamp"
  fi
}

dev=no
for argument in "$@"; do
  case "$argument" in
    --dev) dev=yes ;;
    -h | --help) usage; exit 0 ;;
    *) fail "unknown option '$argument'; see --help" 2 ;;
  esac
done
requirements=("$root/requirements.txt")
if [ "$dev" = yes ]; then requirements+=("$root/requirements-dev.txt"); fi
stamp="$venv/ortho-stamp"
paths="$venv/ortho-paths.sh" # where FreeCAD was found; the other scripts source it

install_from_distribution
find_freecad
if ! is_ready; then
  scratch=$(mktemp -d)
  trap 'rm -rf "$scratch"' EXIT
  ask_freecad
  find_python
  make_environment
  install_python_packages
  write_stamp
fi
sed -n 's/^# //p' "$paths" >&2
