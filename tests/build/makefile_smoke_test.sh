#!/usr/bin/env bash
# Makefile.data on a made-up project: what runs, what is kept, what is redone, how it fails.
# The compiler, gnuplot and LaTeX are stand-ins: an "experiment" is a shell script.
set -euo pipefail

source=$1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
unset MAKEFLAGS MFLAGS MAKELEVEL PROFILE JOBS CHECKS
failed=0

expect() { # expect WHAT COMMAND...: one law
  local what=$1
  shift
  if "$@"; then echo "ok    $what"; else echo "WRONG $what"; failed=1; fi
}
says() { grep -q -- "$1" output.txt; }
ran() { [ "$(sort runs.txt 2> /dev/null | xargs)" = "$*" ]; }
run() { # run [ARGUMENT...]: the exit code in $status, what was printed in output.txt
  : > runs.txt
  status=0
  PATH=$work/bin:$PATH make -f Makefile.data "$@" > output.txt 2>&1 || status=$?
}
experiment() { # experiment STEM [COMMAND]: notes that it ran, writes its data
  cat > "validation/$1.cpp" <<SCRIPT
#!/usr/bin/env bash
case "\$5" in
  --list) cat $1.points 2> /dev/null; exit ;;
  --point) echo $1.\$6 >> runs.txt; [ ! -e $1.broken.\$6 ]; exit ;;
esac
echo $1 >> runs.txt
echo 1 > "\$4/$1.csv"
${2:-exit 0}
SCRIPT
}

mkdir -p bin validation paper reference
cp "$source/Makefile.data" .
cat > bin/cmake <<'SCRIPT'
#!/usr/bin/env bash
mkdir -p build/validation
for source in validation/*.cpp; do
  program=build/validation/$(basename "$source" .cpp)
  sed '/^# /d' "$source" > "$program"
  chmod +x "$program"
done
SCRIPT
cat > bin/gnuplot <<'SCRIPT'
#!/usr/bin/env bash
echo "drew $3" >> runs.txt
figure=${2#*figure=\'}
echo figure > "${figure%\'}"
SCRIPT
cat > bin/latexmk <<'SCRIPT'
#!/usr/bin/env bash
echo report >> runs.txt
for option; do case $option in -outdir=*) echo pdf > "${option#*=}/report.pdf" ;; esac; done
SCRIPT
printf '#!/usr/bin/env bash\nexit 0\n' > bin/dpkg-query
cp bin/dpkg-query bin/apt-get
chmod +x bin/*
sed -i '/^packages := /,/texlive-publishers/c packages :=' Makefile.data
sed -i 's/^test_packages := .*/test_packages :=/' Makefile.data
touch paper/style.gp paper/one.gp paper/report.tex paper/references.bib reference/table.csv
experiment one
experiment two

run
expect 'a first run measures, draws and typesets' \
  ran drew paper/one.gp one report two
expect 'and succeeds' test "$status" = 0
expect 'and says where the results are' \
  says '^data: build/data  figures: build/figures  report: build/report.pdf$'

run
expect 'a second run redoes nothing' ran
expect 'and succeeds' test "$status" = 0

