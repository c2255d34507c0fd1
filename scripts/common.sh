# Sourced by the other scripts: where the project is and how they speak.
# shellcheck shell=bash

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
# shellcheck disable=SC2034 # used by the scripts that source this file
venv="$root/.venv"

say() { printf '%s\n' "$*" >&2; }

# fail MESSAGE [EXIT_CODE]: one line that says what is wrong and what to do.
fail() {
  printf '%s: %s\n' "$(basename "$0")" "$1" >&2
  exit "${2:-1}"
}
