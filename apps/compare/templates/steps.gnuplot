# Draws the error over the time step, with a line for each group of settings that differ in the step alone.
{{#lines}}
${{name}} << EOD
{{{rows}}}EOD
{{/lines}}
set logscale xy
set grid lc rgb '#dddddd'
set rmargin 42
set key at graph 1.02, graph 1 left top vertical Left reverse samplen 1.5 spacing 1.2 noenhanced
set xrange [{{x_low}}:{{x_high}}]
set yrange [{{y_low}}:{{y_high}}]
set format '%g'
set xtics ({{x_tics}})
set ytics ({{y_tics}})
set xlabel 'time step [s]'
set ylabel 'error of the {{quantity}} [{{unit}}]'
set colorsequence podo
plot \
{{#lines}}
  ${{name}} using 1:2 smooth unique with linespoints lt {{number}} dt {{dash}} pt {{number}} lw LW title '{{label}}', \
{{/lines}}
{{#floor}}
  {{.}} with lines dt 3 lc rgb '#888888' lw LW title 'below: may be chance', \
{{/floor}}
  NaN notitle