touch validation/*.cpp
run
expect 'a touched source redoes nothing' ran
echo '# a comment, gone when compiled' >> validation/one.cpp
run
expect 'a program of the same content redoes nothing' ran
echo ': # changed' >> validation/two.cpp
run
expect 'a changed program redoes its own experiment' ran report two
touch paper/one.gp
run
expect 'a changed figure is drawn again' ran drew paper/one.gp report
echo 1 > reference/table.csv
run
expect 'changed references redo what reads them' ran drew paper/one.gp one report two
rm build/data/two.csv
run
expect 'results thrown away are measured again' ran report two

run PROFILE=full
expect 'the other profile is measured' ran drew paper/one.gp one report two
expect 'beside the first' test -s build/full/report.pdf
run
expect 'which is kept' ran
run PROFILE=long
expect 'an unknown profile is refused' says 'PROFILE = long: must be quick or full'

printf 'hot\ncold\n' > two.points
: > two.broken.2
echo ': # changed again' >> validation/two.cpp
run
expect 'state points are measured by a process each' ran report two.1 two.2
expect 'one that breaks off is named' says '^two: state point 2 broke off with exit code 1'
expect 'and fails the whole' test "$status" != 0
rm two.broken.2
run LAUNCH='env LAUNCHED=yes'
expect 'the next make goes on with them, and then judges' ran report two two.1 two.2
expect 'to a good end' test "$status" = 0
rm two.points
printf '#!/usr/bin/env bash\necho launched >> runs.txt\nexec "$@"\n' > bin/launcher
chmod +x bin/launcher
rm build/data/two.csv
run LAUNCH=launcher
expect 'what LAUNCH names starts them' ran launched report two

meet='touch there.$$; for _ in $(seq 50); do [ $(ls there.* | wc -l) = 2 ] && exit 0; sleep 0.1; done; exit 3'
experiment one "$meet"
experiment two "$meet"
run
expect 'two experiments run side by side' test "$status" = 0
alone='mkdir lock || exit 3; sleep 0.3; rmdir lock'
experiment complexity "$alone"
experiment speed "$alone"
run data
expect 'but not two that time the program' test "$status" = 0
rm build/data/*.csv
run speed
expect 'asked for by name, one that times the program waits for no other' ran speed
rm validation/complexity.cpp validation/speed.cpp
experiment two

experiment one 'exit 1'
run
expect 'a failed verdict stops neither the others nor the figures nor the report' \
  ran drew paper/one.gp one report two
expect 'it fails the whole' test "$status" != 0
expect 'and is named' says 'one does not agree: build/log/one.log'
run
expect 'a failed verdict is not measured again' ran
expect 'but still fails' test "$status" != 0
expect 'and is still named' says 'one does not agree'

experiment one 'exit 3'
run
expect 'an experiment that breaks off stops neither the others nor the report' ran one report
expect 'it fails the whole' test "$status" != 0
expect 'and is named' says 'one broke off: build/log/one.log'
expect 'its figure is named too' says 'build/figures/one.pdf was not drawn'
run
expect 'it is tried again' ran one report
run one
expect 'asked for by name too' says 'one broke off: build/log/one.log'
run two
expect 'and is no matter to another' test "$status" = 0

experiment one 'touch started; sleep 20'
PATH=$work/bin:$PATH setsid make -f Makefile.data > output.txt 2>&1 &
make_id=$!
for _ in $(seq 100); do [ -e started ] && break; sleep 0.1; done
kill -TERM -- "-$make_id"
wait "$make_id" || true
expect 'an interrupted experiment leaves no verdict' test ! -e build/verdict/one
experiment one
run
expect 'and is run again' ran drew paper/one.gp one report
expect 'to a good end' test "$status" = 0

rm build/data/*.csv
run one
expect 'an experiment asked for by name is measured and drawn alone' ran drew paper/one.gp one
expect 'and succeeds, whatever the others are' test "$status" = 0
run two
expect 'one without a figure is measured' ran two
experiment two 'mv "$4/two.csv" "$4/other.csv"'
run two
expect 'one that leaves its data under another name is told' says 'the stem in its question must be two'
experiment two
run two
run

mkdir validation/scenes
touch build/clack validation/scenes/balls.toml
cat > paper/pictures.sh <<'SCRIPT'
#!/usr/bin/env bash
folder=$2
draw() { echo "drew $1" >> runs.txt; [ ! -e undrawable ] && echo png > "$folder/view_$1.png"; }
draw balls balls
SCRIPT
chmod +x paper/pictures.sh
run
expect 'pictures of balls are drawn for the report' ran drew balls report
run
expect 'and kept' ran
echo 1 > build/clack
run
expect 'another program draws them anew' ran drew balls report
touch undrawable validation/scenes/others.toml
echo 1 > validation/scenes/balls.toml
run report
expect 'a machine that cannot draw them still gets its report' \
  ran drew balls drew paper/one.gp one report two
expect 'and is told' says 'build/figures/view_balls.png was not drawn'
rm -r undrawable paper/pictures.sh validation/scenes
run

sed -i 's/^packages :=.*/packages := liba libb/' Makefile.data
printf '#!/usr/bin/env bash\necho installed libb\n' > bin/dpkg-query
printf '#!/usr/bin/env bash\necho 1000\n' > bin/id
printf '#!/usr/bin/env bash\nexit 1\n' > bin/sudo
chmod +x bin/*
run setup
expect 'without root, the missing packages are named' \
  says 'as root, run: apt-get install --no-install-recommends liba$'
expect 'and it stops' test "$status" != 0
printf '#!/usr/bin/env bash\necho "$*" >> runs.txt\n' > bin/apt-get
printf '#!/usr/bin/env bash\nshift\n[ "$1" = true ] || "$@"\n' > bin/sudo
run setup
expect 'with sudo, they are installed' grep -q 'install --yes --no-install-recommends liba$' runs.txt
printf '#!/usr/bin/env bash\necho "$*" >> runs.txt\necho Remv libc6\n' > bin/apt-get
run setup
expect 'what would remove a package is not done' says 'apt would remove these; nothing was changed'
expect 'indeed' test "$(grep -vc -e update -e simulate runs.txt)" = 0
printf '#!/usr/bin/env bash\necho installed liba\necho installed libb\n' > bin/dpkg-query
run setup
expect 'with all there, apt is not asked' ran
expect 'and it succeeds' test "$status" = 0

if [ "$failed" != 0 ]; then cat output.txt; fi
exit "$failed"
