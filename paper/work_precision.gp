# Work and precision of all methods, one column a packing fraction. From above: error of positions at
# the final time; collisions per ball until the sequence departs from the oracle's, with the lines
# that the Lyapunov exponent alone sets to each floating type and the limits by tangent space along
# the run; deepest overlap; drift of the energy.
width = 17.8 # [cm]
height = 17.0
load 'paper/style.gp'
set datafile missing NaN

file = data . '/work_precision_points.csv'
methods = 'table heap fast frames lammps'
titles = 'table heap fast frames LAMMPS'
style(k) = k == 1 ? 1 : k == 2 ? 3 : k == 3 ? 2 : k + 0
counts = '27 100 1000'
size(c) = c == 1 ? 0.25 : c == 2 ? 0.4 : 0.6
at(k, c, phi, y) = strcol(3) eq word(methods, k) && $2 == word(counts, c) + 0 && $1 == phi && column(y) > 0 ? column(y) : NaN
types = '"float" "double" "long double" "quad"'

# One cell: column j of 3, row i of 4.
left(j) = 0.085 + 0.315 * (j - 1)
top(i) = 0.955 - 0.222 * (i - 1)
cell = 'set lmargin at screen left(j); set rmargin at screen left(j) + 0.265; set tmargin at screen top(i); set bmargin at screen top(i) - 0.2'
curves = 'for [k = 1:5] for [c = 1:3] file using 5:(at(k, c, phi, y)) with linespoints ls style(k) lw thin ps size(c)'

set multiplot
# A panel of its own for the key.
set lmargin at screen 0.085; set rmargin at screen 0.98
set tmargin at screen 0.99; set bmargin at screen 0.96
unset border
unset tics
set key center center horizontal samplen 4 width 3
plot [0:1] [0:1] for [k = 1:5] NaN with linespoints ls style(k) title word(titles, k), \
    NaN with points pt 2 ps 0.7 lc rgb '#000000' title 'limit'
set border 31 lw thin
set key off

set logscale x
set xrange [1e-8:3e-2]
set xtics scale 0.6 nomirror out offset 0, 0.3 1e-8, 100
set ytics scale 0.6 nomirror out offset 0.4, 0
set format x ''
do for [j = 1:3] {
    phi = word('0.05 0.2 0.4', j) + 0
    set format x ''
    unset xlabel
    set logscale y

    i = 1; y = 6
    @cell
    set label 1 sprintf('%s = %g', eta, phi) at graph 0.03, 0.07 left
    # What to see at a glance, beside the lines that say it.
    if (j == 2) {
        set label 2 "frames, LAMMPS:\nmore work for\neach digit" at graph 0.97, 0.72 right font ',7'
        set label 3 "engine: digits\nby the type" at graph 0.97, 0.32 right font ',7'
    }
    set yrange [1e-38:20]
    set ytics 1e-40, 1e5
    set format y (j == 1 ? '10^{%T}' : '')
    set ylabel (j == 1 ? 'position error (diameters)' : '') offset 0.6, 0
    eval 'plot ' . curves . ", for [k = 1:5] for [c = 1:3] file using 5:(at(k, c, phi, 7)) with points ls style(k) pt 6 ps 0.7 * size(c), file using 5:(at(3, 1, phi, 6)):(strcol(4)) with labels font ',7' offset -1, -0.3 right"
    unset label 1
    unset label 2
    unset label 3

    i = 2; y = 8
    @cell
    unset logscale y
    set yrange [0:word('44 120 260', j) + 0]
    set ytics auto
    set format y '%g'
    set ylabel (j == 1 ? 'collisions per ball in common' : '') offset 0.6, 0
    # Limits for 100 balls; each stands once in the rows of `fast`.
    limit(n) = strcol(3) eq 'fast' && $2 == 100 && $1 == phi && strcol(4) eq word(types, n) ? $13 : NaN
    eval 'plot for [n = 1:4] file using (1e-8):(limit(n)):(3e-2):(0) with vectors nohead ls 9, for [n = 1:4] file using (2.5e-2):(limit(n)):(strcol(4)) with labels font ",7" offset 0, (n == 2 ? -0.5 : 0.5) right, ' . curves . ", for [c = 1:3] file using 5:(at(3, c, phi, 12)) with points pt 2 ps 1.6 * size(c) lc rgb '#000000'"

    i = 3; y = 9
    @cell
    set logscale y
    set yrange [1e-38:20]
    set ytics 1e-40, 1e5
    set format y (j == 1 ? '10^{%T}' : '')
    set ylabel (j == 1 ? 'deepest overlap (diameters)' : '') offset 0.6, 0
    eval 'plot ' . curves

    i = 4; y = 10
    @cell
    set format x '10^{%T}'
    set xlabel (j == 2 ? 'processor time by ball and mean free time, s' : '')
    set ylabel (j == 1 ? 'drift of the energy, relative' : '') offset 0.6, 0
    eval 'plot ' . curves
}
unset multiplot
