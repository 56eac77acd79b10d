# Draws a profile of solvers from profiles.csv in the same folder.
set datafile separator ','
set logscale x
set format x '10^{%L}'
set xrange [{{low}}:{{high}}]
set yrange [-0.02:1.02]
set ytics 0.2
set grid lc rgb '#dddddd'
set key outside right noenhanced
set xlabel '{{x_label}}'
set ylabel 'share of the {{problems}} problems that are solved [-]'
chosen(kind, solver) = strcol(1) eq '{{law}}' && strcol(3) eq kind && strcol(4) eq solver && abs($2 / {{tolerance}} - 1) < 1e-9
plot \
{{#solvers}}
  'profiles.csv' using (chosen('{{kind}}', '{{name}}') ? $5 : NaN):6 with steps {{{look}}} notitle, \
  '' using (chosen('{{kind}}', '{{name}}') ? $5 : NaN):6 with points {{{look}}} notitle, \
  keyentry with linespoints {{{look}}} title '{{name}}', \
{{/solvers}}
  NaN notitle
