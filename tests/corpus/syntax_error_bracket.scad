cube([1,2,3);
sphere(1);
