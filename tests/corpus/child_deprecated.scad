module m() { child(); child(1); } m() { cube(1); sphere(1); }
assign (a = 1, b = 2) cube([a, b, 3]);
children();
