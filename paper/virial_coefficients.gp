# What is left of the pressure beyond the second virial coefficient, beside the series; and the
# fitted coefficients' residuals in standard errors.
height = 7.2
load 'paper/style.gp'

results = data . '/virial_coefficients.csv'
points = data . '/virial_coefficients_points.csv'
theory = data . '/virial_coefficients_theory.csv'

set multiplot

@main_panel
set format x '%h'
set bmargin at screen 0.47
set xrange [0:0.25]
set xtics 0.05
set yrange [9:17.5]
set ytics 2
set ylabel '({/:Italic Z} – 1 – 4' . eta . ') / ' . eta . '^2'
set xlabel 'packing fraction ' . eta offset 0, 0.4
set key top left Left reverse
plot theory using 1:2 with lines ls 1 title 'all known coefficients', \
     theory using 1:4 with lines ls 4 title 'up to {/:Italic B}_6', \
     theory using 1:3 with lines ls 3 title 'up to {/:Italic B}_4', \
     points using 1:3:4 with yerrorbars ls 2 pt 7 title 'clack'

@residual_panel
set tmargin at screen 0.31; set bmargin at screen 0.8 / height
set xrange [1.5:4.5]
set xtics ('{/:Italic B}_2' 2, '{/:Italic B}_3' 3, '{/:Italic B}_4' 4)
set format x '%g'
set yrange [*<-4.5:4.5<*] noextend
set ytics -3, 3
set ylabel 'residual, s.e.' offset 0.3, 0
unset xlabel
plot 0 with lines ls 1, \
     results using 1:8:(1) with yerrorbars ls 2 pt 7
unset multiplot
