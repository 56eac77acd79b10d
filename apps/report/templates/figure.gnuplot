# Draws a plot of a report for papers: curves with their ranges, and marked values with their errors.
{{#curves}}
${{block}} << EOD
{{{rows}}}EOD
{{/curves}}
set encoding utf8
set title '{{title}}' noenhanced
set xlabel '{{x_label}}' noenhanced offset 0,0.4
set ylabel '{{y_label}}' noenhanced
set border 3 lc rgb '#666666'
set tics nomirror out
set grid lc rgb '#e4e4e4' lw 0.5
set key below Left reverse noenhanced samplen 2
set style fill transparent solid 0.25 noborder
{{#log_x}}
set logscale x
set format x '10^{%L}'
{{/log_x}}
{{#log_y}}
set logscale y
set format y '10^{%L}'
{{#y_low}}
set yrange [{{y_low}}:*]
{{/y_low}}
{{/log_y}}
{{#x_range}}
set xrange [{{low}}:{{high}}]
{{/x_range}}
{{#y_range}}
set yrange [{{low}}:{{high}}]
{{/y_range}}
{{#formats}}
set terminal {{{terminal}}}
set output '{{file}}'
plot \
{{#levels}}
{{#has_band}}
  '+' using 1:({{low}}):({{high}}) with filledcurves fc rgb '#bbbbbb' notitle, \
{{/has_band}}
  {{y}} with lines lc rgb '#444444' dt 2 title '{{name}}', \
{{/levels}}
{{#curves}}
{{#has_range}}
  ${{block}} using 1:3:4 with filledcurves fc rgb '{{colour}}' notitle, \
{{/has_range}}
  ${{block}} using 1:2 with {{style}} dt {{dash}} lc rgb '{{colour}}' title '{{name}}', \
{{/curves}}
  NaN notitle
unset output
{{/formats}}
