cube(1, true, 3); cube(siz = 2); sphere(1, 2); translate([1, 2, 3], 4) cube(1); cylinder(1, 2, 3, true, 5); cube(center = true, 2); cube($foo = 1);
