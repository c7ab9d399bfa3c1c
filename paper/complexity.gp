# Processor time of a start (above) and of a collision (below) against the number of balls. Lines
# are the powers of n fitted to the sizes that the caches hold, drawn on to all sizes.
height = 9.2
load 'paper/style.gp'

costs = data . '/complexity_costs.csv'
methods = 'table heap fast'
style(k) = k == 1 ? 1 : k == 2 ? 3 : 2
only(method, quantity, y) = strcol(1) eq method && strcol(2) eq quantity ? y : NaN

# The three exponents stand in the key, as they were fitted.
exponent(method, quantity) = system(sprintf("awk -F, '$1 == \"%s\" && $2 == \"%s\" { printf \"%%.2f\", $7; exit }' %s", method, quantity, costs))
name(method, quantity) = sprintf('%s,  {/:Italic n}^{%s}', method, exponent(method, quantity))

set multiplot
set logscale xy
set xrange [350:200000]
set xtics 1e2, 10
set mxtics 10
set key top left Left reverse maxrows 3

set tmargin at screen 0.975
set bmargin at screen 0.565
set format x ''
set format y '10^{%T}'
set yrange [5e-5:20]
set ytics 1e-8, 10
set ylabel 'processor time of a start, s' offset 0.6, 0
plot for [k = 1:3] costs using 3:(only(word(methods, k), 'start', $6)) with lines ls style(k) lw thin, \
     for [k = 1:3] costs using 3:(only(word(methods, k), 'start', $4)):5 with yerrorbars ls style(k) title name(word(methods, k), 'start')

set tmargin at screen 0.525
set bmargin at screen 1.1 / height
set format x '10^{%T}'
set yrange [1.5e-7:2e-3]
set ylabel 'of a collision, s' offset 0.6, 0
set xlabel 'number of balls {/:Italic n}'
plot for [k = 1:3] costs using 3:(only(word(methods, k), 'collision', $6)) with lines ls style(k) lw thin, \
     for [k = 1:3] costs using 3:(only(word(methods, k), 'collision', $4)):5 with yerrorbars ls style(k) title name(word(methods, k), 'collision')
unset multiplot
