# Compressibility factor of the fluid beside its equation of state, and the residuals in standard
# errors. Carnahan and Starling's formula is a guide line.
height = 7.2
load 'paper/style.gp'

points = data . '/equation_of_state.csv'
theory = data . '/equation_of_state_theory.csv'

set multiplot
set xrange [0:0.52]
set xtics 0.1

@main_panel
set yrange [0:13.9]
set ytics 4
set ylabel 'compressibility factor {/:Italic Z}'
set key top left Left reverse
plot theory using 1:2 with lines ls 1 title 'modified Kolafa–Labík–Malijevský', \
     theory using 1:3 with lines ls 3 title 'Carnahan–Starling', \
     points using 1:14:15 with yerrorbars ls 2 pt 7 title 'clack'

@residual_panel
set yrange [-9:5]
set ytics -4, 4
set ylabel 'residual, s.e.'
set xlabel 'packing fraction ' . eta
set key bottom left horizontal Left reverse samplen 1
plot 0 with lines ls 1, \
     points using 1:(($17 - $16) / $15) with lines ls 3, \
     points using ($1 - 0.002):12:(1) with yerrorbars ls 2 pt 7 title 'by virial', \
     points using ($1 + 0.002):13:(1) with yerrorbars ls 4 pt 6 title 'by collision rate'
unset multiplot
