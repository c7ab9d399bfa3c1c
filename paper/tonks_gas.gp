# Balls on a line: how far they are from the exact solution as collisions add up, in two precisions,
# and the excess of the pressure over Tonks's, between the bounds that whole numbers of hits set.
height = 8.4
load 'paper/style.gp'

course = data . '/tonks_gas_course.csv'
only(n, precision, y) = (column(1) == n && strcol(2) eq precision) ? y : NaN

set multiplot
set logscale x
set xrange [0.9:1.3e4]

@main_panel
set bmargin at screen 0.47
set logscale y
set yrange [2e-16:1e5]
set ytics ('10^{−15}' 1e-15, '10^{−12}' 1e-12, '10^{−9}' 1e-9, '10^{−6}' 1e-6, '10^{−3}' 1e-3, '1' 1)
set ylabel 'farthest from its place, ' . sigma offset 0.4, 0
set key top left Left reverse maxrows 3 samplen 2
plot course using 4:(only(10, 'float', $7)) with lines ls 9 title 'bound of rounding', \
     course using 4:(only(10, 'double', $7)) with lines ls 9, \
     course using 4:(only(100, 'double', $7)) with lines ls 9, \
     course using 4:(only(10, 'float', $5)):6 with yerrorbars ls 3 title '{/:Italic n} = 10, float', \
     course using 4:(only(10, 'double', $5)):6 with yerrorbars ls 2 title '10, double', \
     course using 4:(only(100, 'double', $5)):6 with yerrorbars ls 1 title '100, double'

@residual_panel
set tmargin at screen 0.42
unset logscale y
set yrange [-0.6:0.6]
set ytics -0.5, 0.5
set ylabel '{/:Italic F} / {/:Italic F}_{Tonks} − 1' offset 0.4, 0
set xlabel 'collisions per ball'
plot 0 with lines ls 10, \
     course using 4:(only(10, 'double', $10)) with lines ls 9, \
     course using 4:(only(10, 'double', -$10)) with lines ls 9, \
     course using ($4 * 0.95):(only(10, 'double', $8)):9 with yerrorbars ls 2, \
     course using ($4 * 1.05):(only(100, 'double', $8)):9 with yerrorbars ls 1
unset multiplot
