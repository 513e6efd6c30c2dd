sphere(); sphere(2); sphere(d = 3); sphere(r = 1, d = 4); sphere(0); sphere(-1); sphere("a"); sphere(1/0); sphere(2, $fn = 5); sphere(r = undef); sphere([1]);
