# Draws bars with standard errors of the change by each simplification and of the computing time that it saves.
$changes << EOD
{{{changes}}}EOD
$saved << EOD
{{{saved}}}EOD
set multiplot layout 1,2
set yrange [{{bottom}}:0.4]
set ytics noenhanced
set xzeroaxis
set xtics rotate by -30
set arrow from 0, graph 0 to 0, graph 1 nohead lc rgb '#888888'
set grid x lc rgb '#dddddd'
set lmargin 24
set xlabel '{{quantity}}'
plot $changes using (0.5*$2):1:(0.5*abs($2)):(0.3):ytic(4) with boxxyerror fs solid 0.35 lc rgb '#0072b2' lw LW notitle, \
  $changes using 2:1:3 with xerrorbars pt 0 lc rgb '#000000' lw LW notitle
set format y ''
set lmargin 4
set xlabel 'computing time saved [ms per simulated second]'
plot $saved using (0.5*$2):1:(0.5*abs($2)):(0.3) with boxxyerror fs solid 0.35 lc rgb '#0072b2' lw LW notitle, \
  $saved using 2:1:3 with xerrorbars pt 0 lc rgb '#000000' lw LW notitle
unset multiplot
