set encoding utf8
set terminal svg size 560,380 dynamic enhanced font "sans-serif,13" name "plumb" background "#ffffff"
set output "picture.svg"
set lmargin at screen 0.135714
set rmargin at screen 0.971429
set bmargin at screen 0.228947
set tmargin at screen 0.892105
set grid lc rgb "gray" lw 0.5 dt solid
set tics scale 0.6 nomirror
set border 3
set title "Outcomes" noenhanced offset 0,-0.2
set xlabel "scheme" noenhanced offset 0,0.3
set label "cfl" at screen 0.025000, graph 0.5 center rotate by 90 noenhanced
set xrange [0.75:2.25]
set xtics ("1" 1, "1.5" 1.5, "2" 2)
set yrange [0.05:0.25]
set ytics ("0.1" 0.1, "0.2" 0.2)
set key at screen 0.5, screen 0.010526 center bottom horizontal maxcols 3 Left reverse noenhanced samplen 2.5 spacing 1.05
$map0 << EOD
1 0.1 0.75 1.25 0.05 0.15 1
2 0.2 1.75 2.25 0.15 0.25 1
EOD
$map1 << EOD
1.5 0.1 1.25 1.75 0.05 0.15 1
1.5 0.2 1.25 1.75 0.15 0.25 1
EOD
$map2 << EOD
1 0.2 0.75 1.25 0.15 0.25 1
EOD
plot $map0 using 1:2:3:4:5:6 with boxxyerror fc rgb "#0072b2" fs solid border lc rgb "#ffffff" title "stable", \
     $map1 using 1:2:3:4:5:6 with boxxyerror fc rgb "#d55e00" fs solid border lc rgb "#ffffff" title "inverted", \
     $map2 using 1:2:3:4:5:6 with boxxyerror fc rgb "#009e73" fs solid border lc rgb "#ffffff" title "hourglass"
unset output
