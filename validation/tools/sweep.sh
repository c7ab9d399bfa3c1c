#!/usr/bin/env bash
#SBATCH --job-name=clack-sweep
#SBATCH --ntasks=1
#SBATCH --output=/dev/null
# Runs one scene at every state point of a table, and collects one table of results.
#
#   validation/tools/sweep.sh TABLE.csv SCENE.toml OUT             all rows, one after the other
#   sbatch --array=1-N validation/tools/sweep.sh TABLE.csv SCENE.toml OUT     row k in task k
#   validation/tools/sweep.sh --collect TABLE.csv OUT > results.csv
#
# The table's first line names keys of scene files, each further line is a state point:
#   container.packing_fraction,balls.count,run.seed
#   0.10,500,1
# What is finished is kept, OUT/<row>.json; a row that failed is named in OUT/<row>.failed and by
# --collect, and is run again, alone, by the same command. From the project's folder, after
# `make -f Makefile.data build`; elsewhere CLACK names the program.
set -euo pipefail

row_of() { sed -n "$(($2 + 1))p" "$1"; } # row_of TABLE K

run() { # run TABLE SCENE OUT K
  local table=$1 scene=$2 out=$3 k=$4 keys values set=()
  if [ -s "$out/$k.json" ]; then return; fi
  IFS=, read -r -a keys < "$table"
  IFS=, read -r -a values <<< "$(row_of "$table" "$k")"
  for i in "${!keys[@]}"; do set+=(--set "${keys[i]}=${values[i]}"); done
  mkdir -p "$out"
  if "${CLACK:-build/clack}" run "$scene" "${set[@]}" -o "$out/$k.h5" --hash --json --quiet \
      > "$out/$k.part" 2> "$out/$k.failed"; then
    mv "$out/$k.part" "$out/$k.json"
    rm -f "$out/$k.failed"
  else
    echo "row $k: $(tail -n 1 "$out/$k.failed")" >&2
    return 1
  fi
}

field() { sed -n "s/^ *\"$2\": \"\\{0,1\\}\\([^\",]*\\)\"\\{0,1\\},\\{0,1\\}\$/\\1/p" "$1" | head -n 1; }

collect() { # collect TABLE OUT
  local rows status=0
  rows=$(($(wc -l < "$1") - 1))
  echo "$(head -n 1 "$1"),Z_virial,Z_virial_error,ball_collisions,hash"
  for k in $(seq "$rows"); do
    local result=$2/$k.json
    if [ ! -s "$result" ]; then
      echo "row $k: not there: $(cat "$2/$k.failed" 2> /dev/null)" >&2
      status=1
      continue
    fi
    echo "$(row_of "$1" "$k"),$(field "$result" value),$(field "$result" error),$(
      field "$result" ball_collisions),$(field "$result" hash)"
  done
  return "$status"
}

if [ "${1:-}" = --collect ] && [ $# = 3 ]; then
  collect "$2" "$3"
elif [ $# = 3 ] && [ -n "${SLURM_ARRAY_TASK_ID:-}" ]; then
  run "$1" "$2" "$3" "$SLURM_ARRAY_TASK_ID"
elif [ $# = 3 ]; then
  status=0
  for k in $(seq $(($(wc -l < "$1") - 1))); do run "$1" "$2" "$3" "$k" || status=1; done
  exit "$status"
else
  sed -n '5,16s/^# \{0,1\}//p' "$0" >&2
  exit 2
fi
