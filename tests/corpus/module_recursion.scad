module tree(n, s=1) { cube([s, s, 10*s]); if (n > 0) for (a=[-30,30]) translate([0,0,10*s]) rotate([0,a,0]) tree(n-1, s*0.7); }
tree(3);
module count(n) { echo(n); if (n > 0) count(n-1); }
count(3);
