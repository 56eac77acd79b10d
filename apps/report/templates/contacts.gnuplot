# Draws where ice touched a hull or structures: a row per time, with three views each. Marks are coloured by the force of
# one step on a logarithmic scale that all rows share. Lines are as in the picture of a hull (hull.gnuplot): edges dark,
# the waterline blue, both solid. A broken line would break where a short piece of a mesh begins.
{{#blocks}}
${{name}} << EOD
{{{rows}}}EOD
{{/blocks}}
set size ratio -1
set tics font ',9' nomirror out
set border 3 lc rgb '#888888'
set palette defined (0 '#440154', 1 '#3b528b', 2 '#21918c', 3 '#5ec962', 4 '#fde725')
set logscale cb
set cbrange [{{force_low}}:{{force_high}}]
set cblabel 'force of a contact [{{force_unit}}]' offset 0,0.5
{{#formats}}
set terminal {{terminal}} size {{width}},{{height}} font 'sans,11'{{#background}} background '{{.}}'{{/background}}
set output '{{file}}'
set multiplot layout {{row_count}},{{view_count}} title '{{title}}' noenhanced margins {{left}},{{right}},{{bottom}},{{top}} spacing {{gap_across}},{{gap_up}}
{{#panels}}
{{#left_out}}
set label 1 '{{text}}' at screen 0.5,{{place}} center font ',9' noenhanced
{{/left_out}}
{{^left_out}}
unset label 1
{{/left_out}}
{{#colour_scale}}
set colorbox horizontal user origin 0.36,{{origin}} size 0.28,{{size}}
set key at screen {{left}},{{key}} left bottom Left reverse samplen 3 font ',9'
{{/colour_scale}}
{{^colour_scale}}
unset colorbox
set key off
{{/colour_scale}}
set xrange [{{x_low}}:{{x_high}}]
set yrange [{{y_low}}:{{y_high}}]
set xtics {{x_step}}
set ytics {{y_step}}
set title '{{heading}}'{{#loads}}."\n".'{{.}}'{{/loads}} noenhanced offset 0,-0.6
set xlabel '{{x_label}}'
set ylabel '{{y_label}} [m]' offset 0.5,0
plot \
{{#floes}}
  ${{.}} using 1:2 with filledcurves closed fc rgb '#dbeaf5' notitle, \
  ${{.}} using 1:2 with lines lc rgb '#7fa6c4' lw 0.7 notitle, \
{{/floes}}
{{#marks}}
  ${{.}} using 1:2:(0.35 + 0.9 * sqrt($3 / {{force_high}})):3 with points pt 7 ps variable lc palette notitle, \
{{/marks}}
  ${{bodies}} using 1:2 with lines lc rgb '#333333' lw 1 notitle, \
  ${{water}} using 1:2 with lines lc rgb '#0040ff' lw 1.5 notitle{{#colour_scale}}, \
  keyentry with points pt 7 ps 0.9 lc palette cb {{force_high}} title 'contact', \
  keyentry with lines lc rgb '#333333' lw 1 title 'edge of hull or body', \
  keyentry with lines lc rgb '#0040ff' lw 1.5 title 'waterline', \
  keyentry with lines lc rgb '#7fa6c4' lw 0.7 title 'edge of ice'{{/colour_scale}}
{{/panels}}
unset multiplot
unset output
{{/formats}}
