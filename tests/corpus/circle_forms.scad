circle(); circle(2); circle(d = 3); circle(r = 1, d = 4); circle(0); circle(-1); circle("a"); circle(3, $fn = 6); circle($fa = 40, $fs = 3); circle(r = 5, $fs = 0.001); circle(r = 5, $fa = 0);
