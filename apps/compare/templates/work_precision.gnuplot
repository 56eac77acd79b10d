# Draws accuracy against time from work-precision.csv in the same folder.
set datafile separator ','
set logscale xy
set format '10^{%L}'
set grid lc rgb '#dddddd'
set key outside right noenhanced
set xlabel 'time of the solve [s]'
set ylabel 'residual of the friction law that was reached [m/s]'
least = 1e-17
plot \
{{#solvers}}
  'work-precision.csv' using (strcol(1) eq '{{law}}' && strcol(2) eq 'median' && strcol(3) eq '{{name}}' ? $5 : NaN):($6 > least ? $6 : least) with linespoints {{{look}}} title '{{name}}', \
{{/solvers}}
  NaN notitle
