# Compressibility factor of soft balls of LAMMPS over theory's for hard balls, against the stiffness:
# of diameter 1, and so much wider that their Barker-Henderson diameter is 1.
height = 7.2
load 'paper/style.gp'

points = data . '/pressure_vs_lammps.csv'
# Theory's for as many hard balls stands beside the engine's.
theory(packing) = system(sprintf("awk -F, '$1 == %g && $2 == \"hard\" { print $6 }' %s", packing, points)) + 0
array expected[2] = [theory(0.2), theory(0.4)]
of_hard(packing, z) = 100 * z / expected[packing == 0.2 ? 1 : 2]
of(packing, quantity, y) = $1 == packing && strcol(3) eq quantity ? y : NaN
percent(packing, quantity, z) = of(packing, quantity, of_hard($1, z) - 100)
beside(k, packing) = k * (packing == 0.2 ? 0.93 : 1.07)

set datafile missing NaN # so that lines go on past other rows
set multiplot
set logscale x
set xrange [6e2:1.2e5]
stats points using 2 nooutput
set xrange [0.6 * STATS_min:1.7 * STATS_max]
set mxtics 10

@main_panel
set yrange [-26:4]
set ytics 10
set ylabel 'plain, %' offset 0.8, 0
set key bottom right
plot 0 with lines ls 10, \
     points using 2:(percent(0.2, 'plain_softened', $6)) with lines ls 2 lw thin, \
     points using 2:(percent(0.4, 'plain_softened', $6)) with lines ls 3 lw thin, \
     points using (beside($2, $1)):(percent(0.2, 'plain_softened', $4)):(of_hard($1, $5)) with yerrorbars ls 2 title eta . ' = 0.2', \
     points using (beside($2, $1)):(percent(0.4, 'plain_softened', $4)):(of_hard($1, $5)) with yerrorbars ls 3 title eta . ' = 0.4'

@residual_panel
set format x '10^{%T}'
set yrange [-2.4:2.4]
set ytics 1
set ylabel 'widened, %' offset 0.8, 0
set xlabel 'stiffness {/:Italic k} ({/:Italic kT}/diameter^2)'
plot 0 with lines ls 10, \
     for [sign in '-1 1'] points using 2:(of(0.2, 'soft_clack', sign * of_hard($1, $8))) with lines ls 2 lw thin, \
     for [sign in '-1 1'] points using 2:(of(0.4, 'soft_clack', sign * of_hard($1, $8))) with lines ls 3 lw thin, \
     points using (beside($2, $1)):(percent(0.2, 'soft_theory', $4)):(of_hard($1, $5)) with yerrorbars ls 2, \
     points using (beside($2, $1)):(percent(0.4, 'soft_theory', $4)):(of_hard($1, $5)) with yerrorbars ls 3
unset multiplot
