# Compressibility factor of soft balls of LAMMPS over theory's for hard balls, against the stiffness:
# of diameter 1, and so much wider that their Barker-Henderson diameter is 1.
height = 7.2
load 'paper/style.gp'

points = data . '/pressure_vs_lammps_values.csv'
percent(z, theory) = 100 * (z / theory - 1)
of(packing, y) = $1 == packing ? y : NaN
beside(k, packing) = k * (packing == 0.2 ? 0.93 : 1.07)

set multiplot
set logscale x
set xrange [6e2:1.2e5]
stats points using 3 nooutput
set xrange [0.6 * STATS_min:1.7 * STATS_max]
set mxtics 10

@main_panel
set yrange [-26:4]
set ytics 10
set ylabel 'plain, %' offset 0.8, 0
set key bottom right
plot 0 with lines ls 10, \
     points using 3:(of(0.2, percent($7, $15))) with lines ls 2 lw thin, \
     points using 3:(of(0.4, percent($7, $15))) with lines ls 3 lw thin, \
     points using (beside($3, $1)):(of(0.2, percent($4, $15))):(100 * $5 / $15) with yerrorbars ls 2 title eta . ' = 0.2', \
     points using (beside($3, $1)):(of(0.4, percent($4, $15))):(100 * $5 / $15) with yerrorbars ls 3 title eta . ' = 0.4'

@residual_panel
set format x '10^{%T}'
set yrange [-2.4:2.4]
set ytics 1
set ylabel 'widened, %' offset 0.8, 0
set xlabel 'stiffness {/:Italic k} ({/:Italic kT}/diameter^2)'
plot 0 with lines ls 10, \
     for [sign in '-1 1'] points using 3:(of(0.2, 100 * sign * $16 / $15)) with lines ls 2 lw thin, \
     for [sign in '-1 1'] points using 3:(of(0.4, 100 * sign * $16 / $15)) with lines ls 3 lw thin, \
     points using (beside($3, $1)):(of(0.2, percent($11, $15))):(100 * $12 / $15) with yerrorbars ls 2, \
     points using (beside($3, $1)):(of(0.4, percent($11, $15))):(100 * $12 / $15) with yerrorbars ls 3
unset multiplot
