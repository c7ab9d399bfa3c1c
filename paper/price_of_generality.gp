# What each ingredient costs a collision that does not need it (above), and the rate of the model
# that `auto` chooses over that of the best method (middle: walls, below: periodic).
height = 15.5
load 'paper/style.gp'

prices = data . '/price_of_generality.csv'
choices = data . '/price_of_generality_auto.csv'
fractions = system(sprintf("grep -v '^#' %s | tail -n +2 | cut -d, -f3 | sort -gu | tr '\n' ' '", choices))
rows = int(system(sprintf("grep -v '^#' %s | tail -n +2 | wc -l", prices)))
largest = real(system(sprintf("grep -v '^#' %s | tail -n +2 | cut -d, -f2 | sort -g | tail -n 1", choices)))
shortest = 0.85
longest = 1.25
within(x) = x < shortest ? shortest : x > longest ? longest : x
only(boundary, k, y) = strcol(1) eq boundary && $3 == real(word(fractions, k)) ? y : NaN

set multiplot
set datafile missing NaN

set tmargin at screen 0.985
set bmargin at screen 0.565
set lmargin at screen 0.40
set rmargin at screen 0.785
set xrange [shortest:longest]
set yrange [rows - 0.4:-0.6]
set xtics 0.1
set xlabel 'time of a collision / smallest model' offset 0, 0.5
set ytics scale 0
set style fill solid 0.55 noborder
set arrow from 1, graph 0 to 1, graph 1 nohead ls 10 front
name = "(strcol(1) . (strcol(2) eq 'whole' ? '' : '*'))"
plot prices using (within($3)):0:(1):(within($3)):($0 - 0.3):($0 + 0.3):ytic(@name) every ::1 with boxxyerror lc rgb '#56b4e9', \
     prices using ($3 < longest ? $3 : NaN):0:4 every ::1 with xerrorbars ls 1 ps 0 lw thin, \
     prices using ($3 < longest ? NaN : longest):0:('…') every ::1 with labels left offset -1.6, 0, \
     prices using (longest):0:(sprintf($3 < 2 ? '%.3f ± %.3f' : '%.1f ± %.1f', $3, $4)) every ::1 with labels left offset 0.6, 0
unset arrow

set lmargin at screen 0.155
set rmargin at screen 0.965
set logscale x
set xrange [1.6:1.3 * largest]
set yrange [0.8:1.6]
set ytics 0.2 scale 0.6
set ylabel 'rate of auto / best method' offset 1.0, -4.5
set arrow from graph 0, first 0.9 to graph 1, first 0.9 nohead ls 9
set arrow from graph 0, first 1 to graph 1, first 1 nohead ls 10
set key top right maxrows 2 samplen 2 width 0

set tmargin at screen 0.475
set bmargin at screen 0.29
set xtics ('' 2, '' 4, '' 8, '' 16, '' 32, '' 64, '' 128, '' 500, '' 2000, '' 8000, '' 32000)
unset xlabel
set label 1 'walls' at graph 0.03, 0.9
plot for [k = 1:words(fractions)] choices using 2:(only('walls', k, $12)):13 with yerrorlines ls k lw thin title (k == 1 ? eta . ' = ' : '') . word(fractions, k)

set tmargin at screen 0.26
set bmargin at screen 1.1 / height
set xtics (2, 4, 8, 16, 32, 64, 128, 500, 2000, 8000, 32000)
set xlabel 'number of balls {/:Italic n}' offset 0, 0.6
unset ylabel
unset key
set label 1 'periodic'
plot for [k = 1:words(fractions)] choices using 2:(only('periodic', k, $12)):13 with yerrorlines ls k lw thin
unset multiplot
