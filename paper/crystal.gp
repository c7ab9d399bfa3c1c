# Pressure of the crystal times the free part of the volume, its bond order, and residuals in
# standard errors.
height = 9.4
load 'paper/style.gp'

results = data . '/crystal.csv'
points = data . '/crystal_points.csv'
theory = data . '/crystal_theory.csv'
y(packing) = 1 - packing / (pi / (3 * sqrt(2)))

set multiplot
set xrange [0.51:0.75]
set xtics 0.05

set tmargin at screen 0.97
set bmargin at screen 0.58
set format x ''
set yrange [2.84:3.04]
set ytics 0.05
set ylabel '{/:Italic Z}(1 – ' . eta . '/' . eta . '_0)'
set key bottom right
plot 3 with lines ls 9 title 'free volume', \
     theory using 1:($2 * y($1)) with lines ls 1 title 'Schultz', \
     theory using 1:($3 * y($1)) with lines ls 3 title 'Speedy', \
     points using 1:($4 * $2):($5 * $2) with yerrorbars ls 2 pt 7 title 'clack'

set tmargin at screen 0.555
set bmargin at screen 0.37
set yrange [0.435:0.63]
set ytics 0.05
set ylabel 'bond order {/:Italic Q}_6'
unset key
set label 1 'fcc' at 0.745, 0.597 right
set label 2 'bcc' at 0.745, 0.531 right
set label 3 'hcp' at 0.745, 0.466 right
plot 0.57452 with lines ls 9, 0.51069 with lines ls 3, 0.48476 with lines ls 4, \
     points using 1:8:9 with yerrorbars ls 2 pt 7

set tmargin at screen 0.345
set bmargin at screen 1.1 / height
set format x '%h'
set yrange [*<-7:5<*] noextend
set ytics -4, 4
set ylabel 'residual, s.e.' offset 0.3, 0
set xlabel 'packing fraction ' . eta
unset label
set key bottom left horizontal Left reverse samplen 1
plot 0 with lines ls 1, \
     results using ($1 - 0.002):(strcol(2) eq 'virial' ? $8 : NaN):(1) with yerrorbars ls 2 pt 7 title 'virial', \
     results using ($1 + 0.000):(strcol(2) eq 'rate' ? $8 : NaN):(1) with yerrorbars ls 4 pt 6 title 'rate', \
     results using ($1 + 0.002):(strcol(2) eq 'virial_speedy' ? $8 : NaN):(1) with yerrorbars ls 3 pt 8 title 'Speedy'
unset multiplot
