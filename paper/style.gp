# What all figures share. A figure's script starts with
#     load 'paper/style.gp'
# and is drawn from the project's root by
#     gnuplot -e "data='build/data'; figure='build/figures/NAME.pdf'" paper/NAME.gp
# `data` is the folder of the experiments' results, `figure` the file to draw: a PDF one column of
# the report wide, or a PNG of the same for a screen.
#
# A script that wants another height says so first:  height = 9.0   # [cm]
# Line styles 1 to 8 are told apart by colour (for all kinds of colour vision: Okabe and Ito), by
# lightness, by dashes and by the shape of the points. Style 9 is a guide line, style 10 a zero line.
#     plot f(x) with lines ls 1, file using 1:2:3 with yerrorbars ls 2
# A residual panel below the main one:
#     set multiplot
#     @main_panel;     plot ...
#     @residual_panel; plot ...
#     unset multiplot

if (!exists("width")) width = 8.6                              # [cm] a revtex column
if (!exists("height")) height = 6.2        # [cm]
if (!exists("data")) data = 'build/data'
if (!exists("figure")) figure = 'figure.pdf'

if (figure[strlen(figure)-3:*] eq '.png') {
    set terminal pngcairo size 100 * width, 100 * height font 'Latin Modern Roman,9' fontscale 2.4 linewidth 2.4 pointscale 2.4 background 'white'
} else {
    set terminal pdfcairo size width cm, height cm font 'Latin Modern Roman,9' fontscale 0.66 linewidth 1 dashlength 0.6
}
set output figure

set datafile separator comma               # results are CSV, comments start with #
set datafile commentschars '#'
set encoding utf8
set minussign

point = 0.45                               # size of a point that carries an error bar
small_point = 0.25                         # of one among very many
bold = 1.6                                 # width of a line that is the result
thin = 0.8                                 # of one that helps to read it

set style line 1 lc rgb '#000000' lw bold dt solid       pt 7  ps point
set style line 2 lc rgb '#0072b2' lw bold dt (12, 4)     pt 5  ps point
set style line 3 lc rgb '#d55e00' lw bold dt (3, 3)      pt 9  ps 1.2 * point
set style line 4 lc rgb '#009e73' lw bold dt (12, 3, 3, 3) pt 13 ps 1.2 * point
set style line 5 lc rgb '#cc79a7' lw bold dt (6, 3)      pt 11 ps 1.2 * point
set style line 6 lc rgb '#e69f00' lw bold dt (12, 3, 3, 3, 3, 3) pt 6 ps point
set style line 7 lc rgb '#56b4e9' lw bold dt (20, 5)     pt 4  ps point
set style line 8 lc rgb '#999999' lw bold dt solid       pt 8  ps 1.2 * point
set style line 9 lc rgb '#777777' lw thin dt (6, 4)      pt 2  ps point
set style line 10 lc rgb '#777777' lw thin dt solid      pt 1  ps point

set border lw thin
set tics scale 0.6 nomirror out
set xtics offset 0, 0.3
set ytics offset 0.4, 0
set xlabel offset 0, 0.6
set ylabel offset 1.4, 0
set key spacing 1.1 samplen 2.5 width 0 noautotitle
set errorbars 0.4 linewidth thin
set pointintervalbox 0.01                   # no halo that would cut bars and lines
set lmargin at screen 0.155
set rmargin at screen 0.965
set bmargin at screen 1.1 / height
set tmargin at screen 0.965

# Symbols as the report sets them: the text font has no Greek.
eta = '{/"Latin Modern Math" 𝜂}'
sigma = '{/"Latin Modern Math" 𝜎}'
rho = '{/"Latin Modern Math" 𝜌}'

# The two panels share the abscissa: its label and numbers stand below the lower one only.
main_panel = "set tmargin at screen 0.965; set bmargin at screen 0.42; set format x ''"
residual_panel = "set tmargin at screen 0.37; set bmargin at screen 1.1 / height; set format x '%h'; unset key; unset label"
