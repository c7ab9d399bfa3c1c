# Free times of a dilute gas beside the law of the limit and an exponential one, the residuals, and
# the squared impact parameter, which is uniform at every density.
height = 11.0
load 'paper/style.gp'

times = data . '/collision_statistics_times.csv'
impacts = data . '/collision_statistics_impacts.csv'
only(eta, y) = abs(column(2) - eta) < 1e-9 ? y : NaN
poisson(t) = 0.125 * 8 * (exp(-(t - 0.125)) - exp(-(t + 0.125))) / 0.25 # mean over a bin

set multiplot
set xrange [0:8]

set tmargin at screen 0.975
set bmargin at screen 0.66
set format x ''
set logscale y
set yrange [2e-4:2.5]
set ytics ('0.001' 1e-3, '0.01' 1e-2, '0.1' 0.1, '1' 1)
set ylabel 'density of free time, 1/⟨{/:Italic t}⟩' offset 0.4, 0
set key top right
plot times using 3:(only(0.002, $6)) with lines ls 1 title 'dilute limit', \
     poisson(x) with lines ls 3 title 'exponential', \
     times using 3:(only(0.002, $4)):5 with yerrorbars ls 2 pt 7 title 'clack, ' . eta . ' = 0.002'

set tmargin at screen 0.635
set bmargin at screen 0.48
set format x '%h'
unset logscale y
set yrange [-0.35:0.35]
set ytics -0.2, 0.2
set ylabel 'relative residual' offset 0.4, 0
set xlabel 'free time {/:Italic t}/⟨{/:Italic t}⟩'
unset key
plot 0 with lines ls 1, \
     times using 3:(only(0.002, poisson($3) / $6 - 1)) with lines ls 3, \
     times using 3:(only(0.002, $4 / $6 - 1)):($5 / $6) with yerrorbars ls 2 pt 7

set tmargin at screen 0.37
set bmargin at screen 0.95 / height
set xrange [0:1]
set yrange [0.97:1.045]
set ytics 0.98, 0.02
set xtics 0.2
set xlabel 'squared impact parameter {/:Italic b}^2/' . sigma . '^2'
set ylabel 'density'
set key top left horizontal Left reverse samplen 1
plot 1 with lines ls 1, \
     impacts using ($3 - 0.009):(only(0.1, $4)):5 with yerrorbars ls 3 title '8 balls, ' . eta . ' = 0.1', \
     impacts using ($3 - 0.003):(only(0.002, $4)):5 with yerrorbars ls 2 title '0.002', \
     impacts using ($3 + 0.003):(only(0.3, $4)):5 with yerrorbars ls 4 title '0.3', \
     impacts using ($3 + 0.009):(only(0.45, $4)):5 with yerrorbars ls 1 title '0.45'
unset multiplot
