#!/usr/bin/env bash
# The same targets on a cluster: an experiment under a Slurm of one node, which this script starts
# on loopback and stops again. A state point that Slurm kills is named and measured again alone, and
# the tables are those of one machine, to the bit. It is no part of the test command:
#
#   tests/cluster/one_node_slurm.sh . build      after make -f Makefile.data build, half a minute
#
# Needs Debian's slurm-wlm and munge, and root as slurmd does.
set -euo pipefail

source=$(realpath "$1")
build=$(realpath "$2")
PATH=$PATH:/usr/sbin
for program in munged slurmctld slurmd srun sbatch; do
  if ! command -v "$program" > /dev/null; then
    echo "skipped: no $program: make -f Makefile.data setup CLUSTER=1"
    exit 77
  fi
done
if [ "$(id -u)" != 0 ]; then echo 'skipped: slurmd wants root'; exit 77; fi

work=$(mktemp -d)
daemons=()
stop() {
  for daemon in "${daemons[@]}"; do kill "$daemon" 2> /dev/null || true; done
  for daemon in "${daemons[@]}"; do wait "$daemon" 2> /dev/null || true; done
  rm -rf "$work"
}
trap stop EXIT
failed=0
expect() { # expect WHAT COMMAND...: one law
  local what=$1
  shift
  if "$@"; then echo "ok    $what"; else echo "WRONG $what"; failed=1; fi
}

# ---- Slurm

host=$(hostname -s)
port=$((20000 + RANDOM % 20000))
mkdir -p "$work"/{state,spool}
dd if=/dev/urandom of="$work/munge.key" bs=1 count=128 status=none
chmod 400 "$work/munge.key"
chmod 755 "$work"
munged --foreground --force --key-file="$work/munge.key" --socket="$work/munge.socket" \
  --pid-file="$work/munge.pid" --log-file="$work/munge.log" --seed-file="$work/munge.seed" \
  > "$work/out.munged" 2>&1 &
daemons+=($!)
cat > "$work/slurm.conf" <<CONF
ClusterName=one
SlurmctldHost=$host(127.0.0.1)
SlurmUser=root
AuthInfo=socket=$work/munge.socket
SlurmctldPort=$port
SlurmdPort=$((port + 1))
CommunicationParameters=NoCtldInAddrAny,NoInAddrAny
StateSaveLocation=$work/state
SlurmdSpoolDir=$work/spool
SlurmctldPidFile=$work/slurmctld.pid
SlurmdPidFile=$work/slurmd.pid
SlurmctldLogFile=$work/slurmctld.log
SlurmdLogFile=$work/slurmd.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
MpiDefault=none
ReturnToService=2
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
SchedulerParameters=sched_min_interval=100000
AccountingStorageType=accounting_storage/none
NodeName=$host NodeAddr=127.0.0.1 CPUs=$(nproc) State=UNKNOWN
PartitionName=one Nodes=ALL Default=YES MaxTime=10 State=UP
CONF
export SLURM_CONF=$work/slurm.conf
slurmctld -D > "$work/out.ctld" 2>&1 &
daemons+=($!)
slurmd -D > "$work/out.slurmd" 2>&1 &
daemons+=($!)
for _ in $(seq 100); do
  if sinfo --noheader -o %t 2> /dev/null | grep -q idle; then break; fi
  sleep 0.2
done
if ! sinfo --noheader -o %t 2> /dev/null | grep -q idle; then
  echo 'WRONG Slurm does not start:' && tail -n 5 "$work"/*.log
  exit 1
fi

# ---- an experiment, one process a state point

# A project of one experiment, whose program is compiled already.
project() {
  mkdir -p "$1"/{bin,validation,paper,reference,build/validation}
  cp "$source/Makefile.data" "$1"
  cp "$build/validation/conservation" "$1/build/validation"
  touch "$1"/validation/conservation.cpp "$1"/paper/{style.gp,report.tex} "$1/reference/table.csv"
  for stand_in in cmake dpkg-query apt-get; do
    printf '#!/usr/bin/env bash\nexit 0\n' > "$1/bin/$stand_in"
    chmod +x "$1/bin/$stand_in"
  done
  sed -i -E '/^packages := /,/texlive-publishers/c packages :=' "$1/Makefile.data"
  sed -i -E 's/^test_packages := .*/test_packages :=/' "$1/Makefile.data"
}
measure() { # measure PROJECT [ARGUMENT...]: the exit code in $status, what was printed in output.txt
  status=0
  (cd "$1" && env -u MAKEFLAGS PATH="$1/bin:$PATH" make -f Makefile.data -j4 data "${@:2}") \
    > "$work/output.txt" 2>&1 || status=$?
}
says() { grep -q -- "$1" "$work/output.txt"; }
table() { grep -v '^#' "$1/build/data/conservation.csv"; }

project "$work/alone"
measure "$work/alone"
expect 'on one machine the experiment agrees' test "$status" = 0

# The second state point is killed by Slurm, once.
project "$work/cluster"
cat > "$work/victim" <<SCRIPT
#!/usr/bin/env bash
if [[ "\$*" == *'--point 2' ]] && mkdir "$work/killed" 2> /dev/null; then
  scancel "\$SLURM_JOB_ID"
  sleep 60
fi
exec "\$@"
SCRIPT
chmod +x "$work/victim"
measure "$work/cluster" LAUNCH="srun -n1 $work/victim"
expect 'a state point that Slurm killed is named' says 'conservation: state point 2 broke off'
expect 'it fails the whole' test "$status" != 0
measure "$work/cluster" LAUNCH="srun -n1 $work/victim"
expect 'it is measured again' says 'walls packing_fraction=0.3 .*: measuring 1 of 1 replicates'
expect 'and it alone' test "$(grep -c ': measuring' "$work/output.txt")" = 1
expect 'to a good end' test "$status" = 0
expect 'the table is that of one machine, to the bit' \
  diff <(table "$work/alone") <(table "$work/cluster")

# ---- a sweep over a table of state points

cat > "$work/points.csv" <<TABLE
container.packing_fraction,balls.count,run.seed
0.10,100,1
0.20,100,2
0.90,100,3
0.30,100,4
TABLE
sweep=$source/validation/tools/sweep.sh
scene=$source/validation/scenes/dilute.toml
export CLACK=$build/clack
"$sweep" "$work/points.csv" "$scene" "$work/here" > /dev/null 2>&1 || true
sbatch --wait --chdir="$work" --array=1-4 "$sweep" "$work/points.csv" "$scene" "$work/there" \
  > /dev/null 2>&1 || true
"$sweep" --collect "$work/points.csv" "$work/here" > "$work/here.csv" 2> "$work/here.txt" || true
status=0
"$sweep" --collect "$work/points.csv" "$work/there" > "$work/there.csv" 2> "$work/there.txt" ||
  status=$?
expect 'a row that cannot be run is named' grep -q '^row 3: not there: .*packing_fraction' \
  "$work/there.txt"
expect 'and fails the collection' test "$status" = 1
expect 'the others are there' test "$(wc -l < "$work/there.csv")" = 4
expect 'a sweep collects the table of one machine, to the bit' \
  diff "$work/here.csv" "$work/there.csv"

exit "$failed"
