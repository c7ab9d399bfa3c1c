# Collisions per second of processor time: against the number of balls, one line a packing fraction
# (fast above, heap below); against the packing fraction, all methods among 4000 balls; and how many
# times as fast as the heap the fast method is, with its aim.
height = 13.4
load 'paper/style.gp'

rates = data . '/speed_rates.csv'
account = data . '/speed.csv'
column_of(file, k) = system(sprintf("grep -v '^#' %s | tail -n +2 | cut -d, -f%d | sort -gu | tr '\n' ' '", file, k))
fractions = column_of(rates, 3)
counts = column_of(rates, 2)
aim = real(system(sprintf("awk -F, '$4 == \"aim_over_heap\" { print $7; exit }' %s", account)))
only(boundary, method, y) = strcol(1) eq boundary && strcol(4) eq method ? y : NaN
at(k, value, list) = value == real(word(list, k)) ? 1 : NaN
million = 1e-6

set multiplot
set datafile missing NaN

set tmargin at screen 0.985
set bmargin at screen 0.725
set logscale xy
set xrange [300:*]
set yrange [0.06:40]
set format x '10^{%T}'
set format y '%g'
set xtics 1e2, 10
set mxtics 10
set ytics add (0.1, 0.2, 0.5, 1, 2, 5, 10)
set ylabel '10^6 collisions per second' offset 0.8, 0
set xlabel 'number of balls {/:Italic n}'
set key top right Left reverse maxrows 2 samplen 1.6 width 0.5
plot for [k = 1:words(fractions)] rates using 2:(only('periodic', 'heap', $5) * million * at(k, $3, fractions)) with lines ls k lw 0.5 * thin, \
     for [k = 1:words(fractions)] rates using 2:(only('periodic', 'fast', $5) * million * at(k, $3, fractions)):($6 * million) with yerrorlines ls k lw thin title (k == 1 ? eta . ' = ' : '') . word(fractions, k)

set tmargin at screen 0.635
set bmargin at screen 0.405
unset logscale x
set xrange [0:0.56]
set format x '%g'
set xtics 0.1
unset mxtics
set yrange [0.01:60]
set xlabel 'packing fraction ' . eta
set ytics (0.01, 0.1, 1, 10)
set key top left Left reverse maxrows 2 samplen 2.5 width 0
style(name) = name eq 'table' ? 1 : name eq 'heap' ? 3 : name eq 'fast' ? 2 : 4
runners = system(sprintf("grep -v '^#' %s | tail -n +2 | cut -d, -f4 | awk '!seen[$0]++' | tr '\n' ' '", rates))
plot for [name in runners] rates using 3:(only('periodic', name, $5) * million * ($2 == 4000 ? 1 : NaN)):($6 * million) with yerrorlines ls style(name) lw thin title name

set tmargin at screen 0.315
set bmargin at screen 1.1 / height
unset logscale y
set yrange [0:*]
set ytics 1
set offsets 0, 0, 2.5, 0
set ylabel 'rate of fast / rate of heap' offset 0, 0
set key top left Left reverse maxrows 2 samplen 2 width 0
plot aim with lines ls 9 title 'aim', \
     for [k = 1:words(counts)] rates using 3:(only('periodic', 'fast', $7) * at(k, $2, counts)):8 with yerrorlines ls k lw thin title '{/:Italic n} = ' . word(counts, k)
unset multiplot
