# Compressibility factor of the fluid beside its equation of state; two ways to it relative to that,
# on the scale of their errors, with Schultz' fit; and residuals in standard errors of all three
# ways. Carnahan and Starling's formula is a guide line.
height = 9.4
load 'paper/style.gp'

results = data . '/equation_of_state.csv'
points = data . '/equation_of_state_infinite.csv'
theory = data . '/equation_of_state_theory.csv'
only(quantity, y) = strcol(2) eq quantity ? y : NaN
stats results using (only('virial', 100 * $4 / $5)) name 'error' nooutput
widest = error_max

set multiplot
set xrange [0:0.52]
set xtics 0.1

set tmargin at screen 0.97
set bmargin at screen 0.56
set format x ''
set yrange [0:13.9]
set ytics 4
set ylabel 'compressibility factor {/:Italic Z}'
set key top left Left reverse
plot theory using 1:2 with lines ls 1 title 'modified Kolafa–Labík–Malijevský', \
     theory using 1:3 with lines ls 3 title 'Carnahan–Starling', \
     points using 1:2:3 with yerrorbars ls 2 pt 7 title 'clack'

set tmargin at screen 0.53
set bmargin at screen 0.34
set yrange [-6 * widest:6 * widest]
set ytics 4 * widest
set format y '%.1g'
set ylabel 'deviation, %' offset 0.3, 0
unset key
plot 0 with lines ls 1, \
     theory using 1:(100 * ($3 - $2) / $2) with lines ls 3, \
     theory using 1:(100 * ($4 - $2) / $2) with lines ls 6, \
     results using ($1 - 0.004):(only('virial', 100 * ($3 - $5) / $5)):(100 * $4 / $5) with yerrorbars ls 2 pt 7, \
     results using 1:(only('rate', 100 * ($3 - $5) / $5)):(100 * $4 / $5) with yerrorbars ls 4 pt 6
set format y '%h'

set tmargin at screen 0.31
set bmargin at screen 1.1 / height
set format x '%h'
set yrange [*<-8:4.5<*] noextend
set ytics autofreq
set ylabel 'residual, s.e.' offset 0.3, 0
set xlabel 'packing fraction ' . eta
set key bottom left horizontal maxrows 1 Left reverse samplen 1
plot 0 with lines ls 1, \
     results using ($1 - 0.004):(only('virial', $8)):(1) with yerrorbars ls 2 pt 7 title 'virial', \
     results using 1:(only('rate', $8)):(1) with yerrorbars ls 4 pt 6 title 'rate', \
     results using ($1 + 0.004):(only('contact', $8)):(1) with yerrorbars ls 5 pt 8 title 'contact'
unset multiplot
