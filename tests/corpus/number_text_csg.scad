cube([1234567, 0.000001, 1/3]);
sphere(1e7);
cylinder(h = 123456.7, r1 = 0.1, r2 = 1e-5);
translate([1234567, 1e-6, -1/3]) cube(999999.5);
