# Which method fails in which scene: the worst outcome, and from which k on.
width = 17.6
height = 12.6
load 'paper/style.gp'

file = data . '/failure_atlas.csv'
stats file using 1 nooutput; rows = STATS_max + 1
stats file using 4 nooutput; columns = STATS_max + 1

# Outcome codes: 0 ok, 1 digits, 2 order, 3 overlap, 4 energy, 5 lost, 6 hang, 7 crash, 8 not run.
array colours[9] = [0xdcefe6, 0, 0x56b4e9, 0xd55e00, 0xcc79a7, 0x0072b2, 0x202020, 0x7a0000, 0xffffff]
# The more digits are lost, the deeper the yellow.
part(digits) = (digits > 16 ? 1 : digits / 16.0)
fade(from, to, digits) = int(from + (to - from) * part(digits))
yellow(digits) = 65536 * fade(255, 214, digits) + 256 * fade(246, 140, digits) + fade(200, 0, digits)
colour(code, digits) = (code == 1 ? yellow(digits) : colours[int(code) + 1])
dark(code) = (code == 3 || code == 5 || code == 6 || code == 7)
ink(code) = (dark(code) ? 0xffffff : 0x000000)
# The k from which on more than digits is lost, where it is; how far a method was run that held out
# as long as it was; why it was not run at all.
number(k) = sprintf('%.3g', real(k))
shown(code, k, gross, reached, last, why) = \
    (code == 8 ? word('t w r m', int(why)) : code == 0 ? (real(reached) < real(last) ? '≤ ' . number(reached) : '') : code == 1 ? number(k) : number(gross))

# A dagger: from some k on physics has no answer. What grows with k stands behind the name.
title(scene, parameter, none) = scene . (none eq 'nan' ? '' : '†') . ' {/=5.5 (' . raised(minus(parameter)) . ')}'
minus(text) = (strstrt(text, ' - ') ? text[1:strstrt(text, ' - ')] . '−' . text[strstrt(text, ' - ') + 2:*] : text)
raised(text) = (strstrt(text, '10^-k') ? text[1:strstrt(text, '10^-k') - 1] . '10^{−k}' . text[strstrt(text, '10^-k') + 5:*] : text)

set lmargin at screen 0.305
set rmargin at screen 0.955
set tmargin at screen 0.855
set bmargin at screen 0.085
set xrange [-0.5:columns - 0.5]
set yrange [rows - 0.5:-0.5]
set xtics () scale 0
set x2range [-0.5:columns - 0.5]
set x2tics scale 0 rotate by 40 left offset -0.6, -0.2 font ',7'
set ytics scale 0 offset 0.2, 0 font ',7'
unset xtics
set style fill solid border lc rgb '#ffffff'

# The key stands below, a box a kind of outcome.
array names[8] = ['ok', 'loses digits', 'wrong order', 'overlap', 'energy drift', 'lost ball', 'hang', 'crash']
array places[8] = [0.02, 0.10, 0.25, 0.40, 0.52, 0.66, 0.78, 0.87]
do for [n = 1:8] {
    x = places[n]
    set object n rect from screen x, 0.042 to screen x + 0.016, 0.062 fc rgb (n == 2 ? yellow(9) : colours[n]) fs solid border lc rgb '#777777'
    set label n names[n] at screen x + 0.021, 0.052 left font ',7'
}
set label 9 'number: from this {/:Italic k} on (digits may go before);  ≤: run so far;  not run:  t too long,  w too wide,  r turns round,  m missing' at screen 0.02, 0.016 left font ',6.5'
# clack | frames | LAMMPS | textbooks
do for [x in "2.5 5.5 6.5 9.5"] {
    set arrow from first x + 0, first -0.5 to first x + 0, first rows - 0.5 nohead front lc rgb '#000000' lw 1
}

plot file using 4:1:(0.5):(0.5):(colour($8, $9)):ytic(title(strcol(2), strcol(3), strcol(7))):x2tic(strcol(5)) with boxxyerror lc rgb variable, \
     file using 4:1:(shown($8, strcol(10), strcol(11), strcol(12), strcol(6), $13)):($8 == 8 ? 0x888888 : ink($8)) with labels font ',5.5' tc rgb variable
