# How Boltzmann's H falls from three starts, beside Kac's walk, and the residuals in standard errors.
height = 8.4
load 'paper/style.gp'

course = data . '/relaxation_course.csv'
only(start, y) = strcol(1) eq start ? y : NaN

set multiplot
set xrange [0:5.3]

@main_panel
set bmargin at screen 0.47
set logscale y
set yrange [0.03:40]
set ytics ('0.05' 0.05, '0.1' 0.1, '0.2' 0.2, '0.5' 0.5, '1' 1, '2' 2, '5' 5, '10' 10)
set ylabel '{/:Italic H} − {/:Italic H}_∞ per ball' offset 0.4, 0
set key top right samplen 2
plot course using 2:(only('one_moving', $5)) with lines ls 1, \
     course using 2:(only('equal_speeds', $5)) with lines ls 1, \
     course using 2:(only('two_halves', $5)) with lines ls 1 title 'Kac’s walk', \
     course using 2:(only('one_moving', $3)):4 with yerrorbars ls 3 title 'one moving ball', \
     course using 2:(only('equal_speeds', $3)):4 with yerrorbars ls 2 title 'equal speeds', \
     course using 2:(only('two_halves', $3)):4 with yerrorbars ls 4 title 'two temperatures'

@residual_panel
set tmargin at screen 0.42
unset logscale y
set yrange [*<-5:5<*] noextend
set ytics -3, 3
set ylabel 'residual, s.e.' offset 0.4, 0
set xlabel 'time, final mean free times'
plot 0 with lines ls 1, \
     course using ($2 - 0.03):(only('one_moving', ($3 - $5) / sqrt($4**2 + $6**2))):(1) with yerrorbars ls 3, \
     course using 2:(only('equal_speeds', ($3 - $5) / sqrt($4**2 + $6**2))):(1) with yerrorbars ls 2, \
     course using ($2 + 0.03):(only('two_halves', ($3 - $5) / sqrt($4**2 + $6**2))):(1) with yerrorbars ls 4
unset multiplot
