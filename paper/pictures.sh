#!/usr/bin/env bash
# The pictures of balls in the README and the report: pictures.sh PROGRAM FOLDER SCALE draws them
# with `clack view --screenshot`, SCALE times as large as the README shows them. No display needed.
set -euo pipefail
program=$1 folder=$2 scale=$3
scenes=$(dirname "$0")/../validation/scenes

draw() { # draw NAME SCENE WIDTH HEIGHT OPTIONS...
  "$program" view "$scenes/$2.toml" --screenshot "$folder/view_$1.png" \
    --size "$((scale * $3))x$((scale * $4))" "${@:5}"
}

draw dense_fluid dense_fluid 440 400
draw two_halves dense_fluid 250 220 --time 0,10,200 --colour side \
  --set 'container.boundary="walls"' --set container.packing_fraction=0.2 --set balls.count=1500
draw cradle newtons_cradle 470 86 --time 0,1,1.75,3,5 --azimuth -90 --elevation 0 --zoom 5.2
