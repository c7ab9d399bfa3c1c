# Viscosities and thermal conductivity over Enskog's against packing fraction, and the deviation from
# 1 where Enskog is the yardstick, beside Boltzmann's.
height = 7.2
load 'paper/style.gp'

values = data . '/transport.csv'
only(name) = strcol(3) eq name
judged(y) = strcol(11) ne 'guide' ? y : NaN

set multiplot
set xrange [0:0.52]
set xtics 0.1

@main_panel
set yrange [0.5:2.6]
set ytics 0.5
set ylabel 'transport / Enskog’s' offset 0.4, 0
set key top left Left reverse
plot 1 with lines ls 1 title 'Enskog', \
     values using ($1 - 0.003):(only('shear') ? $4 : NaN):5 with yerrorbars ls 2 pt 7 title 'shear viscosity', \
     values using 1:(only('conductivity') ? $4 : NaN):5 with yerrorbars ls 4 pt 6 title 'thermal conductivity', \
     values using ($1 + 0.003):(only('bulk') ? $4 : NaN):5 with yerrorbars ls 3 title 'bulk viscosity'

@residual_panel
set yrange [-0.4:0.15]
set ytics 0.2
set ylabel 'residual, judged' offset 0.4, 0
set xlabel 'packing fraction ' . eta
plot 0 with lines ls 1, \
     values using ($1 - 0.003):(only('shear') ? judged($4 - 1) : NaN):5 with yerrorbars ls 2 pt 7, \
     values using 1:(only('conductivity') ? judged($4 - 1) : NaN):5 with yerrorbars ls 4 pt 6, \
     values using ($1 + 0.003):(only('bulk') ? judged($4 - 1) : NaN):5 with yerrorbars ls 3, \
     values using ($1 + 0.012):(only('shear_not_boltzmann') ? $6 - 1 : NaN) with points ls 2 pt 2 ps 1, \
     values using ($1 + 0.012):(only('conductivity_not_boltzmann') ? $6 - 1 : NaN) with points ls 4 pt 2 ps 1
unset multiplot
