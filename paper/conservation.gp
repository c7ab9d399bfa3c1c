# Drift of energy and deepest overlap of long runs, beside their bounds.
height = 8.6
load 'paper/style.gp'

file = data . '/conservation.csv'
at(name, packing, column) = \
    sprintf('(strcol(1) eq "%s" && $2 == %g ? $4 : NaN):(column(%d))', name, packing, column)
runs(column) = sprintf("file using %s with linespoints ls 2 title 'walls, 0.05', \
     file using %s with linespoints ls 3 title 'walls, 0.3', \
     file using %s with linespoints ls 4 title 'walls, 0.45', \
     file using %s with linespoints ls 5 title 'periodic, 0.05', \
     file using %s with linespoints ls 6 title 'periodic, 0.3', \
     file using %s with linespoints ls 7 title 'periodic, 0.45'", \
     at('walls', 0.05, column), at('walls', 0.3, column), at('walls', 0.45, column), \
     at('periodic', 0.05, column), at('periodic', 0.3, column), at('periodic', 0.45, column))

set logscale xy
set format y '10^{%T}'
set xrange [0.8:*]
set multiplot

set tmargin at screen 0.98; set bmargin at screen 0.58
set format x ''
set yrange [1e-17:1e-12]
set ylabel '|{/:Italic E}/{/:Italic E}_0 − 1|'
set key top left maxrows 3 samplen 2 font ',7'
eval "plot file using " . at('walls', 0.05, 7) . " with lines ls 1 title 'bound', " . runs(5)

set tmargin at screen 0.54; set bmargin at screen 0.12
set format x '10^{%T}'
set xlabel 'collisions per ball'
set yrange [1e-16:1e-12]
set ylabel 'deepest overlap (diameters)'
set key off
eval "plot " . runs(8)
unset multiplot
