# Lyapunov exponent over the collision rate: measured, by formula, and the dilute theory (above);
# measured against the formula (below).
height = 9.0
load 'paper/style.gp'

points = data . '/lyapunov.csv'
counts = '27 100 1000'
style(k) = k == 1 ? 3 : k == 2 ? 2 : 1
only(quantity, y) = strcol(4) eq quantity ? y : NaN
of(boundary, n, y) = strcol(1) eq boundary && $3 == n ? only('exponent', y) : NaN
held_out(y) = strcol(12) eq 'guide' ? NaN : only('exponent', y)

set datafile missing NaN # so that lines go on past other rows
set multiplot
set logscale x
set xrange [6e-4:0.7]

set tmargin at screen 0.975
set bmargin at screen 0.42
set format x ''
set logscale y
set yrange [0.25:45]
set ylabel 'exponent / collision rate' offset 0.6, 0
set key bottom left Left reverse samplen 2 font ',8'
# Leading order for endless n, in number density; approached as slowly as 1 / ln^2 n.
dilute(x) = x < 0.02 ? -4.311 * log(6 * x / pi) : NaN
plot dilute(x) with lines ls 9 title 'dilute theory', \
     for [k = 1:3] points using 2:(of('walls', word(counts, k) + 0, $7)) with lines ls style(k) lw thin, \
     for [k = 1:3] points using 2:(of('walls', word(counts, k) + 0, $5)):6 with yerrorbars ls style(k) pt 7 title sprintf('walls, {/:Italic n} = %s', word(counts, k)), \
     for [k = 2:3] points using 2:(of('periodic', word(counts, k) + 0, $5)):6 with yerrorbars ls style(k) pt 6 title sprintf('periodic, {/:Italic n} = %s', word(counts, k)), \
     points using 2:(held_out($5)):6 with yerrorbars ls 8 lc rgb '#000000' lw thin pt 2 ps 0.6 title 'not fitted to', \
     points using 2:(only('twins', $5)):6 with yerrorbars ls 4 pt 1 ps 1.2 title 'twin runs, {/:Italic n} = 100'

set tmargin at screen 0.37
set bmargin at screen 1.1 / height
set format x '%h'
unset logscale y
set yrange [*<-8:8<*] noextend
set ytics 4
set ylabel 'off the formula, %' offset 0.6, 0
set xlabel 'packing fraction ' . eta
unset key
plot 0 with lines ls 10, \
     for [k = 1:3] points using 2:(of('walls', word(counts, k) + 0, 100 * ($5 / $7 - 1))):(100 * $6 / $7) with yerrorbars ls style(k) pt 7, \
     for [k = 2:3] points using 2:(of('periodic', word(counts, k) + 0, 100 * ($5 / $7 - 1))):(100 * $6 / $7) with yerrorbars ls style(k) pt 6, \
     points using 2:(held_out(100 * ($5 / $7 - 1))):(100 * $6 / $7) with yerrorbars ls 8 lc rgb '#000000' lw thin pt 2 ps 0.6
unset multiplot
