set encoding utf8
set terminal svg size 560,380 dynamic enhanced font "sans-serif,13" name "plumb" background "#ffffff"
set output "picture.svg"
set lmargin at screen 0.135714
set rmargin at screen 0.933929
set bmargin at screen 0.157895
set tmargin at screen 0.892105
set grid lc rgb "gray" lw 0.5 dt solid
set tics scale 0.6 nomirror
set border 3
set title "Steps" noenhanced offset 0,-0.2
set xlabel "n" noenhanced offset 0,0.3
set label "share" at screen 0.025000, graph 0.5 center rotate by 90 noenhanced
set xrange [-0.165:5.665]
set xtics 1
set yrange [-0.033:0.583]
set ytics 0.2
set label "a" at graph 1.026846, graph 0.946429 left noenhanced tc rgb "#00588a"
set key off
$s0 << EOD
0 0 0 0
2 0.3 0 0
5.5 0.55 0 0
EOD
plot $s0 using 1:2 with linespoints lw 1.8 dt solid pt 7 ps 0.55 lc rgb "#0072b2" title "a"
unset output
