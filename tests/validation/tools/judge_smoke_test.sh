#!/usr/bin/env bash
# What another program measured is judged: balls of theory agree, others do not.
set -euo pipefail
judge=$2/validation/tools/judge
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

# expect CODE LAST_LINE QUANTITY VALUES...: of 108 balls at number density 0.5
expect() {
  local code=$1 last=$2 quantity=$3 status=0
  shift 3
  { echo 'packing_fraction,count,value'
    printf '0.2617993877991494,108,%s\n' "$@"; } > "$folder/runs.csv"
  "$judge" "$quantity" "$folder/runs.csv" > "$folder/said" 2>&1 || status=$?
  if [ "$status" != "$code" ] || [[ $(tail -n 1 "$folder/said") != $last ]]; then
    echo "$quantity $*: exit code $status where $code and '$last' were expected:"
    cat "$folder/said"
    exit 1
  fi
}

expect 0 agrees Z 3.2500 3.2505 3.2510 3.2515 3.2520 # reference/periodic_md.csv
expect 0 agrees collision_rate 7.650 7.652 7.653 7.654 7.656
# A diameter 0.5 % too large, the packing fraction being that of the right one.
expect 1 differs Z 3.3080 3.3085 3.3090 3.3095 3.3100
expect 1 differs collision_rate 7.815 7.817 7.818 7.819 7.821
expect 1 undecided Z 3.1 3.2 3.3
expect 2 'judge: *two replicates' Z 3.25
expect 2 'judge: *runs.csv*' Z many
