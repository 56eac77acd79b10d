# Draws the errors of a family of cases: cases along x, a mark per solver, and the allowed error as a bar.
$allowed << EOD
{{{allowed}}}EOD
{{#solvers}}
$s{{mark}} << EOD
{{{rows}}}EOD
{{/solvers}}
set logscale y
set format y '10^{%L}'
set yrange [{{foot}}:10]
set xrange [-0.6:{{right}}]
set xtics ({{{ticks}}})
set ylabel 'error'
set grid y lc rgb '#dddddd'
set key outside right noenhanced
set colorsequence podo
{{#formats}}
set terminal {{{terminal}}}
set output 'family-{{family}}.{{kind}}'
plot $allowed using 1:2:($3-$1):(0) with vectors nohead lc rgb '#555555' lw 1.5 title 'allowed'{{#solvers}}, \
  $s{{mark}} using 1:2 with points pt {{mark}} ps 0.7 title '{{solver}}'{{/solvers}}
{{/formats}}
