# How balls forget their velocity: the decay beside the dilute gas, the residual, and the tail.
height = 11.0
load 'paper/style.gp'

curves = data . '/velocity_autocorrelation_curves.csv'
is(part, eta) = strcol(1) eq part && abs(column(2) - eta) < 1e-9

set multiplot
set xrange [0:6]

set tmargin at screen 0.975
set bmargin at screen 0.66
set format x ''
set logscale y
set yrange [0.01:1.3]
set ytics ('0.01' 0.01, '0.1' 0.1, '1' 1)
set ylabel '{/:Italic C}({/:Italic t}) / {/:Italic C}(0)' offset 0.4, 0
set key bottom left Left reverse
plot curves using 3:(is('decay', 0.002) ? $6 : NaN) with lines ls 1 title 'Kac’s walk', \
     exp(-2 * x / 3) with lines ls 9 title 'exp(−2{/:Italic tν}/3)', \
     curves using 3:(is('decay', 0.002) ? $4 : NaN):5 every 4 with yerrorbars ls 2 pt 7 title 'clack, ' . eta . ' = 0.002', \
     curves using 3:(is('decay', 0.3) ? $4 : NaN):5 every 4 with yerrorbars ls 3 title '0.3'

set tmargin at screen 0.635
set bmargin at screen 0.48
set format x '%h'
unset logscale y
set yrange [-0.009:0.009]
set ytics -0.005, 0.005
set ylabel 'residual' offset 0.4, 0
set xlabel 'time, mean free times'
unset key
plot 0 with lines ls 1, \
     curves using 3:(is('decay', 0.002) ? $4 - $6 : NaN):5 every 4 with yerrorbars ls 2 pt 7

set tmargin at screen 0.37
set bmargin at screen 0.95 / height
set logscale xy
set xrange [4:45]
set xtics (5, 10, 20, 40)
set yrange [5e-4:0.2]
set ytics ('0.001' 0.001, '0.01' 0.01, '0.1' 0.1)
set ylabel '{/:Italic C}({/:Italic t}) / {/:Italic C}(0)' offset 0.4, 0
set key top right
plot curves using 3:(is('tail', 0.2) ? $8 : NaN) with lines ls 1 title 'tail {/:Italic t}^{−3/2}', \
     curves using 3:(is('tail', 0.2) ? $7 : NaN) with lines ls 4 title 'in the box', \
     exp(-2 * x / 3) with lines ls 9 notitle, \
     curves using 3:(is('tail', 0.2) ? $4 : NaN):5 with yerrorbars ls 2 pt 7 title 'clack, ' . eta . ' = 0.2'
unset multiplot
