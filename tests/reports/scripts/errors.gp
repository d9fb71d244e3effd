set encoding utf8
set terminal svg size 560,380 dynamic enhanced font "sans-serif,13" name "plumb" background "#ffffff"
set output "picture.svg"
set lmargin at screen 0.135714
set rmargin at screen 0.796429
set bmargin at screen 0.157895
set tmargin at screen 0.847368
set grid lc rgb "gray" lw 0.5 dt solid
set tics scale 0.6 nomirror
set border 3
set title "Error of the swinging plate against the spacing, with a long title that\ntakes two lines and more" noenhanced offset 0,-0.2
set xlabel "spacing d [m]" noenhanced offset 0,0.3
set label "relative error in L₂" at screen 0.025000, graph 0.5 center rotate by 90 noenhanced
set xrange [0.0234880687304:0.212874036491]
set logscale x
set xtics ("0.05" 0.05, "0.1" 0.1, "0.2" 0.2)
set yrange [3.68742168517e-05:0.0108476880095]
set logscale y
set ytics 1e1 format "10^{%T}"
set mytics 10
set arrow from graph 0, first 0.0001 to graph 1, first 0.0001 nohead back lw 1.2 dt (6,4) lc rgb "#808080"
set label "round-off" at graph 0.01, first 0.0001 left offset 0,0.5 noenhanced tc rgb "#606060"
set arrow from first 0.07, graph 0 to first 0.07, graph 1 nohead back lw 1.2 dt (6,4) lc rgb "#808080"
set object polygon from 0.055486165086,0.000229585613053 to 0.0901125531427,0.000605544187133 to 0.0901125531427,0.000229585613053 to 0.055486165086,0.000229585613053 fillstyle empty border lc rgb "#606060" lw 1.2
set label "slope 2" at 0.0707106781187,0.000229585613053 center offset 0,-0.7 tc rgb "#606060"
set object polygon from 0.0784692871887,0.000472230831321 to 0.127438394794,0.000766928581513 to 0.127438394794,0.000472230831321 to 0.0784692871887,0.000472230831321 fillstyle empty border lc rgb "#606060" lw 1.2
set label "slope 1" at 0.1,0.000472230831321 center offset 0,-0.7 tc rgb "#606060"
set label "W0" at graph 1.032432, graph 0.946429 left noenhanced tc rgb "#a84a00"
set label "W0, standard" at graph 1.032432, graph 0.881543 left noenhanced tc rgb "#00714f"
set arrow from first 0.2, first 0.0078 to graph 1.024324, graph 0.881543 nohead back lw 0.6 dt (3,3) lc rgb "#009e73"
set label "W1, improved" at graph 1.032432, graph 0.816658 left noenhanced tc rgb "#00588a"
set key off
$s0 << EOD
0.2 0.004 0.003 0.005
0.1 0.0011 0.0009 0.0013
0.05 0.00026 0.0002 0.0003
0.025 7e-05 5e-05 9e-05
EOD
$s1 << EOD
0.2 0.008 0 0
0.1 0.0021 0 0
0.05 0.00052 0 0
EOD
$s2 << EOD
0.2 0.0078 0 0
0.1 0.005 0 0
0.05 0.0032 0 0
EOD
plot $s0 using 1:3:4 with filledcurves lc rgb "#0072b2" fs transparent solid 0.18 noborder notitle, \
     $s0 using 1:2 with linespoints lw 1.8 dt solid pt 7 ps 0.55 lc rgb "#0072b2" title "W1, improved", \
     $s1 using 1:2 with points pt 4 ps 0.55 lc rgb "#d55e00" title "W0", \
     $s2 using 1:2 with lines lw 1.8 dt (9,4) lc rgb "#009e73" title "W0, standard"
unset output
set encoding utf8
set terminal pngcairo size 560,380 enhanced font "DejaVu Sans,9.5" background "#ffffff"
set output "picture.png"
set lmargin at screen 0.135714
set rmargin at screen 0.796429
set bmargin at screen 0.157895
set tmargin at screen 0.847368
set grid lc rgb "gray" lw 0.5 dt solid
set tics scale 0.6 nomirror
set border 3
set title "Error of the swinging plate against the spacing, with a long title that\ntakes two lines and more" noenhanced offset 0,-0.2
set xlabel "spacing d [m]" noenhanced offset 0,0.3
set label "relative error in L₂" at screen 0.025000, graph 0.5 center rotate by 90 noenhanced
set xrange [0.0234880687304:0.212874036491]
set logscale x
set xtics ("0.05" 0.05, "0.1" 0.1, "0.2" 0.2)
set yrange [3.68742168517e-05:0.0108476880095]
set logscale y
set ytics 1e1 format "10^{%T}"
set mytics 10
set arrow from graph 0, first 0.0001 to graph 1, first 0.0001 nohead back lw 1.2 dt (6,4) lc rgb "#808080"
set label "round-off" at graph 0.01, first 0.0001 left offset 0,0.5 noenhanced tc rgb "#606060"
set arrow from first 0.07, graph 0 to first 0.07, graph 1 nohead back lw 1.2 dt (6,4) lc rgb "#808080"
set object polygon from 0.055486165086,0.000229585613053 to 0.0901125531427,0.000605544187133 to 0.0901125531427,0.000229585613053 to 0.055486165086,0.000229585613053 fillstyle empty border lc rgb "#606060" lw 1.2
set label "slope 2" at 0.0707106781187,0.000229585613053 center offset 0,-0.7 tc rgb "#606060"
set object polygon from 0.0784692871887,0.000472230831321 to 0.127438394794,0.000766928581513 to 0.127438394794,0.000472230831321 to 0.0784692871887,0.000472230831321 fillstyle empty border lc rgb "#606060" lw 1.2
set label "slope 1" at 0.1,0.000472230831321 center offset 0,-0.7 tc rgb "#606060"
set label "W0" at graph 1.032432, graph 0.946429 left noenhanced tc rgb "#a84a00"
set label "W0, standard" at graph 1.032432, graph 0.881543 left noenhanced tc rgb "#00714f"
set arrow from first 0.2, first 0.0078 to graph 1.024324, graph 0.881543 nohead back lw 0.6 dt (3,3) lc rgb "#009e73"
set label "W1, improved" at graph 1.032432, graph 0.816658 left noenhanced tc rgb "#00588a"
set key off
$s0 << EOD
0.2 0.004 0.003 0.005
0.1 0.0011 0.0009 0.0013
0.05 0.00026 0.0002 0.0003
0.025 7e-05 5e-05 9e-05
EOD
$s1 << EOD
0.2 0.008 0 0
0.1 0.0021 0 0
0.05 0.00052 0 0
EOD
$s2 << EOD
0.2 0.0078 0 0
0.1 0.005 0 0
0.05 0.0032 0 0
EOD
plot $s0 using 1:3:4 with filledcurves lc rgb "#0072b2" fs transparent solid 0.18 noborder notitle, \
     $s0 using 1:2 with linespoints lw 1.8 dt solid pt 7 ps 0.55 lc rgb "#0072b2" title "W1, improved", \
     $s1 using 1:2 with points pt 4 ps 0.55 lc rgb "#d55e00" title "W0", \
     $s2 using 1:2 with lines lw 1.8 dt (9,4) lc rgb "#009e73" title "W0, standard"
unset output
