# Draws a hull in several views, a panel for each: the faces in order of depth, then the marks over them in the same
# place. A prepared hull has a bow, whose label and waterline are drawn; a faulty mesh has open edges and marks. The
# waterline is as in the picture of contacts (contacts.gnuplot): solid and blue.
set terminal pngcairo size {{width}},{{height}} font ',11'
set output '{{picture}}'
set multiplot
set pm3d depthorder noborder
unset colorbox
unset key
set xrange [{{x_low}}:{{x_high}}]
set yrange [{{y_low}}:{{y_high}}]
set zrange [{{z_low}}:{{z_high}}]
set xyplane relative 0
set xlabel 'x [m]'
# gnuplot omits the title of the y axis in such views
set format y 'y %g m'
set zlabel 'z [m]'
set xtics offset 0,-0.3
set ytics {{y_tics}}
set ztics {{z_tics}}
unset border
{{#panels}}
set origin 0,{{low}}
set size 1,{{high}}
set view {{tilt}},{{turn}},{{zoom}}
set view equal xyz
set title '{{title}}'
splot '{{data}}' using 1:2:3:4 with pm3d lc rgb variable notitle
set title ' '
{{#bow}}
set label 'bow (+x)' at {{x}},{{y}},{{z}} left offset 1,0.8 font ',13' textcolor rgb '#c00000'
{{#key}}
set key at screen 0.98,0.985 right top samplen 2
{{/key}}
splot '.water.dat' with lines lw 2 lc rgb '#0040ff' title '{{key}}'
unset key
{{/bow}}
{{^bow}}
splot '.edges.dat' with lines lw 2 lc rgb '#e00000' notitle, '.marks.dat' with points pt 6 ps 2 lw 2 lc rgb '#e00000' notitle
{{/bow}}
unset label
{{/panels}}
unset multiplot
