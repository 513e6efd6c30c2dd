intersection_for (i = [0 : 2]) translate([i, 0, 0]) cube(5);
intersection_for (a = [0, 90], b = [1, 2]) rotate(a) scale(b) cube(3);
intersection_for (i = []) cube();
intersection_for (i = undef) cube();
