set encoding utf8
set terminal svg size 560,380 dynamic enhanced font "sans-serif,13" name "plumb" background "#ffffff"
set output "picture.svg"
set lmargin at screen 0.025000
set rmargin at screen 0.835714
set bmargin at screen 0.031579
set tmargin at screen 0.892105
set grid lc rgb "gray" lw 0.5 dt solid
set tics scale 0.6 nomirror
set border 3
set title "Body" noenhanced offset 0,-0.2
set xlabel "" noenhanced offset 0,0.3
set label "" at screen 0.025000, graph 0.5 center rotate by 90 noenhanced
set xrange [0:2]
set xtics 0.5
set yrange [-0.220264317181:1.22026431718]
set ytics 0.5
set key off
set palette defined (0 "#440154", 1 "#472d7b", 2 "#3b528b", 3 "#2c728e", 4 "#21918c", 5 "#28ae80", 6 "#5ec962", 7 "#addc30", 8 "#fde725")
set cblabel "stress [MPa]" noenhanced
set colorbox user origin screen 0.857143, graph 0 size screen 0.025000, graph 1 noborder
unset border
unset xtics
unset ytics
unset grid
$patches << EOD
0 0 5
1 0 5
1 1 5
0 1 5

1 0 7.5
2 0 7.5
2 1 7.5
1 1 7.5

EOD
set cbrange [0:10]
set arrow from 0,0 to 1,0 filled size screen 0.012,20 lw 1.3 lc rgb "#606060"
set label "x, 1 m" at 1,0 left offset 0.5,0.3 noenhanced tc rgb "#606060"
plot $patches using 1:2:3 with polygons fs solid noborder fc palette notitle
unset output
