#!/usr/bin/env bash
# Runs the FreeCAD suites on this machine's FreeCAD and on those of three Debian releases.
set -euo pipefail
# shellcheck source=scripts/common.sh
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"

usage() {
  cat <<'TEXT'
usage: bash scripts/test_matrix.sh [--required] [--only NAME]... [arguments for pytest]

Runs tests/freecad, with and without a window, on FreeCAD 0.20 (Debian bookworm), 1.0 (trixie)
and 1.1 (forky), and prints how long each suite took on each; suites that take minutes run on the
last of these only. This machine's own FreeCAD is tested in place and stands for its release; the
others run in a Debian of their own that is built once and kept (scripts/debian_system.sh; root
only).

  --required    fail where such a Debian cannot be had, instead of saying so and leaving it out
  --only NAME   here, bookworm, trixie or forky
TEXT
}

releases=(bookworm trixie forky)
minutes=25 # for one FreeCAD, so that nothing hangs a night long
cache=${ORTHO_MATRIX_CACHE:-/var/tmp/ortho-matrix}
required=no
only=()
while [ $# -gt 0 ]; do
  case "$1" in
    --required) required=yes ;;
    --only)
      [[ " here ${releases[*]} " == *" ${2:-} "* ]] || fail "--only: expected here, ${releases[*]}" 2
      only+=("$2")
      shift
      ;;
    -h | --help) usage; exit 0 ;;
    *) break ;;
  esac
  shift
done

if [ ${#only[@]} -eq 0 ]; then
  own=$(sed -n 's/^VERSION_CODENAME=//p' /etc/os-release 2>/dev/null) || true
  only=(here)
  for release in "${releases[@]}"; do
    if [ "$release" != "$own" ]; then only+=("$release"); fi
  done
fi

# Suites wait a third of their time, for timers and for what is drawn: one more at once fills that.
at_once=$((workers + 1))
# The one thing that runs here and, copied along, in each of the other systems.
one="bash scripts/setup.sh --dev && . .venv/ortho-paths.sh &&
  .venv/bin/python -m pytest -q tests/freecad \
    -n $at_once --dist load --maxschedchunk 1"' "$@"'

given=("$@")
results=$(mktemp -d)
trap 'rm -rf "$results"' EXIT
failed=() absent=()
newest=${only[${#only[@]} - 1]}
for name in "${only[@]}"; do
  say "== FreeCAD suites: $name"
  code=0
  chosen=()
  if [ "$name" != "$newest" ]; then chosen=(-m "not long_suite"); fi
  set -- ${chosen[@]+"${chosen[@]}"} ${given[@]+"${given[@]}"}
  if [ "$name" = here ]; then
    (cd "$root" && timeout "${minutes}m" bash -c "$one" bash --junitxml "$results/here.xml" "$@") ||
      code=$?
  else
    timeout "${minutes}m" bash "$root/scripts/debian_system.sh" "$name" \
      bash -c "$one" bash --junitxml "results.xml" "$@" || code=$?
    found=$cache/$name/system/ortho/freecad_ortho/results.xml
    if [ "$code" -ne 75 ] && [ -r "$found" ]; then cp "$found" "$results/$name.xml"; fi
  fi
  case "$code" in
    0) ;;
    75) absent+=("$name") ;;
    *) failed+=("$name") ;;
  esac
done

shopt -s nullglob
runs=("$results"/*.xml)
if [ ${#runs[@]} -gt 0 ]; then
  python3 "$root/scripts/matrix_table.py" "${runs[@]}" || failed+=("table")
fi
if [ ${#failed[@]} -gt 0 ]; then fail "failed on: ${failed[*]}; see above"; fi
if [ ${#absent[@]} -gt 0 ]; then
  if [ "$required" = yes ]; then fail "not tested: ${absent[*]}; see above"; fi
  say "not tested: ${absent[*]}; see above"
fi
