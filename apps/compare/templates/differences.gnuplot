# Draws the mean load of each setting minus that of the scene's own, run by run on the same ice. Small points are
# realisations, and large ones their means. The band is the difference by chance of two runs of one realisation.
{{#runs}}
$runs << EOD
{{{.}}}EOD
{{/runs}}
{{#layers}}
${{name}} << EOD
{{{rows}}}EOD
{{/layers}}
set xrange [{{low}}:{{high}}]
set yrange [{{bottom}}:-0.7]
set ytics noenhanced ({{#rows}}'{{label}}' {{place}}{{comma}}{{/rows}})
set grid lc rgb '#dddddd'
set xtics rotate by -30
set xlabel 'mean ice load minus that of the scene''s own setting, on the same ice [N]'
set rmargin 6
set key outside top center horizontal noenhanced
set arrow from 0, graph 0 to 0, graph 1 nohead lc rgb '#888888'
{{#band}}
set object rectangle from {{from}}, graph 0 to {{to}}, graph 1 behind fc rgb '#eeeeee' fs solid noborder
{{/band}}
plot \
{{#layers}}
  ${{name}} using 1:2:3 with xerrorbars pt {{mark}} ps LW lw LW lc rgb '{{colour}}' title '{{title}}', \
{{/layers}}
{{#runs}}
  $runs using 1:2 with points pt 7 ps 0.4*LW lc rgb '#000000' title 'each realisation', \
{{/runs}}
  NaN notitle
