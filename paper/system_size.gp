# The compressibility factor against the inverse of the number of balls, the law, and residuals in
# standard errors.
height = 7.2
load 'paper/style.gp'

points = data . '/system_size_points.csv'

set multiplot
set logscale x
set xrange [2e-5:0.05]
set xtics 10

@main_panel
set yrange [3.19:3.285]
set ytics 0.02
set ylabel 'compressibility factor {/:Italic Z}'
set key bottom left Left reverse
plot points using (1 / $1):4 with lines ls 1 title 'law, 1/{/:Italic n}', \
     points using (1 / $1):5 with lines ls 9 title 'infinitely many balls', \
     points using (1 / $1):($6 == 1 ? $2 : NaN):3 with yerrorbars ls 2 pt 7 title 'clack', \
     points using (1 / $1):($6 == 0 ? $2 : NaN):3 with yerrorbars ls 3 pt 8 title 'clack, sees its images'

@residual_panel
set format x '10^{%T}'
set yrange [*<-5:8<*] noextend
set ytics -4, 4
set ylabel 'residual, s.e.' offset 0.3, 0
set xlabel '1 / number of balls {/:Italic n}'
plot 0 with lines ls 1, \
     points using (1 / $1):($6 == 1 ? ($2 - $4) / $3 : NaN):(1) with yerrorbars ls 2 pt 7, \
     points using (1 / $1):($6 == 0 ? ($2 - $4) / $3 : NaN):(1) with yerrorbars ls 3 pt 8
unset multiplot
