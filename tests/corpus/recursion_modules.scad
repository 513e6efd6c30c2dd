module m(n) { if (n > 0) { translate([n, 0, 0]) cube(n); m(n - 1); } } m(5);
module tree(n) { cube(n); if (n > 1) for (a = [0, 90]) rotate(a) tree(n - 1); } tree(3);
