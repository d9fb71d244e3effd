set encoding utf8
set terminal svg size 560,380 dynamic enhanced font "sans-serif,13" name "plumb" background "#ffffff"
set output "picture.svg"
set lmargin at screen 0.135714
set rmargin at screen 0.835714
set bmargin at screen 0.157895
set tmargin at screen 0.892105
set grid lc rgb "gray" lw 0.5 dt solid
set tics scale 0.6 nomirror
set border 3
set title "Heat" noenhanced offset 0,-0.2
set xlabel "x [m]" noenhanced offset 0,0.3
set label "y [m]" at screen 0.025000, graph 0.5 center rotate by 90 noenhanced
set xrange [0.0707106781187:0.565685424949]
set logscale x
set xtics ("0.1" 0.1, "0.2" 0.2, "0.4" 0.4)
set yrange [-0.5:1.5]
set ytics ("0" 0, "1" 1)
set key off
set palette defined (0 "#440154", 1 "#472d7b", 2 "#3b528b", 3 "#2c728e", 4 "#21918c", 5 "#28ae80", 6 "#5ec962", 7 "#addc30", 8 "#fde725")
set logscale cb
set format cb "10^{%T}"
set cblabel "stress [MPa]" noenhanced
set colorbox user origin screen 0.857143, graph 0 size screen 0.025000, graph 1 noborder
$map << EOD
0.1 0 0.0707106781187 0.141421356237 -0.5 0.5 1
0.2 0 0.141421356237 0.282842712475 -0.5 0.5 2
0.4 0 0.282842712475 0.565685424949 -0.5 0.5 3
0.1 1 0.0707106781187 0.141421356237 0.5 1.5 4
0.2 1 0.141421356237 0.282842712475 0.5 1.5 50
0.4 1 0.282842712475 0.565685424949 0.5 1.5 600
EOD
plot $map using 1:2:3:4:5:6:7 with boxxyerror fs solid noborder lc palette notitle
unset output
