set encoding utf8
set terminal svg size 560,380 dynamic enhanced font "sans-serif,13" name "plumb" background "#ffffff"
set output "picture.svg"
set lmargin at screen 0.135714
set rmargin at screen 0.896429
set bmargin at screen 0.157895
set tmargin at screen 0.892105
set grid lc rgb "gray" lw 0.5 dt solid
set tics scale 0.6 nomirror
set border 3
set title "One value" noenhanced offset 0,-0.2
set xlabel "N" noenhanced offset 0,0.3
set label "value" at screen 0.025000, graph 0.5 center rotate by 90 noenhanced
set xrange [-8989.7:308999.7]
set xtics 100000
set yrange [1.1:3.9]
set ytics 0.5
set label "flat" at graph 1.028169, graph 0.500000 left noenhanced tc rgb "#00588a"
set label "two" at graph 1.028169, graph 0.439068 left noenhanced tc rgb "#a84a00"
set arrow from first 300000, first 2.5 to graph 1.021127, graph 0.439068 nohead back lw 0.6 dt (3,3) lc rgb "#d55e00"
set key off
$s0 << EOD
10 2.5 0 0
20000 2.5 0 0
300000 2.5 0 0
EOD
$s1 << EOD
10 2.5 0 0
20000 2.5 0 0
300000 2.5 0 0
EOD
plot $s0 using 1:2 with linespoints lw 1.8 dt solid pt 7 ps 0.55 lc rgb "#0072b2" title "flat", \
     $s1 using 1:2 with linespoints lw 1.8 dt solid pt 5 ps 0.55 lc rgb "#d55e00" title "two"
unset output
