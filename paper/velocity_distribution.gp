# Speeds of few balls beside the exact law and Maxwell and Boltzmann's, residuals in standard
# errors, and how balls of one speed come there.
height = 11.0
load 'paper/style.gp'

histogram = data . '/velocity_distribution_histogram.csv'
laws = data . '/velocity_distribution_theory.csv'
relaxation = data . '/velocity_distribution_relaxation.csv'
fewest = 8
only(n, y) = n == fewest ? y : NaN

set multiplot

# speeds
set tmargin at screen 0.975
set bmargin at screen 0.66
set format x ''
set xrange [0:4]
set yrange [0:0.72]
set ytics 0.2
set ylabel 'density of speed, 1/({/:Italic kT}/{/:Italic m})^{1/2}'
set key top right
plot laws using 1:2 with lines ls 1 title sprintf('exact, %d balls', fewest), \
     laws using 1:3 with lines ls 3 title 'Maxwell–Boltzmann', \
     histogram using 2:(only($1, $3)):4 with yerrorbars ls 2 pt 7 title 'clack'

# residuals
set tmargin at screen 0.635
set bmargin at screen 0.48
set format x '%h'
set yrange [-7:7]
set ytics -5, 5
set ylabel 'residual, s.e.'
set xlabel 'speed, ({/:Italic kT}/{/:Italic m})^{1/2}'
unset key
plot 0 with lines ls 1, \
     histogram using 2:(only($1, ($6 - $5) / $4)) with lines ls 3, \
     histogram using 2:(only($1, ($3 - $5) / $4)):(1) with yerrorbars ls 2 pt 7

# relaxation
set tmargin at screen 0.37
set bmargin at screen 0.95 / height
set xrange [0:13.5]
set yrange [0.95:1.75]
set ytics 0.2
set xlabel 'collisions per ball'
set ylabel '⟨{/:Italic v}^4⟩ / ⟨{/:Italic v}^2⟩^2'
set key bottom right
plot relaxation using 1:5 with lines ls 1 title 'exact, 500 balls', \
     relaxation using 1:($1 < 2.6 ? $4 : NaN) with lines ls 3 title 'first rise, 8/35 per collision', \
     relaxation using 1:2:3 with yerrorbars ls 2 pt 7 title 'clack, from equal speeds'

unset multiplot
