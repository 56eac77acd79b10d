# Draws the load by place on the unrolled surface.
$cells << EOD
{{{rows}}}EOD
set encoding utf8
set title 'Impulse by place on the unrolled surface'
set xlabel 'along the waterline, {{side}} [m]'
set ylabel 'above the water [m]'
set cblabel 'impulse [N s]'
set border 3 lc rgb '#666666'
set tics nomirror out
set grid lc rgb '#e4e4e4' lw 0.5
set key off
set xrange [{{low}}:{{high}}]
set logscale cb
set palette defined (0 '#440154', 1 '#3b528b', 2 '#21918c', 3 '#5ec962', 4 '#fde725')
set style fill solid 1 noborder
{{#formats}}
set terminal {{{terminal}}}
set output '{{file}}'
plot 0 with lines lc rgb '#0040ff' lw 1, $cells using 1:2:({{half}}):({{half}}):3 with boxxyerror lc palette
unset output
{{/formats}}
