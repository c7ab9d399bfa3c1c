# Error of the compressibility factor against processor time: the engine, frames and LAMMPS.
height = 9.2
load 'paper/style.gp'
set datafile missing NaN

file = data . '/cost_of_statistics_errors.csv'
# The knobs in the order of the rows.
knobs(method) = system(sprintf("awk -F, '$1 == \"%s\" { print $2 }' %s | uniq", method, file))
frames = knobs('frames')
lammps = knobs('lammps')
of(method, knob, y) = strcol(1) eq method && strcol(2) eq knob ? y : NaN
stiffness(k) = sprintf('{/:Italic k} = %s', k)

set logscale xy
set format xy '10^{%T}'
set xrange [2e-4:40]
set yrange [1e-4:0.3]
set xlabel 'processor time, s'
set ylabel 'error of {/:Italic Z}, relative' offset 0.6, 0
# Below, since the full profile fills the whole plot.
set bmargin at screen 0.36
set key at screen 0.56, 0.12 center center vertical maxrows 5 reverse Left samplen 3 font ',8'
set label 1 'bias: more time buys no digit' at graph 0.97, 0.93 right font ',8'
# The slope of -1/2 through the first point of the engine.
anchor = system(sprintf("awk -F, '$1 == \"fast\" { print $3 * $4^2; exit }' %s", file)) + 0
root(x) = sqrt(anchor / x)
plot root(x) with lines ls 9 title 'slope −1/2', \
     file using 3:(of('fast', 'double', $4)) with linespoints ls 2 title 'fast', \
     for [k = 1:words(frames)] file using 3:(of('frames', word(frames, k), $4)) with linespoints ls 4 pt 2 * k + 3 title 'frames, ' . word(frames, k), \
     for [k = 1:words(lammps)] file using 3:(of('lammps', word(lammps, k), $4)) with linespoints ls 5 pt 2 * k + 3 title 'LAMMPS, ' . stiffness(word(lammps, k))
