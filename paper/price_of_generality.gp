# What each ingredient costs a collision that does not need it (above), and a map of the models that
# `auto` chooses with their rate over that of the best method (middle: walls, below: periodic).
height = 18.5
load 'paper/style.gp'

prices = data . '/price_of_generality.csv'
choices = data . '/price_of_generality_auto.csv'
fractions = system(sprintf("grep -v '^#' %s | tail -n +2 | cut -d, -f3 | sort -gu | tr '\n' ' '", choices))
# They stand first, and nothing else is a guide.
rows = int(system(sprintf("grep -c ',guide$' %s", prices)))
shortest = 0.85
longest = 1.25
within(x) = x < shortest ? shortest : x > longest ? longest : x

set multiplot
set datafile missing NaN

set tmargin at screen 0.988
set bmargin at screen 0.503
set lmargin at screen 0.40
set rmargin at screen 0.785
set xrange [shortest:longest]
set yrange [rows - 0.4:-0.6]
set xtics 0.1
set xlabel 'time of a collision / smallest model' offset 0, 0.5
set ytics scale 0
set style fill solid 0.55 noborder
set arrow from 1, graph 0 to 1, graph 1 nohead ls 10 front
first = 'every ::1::rows'
plot prices using (within($5)):0:(1):(within($5)):($0 - 0.3):($0 + 0.3):ytic(4) @first with boxxyerror lc rgb '#56b4e9', \
     prices using ($5 < longest ? $5 : NaN):0:6 @first with xerrorbars ls 1 ps 0 lw thin, \
     prices using ($5 < longest ? NaN : longest):0:('…') @first with labels left offset -1.6, 0, \
     prices using (longest):0:(sprintf($5 < 2 ? '%.3f ± %.3f' : $5 < 10 ? '%.2f ± %.2f' : '%.1f ± %.1f', $5, $6)) @first with labels left offset 0.6, 0
unset arrow

# A map of the methods: what `auto` chooses by number of balls and packing fraction, and its rate
# over that of the best method.
models = 'EveryPair+CollisionTable EveryPair+BinaryHeap EveryPair+Calendar CellGrid+Calendar NeighbourList+Calendar'
titles = '"table" "all pairs, heap" "all pairs, calendar" "cells, calendar" "lists, calendar"'
array colours[5] = [0xdddddd, 0xf3d08a, 0xe69f00, 0x9fd3f0, 0x7fcdb4]
counts = system(sprintf("grep -v '^#' %s | tail -n +2 | cut -d, -f2 | sort -gu | tr '\n' ' '", choices))
# The place of a number in a list; 0 where it is not there.
place(list, x) = (sum [k = 1:words(list)] (real(word(list, k)) == x ? k : 0))
model(search, queue) = (sum [k = 1:words(models)] (word(models, k) eq search . '+' . queue ? k : 0))
colour(search, queue) = (model(search, queue) > 0 ? colours[model(search, queue)] : 0xffffff)
row(boundary, y) = (strcol(1) eq boundary ? y : NaN)

set lmargin at screen 0.155
set rmargin at screen 0.985
set xrange [0.5:words(counts) + 0.5]
set yrange [0.5:words(fractions) + 0.5]
set style fill solid border lc rgb '#ffffff'
unset xtics
set ytics () scale 0
do for [k = 1:words(fractions)] { set ytics add (word(fractions, k) k) }
set ylabel 'packing fraction ' . eta offset 1.0, -4.8
unset xlabel
do for [k = 1:5] {
    x = 0.03 + (k > 2 ? 0.345 * (k - 3) : 0.345 * (k - 1) + 0.17)
    y = k > 2 ? 0.394 : 0.412
    set object k rect from screen x, y to screen x + 0.026, y + 0.010 fc rgb colours[k] fs solid border lc rgb '#777777'
    set label k word(titles, k) at screen x + 0.04, y + 0.005 left font ',8'
}
map = "plot choices using (place(counts, $2)):(row(boundary, place(fractions, $3))):(0.5):(0.5):(colour(strcol(4), strcol(5))) every ::1 with boxxyerror lc rgb variable, choices using (place(counts, $2)):(row(boundary, place(fractions, $3))):(sprintf('%.2f', $6)) every ::1 with labels font ',4.6'"

set tmargin at screen 0.364
set bmargin at screen 0.222
boundary = 'walls'
set label 9 'walls: what auto chooses, and its rate / best method' at graph 0, 1.07 left font ',8'
eval map
do for [k = 1:5] { unset object k; unset label k }

set tmargin at screen 0.197
set bmargin at screen 1.1 / height
set xtics scale 0 font ',7' ('' 1)
in_short(n) = n < 1000 ? sprintf('%d', n) : sprintf('%gk', n / 1000)
do for [k = 1:words(counts)] { set xtics add (in_short(real(word(counts, k))) k) }
set xlabel 'number of balls {/:Italic n} (k: thousands)' offset 0, 0.6
unset ylabel
boundary = 'periodic'
set label 9 'periodic' at graph 0, 1.07
eval map
unset multiplot
