difference() { cube(3); !translate([1, 1, 1]) sphere(1); } cube(9);
