# Pressure along the branches of fluid and crystal about coexistence, and residuals in standard
# errors. The fluid forced to where the crystal is stable lies on neither.
height = 7.6
load 'paper/style.gp'

results = data . '/freezing.csv'
points = data . '/freezing_points.csv'
theory = data . '/freezing_theory.csv'

set multiplot
set xrange [0.84:1.1]
set xtics 0.05

@main_panel
set yrange [7:26.5]
set ytics 5
set ylabel 'pressure {/:Italic p}, {/:Italic kT}/' . sigma . '^3'
set key top left Left reverse
plot theory using 1:4 with lines ls 9 title 'coexistence', \
     theory using 1:2 with lines ls 1 title 'theories', \
     theory using 1:3 with lines ls 1, \
     points using 2:(strcol(1) eq 'fluid' ? $3 : NaN):4 with yerrorbars ls 2 pt 7 title 'fluid', \
     points using 2:(strcol(1) eq 'crystal' ? $3 : NaN):4 with yerrorbars ls 4 pt 6 title 'crystal', \
     points using 2:(strcol(1) eq 'forced' ? $3 : NaN):4 with yerrorbars ls 3 pt 8 title 'forced fluid'

@residual_panel
set yrange [*<-5:5<*] noextend
set ytics -4, 4
set ylabel 'residual, s.e.' offset 0.3, 0
set xlabel 'number density ' . rho . ', 1/' . sigma . '^3'
plot 0 with lines ls 1, \
     results using 1:(strcol(2) eq 'fluid' ? $8 : NaN):(1) with yerrorbars ls 2 pt 7, \
     results using 1:(strcol(2) eq 'crystal' ? $8 : NaN):(1) with yerrorbars ls 4 pt 6
unset multiplot
