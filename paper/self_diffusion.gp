# Self-diffusion over Enskog's against packing fraction, the two routes beside one another, and how
# the size of the box takes part.
height = 11.0
load 'paper/style.gp'

values = data . '/self_diffusion_values.csv'
ledger = data . '/self_diffusion.csv'
theory = data . '/self_diffusion_theory.csv'

set multiplot
set xrange [0:0.52]
set xtics 0.1

set tmargin at screen 0.975
set bmargin at screen 0.66
set format x ''
set yrange [0.4:1.55]
set ytics 0.4, 0.2
set ylabel 'self-diffusion {/:Italic D} / {/:Italic D}_{Enskog}' offset 0.4, 0
set key bottom left Left reverse
plot 1 with lines ls 10, \
     theory using 1:2 with lines ls 9 title 'Speedy, 500 balls', \
     values using 1:($3 / $7):($4 / $7) with yerrorbars ls 2 title 'clack, in the box', \
     values using 1:9:10 with yerrorbars ls 3 pt 7 title 'clack, infinite box'

set tmargin at screen 0.635
set bmargin at screen 0.48
set format x '%h'
set yrange [-0.045:0.045]
set ytics -0.02, 0.02
set ylabel '{/:Italic D}_{GK}/{/:Italic D}_{E} − 1' offset 0.4, 0
set xlabel 'packing fraction ' . eta
unset key
ratio(y) = strcol(3) eq 'route_ratio' ? y : NaN
plot 0 with lines ls 1, \
     ledger using 1:(ratio($4 - 1)):5 with yerrorbars ls 2 pt 7

set tmargin at screen 0.37
set bmargin at screen 0.95 / height
set xrange [0:0.19]
set xtics 0.05
set yrange [1.05:1.45]
set ytics 1.1, 0.1
set xlabel 'inverse side of the box, 1/' . sigma
set ylabel '{/:Italic D} / {/:Italic D}_{Enskog}' offset 0.4, 0
set key bottom left Left reverse
stats values using (abs($1 - 0.2618) < 1e-3 && $2 > 500 ? $9 : NaN) name 'far' nooutput
stats values using (abs($1 - 0.2618) < 1e-3 && $2 > 500 ? $8 / $7 / $11 : NaN) name 'slope' nooutput
plot far_mean - slope_mean * x with lines ls 1 title 'expected slope', \
     values using 11:(abs($1 - 0.2618) < 1e-3 ? $3 / $7 : NaN):($4 / $7) with yerrorbars ls 2 pt 7 title 'clack, ' . eta . ' = 0.26'
unset multiplot
