cube((1);
sphere(1);
