#cube(1); difference() { cube(3); #sphere(1); } #translate([1, 0, 0]) cube(); #for (i = [0 : 1]) cube(i + 1); module m() cube(2); #m();
