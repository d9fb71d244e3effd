set encoding utf8
set terminal svg size 560,421 dynamic enhanced font "sans-serif,13" name "plumb" background "#ffffff"
set output "picture.svg"
set lmargin at screen 0.135714
set rmargin at screen 0.971429
set bmargin at screen 0.356295
set tmargin at screen 0.902613
set grid lc rgb "gray" lw 0.5 dt solid
set tics scale 0.6 nomirror
set border 3
set title "Energy" noenhanced offset 0,-0.2
set xlabel "time [s]" noenhanced offset 0,0.3
set label "energy [J]" at screen 0.025000, graph 0.5 center rotate by 90 noenhanced
set xrange [-0.0375:1.2875]
set xtics ("0" 0, "0.4" 0.4, "1.2" 1.2)
set yrange [-4.5:6.54]
set ytics 2
set key at screen 0.5, screen 0.009501 center bottom horizontal maxcols 2 Left reverse noenhanced samplen 2.5 spacing 1.05
$s0 << EOD
0 0 0 0
0.5 0 0 0
1.25 -0 0 0
EOD
$s1 << EOD
0 0 0 0
0.5 1 0 0
1.25 -0.5 0 0
EOD
$s2 << EOD
0 0 0 0
0.5 2 0 0
1.25 -1 0 0
EOD
$s3 << EOD
0 0 0 0
0.5 3 0 0
1.25 -1.5 0 0
EOD
$s4 << EOD
0 0 0 0
0.5 4 0 0
1.25 -2 0 0
EOD
$s5 << EOD
0 0 0 0
0.5 5 0 0
1.25 -2.5 0 0
EOD
$s6 << EOD
0 0 0 0
0.5 6 0 0
1.25 -3 0 0
EOD
plot $s0 using 1:2 with lines lw 1.8 dt solid lc rgb "#0072b2" title "a name of part 0", \
     $s1 using 1:2 with lines lw 1.8 dt (9,4) lc rgb "#d55e00" title "a name of part 1", \
     $s2 using 1:2 with lines lw 1.8 dt (2,4) lc rgb "#009e73" title "a name of part 2", \
     $s3 using 1:2 with lines lw 1.8 dt (9,3,2,3) lc rgb "#0072b2" title "a name of part 3", \
     $s4 using 1:2 with lines lw 1.8 dt solid lc rgb "#e69f00" title "a name of part 4", \
     $s5 using 1:2 with lines lw 1.8 dt (9,4) lc rgb "#56b4e9" title "a name of part 5", \
     $s6 using 1:2 with lines lw 1.8 dt (2,4) lc rgb "#505050" title "a name of part 6"
unset output
