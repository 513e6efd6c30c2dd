difference() { for (i = [0 : 1]) translate([i, 0, 0]) cube(); sphere(); }
intersection() { if (false) cube(); sphere(); }
module none() { } difference() { none(); cube(); } intersection() { union() { } cube(); }
difference() { if (false) cube(1); cube(2); cube(3); } difference() { let (a = 1) cube(a); sphere(); } difference() { assert(true); cube(1); sphere(1); } difference() { echo("e"); cube(1); sphere(1); }
