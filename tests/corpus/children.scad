module m() { children(); children(0); children(1.7); children([0,1]); children([1:-1:0]); echo($children); }
m() { cube(1); sphere(2); }
m();
m() { for (i=[0:2]) cube(i); if (false) cube(9); }
module line() { for (i=[0:$children-1]) translate([i*3,0,0]) children(i); }
line() { cube(1); sphere(1); cylinder(1); }
