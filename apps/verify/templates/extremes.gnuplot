# Draws the map of the extremes: a column per solver and integrator, a row per extreme and level. A letter beside the
# colour is for grey print.
$map << EOD
{{{cells}}}EOD
set xrange [-0.5:{{right}}]
set yrange [{{bottom}}:-0.5]
set xtics ({{{columns}}}) rotate by 60 right noenhanced
set ytics ({{{rows}}}) noenhanced
set cbrange [-0.5:5.5]
unset colorbox
unset key
set lmargin 34
set bmargin 9
set palette defined (0 '#009e73', 1 '#f0e442', 2 '#e69f00', 3 '#bbbbbb', 4 '#56b4e9', 5 '#d55e00') maxcolors 6
set title 'green . holds   yellow s tolerance missed and reported   orange x stopped   grey r refused   blue l documented limit   red F fails' noenhanced
set style fill solid border rgb '#ffffff'
{{#formats}}
set terminal {{{terminal}}}
set output 'extremes.{{kind}}'
plot $map using 1:2:(0.5):(0.5):3 with boxxyerror lc palette, \
  $map using 1:2:4 with labels
{{/formats}}
