cube(1);
difference() { !sphere(2); cube(3); }
cylinder(4);
