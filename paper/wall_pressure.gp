# Density of centres at a wall; the pressure on the walls as a part of what theory says, term after
# term; and residuals in standard errors.
height = 11.4
load 'paper/style.gp'

results = data . '/wall_pressure.csv'
cubes = data . '/wall_pressure_cubes.csv'
profile = data . '/wall_pressure_profile.csv'

set multiplot

set tmargin at screen 0.975
set bmargin at screen 0.70
set xrange [0.4:3.5]
set yrange [0:4.9]
set ytics 1
set ylabel 'density, 1/' . sigma . '^3'
set xlabel 'distance from a wall, ' . sigma offset 0, 0.6
set key top right
plot profile using (0.44):($1 == 1400 ? $4 : NaN) every 150 with points ls 1 pt 5 title 'bulk pressure', \
     profile using (0.44):($1 == 500 ? $4 : NaN) with points ls 1 pt 5, \
     profile using (0.44):($1 == 200 ? $4 : NaN) with points ls 1 pt 5, \
     profile using 2:($1 == 1400 ? $3 : NaN) with lines ls 2 title '1400 balls', \
     profile using 2:($1 == 500 ? $3 : NaN) with lines ls 3 title '500 balls', \
     profile using 2:($1 == 200 ? $3 : NaN) with lines ls 4 title '200 balls'

set tmargin at screen 0.59
set bmargin at screen 0.345
set format x ''
set xlabel ''
set xrange [0:0.75]
set yrange [0.64:1.46]
set ytics 0.7, 0.1, 1.1
set ylabel '{/:Italic p} / theory'
set key top right maxrows 3 samplen 2
plot 1 with lines ls 1 title 'bulk, faces, edges', \
     cubes using 3:($8 / $9) with linespoints ls 4 pt 4 title 'bulk, faces', \
     cubes using 3:($7 / $9) with linespoints ls 5 pt 8 title 'bulk alone', \
     cubes using 3:($6 / $9) with linespoints ls 3 title 'naive, {/:Italic n}/{/:Italic L}^3', \
     cubes using 3:($4 / $9):($5 / $9) with yerrorbars ls 2 pt 7 title 'clack'

set tmargin at screen 0.315
set bmargin at screen 1.1 / height
set format x '%h'
set yrange [*<-7:4.5<*] noextend
set ytics -3, 3
set ylabel 'residual, s.e.' offset 0.3, 0
set xlabel 'overall density {/:Italic n}/{/:Italic L}^3, 1/' . sigma . '^3' offset 0, 0.6
set key bottom left horizontal maxrows 1 Left reverse samplen 1
plot 0 with lines ls 1, \
     results using ($1 - 0.008):(strcol(2) eq 'cube_impulse' ? $8 : NaN):(1) with yerrorbars ls 2 pt 7 title 'force', \
     results using ($1 - 0.003):(strcol(2) eq 'hits_minus_impulse' ? $8 : NaN):(1) with yerrorbars ls 4 pt 6 title 'hits', \
     results using ($1 + 0.003):(strcol(2) eq 'profile_minus_impulse' ? $8 : NaN):(1) with yerrorbars ls 5 pt 8 title 'profile', \
     results using ($1 + 0.008):(strcol(2) eq 'middle_minus_bulk' ? $8 : NaN):(1) with yerrorbars ls 6 pt 4 title 'contact–bulk'
unset multiplot
