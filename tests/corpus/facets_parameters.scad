sphere(5, $fn = 3.7); sphere(5, $fn = -2); sphere(5, $fn = 1/0); sphere(5, $fa = -1); sphere(5, $fs = 0); sphere(5, $fn = "a"); sphere(5, $fn = undef); cylinder(1, 1, $fn = 1e6);
