# Thermal conductivity over Enskog's against packing fraction, and the deviation from 1 where Enskog is exact.
height = 7.2
load 'paper/style.gp'

values = data . '/thermal_conductivity.csv'
only(name) = strcol(3) eq name
judged(y) = strcol(11) ne 'guide' ? y : NaN

set multiplot
set xrange [0:0.52]
set xtics 0.1

@main_panel
set yrange [0.5:2.6]
set ytics 0.5
set ylabel 'thermal conductivity / Enskog’s' offset 0.4, 0
set key top left Left reverse
plot 1 with lines ls 1 title 'Enskog', \
     values using 1:(only('conductivity') ? $4 : NaN):5 with yerrorbars ls 2 pt 7 title 'clack'

@residual_panel
set yrange [-0.3:0.3]
set ytics -0.2, 0.2
set ylabel 'residual, judged' offset 0.4, 0
set xlabel 'packing fraction ' . eta
plot 0 with lines ls 1, \
     values using 1:(only('conductivity') ? judged($4 - 1) : NaN):5 with yerrorbars ls 2 pt 7
unset multiplot
