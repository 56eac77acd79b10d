# Draws accuracy against time of single problems, a panel each, from work-precision.csv in the same folder. The names of
# the solvers are below the panels.
set datafile separator ','
set logscale xy
set format '10^{%L}'
set grid lc rgb '#dddddd'
set xlabel 'time of the solve [s]'
set ylabel 'residual reached [m/s]'
least = 1e-17
set multiplot
unset key
set xtics font ',9'
set ytics font ',9'
set size {{width}},{{panel_height}}
{{#panels}}
set origin {{left}},{{bottom}}
set title '{{problem}}' noenhanced font ',10'
plot \
{{#solvers}}
  'work-precision.csv' using (strcol(1) eq '{{law}}' && strcol(2) eq '{{problem}}' && strcol(3) eq '{{name}}' ? $5 : NaN):($6 > least ? $6 : least) with linespoints {{{look}}} notitle, \
{{/solvers}}
  NaN notitle
{{/panels}}
set size 1,{{names_height}}
set origin 0,0
set margins 0,0,0,0
unset title
unset xlabel
unset ylabel
unset tics
unset border
unset grid
set key center center maxrows 4 noenhanced
set xrange [1:2]
set yrange [1:2]
plot \
{{#solvers}}
  keyentry with linespoints {{{look}}} title '{{name}}', \
{{/solvers}}
  NaN notitle
unset multiplot
