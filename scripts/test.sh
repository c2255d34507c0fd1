#!/usr/bin/env bash
# Installs what is missing, then runs every check and test.
# usage: bash scripts/test.sh [arguments for pytest]
set -euo pipefail
# shellcheck source=scripts/common.sh
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"

bash "$root/scripts/setup.sh" --dev
# shellcheck source=/dev/null
. "$venv/ortho-paths.sh"
cd "$root"

# All checks run before the verdict, so that one run shows everything there is to mend.
failed=()
check() {
  local name=$1
  shift
  say "== $name"
  "$@" || failed+=("$name")
}

python="$venv/bin/python"
check "ruff check" "$python" -m ruff check .
check "ruff format" "$python" -m ruff format --check .
check "mypy" "$python" -m mypy
# Tests of one file stay together: they share what is costly to make.
check "pytest" "$python" -m pytest -n "$workers" --dist loadfile --durations 40 "$@"

if [ ${#failed[@]} -gt 0 ]; then
  fail "failed: $(printf '%s, ' "${failed[@]}" | sed 's/, $//'); see above"
fi
