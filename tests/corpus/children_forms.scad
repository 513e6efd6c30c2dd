module m() { children(); }
module f() children(0);
module l() children([0, 2]);
module r() children([0 : 2 : 2]);
module t() children(1.9);
m() { cube(1); sphere(2); cylinder(3); }
f() { cube(1); sphere(2); cylinder(3); }
l() { cube(1); sphere(2); cylinder(3); }
r() { cube(1); sphere(2); cylinder(3); }
t() { cube(1); sphere(2); cylinder(3); }
