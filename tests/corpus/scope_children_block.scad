a = 1;
translate([a, 0, 0]) { a = 5; cube(a); b = a; sphere(b); }
module m() { a = 100; children(); }
m() { a = 7; cube(a); }
m() cube(a);
