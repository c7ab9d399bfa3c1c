#!/usr/bin/env bash
# What is measured now is held against the baseline: a shift is named and fails, a baseline of some
# experiments leaves those of others as they were.
set -euo pipefail
regression=$2/validation/tools/regression
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"

measured() { # measured EXPERIMENT VALUES...: a replicate each
  local stem=$1 number=0
  shift
  { echo "# replicates of $stem, program 0"
    for value; do echo "here|$((number++))|1|0.1|$value ;"; done; } > "$stem.replicates"
  printf '# profile: quick\n' > "${stem}_verdict.csv"
}
expect() { # expect CODE PATTERN ARGUMENT...: one of the lines that are said
  local code=$1 pattern=$2 status=0
  shift 2
  "$regression" -o . --baseline known.csv "$@" > said 2>&1 || status=$?
  if [ "$status" != "$code" ] || ! grep -q -- "$pattern" said; then
    echo "$*: exit code $status where $code and '$pattern' were expected:"
    cat said
    exit 1
  fi
}

expect 2 'known.csv: cannot be read' gas
measured gas 1.00 1.01 1.02
measured crystal 2.00 2.01 2.02
expect 0 'known.csv: 2 values written$' --renew gas crystal
expect 0 '2 values compared, 0 shifted' gas crystal
measured gas 1.50 1.51 1.52
measured crystal 2.50 2.51 2.52
expect 1 'z = .* crystal here \[0\]: 2.51' gas crystal
expect 1 '1 values compared, 1 shifted' gas
expect 0 '1 values written, 1 of other experiments kept' --renew gas
expect 0 '1 values compared, 0 shifted' gas
expect 1 '1 values compared, 1 shifted' crystal
rm crystal.replicates
expect 1 'in the baseline, not measured now: crystal here: 1 values' gas crystal
printf '# profile: full\n' > gas_verdict.csv
expect 2 'gas is of the profile full' gas
