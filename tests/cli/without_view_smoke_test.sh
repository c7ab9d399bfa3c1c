#!/usr/bin/env bash
# The program as it is built where the viewer's libraries are missing: it does all but show.
set -euo pipefail

program=$2/clack_without_view
scene=$1/validation/scenes/two_balls.toml
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
failed=0

expect() { # expect WHAT COMMAND...: one law
  local what=$1
  shift
  if "$@"; then echo "ok    $what"; else echo "WRONG $what"; failed=1; fi
}

status=0
"$program" view "$scene" --screenshot "$work/none.png" > "$work/output.txt" 2>&1 || status=$?
expect 'to view is refused' test "$status" = 2
expect 'in one line' test "$(wc -l < "$work/output.txt")" = 1
expect 'which says why, and what to do' \
  grep -q '^clack: view .*without the viewer; install .*libglfw3-dev' "$work/output.txt"
expect 'and leaves no picture' test ! -e "$work/none.png"
expect 'but a scene runs' "$program" run "$scene" -o "$work/run.h5" --quiet
expect 'to a whole file' "$program" check "$work/run.h5"
exit $failed
