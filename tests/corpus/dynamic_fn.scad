$fn = 7; sphere(1); sphere(1, $fn = 9); circle(1, $fa = 30); { cylinder(1, 2); } module m() circle(3); m($fn = 4); translate([0, 0, 0], $fn = 3) sphere(2); m();
