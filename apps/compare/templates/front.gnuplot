# Draws computing time against error. A mark is black if no other setting is faster and better, else grey. It is hollow if
# the error may be chance, and is then at the size up to which it may be. Every point has its setting's number. Horizontal
# bars show how far times of one setting scatter.
{{#bars}}
$bars << EOD
{{{.}}}EOD
{{/bars}}
{{#best}}
$best << EOD
{{{.}}}EOD
{{/best}}
{{#beaten}}
$beaten << EOD
{{{.}}}EOD
{{/beaten}}
{{#hidden}}
$hidden << EOD
{{{.}}}EOD
{{/hidden}}
{{#chosen}}
$chosen << EOD
{{{.}}}EOD
{{/chosen}}
{{#numbers}}
${{name}} << EOD
{{{rows}}}EOD
{{/numbers}}
{{#leaders}}
$leaders << EOD
{{{.}}}EOD
{{/leaders}}
set logscale xy
set grid lc rgb '#dddddd'
# The names of settings are in the key next to the plot, because they would overlap at the points. The numbers have
# places of their own, which were found for this size of the plot.
set lmargin at screen {{left}}
set rmargin at screen {{right}}
set bmargin at screen {{bottom}}
set tmargin at screen {{top}}
set key at graph 1.02, graph 1 left top vertical Left reverse samplen 1.5 spacing 1.2 noenhanced
set xrange [{{x_low}}:{{x_high}}]
set yrange [{{y_low}}:{{y_high}}]
set format '%g'
set xtics ({{x_tics}})
set ytics ({{y_tics}})
set xlabel 'computing time per simulated second [s/s]'
set ylabel 'error of the {{quantity}} [{{unit}}]'
plot \
{{#leaders}}
  $leaders using 1:2 with lines lw 0.5*LW lc rgb '#999999' notitle, \
{{/leaders}}
{{#bars}}
  $bars using 1:2:3:4 with xerrorbars pt 0 lw LW lc rgb '#999999' title 'scatter of times ({{time_scatter}})', \
{{/bars}}
{{^bars}}
  keyentry with points pt 0 title 'scatter of times: not measured', \
{{/bars}}
{{#beaten}}
  $beaten using 1:2:3:4 with yerrorbars pt 7 ps 0.7*LW lw LW lc rgb '#aaaaaa' title 'another is faster and better, or it failed', \
{{/beaten}}
{{#best}}
  $best using 1:2:3:4 with yerrorbars pt 7 ps 0.9*LW lw LW lc rgb '#000000' title 'none is both faster and better', \
{{/best}}
{{#hidden}}
  $hidden using 1:2 with points pt 10 ps LW lw LW lc rgb '#0072b2' title 'not significant: the error is below this', \
{{/hidden}}
{{#chosen}}
  $chosen using 1:2 with points pt 6 ps 2*LW lw 2*LW lc rgb '#d55e00' title 'recommended', \
{{/chosen}}
{{#numbers}}
  ${{name}} using 1:2:3 with labels center tc rgb '{{colour}}' noenhanced notitle, \
{{/numbers}}
{{#reference_moves}}
  {{.}} with lines dt 2 lw LW lc rgb '#009e73' title 'change of the reference with its step', \
{{/reference_moves}}
{{#names}}
  keyentry with points pt 0 title '{{.}}', \
{{/names}}
  NaN notitle
