#!/usr/bin/env bash
# The event loop costs the instructions that it cost when they were last counted. Time on a shared
# machine wanders by a quarter; instructions do not wander at all, so a loss of a few per cent shows.
#
#   instruction_count_smoke_test.sh SOURCE BUILD            compares with the numbers kept
#   instruction_count_smoke_test.sh SOURCE BUILD --renew    keeps what is counted now
#
# The program counted is one for a fixed set of instructions (tests/CMakeLists.txt), so the numbers
# are the same on every machine with this compiler.
set -euo pipefail
shopt -s inherit_errexit

kept=$1/tests/simulation/instruction_counts.csv
program=$2/tests/instruction_count
band=3 # per cent: below what is worth an engineer's look, above what a change of library makes
renew='make -f Makefile.data recount'

skip() {
  echo "skipped: the instructions of the event loop were not counted: $1"
  exit 77 # what ctest takes for skipped
}
[ -x "$program" ] || skip 'that takes a build by g++ for x86-64'
command -v valgrind > /dev/null || skip 'valgrind is not installed'
grep -qw avx2 /proc/cpuinfo || skip 'this machine has no AVX2'
compiler=$("$program" --version)
if [ "${3:-}" != --renew ] && ! grep -qx "# compiler: $compiler" "$kept"; then
  skip "this is $compiler, and the numbers kept are those of $(sed -n 's/^# compiler: //p' "$kept")"
fi

count() { # count SCENE: instructions of the event loop per collision
  local report collisions
  report=$(valgrind --tool=callgrind --callgrind-out-file=/dev/null --toggle-collect=counted \
             "$program" "$1" 2>&1)
  collisions=$(sed -nE 's/^([0-9]+)$/\1/p' <<< "$report")
  awk -v of="$collisions" '/Collected : [1-9]/ { printf "%.0f\n", $NF / of; found = 1 }
                           END { exit !found }' <<< "$report" ||
    { printf 'no count of %s:\n%s\n' "$1" "$report" >&2; return 1; }
}

if [ "${3:-}" = --renew ]; then
  counts=$(for scene in $("$program"); do now=$(count "$scene"); echo "$scene,$now"; done)
  cat > "$kept" <<FILE
# Instructions of the event loop per ball-ball collision, counted by valgrind's callgrind over the
# scenes of tests/simulation/instruction_count.cpp. Renewed by: $renew
# compiler: $compiler
scene,instructions
$counts
FILE
  cat "$kept"
  exit
fi

failed=0
for scene in $("$program"); do
  before=$(sed -n "s/^$scene,//p" "$kept")
  now=$(count "$scene")
  if [ -z "$before" ]; then
    verdict="WRONG no number is kept; keep this one: $renew"
  elif [ $((100 * now)) -gt $(((100 + band) * before)) ]; then
    verdict="WRONG more than kept: the engine has become slower; if it must be, keep it: $renew"
  elif [ $((100 * now)) -lt $(((100 - band) * before)) ]; then
    verdict="WRONG fewer than kept: an improvement that is not recorded; keep it: $renew"
  else
    verdict=ok
  fi
  echo "$scene: $now instructions a collision, kept ${before:-none}, band $band %: $verdict"
  if [ "$verdict" != ok ]; then failed=1; fi
done
exit "$failed"
