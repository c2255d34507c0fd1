# Sourced by the other scripts: where the project is and how they speak.
# shellcheck shell=bash

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
# shellcheck disable=SC2034 # used by the scripts that source this file
venv="$root/.venv"

# Processes that tests are shared out to, and threads of each: more than the processors slow all.
workers=$(getconf _NPROCESSORS_ONLN 2>/dev/null || echo 1)
# shellcheck disable=SC2034
if [ "$workers" -gt 4 ]; then workers=4; fi
export OMP_NUM_THREADS=${OMP_NUM_THREADS:-1} OPENBLAS_NUM_THREADS=${OPENBLAS_NUM_THREADS:-1}

say() { printf '%s\n' "$*" >&2; }

# fail MESSAGE [EXIT_CODE]: one line that says what is wrong and what to do.
fail() {
  printf '%s: %s\n' "$(basename "$0")" "$1" >&2
  exit "${2:-1}"
}
