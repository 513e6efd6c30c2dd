cube(3);
sphere(1);
