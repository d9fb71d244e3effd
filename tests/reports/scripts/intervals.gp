set encoding utf8
set terminal svg size 560,380 dynamic enhanced font "sans-serif,13" name "plumb" background "#ffffff"
set output "picture.svg"
set lmargin at screen 0.148214
set rmargin at screen 0.971429
set bmargin at screen 0.157895
set tmargin at screen 0.892105
set grid lc rgb "gray" lw 0.5 dt solid
set tics scale 0.6 nomirror
set border 3
set title "Orders" noenhanced offset 0,-0.2
set xlabel "order" noenhanced offset 0,0.3
set label "" at screen 0.025000, graph 0.5 center rotate by 90 noenhanced
set xrange [0.5:2.4]
set xtics 0.5
set yrange [-0.6:2.6]
set ytics 1
set key off
set ytics ("W1 & more" 2, "W0" 1, "none" 0) noenhanced
$met << EOD
2 2 1.9 2.1
EOD
$missed << EOD
0.7 1 0.5 0.9
2.3 0 2.2 2.4
EOD
$wanted << EOD
2 1.65 0 0.7
2 0.65 0 0.7
2 -0.35 0 0.7
EOD
plot $wanted with vectors nohead lw 3 lc rgb "#808080" notitle, \
     $met with xerrorbars pt 7 ps 0.7 lw 1.8 lc rgb "#0072b2" notitle, \
     $missed with xerrorbars pt 9 ps 0.7 lw 1.8 lc rgb "#d55e00" notitle
unset output
