# Draws a hydrodynamic database: added mass and damping of each mode, and below them the modulus of wave excitation.
set terminal pngcairo size 1500,{{#loads}}1400{{/loads}}{{^loads}}750{{/loads}} font ',11'
set output '{{picture}}'
{{#modes}}
${{name}} << EOD
{{{rows}}}EOD
{{/modes}}
set multiplot layout {{#loads}}4{{/loads}}{{^loads}}2{{/loads}},3 title '{{title}}' noenhanced
set xlabel 'frequency [rad/s]'
set format y '%.3g'
set format y2 '%.3g'
set ytics nomirror
set y2tics
set key top right samplen 2
{{#modes}}
set title '{{name}}'
set ylabel 'added mass [{{mass_unit}}]'
set y2label 'damping [{{damping_unit}}]'
plot ${{name}} using 1:2 with lines lw 2 lc rgb '#0072b2' title 'A', ${{name}} using 1:4 with lines dt 2 lc rgb '#0072b2' title 'A(inf)', ${{name}} using 1:3 axes x1y2 with lines lw 2 lc rgb '#d55e00' title 'B'
{{/modes}}
unset y2tics
unset y2label
set ytics mirror
{{#loads}}
{{#modes}}
set title '{{name}}'
set ylabel 'excitation [{{load_unit}}]'
plot {{#lines}}${{block}} using 1:{{column}} with lines lw 2 title '{{label}}'{{#more}}, {{/more}}{{/lines}}
{{/modes}}
{{/loads}}
unset multiplot
