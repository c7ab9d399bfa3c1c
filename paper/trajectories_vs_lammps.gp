# Soft balls of LAMMPS against hard balls, for two packing fractions side by side: distances at the
# ends of short segments against the stiffness, as they are, by Richardson and from hard balls of a
# yielding diameter; how many balls are compared; how many collisions of a long run are the same.
height = 12.6
load 'paper/style.gp'

curves = data . '/trajectories_vs_lammps_curves.csv'
of(packing, quantity) = $1 == packing && strcol(4) eq quantity ? $5 : NaN
# 27, 100 and 1000 balls stand beside each other.
beside(k, n) = k * (n == 27 ? 0.8 : n == 100 ? 1 : 1.25)
contact(k) = pi / sqrt(2 * k)

panel(column, low, high) = sprintf("set lmargin at screen %g; set rmargin at screen %g; set bmargin at screen %g; set tmargin at screen %g", column == 1 ? 0.155 : 0.575, column == 1 ? 0.555 : 0.975, low, high)
own_ordinate = "set format y '%h'; set key"
shared_ordinate = "set format y ''; set ylabel ''; unset key"
below = "set format x '10^{%T}'; set xlabel 'stiffness {/:Italic k} ({/:Italic kT}/diameter^2)'"

set multiplot
set logscale x
set mxtics 10

do for [column = 1:2] {
    packing = column == 1 ? 0.2 : 0.4
    shift = column == 1 ? 1 : 16
    first_tic = column == 1 ? 1e5 : 1e6
    set xrange [8e4 * shift:9e7 * shift]
    set xtics first_tic, 10

    # distances
    eval panel(column, 0.57, 0.965)
    set format x ''
    set xlabel ''
    set logscale y
    set yrange [1.5e-10:0.3]
    set ytics 1e-8, 100
    set ylabel 'distance (diameters)' offset 0.6, 0
    eval own_ordinate
    set format y '10^{%T}'
    set key bottom left Left reverse samplen 0.6 spacing 0.9 font ',7'
    set label 1 sprintf('%s = %.1f', eta, packing) at graph 0.93, 0.93 right
    set label 2 '{/:Italic t}_c' at graph 0.74, (column == 1 ? 0.65 : 0.585) font ',7'
    set label 3 '{/:Italic t}_c^2/2' at graph 0.82, (column == 1 ? 0.18 : 0.05) font ',7'
    if (column == 2) { eval shared_ordinate }
    plot contact(x) with lines ls 1 lw thin, \
         contact(x)**2 / 2 with lines ls 9, \
         curves using (beside($3, $2)):(of(packing, 'distance_median')):6 with yerrorbars ls 1 title 'as they are', \
         curves using (beside($3, $2)):(of(packing, 'distance_largest')):6 with yerrorbars ls 1 pt 6, \
         curves using (beside($3, $2)):(of(packing, 'richardson_median')):6 with yerrorbars ls 3 pt 9 title 'Richardson', \
         curves using (beside($3, $2)):(of(packing, 'richardson_largest')):6 with yerrorbars ls 3 pt 8, \
         curves using (beside($3, $2)):(of(packing, 'softened_median')):6 with yerrorbars ls 2 pt 5 title 'yielding', \
         curves using (beside($3, $2)):(of(packing, 'softened_largest')):6 with yerrorbars ls 2 pt 4
    unset label 1
    unset label 2
    unset label 3

    # kept
    eval panel(column, 0.40, 0.55)
    eval below
    unset logscale y
    set yrange [0.5:1.04]
    set ytics 0.5, 0.2
    set ylabel 'balls kept' offset 0.8, 0
    eval own_ordinate
    unset key
    if (column == 2) { eval shared_ordinate }
    plot 1 with lines ls 10, \
         curves using (beside($3, $2)):(of(packing, 'kept')):6 with yerrorbars ls 1

    # matched prefix
    eval panel(column, 0.09, 0.29)
    set xrange [8e3 * shift / 2:(column == 1 ? 2.5e7 : 2e8)]
    set yrange [0:16]
    set ytics 5
    set ylabel 'equal collisions' offset 0.8, 0
    eval own_ordinate
    set key top left Left reverse samplen 0.6 spacing 0.9 font ',7'
    if (column == 2) { eval shared_ordinate }
    plot curves using 3:(of(packing, 'matched')):6 with yerrorbars ls 1 title 'hard', \
         curves using 3:(of(packing, 'matched_softened')):6 with yerrorbars ls 2 title 'yielding'
}
unset multiplot
