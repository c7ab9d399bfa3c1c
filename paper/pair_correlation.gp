# g(r) beside Verlet and Weis', what is left of it, and S(k) for long waves beside Percus and
# Yevick's and the compressibility.
height = 11.4
load 'paper/style.gp'

g = data . '/pair_correlation_g.csv'
s = data . '/pair_correlation_s.csv'
dense = 0.45
middle = 0.3
dilute = 0.05

set multiplot

set tmargin at screen 0.975
set bmargin at screen 0.69
set format x ''
set xrange [0.9:4.05]
set yrange [0:5.2]
set ytics 1
set ylabel '{/:Italic g}({/:Italic r})'
set key top right
plot g using 2:(abs($1 - dense) < 1e-9 ? $5 : NaN) with lines ls 1 title 'Verlet–Weis', \
     g using 2:(abs($1 - dense) < 1e-9 ? $6 : NaN) with lines ls 3 title 'Percus–Yevick', \
     g using 2:(abs($1 - dense) < 1e-9 ? $3 : NaN):4 every 3 with yerrorbars ls 2 pt 7 ps small_point title 'clack, ' . eta . ' = 0.45', \
     g using 2:(abs($1 - middle) < 1e-9 ? $5 : NaN) with lines ls 1, \
     g using 2:(abs($1 - middle) < 1e-9 ? $6 : NaN) with lines ls 3, \
     g using 2:(abs($1 - middle) < 1e-9 ? $3 : NaN):4 every 3 with yerrorbars ls 4 pt 6 ps small_point title '0.30', \
     g using 2:(abs($1 - dilute) < 1e-9 ? $6 : NaN) with lines ls 3, \
     g using 2:(abs($1 - dilute) < 1e-9 ? $3 : NaN):4 every 3 with yerrorbars ls 5 pt 8 ps small_point title '0.05'

set tmargin at screen 0.66
set bmargin at screen 0.47
set format x '%h'
set yrange [-0.14:0.14]
set ytics 0.1
set ylabel '{/:Italic g} – theory' offset 0.3, 0
set xlabel 'distance {/:Italic r}, ' . sigma offset 0, 0.6
unset key
plot 0 with lines ls 1, \
     g using 2:(abs($1 - dense) < 1e-9 ? $6 - $5 : NaN) with lines ls 3, \
     g using 2:(abs($1 - dense) < 1e-9 ? $3 - $5 : NaN):4 with yerrorbars ls 2 pt 7 ps small_point, \
     g using 2:(abs($1 - middle) < 1e-9 ? $3 - $5 : NaN):4 with yerrorbars ls 4 pt 6 ps small_point, \
     g using 2:(abs($1 - dilute) < 1e-9 ? $3 - $6 : NaN):4 with yerrorbars ls 5 pt 8 ps small_point

set tmargin at screen 0.365
set bmargin at screen 1.1 / height
set xrange [0:2.35]
set yrange [0.017:1]
set logscale y
set ytics (0.02, 0.05, 0.1, 0.2, 0.5, 1)
set ylabel '{/:Italic S}({/:Italic k})'
set xlabel 'wave number {/:Italic k}, 1/' . sigma offset 0, 0.6
set key at graph 0.98, 0.83
plot s using 2:(abs($1 - dense) < 1e-9 ? $5 : NaN) with lines ls 3 title 'Percus–Yevick', \
     s using 2:(abs($1 - middle) < 1e-9 ? $5 : NaN) with lines ls 3, \
     s using 2:(abs($1 - dilute) < 1e-9 ? $5 : NaN) with lines ls 3, \
     s using (0.0):6 with points ls 1 pt 5 title 'compressibility', \
     s using 2:(abs($1 - dense) < 1e-9 ? $3 : NaN):4 with yerrorbars ls 2 pt 7, \
     s using 2:(abs($1 - middle) < 1e-9 ? $3 : NaN):4 with yerrorbars ls 4 pt 6, \
     s using 2:(abs($1 - dilute) < 1e-9 ? $3 : NaN):4 with yerrorbars ls 5 pt 8
unset multiplot
