#!/usr/bin/env bash
# Checks everything, after setting up what this machine lacks for it: format, lint, types, the
# layers, the tests that need OpenGL on a virtual screen, and all others.
#
#   bash tests/run.sh
#
# Goes on after a failure, so that one run tells all; ends with 1 if there was any.
set -u

# shellcheck source=assets/setup.sh
. "$(dirname "${BASH_SOURCE[0]}")/../assets/setup.sh"
set_up tests
cd "$project" || exit
unset DISPLAY WAYLAND_DISPLAY
failed=()

# check NAME COMMAND...
check() {
  local name=$1
  shift
  echo "== $name"
  "$@" || failed+=("$name")
}

# start_screen: an X server with OpenGL by Mesa; sets DISPLAY to its number.
start_screen() {
  mkfifo "$scratch/display"
  Xvfb -displayfd 7 -screen 0 1400x900x24 -nolisten tcp -noreset +extension GLX \
    7>"$scratch/display" >"$scratch/Xvfb.log" 2>&1 &
  screen=$!
  trap 'kill "$screen" 2>/dev/null; rm -rf "$scratch"' EXIT
  read -r -t 30 display <"$scratch/display" || {
    tail -n 5 "$scratch/Xvfb.log"
    return 1
  }
  export DISPLAY=:$display
}

test_on_screen() {
  start_screen || return
  QT_QPA_PLATFORM=xcb "$venv/bin/python" -m pytest -m gl tests/gl --continue-on-collection-errors
  local code=$?
  unset DISPLAY
  kill "$screen"
  [ $code = 0 ] || [ $code = 5 ] # 5: there are no such tests
}

# Types take a processor for a minute, which the tests on the screen do not need.
"$venv/bin/mypy" plusedit >"$scratch/types.log" 2>&1 &
types=$!

check_types() {
  wait "$types"
  local code=$?
  cat "$scratch/types.log"
  return $code
}

check "format" "$venv/bin/ruff" format --check .
check "lint" "$venv/bin/ruff" check .
check "layers" "$venv/bin/lint-imports"
check "tests with OpenGL" test_on_screen
check "types" check_types
[ ${#failed[@]} = 0 ] || printf '== FAILED so far: %s\n' "${failed[@]}"
QT_QPA_PLATFORM=offscreen check "tests" "$venv/bin/python" -m pytest -m "not gl" --continue-on-collection-errors \
  --numprocesses auto --maxprocesses 4 --dist worksteal
[ ${#failed[@]} = 0 ]
